// SPDX-License-Identifier: GPL-2.0-or-later
#include "symmetry/vpSegmentTree.h"

#include <algorithm>
#include <cmath>

BEGIN_VISP_NAMESPACE

namespace {
const std::size_t leafSegments = 4;
}

vpSegmentTree::vpSegmentTree(const std::vector<vpSegment> &segments, double reach)
    : m_reach(reach), m_segments(segments)
{
  if (!m_segments.empty()) {
    build(0, m_segments.size());
  }
}

void vpSegmentTree::build(std::size_t first, std::size_t last)
{
  Node node;
  node.first = first;
  node.last = last;
  for (std::size_t i = first; i < last; ++i) {
    node.box.extend(m_segments[i].start);
    node.box.extend(m_segments[i].end);
  }
  node.box.min().array() -= m_reach;
  node.box.max().array() += m_reach;
  const std::size_t index = m_nodes.size();
  m_nodes.push_back(node);
  if (last - first <= leafSegments) {
    return;
  }
  Eigen::Index axis = 0;
  node.box.sizes().maxCoeff(&axis);
  const std::size_t middle = first + (last - first) / 2;
  const auto at = [this](std::size_t i) { return m_segments.begin() + static_cast<std::ptrdiff_t>(i); };
  std::nth_element(at(first), at(middle), at(last), [axis](const vpSegment &a, const vpSegment &b) {
    return a.start[axis] + a.end[axis] < b.start[axis] + b.end[axis];
  });
  build(first, middle);
  m_nodes[index].right = m_nodes.size();
  build(middle, last);
}

bool vpSegmentTree::leafHasNear(const Node &leaf, const Eigen::Vector3d &point, const Eigen::Vector3d &direction,
                                double cosine) const
{
  const auto at = [this](std::size_t i) { return m_segments.begin() + static_cast<std::ptrdiff_t>(i); };
  return std::any_of(at(leaf.first), at(leaf.last), [&](const vpSegment &segment) {
    const Eigen::Vector3d from = point - segment.start;
    const double length = (segment.end - segment.start).norm();
    const double along = std::min(std::max(from.dot(segment.direction), 0.), length);
    return (from - along * segment.direction).squaredNorm() <= m_reach * m_reach &&
           std::fabs(direction.dot(segment.direction)) > cosine;
  });
}

bool vpSegmentTree::hasNear(const Eigen::Vector3d &point, const Eigen::Vector3d &direction, double cosine) const
{
  // Nodes that are still to be looked at: at most one for each of the tree's levels, of which there are 64 at most.
  std::size_t waiting[64];
  std::size_t count = 0;
  for (std::size_t index = 0; !m_nodes.empty();) {
    const Node &node = m_nodes[index];
    const bool isNear = node.box.contains(point);
    if (isNear && node.right != 0) {
      waiting[count++] = node.right;
      ++index;
      continue;
    }
    if (isNear && leafHasNear(node, point, direction, cosine)) {
      return true;
    }
    if (count == 0) {
      return false;
    }
    index = waiting[--count];
  }
  return false;
}

END_VISP_NAMESPACE
