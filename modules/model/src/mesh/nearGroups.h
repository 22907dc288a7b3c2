// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef nearGroups_h
#define nearGroups_h

#include <visp3/se3/vpCompatibility.h>

#include <Eigen/Core>

#include <cstddef>
#include <vector>

BEGIN_VISP_NAMESPACE
namespace vpMeshDetail {
//! The numbers of points, those of one group after those of another.
struct NearGroups
{
  std::vector<std::size_t> order; //!< Rising within a group.
  std::vector<std::size_t> start; //!< Of each group in order, and the number of points.

  std::size_t size() const { return start.size() - 1; }
};

//! Points that are near to one another, at most as many in a group; none where there is no point.
NearGroups findNearGroups(const std::vector<Eigen::Vector3d> &points, std::size_t most);
} // namespace vpMeshDetail
END_VISP_NAMESPACE
#endif
