// SPDX-License-Identifier: GPL-2.0-or-later
#include "generate/motion.h"

#include "dataset/largestDistance.h"
#include "generate/handMotion.h"
#include "generate/recordedMotion.h"

#include <visp3/core/vpException.h>
#include <visp3/core/vpIoTools.h>

#include <algorithm>

namespace bench {

double SceneCamera::scale() const
{
  return std::min(width / 640., height / 480.);
}

SceneCamera makeSceneCamera(unsigned int width, unsigned int height)
{
  SceneCamera camera;
  camera.width = width;
  camera.height = height;
  const double focal = 650. * camera.scale();
  camera.cam = vpCameraParameters(focal, focal, width / 2. - 0.5, height / 2. - 0.5);
  return camera;
}

MotionExtent::MotionExtent(const std::vector<Eigen::Vector3d> &all)
{
  Eigen::Vector3d low = all.front();
  Eigen::Vector3d high = all.front();
  for (const Eigen::Vector3d &p : all) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  centre = 0.5 * (low + high);
  for (const Eigen::Vector3d &p : all) {
    radius = std::max(radius, (p - centre).norm());
  }
  diameter = programs::largestDistance(all);
  const std::size_t step = all.size() / 1000 + 1;
  for (std::size_t i = 0; i < all.size(); i += step) {
    points.push_back(all[i]);
  }
}

vpHomogeneousMatrix poseAround(const Eigen::Vector3d &centre, const Eigen::Matrix3d &rotation,
                               const Eigen::Vector3d &place)
{
  const Eigen::Vector3d translation = place - rotation * centre;
  vpHomogeneousMatrix cMo;
  for (unsigned int i = 0; i < 3; ++i) {
    for (unsigned int j = 0; j < 3; ++j) {
      cMo[i][j] = rotation(i, j);
    }
    cMo[i][3] = translation(i);
  }
  return cMo;
}

Eigen::Matrix3d Motion::backgroundTurn(double) const
{
  return Eigen::Matrix3d::Identity();
}

std::vector<std::string> motionNames()
{
  return {"smooth", "handheld", "shaken-camera"};
}

namespace {
void check(const MotionSettings &settings)
{
  if (!(settings.scale > 0. && settings.scale <= 10.)) {
    throw vpException(vpException::badValue, "--motion-scale: %g is not above 0 and at most 10", settings.scale);
  }
  if (settings.exits && settings.kind != "smooth") {
    throw vpException(vpException::badValue,
                      "the variant 'exit' has a motion of its own: leave --motion %s out, or take other variants",
                      settings.kind.c_str());
  }
}
} // namespace

std::unique_ptr<Motion> makeMotion(const SceneCamera &camera, const MotionSettings &settings)
{
  check(settings);
  if (settings.kind == "smooth") {
    return std::make_unique<SmoothMotion>(camera, settings);
  }
  if (settings.kind == "handheld") {
    return std::make_unique<HandheldMotion>(camera, settings);
  }
  if (settings.kind == "shaken-camera") {
    return std::make_unique<ShakenCameraMotion>(camera, settings);
  }
  if (!vpIoTools::checkFilename(settings.kind)) {
    throw vpException(vpException::badValue,
                      "--motion: '%s' is neither smooth, handheld or shaken-camera, nor a file that is there",
                      settings.kind.c_str());
  }
  if (settings.frontOnly) {
    throw vpException(vpException::badValue,
                      "poses of '%s' would show the back of an object that has only a front: give --motion handheld",
                      settings.kind.c_str());
  }
  return std::make_unique<RecordedMotion>(camera, settings);
}

} // namespace bench
