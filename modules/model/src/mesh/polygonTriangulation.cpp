// SPDX-License-Identifier: GPL-2.0-or-later
#include "polygonTriangulation.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

BEGIN_VISP_NAMESPACE
namespace vpMeshDetail {
namespace {
using Point = Eigen::Vector2d;

//! Twice the signed area of a triangle, > 0 if it is counter-clockwise.
double area2(const Point &a, const Point &b, const Point &c)
{
  return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

std::vector<Point> projectOnPlane(const std::vector<Eigen::Vector3d> &corners, const Eigen::Vector3d &normal)
{
  const Eigen::Vector3d right = normal.unitOrthogonal();
  const Eigen::Vector3d up = normal.cross(right);
  std::vector<Point> points;
  points.reserve(corners.size());
  for (const Eigen::Vector3d &corner : corners) {
    const Eigen::Vector3d fromFirst = corner - corners.front();
    points.emplace_back(right.dot(fromFirst), up.dot(fromFirst));
  }
  return points;
}

//! The corners that are left, as a ring of indices.
class EarClipper
{
public:
  explicit EarClipper(std::vector<Point> points) : m_points(std::move(points))
  {
    double extent = 0.;
    for (std::size_t i = 0; i < m_points.size(); ++i) {
      m_ring.push_back(static_cast<int>(i));
      extent = std::max(extent, m_points[i].squaredNorm());
    }
    m_flat = 1e-12 * extent;
    m_blocker.assign(m_points.size(), none);
    m_isLeft.assign(m_points.size(), 1);
  }

  std::vector<std::array<int, 3>> run()
  {
    std::vector<std::array<int, 3>> triangles;
    while (m_ring.size() >= 3) {
      const std::size_t tip = findTip();
      const std::array<int, 3> ear = {{before(tip), m_ring[tip], after(tip)}};
      if (earArea(tip) > m_flat) {
        triangles.push_back(ear);
      }
      m_isLeft[static_cast<std::size_t>(ear[1])] = 0;
      m_blocker[static_cast<std::size_t>(ear[0])] = none;
      m_blocker[static_cast<std::size_t>(ear[2])] = none;
      m_ring.erase(m_ring.begin() + static_cast<std::ptrdiff_t>(tip));
    }
    return triangles;
  }

private:
  const Point &at(int corner) const { return m_points[static_cast<std::size_t>(corner)]; }
  int before(std::size_t i) const { return m_ring[(i + m_ring.size() - 1) % m_ring.size()]; }
  int after(std::size_t i) const { return m_ring[(i + 1) % m_ring.size()]; }
  double earArea(std::size_t i) const { return area2(at(before(i)), at(m_ring[i]), at(after(i))); }

  // Flat tips come after the ears, some of which need their corner. A polygon that crosses itself may have neither:
  // then the widest corner goes, so that the loop always ends.
  std::size_t findTip()
  {
    std::size_t flat = m_ring.size();
    std::size_t widest = 0;
    double widestArea = earArea(0);
    for (std::size_t i = 0; i < m_ring.size(); ++i) {
      const double area = earArea(i);
      if (area > m_flat && isEmpty(i)) {
        return i;
      }
      if (std::abs(area) <= m_flat) {
        flat = i;
      }
      if (area > widestArea) {
        widest = i;
        widestArea = area;
      }
    }
    return flat < m_ring.size() ? flat : widest;
  }

  // What lies in an ear does so until it or one of the ear's ends is cut off: it is kept, so that the corners are
  // looked at as often as the square of their number, and not the cube.
  bool isEmpty(std::size_t tip)
  {
    int &blocker = m_blocker[static_cast<std::size_t>(m_ring[tip])];
    if (blocker == none || m_isLeft[static_cast<std::size_t>(blocker)] == 0) {
      blocker = findBlocker(tip);
    }
    return blocker == none;
  }

  int findBlocker(std::size_t tip) const
  {
    const Point &a = at(before(tip));
    const Point &b = at(m_ring[tip]);
    const Point &c = at(after(tip));
    const auto found = std::find_if(m_ring.begin(), m_ring.end(), [&](int corner) {
      const Point &p = at(corner);
      // A corner that lies on another one belongs to a bridge between an outline and its hole.
      if (p == a || p == b || p == c) {
        return false;
      }
      return area2(a, b, p) >= 0. && area2(b, c, p) >= 0. && area2(c, a, p) >= 0.;
    });
    return found == m_ring.end() ? none : *found;
  }

  static constexpr int none = -1;

  std::vector<Point> m_points;
  std::vector<int> m_ring;
  std::vector<int> m_blocker; //!< A corner in the ear of each corner, where one is known.
  std::vector<char> m_isLeft; //!< Whether each corner is in the ring.
  double m_flat = 0.;         //!< Twice the area below which three corners lie on a line.
};
} // namespace

Eigen::Vector3d newellNormal(const std::vector<Eigen::Vector3d> &corners)
{
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();
  const Eigen::Vector3d &first = corners.front();
  for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
    normal += (corners[i] - first).cross(corners[i + 1] - first);
  }
  return normal;
}

std::vector<std::array<int, 3>> triangulatePolygon(const std::vector<Eigen::Vector3d> &corners,
                                                   const Eigen::Vector3d &normal)
{
  return EarClipper(projectOnPlane(corners, normal)).run();
}
} // namespace vpMeshDetail
END_VISP_NAMESPACE
