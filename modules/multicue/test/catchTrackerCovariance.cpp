// SPDX-License-Identifier: GPL-2.0-or-later
#include <catchMain.h>

#include "noisyBox.h"

#include <meshFiles.h>

#include <visp3/core/vpExponentialMap.h>
#include <visp3/multicue/vpMbMultiCueTracker.h>

#include <Eigen/Cholesky>

#include <cmath>
#include <iostream>
#include <vector>

namespace {
const int edge = vpMbMultiCueTracker::EDGE_TRACKER;
const int klt = vpMbMultiCueTracker::KLT_TRACKER;
const int color = vpMbMultiCueTracker::COLOR_TRACKER;
using Vector6 = Eigen::Matrix<double, 6, 1>;
using Matrix6 = Eigen::Matrix<double, 6, 6, Eigen::RowMajor>;

// The parameters of ViSP's covariances.
Vector6 parameters(const vpHomogeneousMatrix &cMo)
{
  const vpThetaUVector tu = cMo.getThetaUVector();
  Vector6 p;
  p << cMo[0][3], cMo[1][3], cMo[2][3], tu[0], tu[1], tu[2];
  return p;
}

Matrix6 toEigen(const vpMatrix &M)
{
  return Eigen::Map<const Matrix6>(M.data);
}

// Images of one pose, and of others near it to start from.
class Trials
{
public:
  explicit Trials(const vpHomogeneousMatrix &cMo) : m_truth(cMo), m_image(m_box.draw(cMo))
  {
    vpPoseRandom random(7);
    for (int i = 0; i < 8; ++i) {
      vpColVector motion(6);
      for (unsigned int j = 0; j < 6; ++j) {
        motion[j] = (j < 3 ? 0.0015 : 0.012) * random.normal();
      }
      m_starts.push_back(m_truth * vpExponentialMap::direct(motion));
      m_startImages.push_back(m_box.draw(m_starts.back()));
    }
  }

  // The tracker is started at a pose near the one of the image that it then tracks.
  void run(vpMbMultiCueTracker &tracker, int trial, double noise)
  {
    vpPoseRandom random(11, {static_cast<std::uint64_t>(trial)});
    const std::size_t start = static_cast<std::size_t>(trial) % m_starts.size();
    tracker.initFromPose(noisyBox::withNoise(m_startImages[start], noise, random), m_starts[start]);
    tracker.track(noisyBox::withNoise(m_image, noise, random));
  }

  const vpHomogeneousMatrix &truth() const { return m_truth; }

private:
  noisyBox m_box;
  vpHomogeneousMatrix m_truth;
  vpImage<vpRGBa> m_image;
  std::vector<vpHomogeneousMatrix> m_starts;
  std::vector<vpImage<vpRGBa>> m_startImages;
};

void prepare(vpMbMultiCueTracker &tracker, int type)
{
  tracker.setTrackerType(type);
  tracker.setCameraParameters(noisyBox::camera());
  tracker.loadModel(noisyBox::writeObj(meshFiles::temporaryFile("noisy-box.obj")));
  tracker.setCovarianceComputation(true);
}

// Mean of the normalised estimation error squared, 6 where the covariances are right.
double consistency(Trials &trials, int type, int count, double noise)
{
  vpMbMultiCueTracker tracker;
  prepare(tracker, type);
  double sum = 0.;
  for (int i = 0; i < count; ++i) {
    trials.run(tracker, i, noise);
    CHECK(tracker.getTrackingState() == vpTrackingState::TRACKING);
    const Vector6 error = parameters(tracker.getPose()) - parameters(trials.truth());
    sum += error.dot(toEigen(tracker.getCovarianceMatrix()).llt().solve(error));
  }
  return sum / count;
}

void checkConsistency(const vpHomogeneousMatrix &cMo, const std::vector<double> &noises, int count)
{
  Trials trials(cMo);
  const std::vector<std::pair<const char *, int>> types = {
      {"edges", edge}, {"colours", color}, {"points", klt}, {"fused", edge | color | klt}};
  for (const double noise : noises) {
    for (const auto &[name, type] : types) {
      const double mean = consistency(trials, type, count, noise);
      std::cout << "noise " << noise << ", " << name << ": normalised error squared " << mean << std::endl;
      CAPTURE(name, noise);
      CHECK(mean > 3.);
      CHECK(mean < 12.);
    }
  }
}
} // namespace

