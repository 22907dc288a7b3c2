// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef polygonTriangulation_h
#define polygonTriangulation_h

#include <visp3/se3/vpCompatibility.h>

#include <Eigen/Core>

#include <array>
#include <vector>

BEGIN_VISP_NAMESPACE
namespace vpMeshDetail {
//! Newell's normal of a polygon: its length is twice the polygon's area, and it is right for non-convex ones too.
Eigen::Vector3d newellNormal(const std::vector<Eigen::Vector3d> &corners);

/*!
  Cuts ears off a polygon, convex or not, until nothing is left.
  \param corners In order, nearly in a plane.
  \param normal Unit normal of that plane, from whose side the corners run counter-clockwise.
  \return Triangles as indices into \e corners, counter-clockwise; none of them has its corners on one line.
*/
std::vector<std::array<int, 3>> triangulatePolygon(const std::vector<Eigen::Vector3d> &corners,
                                                   const Eigen::Vector3d &normal);
} // namespace vpMeshDetail
END_VISP_NAMESPACE
#endif
