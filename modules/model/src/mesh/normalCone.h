// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef normalCone_h
#define normalCone_h

#include "boundingBox.h"

#include <algorithm>
#include <cmath>
#include <vector>

BEGIN_VISP_NAMESPACE
namespace vpMeshDetail {
/*!
  A bit of surface: its points are in a sphere, its normals in a cone. Tells from few numbers that all of it faces away
  from a camera, or towards it; most bits of a fine mesh do one of them.
*/
class NormalCone
{
public:
  //! Bounds nothing: side() is 0.
  NormalCone() = default;

  //! \param normals Unit vectors.
  NormalCone(const std::vector<Eigen::Vector3d> &points, const std::vector<Eigen::Vector3d> &normals)
  {
    BoundingBox box;
    for (const Eigen::Vector3d &point : points) {
      box.add(point);
    }
    m_centre = 0.5 * (box.lower + box.upper);
    m_radius = 0.5 * box.diagonal();
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (const Eigen::Vector3d &normal : normals) {
      sum += normal;
    }
    const Eigen::Vector3d axis = sum.norm() > 0. ? sum.normalized() : sum;
    double least = normals.empty() ? -1. : 1.;
    for (const Eigen::Vector3d &normal : normals) {
      least = std::min(least, normal.dot(axis));
    }
    const double angle = std::acos(std::min(std::max(least, -1.), 1.)) + margin;
    if (angle < widest) {
      m_axis = axis;
      m_cosine = std::cos(angle);
      m_sine = std::sin(angle);
    }
  }

  //! 1 where n (p - camera) is above 0 for each point p and normal n, -1 where it is below for each, else 0.
  int side(const Eigen::Vector3d &camera) const
  {
    // The normal that is farthest from the line of sight to the middle, and the point that is farthest against it.
    const Eigen::Vector3d sight = m_centre - camera;
    const double along = m_axis.dot(sight);
    const double across = std::sqrt(std::max(sight.squaredNorm() - along * along, 0.));
    if (!(std::abs(along) * m_cosine - across * m_sine > m_radius)) {
      return 0;
    }
    return along > 0. ? 1 : -1;
  }

private:
  // What rounding turns small triangles by, and more; radians.
  static constexpr double margin = 0.02;
  static constexpr double widest = 1.5;

  Eigen::Vector3d m_centre = Eigen::Vector3d::Zero();
  Eigen::Vector3d m_axis = Eigen::Vector3d::Zero();
  double m_radius = 0.;
  double m_cosine = 0.;
  double m_sine = 1.;
};
} // namespace vpMeshDetail
END_VISP_NAMESPACE
#endif
