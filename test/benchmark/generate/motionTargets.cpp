// SPDX-License-Identifier: GPL-2.0-or-later
#include "generate/motionTargets.h"

#include <visp3/core/vpException.h>

#include <algorithm>
#include <cmath>

namespace bench {
namespace {
// Not the sequence's own number, so that a shorter sequence is the beginning of a longer one.
const int measuredFrames = 300;
const int steps = 60;
const double damping = 0.5;
const double tolerance = 0.05;
// Above it, two frames on end do not tell the direction of motion any more.
const double fastest = 2.;

MotionFigures measure(const SceneCamera &camera, const std::vector<Eigen::Vector3d> &points,
                      const std::function<vpHomogeneousMatrix(double)> &poseAt)
{
  std::vector<vpHomogeneousMatrix> poses;
  for (int frame = 0; frame < measuredFrames; ++frame) {
    poses.push_back(poseAt(frame));
  }
  return measureMotion(poses, points, camera.cam);
}

//! Logarithms of what is wanted over what there is.
struct Missing
{
  double pixels = 0.;
  double degrees = 0.;
  double prediction = 0.;
  double largest() const { return std::max({std::abs(pixels), std::abs(degrees), std::abs(prediction)}); }
};

Missing compare(const MotionTargets &targets, const MotionFigures &figures, double scale)
{
  Missing missing;
  missing.pixels = std::log(targets.pixels * scale / figures.pixels.mean);
  missing.degrees = targets.degrees > 0. ? std::log(targets.degrees / figures.degrees.mean) : 0.;
  missing.prediction = std::log(targets.prediction * scale / figures.prediction.mean);
  return missing;
}

// Newton's step, damped, for motion that grows with gain and tempo, and errors of prediction with the tempo's square.
void improve(const Missing &missing, MotionGains &gains)
{
  const double tempo = damping * (missing.prediction - missing.pixels);
  gains.tempo = std::min(fastest, gains.tempo * std::exp(tempo));
  gains.shift *= std::exp(damping * missing.pixels - tempo);
  gains.turn *= std::exp(damping * missing.degrees - tempo);
}
} // namespace

MotionGains reachTargets(const SceneCamera &camera, const MotionSettings &settings, const MotionTargets &targets,
                         const std::function<vpHomogeneousMatrix(const MotionGains &, double)> &poseAt)
{
  MotionGains gains;
  for (int i = 0; i < steps; ++i) {
    const MotionFigures figures = measure(camera, settings.points, [&](double time) { return poseAt(gains, time); });
    const Missing missing = compare(targets, figures, camera.scale());
    if (missing.largest() < tolerance) {
      return gains;
    }
    improve(missing, gains);
  }
  throw vpException(vpException::badValue,
                    "--motion %s cannot be %g times as strong for this object in images of this size: give a "
                    "--motion-scale nearer to 1",
                    settings.kind.c_str(), settings.scale);
}

} // namespace bench
