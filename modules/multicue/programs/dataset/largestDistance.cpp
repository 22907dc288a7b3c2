// SPDX-License-Identifier: GPL-2.0-or-later
#include "dataset/largestDistance.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace programs {
namespace {
const std::size_t leafPoints = 8;

// The points in a tree of boxes: of two boxes that are too close to each other, no pair of points is looked at. A ball
// of 200,000 vertices takes a second or two so, and minutes pair by pair.
class FarthestPair
{
public:
  explicit FarthestPair(const std::vector<Eigen::Vector3d> &points) : m_points(points)
  {
    const std::size_t root = build(0, m_points.size());
    m_largest = guess();
    compare(root, root);
  }

  double distance() const { return m_largest; }

private:
  struct Node
  {
    Eigen::AlignedBox3d box;
    std::size_t first;
    std::size_t last;
    std::size_t children[2] = {0, 0}; // None where both are 0, the root.
    bool isLeaf() const { return children[0] == children[1]; }
  };

  std::size_t build(std::size_t first, std::size_t last)
  {
    Node node;
    node.first = first;
    node.last = last;
    for (std::size_t i = first; i < last; ++i) {
      node.box.extend(m_points[i]);
    }
    const std::size_t index = m_nodes.size();
    m_nodes.push_back(node);
    if (last - first > leafPoints) {
      Eigen::Index axis = 0;
      node.box.sizes().maxCoeff(&axis);
      const std::size_t middle = first + (last - first) / 2;
      const auto at = [&](std::size_t i) { return m_points.begin() + static_cast<std::ptrdiff_t>(i); };
      std::nth_element(at(first), at(middle), at(last),
                       [axis](const Eigen::Vector3d &a, const Eigen::Vector3d &b) { return a[axis] < b[axis]; });
      const std::size_t left = build(first, middle);
      const std::size_t right = build(middle, last);
      m_nodes[index].children[0] = left;
      m_nodes[index].children[1] = right;
    }
    return index;
  }

  // From any point to the farthest from it, and on: close to the longest distance of all.
  double guess() const
  {
    double largest = 0.;
    Eigen::Vector3d from = m_points.front();
    for (int i = 0; i < 4; ++i) {
      const auto farthest = std::max_element(m_points.begin(), m_points.end(), [&](const auto &a, const auto &b) {
        return (a - from).squaredNorm() < (b - from).squaredNorm();
      });
      largest = std::max(largest, (*farthest - from).norm());
      from = *farthest;
    }
    return largest;
  }

  // Of any two points in the boxes.
  static double bound(const Node &a, const Node &b)
  {
    return (a.box.max() - b.box.min()).cwiseAbs().cwiseMax((b.box.max() - a.box.min()).cwiseAbs()).norm();
  }

  void compare(std::size_t first, std::size_t second)
  {
    const Node &a = m_nodes[first];
    const Node &b = m_nodes[second];
    if (bound(a, b) <= m_largest) {
      return;
    }
    if (a.isLeaf() && b.isLeaf()) {
      comparePoints(a, b);
    } else if (first == second) {
      compare(a.children[0], a.children[1]);
      compare(a.children[0], a.children[0]);
      compare(a.children[1], a.children[1]);
    } else {
      const bool splitFirst = b.isLeaf() || (!a.isLeaf() && a.last - a.first >= b.last - b.first);
      for (const std::size_t child : splitFirst ? a.children : b.children) {
        compare(splitFirst ? child : first, splitFirst ? second : child);
      }
    }
  }

  void comparePoints(const Node &a, const Node &b)
  {
    double largest = m_largest * m_largest;
    for (std::size_t i = a.first; i < a.last; ++i) {
      for (std::size_t j = b.first; j < b.last; ++j) {
        largest = std::max(largest, (m_points[i] - m_points[j]).squaredNorm());
      }
    }
    m_largest = std::max(m_largest, std::sqrt(largest));
  }

  std::vector<Eigen::Vector3d> m_points;
  std::vector<Node> m_nodes;
  double m_largest = 0.;
};
} // namespace

double largestDistance(const std::vector<Eigen::Vector3d> &points)
{
  return points.empty() ? 0. : FarthestPair(points).distance();
}

} // namespace programs
