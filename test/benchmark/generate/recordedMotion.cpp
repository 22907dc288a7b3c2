// SPDX-License-Identifier: GPL-2.0-or-later
#include "generate/recordedMotion.h"

#include "dataset/rbotReader.h"

#include <visp3/core/vpException.h>
#include <visp3/se3/vpPoseExponential.h>

#include <algorithm>
#include <cmath>

namespace bench {
namespace {
void requireClear(const std::vector<vpHomogeneousMatrix> &poses, const MotionExtent &extent, const std::string &file)
{
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const Eigen::Vector3d centre = vpPoseExponential::toEigen(poses[i]) * extent.centre;
    if (centre.z() <= 1.1 * extent.radius) {
      throw vpException(vpException::badValue,
                        "pose %zu of '%s' has the object, which is %g m large, %g m before the camera: is its --unit "
                        "right? RBOT's meshes are in millimetres, --unit 0.001",
                        i, file.c_str(), extent.diameter, centre.z());
    }
  }
}
} // namespace

RecordedMotion::RecordedMotion(const SceneCamera &camera, const MotionSettings &settings)
    : m_poses(rbotReader::readPoses(settings.kind)), m_scale(settings.scale)
{
  const double needed = std::ceil(m_scale * (settings.frames - 1)) + 1.;
  if (static_cast<double>(m_poses.size()) < needed) {
    throw vpException(vpException::badValue, "'%s' has %zu poses, and %d frames need %.0f: give fewer --frames",
                      settings.kind.c_str(), m_poses.size(), settings.frames, needed);
  }
  const MotionExtent extent(settings.points);
  if (settings.fitsDistance) {
    fit(camera, settings, extent);
  }
  requireClear(m_poses, extent, settings.kind);
}

// The file's poses are those of an object of another size, with its origin in its middle.
void RecordedMotion::fit(const SceneCamera &camera, const MotionSettings &settings, const MotionExtent &extent)
{
  double distance = 0.;
  for (const vpHomogeneousMatrix &cMo : m_poses) {
    distance += cMo[2][3] / static_cast<double>(m_poses.size());
  }
  const double wanted = camera.cam.get_px() * extent.diameter / (settings.pixelDiameter * camera.scale());
  for (vpHomogeneousMatrix &cMo : m_poses) {
    Eigen::Isometry3d pose = vpPoseExponential::toEigen(cMo);
    pose.translation() *= wanted / distance;
    cMo = vpPoseExponential::fromEigen(pose * Eigen::Translation3d(-extent.centre));
  }
}

vpHomogeneousMatrix RecordedMotion::pose(double time) const
{
  const double place = std::clamp(m_scale * time, 0., static_cast<double>(m_poses.size() - 1));
  const std::size_t before = std::min(static_cast<std::size_t>(place), m_poses.size() - 2);
  const vpHomogeneousMatrix &cMo = m_poses[before];
  const vpPoseTangent velocity = vpPoseExponential::log(cMo.inverse() * m_poses[before + 1]);
  return cMo * vpPoseExponential::exp((place - static_cast<double>(before)) * velocity);
}

} // namespace bench
