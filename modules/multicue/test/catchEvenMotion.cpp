// SPDX-License-Identifier: GPL-2.0-or-later
#include "motion/vpEvenMotion.h" // The library keeps it to itself.

#include <catchMain.h>

namespace {
const vpHomogeneousMatrix start(0.1, -0.2, 0.8, 0.4, -0.3, 0.7);
const Eigen::Vector3d centre(0.05, 0.3, -0.1);
const Eigen::Vector3d speed(0.02, 0.03, -0.01); // Of the centre, in the camera's frame.
const Eigen::Vector3d omega(0.1, -0.2, 0.15);

//! The same motion by its definition.
Eigen::Isometry3d truth(double time)
{
  const Eigen::Isometry3d now = vpPoseExponential::toEigen(start);
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.linear() = now.linear() * Eigen::AngleAxisd(time * omega.norm(), omega.normalized()).toRotationMatrix();
  pose.translation() = now * centre + time * speed - pose.linear() * centre;
  return pose;
}

vpPoseTangent velocity()
{
  vpPoseTangent xi;
  const Eigen::Vector3d inObject = vpPoseExponential::toEigen(start).linear().transpose() * speed;
  xi << inObject - omega.cross(centre), omega;
  return xi;
}
} // namespace

TEST_CASE("The centre goes straight on while the object turns", "[even-motion]")
{
  const double time = GENERATE(0., 0.5, 1., 10., -3.);
  const Eigen::Isometry3d moved = vpPoseExponential::toEigen(vpEvenMotion(start, velocity(), centre, time));
  CHECK((moved.matrix() - truth(time).matrix()).norm() < 1e-12);
}

TEST_CASE("What moved between two frames goes on by as much in the next", "[even-motion]")
{
  const double step = 1e-3; // Both are the same to first order.
  const vpHomogeneousMatrix next = vpPoseExponential::fromEigen(truth(step));
  const vpPoseTangent motion = vpPoseExponential::log(start.inverse() * next);
  const Eigen::Isometry3d moved = vpPoseExponential::toEigen(vpEvenMotion(next, motion, centre, 1.));
  CHECK((moved.matrix() - truth(2. * step).matrix()).norm() < 1e-7);
}
