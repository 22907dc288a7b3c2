// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef modelChecks_h
#define modelChecks_h

#include <visp3/model/vpTrackedModel.h>

#include <Eigen/Geometry>

#include <algorithm>

/*! \file modelChecks.h What tests measure on a model. */

BEGIN_VISP_NAMESPACE
namespace modelChecks {
using Point = Eigen::Vector3d;

inline const Point &corner(const vpTrackedModel &model, const vpModelTriangle &triangle, std::size_t k)
{
  return model.vertices()[static_cast<std::size_t>(triangle.vertex[k])];
}

inline const Point &cornerNormal(const vpTrackedModel &model, const vpModelTriangle &triangle, std::size_t k)
{
  return model.normals()[static_cast<std::size_t>(triangle.normal[k])];
}

//! Twice the area, in the direction of the outside that the order of the corners tells.
inline Point doubleArea(const vpTrackedModel &model, const vpModelTriangle &triangle)
{
  const Point &first = corner(model, triangle, 0);
  return (corner(model, triangle, 1) - first).cross(corner(model, triangle, 2) - first);
}

inline double surfaceArea(const vpTrackedModel &model)
{
  double area = 0.;
  for (const vpModelTriangle &triangle : model.triangles()) {
    area += 0.5 * doubleArea(model, triangle).norm();
  }
  return area;
}

//! Smallest cosine between a triangle's normal by the order of its corners, its corner normals and its face's normal.
inline double worstNormalAgreement(const vpTrackedModel &model)
{
  double worst = 1.;
  for (const vpModelTriangle &triangle : model.triangles()) {
    const Point normal = doubleArea(model, triangle).normalized();
    const vpModelFace &face = model.faces()[static_cast<std::size_t>(triangle.face)];
    worst = std::min(worst, face.planar ? normal.dot(face.normal) : 1.);
    for (std::size_t k = 0; k < 3; ++k) {
      worst = std::min(worst, normal.dot(cornerNormal(model, triangle, k)));
    }
  }
  return worst;
}

inline bool isOutwardFrom(const vpTrackedModel &model, const Point &inside)
{
  return std::all_of(model.triangles().begin(), model.triangles().end(), [&](const vpModelTriangle &triangle) {
    return doubleArea(model, triangle).dot(corner(model, triangle, 0) - inside) > 0.;
  });
}

inline double length(const vpTrackedModel &model, const vpModelEdge &edge)
{
  return (model.vertices()[static_cast<std::size_t>(edge.vertex[1])] -
          model.vertices()[static_cast<std::size_t>(edge.vertex[0])])
      .norm();
}
} // namespace modelChecks
END_VISP_NAMESPACE
#endif
