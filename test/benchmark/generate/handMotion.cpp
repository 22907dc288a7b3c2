// SPDX-License-Identifier: GPL-2.0-or-later
#include "generate/handMotion.h"

#include <visp3/core/vpMath.h>
#include <visp3/se3/vpPoseExponential.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace bench {
namespace {
// Means of an object that a hand moves, at 30 frames a second (those of RBOT's trajectory).
const MotionTargets handheld = {10., 6., 4.};
// Where a hand swings an object farther it turns it less than that much more: 10 degrees for twice the motion.
const double turnExponent = 0.75;
// Medians of an object at rest before a camera in a hand.
const MotionTargets shaken = {9., 0., 9.};
// Share of the smooth motion that is left to a camera in a hand: with the shake, 1 degree a frame, real ones 0.6.
const double slowShare = 0.12;
// Farthest shake in the mean, pixels at 640 x 480: the object stays that far away from the border without it.
const double shakeMargin = 25.;
// Of the camera about its line of sight, beside those across it.
const double rollShare = 0.5;

const double driftTempo = 2. * M_PI / 140.; // Radians per frame.
const double driftShare = 0.25;             // Of the room in the image, in the mean.
const double driftPitch = vpMath::rad(25.);
const double framesPerTurn = 300.;
const double mostSizeChange = 0.15;
// Of an object whose front alone makes sense, with 17 degrees less than 60 because it is not in the image's middle.
const double mostTilt = vpMath::rad(43.);
const double leastRoom = 20.; // Pixels at 640 x 480.
// Longest an object is in the image, so that there is room to swing it, pixels at 640 x 480; less for wider swings.
const double mostPixelDiameter = 225.;
const double diameterExponent = -0.4;

MotionTargets scaled(MotionTargets targets, double scale)
{
  targets.pixels *= scale;
  targets.prediction *= scale;
  targets.degrees *= scale > 1. ? std::pow(scale, turnExponent) : scale;
  return targets;
}

MotionSettings handheldSettings(const MotionSettings &settings)
{
  MotionSettings roomy = settings;
  roomy.pixelDiameter =
      std::min(settings.pixelDiameter, mostPixelDiameter) * std::pow(std::max(1., settings.scale), diameterExponent);
  return roomy;
}

MotionSettings slowSettings(const MotionSettings &settings)
{
  MotionSettings slow = settings;
  slow.scale = slowShare;
  slow.margin += shakeMargin * settings.scale;
  slow.frames = std::max(settings.frames, 300);
  return slow;
}

// Of drift and turning beside the swing, so that they do not exceed what is wanted in all.
double slowness(double scale)
{
  return std::min(1., scale);
}

Eigen::Matrix3d rotationOf(const Eigen::Vector3d &vector)
{
  return vpPoseExponential::expEigen((vpPoseTangent() << Eigen::Vector3d::Zero(), vector).finished()).linear();
}

// Half a turn about x: the object's y axis is up, and its z axis towards the camera.
const Eigen::Matrix3d upright = Eigen::Vector3d(1., -1., -1.).asDiagonal();
} // namespace

HandheldMotion::HandheldMotion(const SceneCamera &camera, const MotionSettings &settings)
    : m_camera(camera), m_settings(handheldSettings(settings)), m_extent(settings.points), m_swing(6, settings.seed),
      m_drift(3, settings.seed + 1)
{
  m_gains = reachTargets(camera, settings, scaled(handheld, settings.scale),
                         [this](const MotionGains &gains, double time) { return poseWith(gains, time); });
}

Eigen::Matrix3d HandheldMotion::rotationAt(const Eigen::Vector3d &swing, double time) const
{
  if (m_settings.frontOnly) {
    Eigen::Vector3d tilt(swing.x(), swing.y(), 0.);
    tilt *= mostTilt * std::tanh(tilt.norm() / mostTilt) / std::max(tilt.norm(), 1e-12);
    return rotationOf({0., 0., swing.z()}) * rotationOf(tilt) * upright;
  }
  const double slow = slowness(m_settings.scale);
  const double pitch = driftPitch * m_drift.at(slow * time, driftTempo)(2);
  const double yaw = 2. * M_PI * slow * time / framesPerTurn;
  return rotationOf(swing) * rotationOf({pitch, 0., 0.}) * rotationOf({0., yaw, 0.}) * upright;
}

// Bent so that the object stays in the image, however far the swing goes. All pixels.
double HandheldMotion::placeAlong(double size, double extent, double wanted) const
{
  const double room = std::max(leastRoom * m_camera.scale(), size / 2. - extent);
  return room * std::tanh(wanted / room);
}

vpHomogeneousMatrix HandheldMotion::poseWith(const MotionGains &gains, double time) const
{
  const Eigen::VectorXd swing = m_swing.at(time, gains.tempo);
  const Eigen::VectorXd drift = m_drift.at(slowness(m_settings.scale) * time, driftTempo);
  const double focal = m_camera.cam.get_px();
  const double change = gains.shift * swing(2) / (mostSizeChange * m_settings.pixelDiameter);
  const double distance = focal * m_extent.diameter / (m_settings.pixelDiameter * m_camera.scale()) *
                          std::exp(mostSizeChange * std::tanh(change));
  const double extent = focal * m_extent.radius / (distance - m_extent.radius) + m_settings.margin * m_camera.scale();
  const double reach = gains.shift * m_camera.scale();
  const double x = placeAlong(m_camera.width, extent, driftShare * m_camera.width / 2. * drift(0) + reach * swing(0));
  const double y = placeAlong(m_camera.height, extent, driftShare * m_camera.height / 2. * drift(1) + reach * swing(1));
  const Eigen::Vector3d turn = gains.turn * swing.tail<3>();
  return poseAround(m_extent.centre, rotationAt(turn, time), distance * Eigen::Vector3d(x / focal, y / focal, 1.));
}

ShakenCameraMotion::ShakenCameraMotion(const SceneCamera &camera, const MotionSettings &settings)
    : m_camera(camera), m_slow(camera, slowSettings(settings)), m_shake(3, settings.seed + 2)
{
  m_gains = reachTargets(camera, settings, scaled(shaken, settings.scale),
                         [this](const MotionGains &gains, double time) { return poseWith(gains, time); });
}

Eigen::Matrix3d ShakenCameraMotion::turnWith(const MotionGains &gains, double time) const
{
  const Eigen::Vector3d shake = m_shake.at(time, gains.tempo);
  const double angle = gains.shift * m_camera.scale() / m_camera.cam.get_px();
  return rotationOf(angle * Eigen::Vector3d(shake(0), shake(1), rollShare * shake(2)));
}

vpHomogeneousMatrix ShakenCameraMotion::poseWith(const MotionGains &gains, double time) const
{
  Eigen::Isometry3d turn = Eigen::Isometry3d::Identity();
  turn.linear() = turnWith(gains, time);
  return vpPoseExponential::fromEigen(turn * vpPoseExponential::toEigen(m_slow.pose(time)));
}

} // namespace bench
