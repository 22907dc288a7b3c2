// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef triangleCorners_h
#define triangleCorners_h

#include <visp3/model/vpTrackedModel.h>

#include <Eigen/Geometry>

#include <cstddef>

BEGIN_VISP_NAMESPACE
namespace vpMeshDetail {
inline const Eigen::Vector3d &corner(const vpTrackedModel &model, const vpModelTriangle &triangle, std::size_t k)
{
  return model.vertices()[static_cast<std::size_t>(triangle.vertex[k])];
}

//! By the order of the corners, of twice the area's length.
inline Eigen::Vector3d normalOf(const vpTrackedModel &model, const vpModelTriangle &triangle)
{
  const Eigen::Vector3d &a = corner(model, triangle, 0);
  return (corner(model, triangle, 1) - a).cross(corner(model, triangle, 2) - a);
}
} // namespace vpMeshDetail
END_VISP_NAMESPACE
#endif