TEST_CASE("Covariances agree with the errors of 200 noisy images", "[covariance]")
{
  checkConsistency(noisyBox::pose(), {6.}, 200);
}

TEST_CASE("Covariances agree at other noise and another pose", "[.long]")
{
  checkConsistency(noisyBox::pose(), {5., 8.}, 200);
  checkConsistency(vpHomogeneousMatrix(0.01, 0.01, 0.45, 2.3, -0.3, 0.2), {5., 8.}, 200);
}

TEST_CASE("Each cue has a covariance of its own, and all together know more than each", "[covariance]")
{
  Trials trials(noisyBox::pose());
  vpMbMultiCueTracker tracker;
  prepare(tracker, edge | color | klt);
  trials.run(tracker, 0, 5.);
  const double all = toEigen(tracker.getCovarianceMatrix()).trace();
  for (const int cue : {edge, color, klt}) {
    CHECK(tracker.getCueReason(cue).empty());
    const Matrix6 covariance = toEigen(tracker.getCovarianceMatrix(cue));
    CHECK(covariance.isApprox(covariance.transpose()));
    CHECK(covariance.llt().info() == Eigen::Success);
    CHECK(covariance.trace() > all);
    CHECK(covariance.trace() < 1e-3);
  }
}

TEST_CASE("Motions that are kept fixed have no error", "[covariance]")
{
  Trials trials(noisyBox::pose());
  vpMbMultiCueTracker tracker;
  prepare(tracker, edge | color);
  vpColVector estimated(6);
  estimated = 1.;
  estimated[3] = estimated[4] = estimated[5] = 0.;
  tracker.setEstimatedDoF(estimated);
  trials.run(tracker, 0, 5.);
  const Matrix6 covariance = toEigen(tracker.getCovarianceMatrix());
  CHECK(covariance.bottomRightCorner(3, 3).norm() < 1e-15);
  CHECK(covariance(0, 0) > 0.);
}

TEST_CASE("A cue without data drops out and says why, and the others track", "[covariance]")
{
  noisyBox box(false);
  const vpHomogeneousMatrix cMo = noisyBox::pose();
  const vpImage<vpRGBa> I = box.draw(cMo);
  vpMbMultiCueTracker tracker;
  prepare(tracker, edge | klt);
  CHECK_FALSE(tracker.getCueReason(edge).empty());
  tracker.initFromPose(I, cMo);
  CHECK_THAT(tracker.getCueReason(edge), ContainsSubstring("no image was tracked"));
  tracker.track(I);
  CHECK(tracker.getTrackingState() == vpTrackingState::TRACKING);
  CHECK(tracker.getCueReason(edge).empty());
  CHECK_THAT(tracker.getCueReason(klt), ContainsSubstring("no texture: 0 points"));
  CHECK_THAT(tracker.getCueReason(color), ContainsSubstring("setTrackerType"));
  CHECK_NOTHROW(tracker.getCovarianceMatrix(edge));
  CHECK_THROWS_AS(tracker.getCovarianceMatrix(klt), vpException);
  CHECK_THROWS_AS(tracker.getCovarianceMatrix(color), vpException);
  CHECK_THROWS_AS(tracker.getCovarianceMatrix(3), vpException);
  CHECK_THROWS_AS(tracker.getCueReason(0), vpException);
}

TEST_CASE("Where nothing is seen each cue says so", "[covariance]")
{
  Trials trials(noisyBox::pose());
  vpMbMultiCueTracker tracker;
  prepare(tracker, edge | color | klt);
  trials.run(tracker, 0, 5.);
  tracker.setCovarianceComputation(false);
  CHECK_THROWS_AS(tracker.getCovarianceMatrix(edge), vpException);
  tracker.setCovarianceComputation(true);
  tracker.track(vpImage<vpRGBa>(noisyBox::height, noisyBox::width, vpRGBa(90, 90, 90)));
  CHECK_FALSE(tracker.getCueReason(edge).empty());
  CHECK_FALSE(tracker.getCueReason(klt).empty());
}
