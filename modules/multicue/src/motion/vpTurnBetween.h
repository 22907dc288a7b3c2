// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpTurnBetween_h
#define vpTurnBetween_h

#include <visp3/core/vpHomogeneousMatrix.h>
#include <visp3/se3/vpPoseExponential.h>

#include <Eigen/Geometry>

BEGIN_VISP_NAMESPACE

//! Angle of the turn that leads from one pose to another one, radians.
inline double vpTurnBetween(const vpHomogeneousMatrix &c1Mo, const vpHomogeneousMatrix &c2Mo)
{
  const Eigen::Matrix3d first = vpPoseExponential::toEigen(c1Mo).linear();
  const Eigen::Matrix3d second = vpPoseExponential::toEigen(c2Mo).linear();
  return Eigen::AngleAxisd(first.transpose() * second).angle();
}

END_VISP_NAMESPACE
#endif
