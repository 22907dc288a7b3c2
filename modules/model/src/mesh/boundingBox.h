// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef boundingBox_h
#define boundingBox_h

#include <visp3/se3/vpCompatibility.h>

#include <Eigen/Core>

#include <cmath>
#include <limits>

BEGIN_VISP_NAMESPACE
namespace vpMeshDetail {
//! An axis-aligned box that grows; empty (lower > upper) at first.
struct BoundingBox
{
  Eigen::Vector3d lower = Eigen::Vector3d::Constant(std::numeric_limits<double>::infinity());
  Eigen::Vector3d upper = Eigen::Vector3d::Constant(-std::numeric_limits<double>::infinity());

  bool empty() const { return lower.x() > upper.x(); }
  double diagonal() const { return empty() ? 0. : (upper - lower).norm(); }

  void add(const Eigen::Vector3d &point)
  {
    lower = lower.cwiseMin(point);
    upper = upper.cwiseMax(point);
  }

  //! Adds a disc; \e normal is a unit vector.
  void addDisc(const Eigen::Vector3d &centre, const Eigen::Vector3d &normal, double radius)
  {
    const Eigen::Vector3d reach = radius * (1. - normal.array().square()).max(0.).sqrt().matrix();
    add(centre - reach);
    add(centre + reach);
  }
};
} // namespace vpMeshDetail
END_VISP_NAMESPACE
#endif
