// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpSameSide_h
#define vpSameSide_h

#include <visp3/core/vpConfig.h>

#include <Eigen/Geometry>

BEGIN_VISP_NAMESPACE

// A pose moved to where a point of the object, its middle, is at another place, so that it shows the same side there:
// seen from another direction, the same rotation would show another one.
inline Eigen::Isometry3d vpSameSide(const Eigen::Isometry3d &cMo, const Eigen::Vector3d &middle,
                                    const Eigen::Vector3d &to)
{
  Eigen::Isometry3d moved = Eigen::Isometry3d::Identity();
  moved.linear() = Eigen::Quaterniond::FromTwoVectors(cMo * middle, to) * cMo.linear();
  moved.translation() = to - moved.linear() * middle;
  return moved;
}

END_VISP_NAMESPACE
#endif
