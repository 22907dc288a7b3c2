// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef benchSurfaceNet_h
#define benchSurfaceNet_h

#include "generate/syntheticObject.h"

#include <functional>

namespace bench {

//! A closed triangle mesh.
struct SurfaceNet
{
  std::vector<Eigen::Vector3d> vertices;
  std::vector<std::array<int, 3>> triangles; //!< Counter-clockwise seen from outside.
};

/*!
  Meshes the surface where a function is zero: one vertex in each cell that the surface passes through, moved onto the
  surface, and two triangles for each edge of the grid that it cuts (S. F. F. Gibson, Constrained elastic surface nets,
  MICCAI 1998).
  \param distance Negative inside; close to a distance near the surface. Positive on the border of the box.
  \param low, high The box that is searched.
  \param cell Size of a cell.
*/
SurfaceNet makeSurfaceNet(const std::function<double(const Eigen::Vector3d &)> &distance, const Eigen::Vector3d &low,
                          const Eigen::Vector3d &high, double cell);

} // namespace bench
#endif
