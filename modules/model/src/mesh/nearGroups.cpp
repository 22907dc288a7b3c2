// SPDX-License-Identifier: GPL-2.0-or-later
#include "nearGroups.h"

#include "boundingBox.h"
#include <visp3/se3/vpExactNumber.h>

#include <algorithm>
#include <numeric>

BEGIN_VISP_NAMESPACE
namespace vpMeshDetail {
namespace {
// Halves a range across its longest side until few enough are left.
void split(const std::vector<Eigen::Vector3d> &points, std::size_t most, std::size_t first, std::size_t last,
           NearGroups &groups)
{
  const auto begin = groups.order.begin() + static_cast<std::ptrdiff_t>(first);
  const auto end = groups.order.begin() + static_cast<std::ptrdiff_t>(last);
  if (last - first <= most) {
    std::sort(begin, end);
    groups.start.push_back(last);
    return;
  }
  BoundingBox box;
  std::for_each(begin, end, [&](std::size_t i) { box.add(points[i]); });
  Eigen::Index axis = 0;
  (box.upper - box.lower).maxCoeff(&axis);
  const std::size_t middle = (first + last) / 2;
  // Equal coordinates by their number: the same points make the same groups, whatever the library.
  std::nth_element(begin, groups.order.begin() + static_cast<std::ptrdiff_t>(middle), end,
                   [&points, axis](std::size_t a, std::size_t b) {
                     return vpIsOther(points[a][axis], points[b][axis]) ? points[a][axis] < points[b][axis] : a < b;
                   });
  split(points, most, first, middle, groups);
  split(points, most, middle, last, groups);
}
} // namespace

NearGroups findNearGroups(const std::vector<Eigen::Vector3d> &points, std::size_t most)
{
  NearGroups groups;
  groups.order.resize(points.size());
  std::iota(groups.order.begin(), groups.order.end(), std::size_t(0));
  groups.start.push_back(0);
  if (!points.empty()) {
    split(points, std::max(most, std::size_t(1)), 0, points.size(), groups);
  }
  return groups;
}
} // namespace vpMeshDetail
END_VISP_NAMESPACE
