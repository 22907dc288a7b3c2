// SPDX-License-Identifier: GPL-2.0-or-later
#include "search/vpSameSide.h"

BEGIN_VISP_NAMESPACE

Eigen::Matrix3d vpSmallestTurn(const Eigen::Vector3d &from, const Eigen::Vector3d &to)
{
  return Eigen::Quaterniond::FromTwoVectors(from, to).toRotationMatrix();
}

Eigen::Isometry3d vpSameSide(const Eigen::Isometry3d &cMo, const Eigen::Vector3d &middle, const Eigen::Vector3d &to)
{
  Eigen::Isometry3d moved = Eigen::Isometry3d::Identity();
  moved.linear() = vpSmallestTurn(cMo * middle, to) * cMo.linear();
  moved.translation() = to - moved.linear() * middle;
  return moved;
}

END_VISP_NAMESPACE
