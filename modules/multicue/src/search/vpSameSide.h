// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpSameSide_h
#define vpSameSide_h

#include <visp3/se3/vpCompatibility.h>

#include <Eigen/Geometry>

BEGIN_VISP_NAMESPACE

// The smallest turn that makes one direction the other. In a file of its own, as Eigen's takes seconds to compile.
Eigen::Matrix3d vpSmallestTurn(const Eigen::Vector3d &from, const Eigen::Vector3d &to);

// A pose moved to where a point of the object, its middle, is at another place, so that it shows the same side there:
// seen from another direction, the same rotation would show another one.
Eigen::Isometry3d vpSameSide(const Eigen::Isometry3d &cMo, const Eigen::Vector3d &middle, const Eigen::Vector3d &to);

END_VISP_NAMESPACE
#endif
