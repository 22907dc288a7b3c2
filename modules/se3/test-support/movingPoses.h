// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef movingPoses_h
#define movingPoses_h

#include <visp3/se3/vpPoseKalmanFilter.h>
#include <visp3/se3/vpPoseNoise.h>

#include <vector>

/*!
  \file movingPoses.h
  Objects that move before a camera, and what a tracker might say about their poses.
*/

namespace movingPoses {

//! A pose at a time, and what was observed.
struct Sample
{
  vpHomogeneousMatrix cMo;
  vpPoseTangent velocity; //!< As vpPoseKalmanFilter::velocity() has it.
  vpHomogeneousMatrix observed;
};

//! Of an observed pose, camera frame: the depth is known less well than the rest.
inline vpPoseMatrix6 observationCovariance()
{
  vpPoseTangent deviation;
  deviation << 0.001, 0.001, 0.004, 0.006, 0.006, 0.003;
  vpPoseMatrix6 correlation = vpPoseMatrix6::Identity();
  correlation(0, 4) = correlation(4, 0) = 0.6;
  correlation(1, 3) = correlation(3, 1) = -0.6;
  return deviation.asDiagonal() * correlation * deviation.asDiagonal();
}

/*!
  A motion whose velocity wanders as \e settings say, in small steps.
  \param dt Between samples, seconds. \param run Names the random numbers.
*/
inline std::vector<Sample> wander(const vpPoseKalmanSettings &settings, double dt, int count, unsigned int run)
{
  const int substeps = 10;
  vpPoseRandom random(7, {run});
  const vpPoseNoise noise(observationCovariance(), vpPoseNoise::Frame::CAMERA);
  vpPoseTangent wander;
  wander << Eigen::Vector3d::Constant(settings.translationWander), Eigen::Vector3d::Constant(settings.rotationWander);
  vpPoseTangent start;
  start << Eigen::Vector3d::Constant(settings.startTranslation), Eigen::Vector3d::Constant(settings.startRotation);
  Sample sample;
  sample.cMo = vpHomogeneousMatrix(0.1, -0.05, 0.8, 0.5, -1.2, 0.4);
  sample.velocity = start.cwiseProduct(random.normalTangent());
  std::vector<Sample> samples;
  for (int i = 0; i < count; i++) {
    if (i > 0) {
      for (int k = 0; k < substeps; k++) {
        const double step = dt / substeps;
        const vpPoseTangent change = std::sqrt(step) * wander.cwiseProduct(random.normalTangent());
        sample.cMo = sample.cMo * vpPoseExponential::exp(step * (sample.velocity + 0.5 * change));
        sample.velocity += change;
      }
    }
    sample.observed = noise.draw(sample.cMo, random); // The true pose is exp(-alpha) times it: the same covariance.
    samples.push_back(sample);
  }
  return samples;
}

} // namespace movingPoses
#endif
