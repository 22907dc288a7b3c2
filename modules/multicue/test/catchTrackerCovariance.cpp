// SPDX-License-Identifier: GPL-2.0-or-later
#include <catchMain.h>

#include "noisyBox.h"

#include <meshFiles.h>

#include <visp3/core/vpExponentialMap.h>
#include <visp3/io/vpImageIo.h>
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
  const vpImage<vpRGBa>& image() const {return m_image;}
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
struct Consistency
{
  double mean = 0.;
  double time=0, rows=0;
  Vector6 bias = Vector6::Zero();
  Matrix6 actual = Matrix6::Zero();
  Matrix6 claimed = Matrix6::Zero();
};

Consistency consistency(Trials &trials, int type, int count, double noise)
{
  vpMbMultiCueTracker tracker;
  prepare(tracker, type);
  Consistency result;
  vpPoseRandom r(5);
  for (int i = 0; i < count; ++i) {
    trials.run(tracker, i, noise);
    CHECK(tracker.getTrackingState() == vpTrackingState::TRACKING);
    const Vector6 error = parameters(tracker.getPose()) - parameters(trials.truth());
    const Matrix6 covariance = toEigen(tracker.getCovarianceMatrix());
    result.mean += error.dot(covariance.llt().solve(error)) / count;
    result.time += tracker.getTimings().total/count; result.rows += tracker.getNbFeaturesKlt()*1./count; if (i==0 && getenv("VERB")) { std::cout << "KLT " << tracker.getCueReason(klt) << std::endl; if(getenv("WR")) {vpImageIo::write(noisyBox::withNoise(trials.image(), noise, r), "/tmp/covbox.png"); } }
    result.bias += error / count;
    result.actual += error * error.transpose() / count;
    result.claimed += covariance / count;
  }
  return result;
}

void checkConsistency(const vpHomogeneousMatrix &cMo, int count)
{
  Trials trials(cMo);
  const std::vector<std::pair<const char *, int>> types = {
      {"edges", edge}, {"colours", color}, {"points", klt}, {"fused", edge | color | klt}};
  for (const double noise : {5., 8.}) {
    for (const auto &[name, type] : types) { if (getenv("ONLY") && type != atoi(getenv("ONLY"))) continue;
      const Consistency found = consistency(trials, type, count, noise);
      std::cout << "noise " << noise << ", " << name << ": normalised error squared " << found.mean << std::endl;
      if (getenv("VERB")) {
      std::cout << "  bias " << found.bias.transpose() << "\n  actual " << found.actual.diagonal().cwiseSqrt().transpose() << "\n  claimed " << found.claimed.diagonal().cwiseSqrt().transpose() << std::endl;
      }
      CAPTURE(name, noise);
      CHECK(found.mean > 3.);
      CHECK(found.mean < 12.);
    }
  }
}
} // namespace

TEST_CASE("Covariances agree with the errors of noisy images", "[covariance]")
{
  checkConsistency(noisyBox::pose(), 60);
}

TEST_CASE("Covariances agree with the errors of 200 noisy images", "[.long]")
{
  checkConsistency(noisyBox::pose(), 200);
  checkConsistency(vpHomogeneousMatrix(-0.02, 0.01, 0.6, -0.4, 0.7, 0.4), 200);
  checkConsistency(vpHomogeneousMatrix(0.01, 0.01, 0.45, 2.3, -0.3, 0.2), 200);
}
