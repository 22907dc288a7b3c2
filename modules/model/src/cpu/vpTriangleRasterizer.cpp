// SPDX-License-Identifier: GPL-2.0-or-later
#include "vpTriangleRasterizer.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

BEGIN_VISP_NAMESPACE

namespace {
//! A triangle cut by up to five planes, in homogeneous crop pixels.
struct Polygon
{
  std::array<Eigen::Vector3d, 8> point;
  std::size_t count = 0;

  void add(const Eigen::Vector3d &p) { point[count++] = p; }
};

//! The part of a convex polygon where the function is >= 0; it has to be linear.
template <class Function> Polygon cut(const Polygon &polygon, const Function &side)
{
  Polygon kept;
  for (std::size_t i = 0; i < polygon.count; ++i) {
    const Eigen::Vector3d &p = polygon.point[i];
    const Eigen::Vector3d &q = polygon.point[(i + 1) % polygon.count];
    const double atP = side(p);
    const double atQ = side(q);
    if (atP >= 0) {
      kept.add(p);
    }
    // Always from the point inside, so that two triangles that share the edge get the same corner.
    if (atP >= 0 && atQ < 0) {
      kept.add(p + (q - p) * (atP / (atP - atQ)));
    } else if (atP < 0 && atQ >= 0) {
      kept.add(q + (p - q) * (atQ / (atQ - atP)));
    }
  }
  return kept;
}

//! True where the corners go counterclockwise around the normals, of a face whose back is never seen.
bool hasBack(const vpTrackedModel &model, const vpModelTriangle &triangle)
{
  const vpModelFace &face = model.faces()[static_cast<std::size_t>(triangle.face)];
  if (!face.oriented) {
    return false;
  }
  const auto corner = [&](std::size_t k) { return model.vertices()[static_cast<std::size_t>(triangle.vertex[k])]; };
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();
  for (const int index : triangle.normal) {
    normal += index < 0 ? face.normal : model.normals()[static_cast<std::size_t>(index)];
  }
  return (corner(1) - corner(0)).cross(corner(2) - corner(0)).dot(normal) > 0.;
}

//! Cuts away what is before the near plane, and what is so far outside the crop that integers would overflow.
Polygon clip(Polygon polygon, double nearDistance)
{
  // A little inside the limit, so that rounding leaves no corner outside.
  constexpr double limit = vpScreenVertex::limit - 1.;
  polygon = cut(polygon, [nearDistance](const Eigen::Vector3d &p) { return p.z() - nearDistance; });
  polygon = cut(polygon, [](const Eigen::Vector3d &p) { return limit * p.z() + p.x(); });
  polygon = cut(polygon, [](const Eigen::Vector3d &p) { return limit * p.z() - p.x(); });
  polygon = cut(polygon, [](const Eigen::Vector3d &p) { return limit * p.z() + p.y(); });
  return cut(polygon, [](const Eigen::Vector3d &p) { return limit * p.z() - p.y(); });
}
} // namespace

vpTriangleRasterizer::vpTriangleRasterizer(const vpTrackedModel &model)
    : m_positions(model.vertices()), m_vertices(model.vertices().size())
{
  m_triangles.reserve(model.triangles().size());
  m_hasBack.reserve(model.triangles().size());
  for (const vpModelTriangle &triangle : model.triangles()) {
    m_triangles.push_back(triangle.vertex);
    m_hasBack.push_back(model.report().closed && hasBack(model, triangle) ? 1 : 0);
  }
}

vpTriangleRasterizer::Vertex vpTriangleRasterizer::project(const Eigen::Vector3d &image) const
{
  constexpr double limit = vpScreenVertex::limit;
  const bool before = image.z() < m_near;
  const double inverse = 1. / (before ? m_near : image.z());
  const double x = std::clamp(image.x() * inverse, -limit, limit);
  const double y = std::clamp(image.y() * inverse, -limit, limit);
  return {vpScreenVertex(x, y, inverse), !before && std::abs(x) < limit && std::abs(y) < limit};
}

void vpTriangleRasterizer::draw(const vpHomogeneousMatrix &cMo, const vpCropCamera &camera, double nearDistance,
                                const vpFillTarget &target)
{
  Eigen::Matrix3d intrinsics;
  intrinsics << camera.fx, 0., camera.cx, 0., camera.fy, camera.cy, 0., 0., 1.;
  m_projection = intrinsics * vpToPoseMatrix(cMo);
  m_near = nearDistance;
  m_isWhole = true;
  for (std::size_t i = 0; i < m_positions.size(); ++i) {
    const Eigen::Vector3d image = vpTransform(m_projection, m_positions[i]);
    m_isWhole = m_isWhole && image.z() >= nearDistance;
    m_vertices[i] = project(image);
  }
  if (target.triangle) {
    drawAll<true>(target);
  } else {
    drawAll<false>(target);
  }
}

template <bool WithTriangle> void vpTriangleRasterizer::drawAll(const vpFillTarget &target) const
{
  for (std::size_t i = 0; i < m_triangles.size(); ++i) {
    const Corners &corners = m_triangles[i];
    const Vertex &a = m_vertices[static_cast<std::size_t>(corners[0])];
    const Vertex &b = m_vertices[static_cast<std::size_t>(corners[1])];
    const Vertex &c = m_vertices[static_cast<std::size_t>(corners[2])];
    if (m_isWhole && m_hasBack[i] != 0 && isFromBehind(a.screen, b.screen, c.screen)) {
      continue;
    }
    if (a.drawable && b.drawable && c.drawable) {
      if (isBetweenPixels(a.screen, b.screen, c.screen)) {
        continue;
      }
      vpFillTriangle<WithTriangle>(a.screen, b.screen, c.screen, static_cast<int>(i), target);
    } else {
      drawClipped<WithTriangle>(corners, static_cast<int>(i), target);
    }
  }
}

template <bool WithTriangle>
void vpTriangleRasterizer::drawClipped(const Corners &corners, int index, const vpFillTarget &target) const
{
  Polygon polygon;
  for (const int corner : corners) {
    polygon.add(vpTransform(m_projection, m_positions[static_cast<std::size_t>(corner)]));
  }
  polygon = clip(polygon, m_near);
  std::array<Vertex, 8> vertices;
  for (std::size_t i = 0; i < polygon.count; ++i) {
    vertices[i] = project(polygon.point[i]);
  }
  for (std::size_t i = 2; i < polygon.count; ++i) {
    vpFillTriangle<WithTriangle>(vertices[0].screen, vertices[i - 1].screen, vertices[i].screen, index, target);
  }
}

END_VISP_NAMESPACE
