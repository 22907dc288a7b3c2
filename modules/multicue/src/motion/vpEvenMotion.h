// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpEvenMotion_h
#define vpEvenMotion_h

#include <visp3/se3/vpPoseExponential.h>

BEGIN_VISP_NAMESPACE

//! Where a pose is led by a motion that goes on: the object turns evenly about a point that goes straight on, as bodies
//! do by themselves. A screw motion is the same for small turns alone.
//! \param velocity Of the object in its own frame [v, omega], of its origin. \param centre The point, in that frame.
//! \param time In the velocity's unit.
inline vpHomogeneousMatrix vpEvenMotion(const vpHomogeneousMatrix &cMo, const vpPoseTangent &velocity,
                                        const Eigen::Vector3d &centre, double time)
{
  const Eigen::Isometry3d now = vpPoseExponential::toEigen(cMo);
  const Eigen::Vector3d v = velocity.head<3>();
  const Eigen::Vector3d omega = velocity.tail<3>();
  vpPoseTangent turn = vpPoseTangent::Zero();
  turn.tail<3>() = time * omega;
  Eigen::Isometry3d moved = now * vpPoseExponential::expEigen(turn);
  const Eigen::Vector3d at = now * centre + time * (now.linear() * (v + omega.cross(centre)));
  moved.translation() = at - moved.linear() * centre;
  return vpPoseExponential::fromEigen(moved);
}

END_VISP_NAMESPACE
#endif
