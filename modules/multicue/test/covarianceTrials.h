// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef covarianceTrials_h
#define covarianceTrials_h

#include "noisyBox.h"

#include <meshFiles.h>

#include <visp3/core/vpExponentialMap.h>
#include <visp3/multicue/vpMbMultiCueTracker.h>

#include <Eigen/Cholesky>

#include <cmath>
#include <iostream>
#include <utility>
#include <vector>

/*! \file covarianceTrials.h How large the errors of poses from noisy images are beside their covariances. */

BEGIN_VISP_NAMESPACE
namespace covarianceTrials {
const int edge = vpMbMultiCueTracker::EDGE_TRACKER;
const int klt = vpMbMultiCueTracker::KLT_TRACKER;
const int color = vpMbMultiCueTracker::COLOR_TRACKER;
using Vector6 = Eigen::Matrix<double, 6, 1>;
using Matrix6 = Eigen::Matrix<double, 6, 6, Eigen::RowMajor>;

//! The parameters of ViSP's covariances.
inline Vector6 parameters(const vpHomogeneousMatrix &cMo)
{
  const vpThetaUVector tu = cMo.getThetaUVector();
  Vector6 p;
  p << cMo[0][3], cMo[1][3], cMo[2][3], tu[0], tu[1], tu[2];
  return p;
}

inline Matrix6 toEigen(const vpMatrix &M)
{
  return Eigen::Map<const Matrix6>(M.data);
}

//! Images of one pose, and of others near it to start from.
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

  //! An image of the start, and one that the tracker is then shown.
  struct Images
  {
    const vpHomogeneousMatrix &start;
    vpImage<vpRGBa> ofStart;
    vpImage<vpRGBa> ofTruth;
  };

  Images draw(int trial, double noise) const
  {
    vpPoseRandom random(11, {static_cast<std::uint64_t>(trial)});
    const std::size_t start = static_cast<std::size_t>(trial) % m_starts.size();
    // In braces, from left to right.
    return {m_starts[start], noisyBox::withNoise(m_startImages[start], noise, random),
            noisyBox::withNoise(m_image, noise, random)};
  }

  //! The tracker is started at a pose near the one of the image that it then tracks.
  static void run(vpMbMultiCueTracker &tracker, const Images &images)
  {
    tracker.initFromPose(images.ofStart, images.start);
    tracker.track(images.ofTruth);
  }
  void run(vpMbMultiCueTracker &tracker, int trial, double noise) const { run(tracker, draw(trial, noise)); }

  const vpHomogeneousMatrix &truth() const { return m_truth; }

private:
  noisyBox m_box;
  vpHomogeneousMatrix m_truth;
  vpImage<vpRGBa> m_image;
  std::vector<vpHomogeneousMatrix> m_starts;
  std::vector<vpImage<vpRGBa>> m_startImages;
};

inline void prepare(vpMbMultiCueTracker &tracker, int type)
{
  tracker.setTrackerType(type);
  tracker.setCameraParameters(noisyBox::camera());
  tracker.loadModel(noisyBox::writeObj(meshFiles::temporaryFile("noisy-box.obj")));
  tracker.setCovarianceComputation(true);
}

//! The mean of the normalised estimation error squared is 6 where the covariances are right.
inline void checkConsistency(const vpHomogeneousMatrix &cMo, const std::vector<double> &noises, int count)
{
  const Trials trials(cMo);
  const std::vector<std::pair<const char *, int>> types = {
      {"edges", edge}, {"colours", color}, {"points", klt}, {"fused", edge | color | klt}};
  for (const double noise : noises) {
    std::vector<vpMbMultiCueTracker> trackers(types.size());
    std::vector<double> sums(types.size(), 0.);
    for (std::size_t k = 0; k < types.size(); ++k) {
      prepare(trackers[k], types[k].second);
    }
    for (int i = 0; i < count; ++i) {
      const Trials::Images images = trials.draw(i, noise); // Drawn once for all types.
      for (std::size_t k = 0; k < types.size(); ++k) {
        Trials::run(trackers[k], images);
        CHECK(trackers[k].getTrackingState() == vpTrackingState::TRACKING);
        const Vector6 error = parameters(trackers[k].getPose()) - parameters(trials.truth());
        sums[k] += error.dot(toEigen(trackers[k].getCovarianceMatrix()).llt().solve(error));
      }
    }
    for (std::size_t k = 0; k < types.size(); ++k) {
      const char *const name = types[k].first;
      const double mean = sums[k] / count;
      std::cout << "noise " << noise << ", " << name << ": normalised error squared " << mean << std::endl;
      CAPTURE(name, noise);
      CHECK(mean > 3.);
      CHECK(mean < 12.);
    }
  }
}

} // namespace covarianceTrials
END_VISP_NAMESPACE
#endif
