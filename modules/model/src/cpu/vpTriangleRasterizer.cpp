// SPDX-License-Identifier: GPL-2.0-or-later
#include "vpTriangleRasterizer.h"

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

//! A column or row that integers can hold.
double held(double coordinate)
{
  return std::min(std::max(coordinate, -vpScreenVertex::limit), vpScreenVertex::limit);
}
} // namespace

vpTriangleRasterizer::vpTriangleRasterizer(const vpTrackedModel &model) : m_clusters(model)
{
  for (const Eigen::Vector3d &vertex : model.vertices()) {
    m_box.add(vertex);
  }
}

void vpTriangleRasterizer::draw(const vpHomogeneousMatrix &cMo, const vpCropCamera &camera, double nearDistance,
                                const vpFillTarget &target)
{
  Eigen::Matrix3d intrinsics;
  intrinsics << camera.fx, 0., camera.cx, 0., camera.fy, camera.cy, 0., 0., 1.;
  const vpPoseMatrix pose = vpToPoseMatrix(cMo);
  m_projection = intrinsics * pose;
  m_near = nearDistance;
  m_isWhole = isWhole();
  const Eigen::Vector3d oC = -pose.leftCols<3>().transpose() * pose.col(3);
  for (const vpTriangleClusters::Cluster &cluster : m_clusters.clusters()) {
    if (m_isWhole && cluster.backs.side(oC) > 0) {
      continue;
    }
    project(cluster);
    if (target.triangle) {
      drawCluster<true>(cluster, target);
    } else {
      drawCluster<false>(cluster, target);
    }
  }
}

// What holds for the corners of the box holds for all that is in it. Rounding may not matter, hence the share and the
// pixel.
bool vpTriangleRasterizer::isWhole() const
{
  for (int corner = 0; corner < 8; ++corner) {
    const Eigen::Vector3d position((corner & 1) ? m_box.upper.x() : m_box.lower.x(),
                                   (corner & 2) ? m_box.upper.y() : m_box.lower.y(),
                                   (corner & 4) ? m_box.upper.z() : m_box.lower.z());
    const Eigen::Vector3d image = vpTransform(m_projection, position);
    const double most = (vpScreenVertex::limit - 1.) * image.z();
    if (!(image.z() > 1.001 * m_near && std::abs(image.x()) < most && std::abs(image.y()) < most)) {
      return false;
    }
  }
  return true;
}

// Plain loops, which compilers turn into vector instructions: half of the time of a fine mesh is spent here.
void vpTriangleRasterizer::project(const vpTriangleClusters::Cluster &cluster)
{
  const vpPoseMatrix projection = m_projection;
  const double nearest = m_near;
  const double *x = m_clusters.x().data() + cluster.firstPosition;
  const double *y = m_clusters.y().data() + cluster.firstPosition;
  const double *z = m_clusters.z().data() + cluster.firstPosition;
  const auto row = [&](Eigen::Index i, std::size_t k) {
    return projection(i, 0) * x[k] + projection(i, 1) * y[k] + projection(i, 2) * z[k] + projection(i, 3);
  };
  std::array<double, vpTriangleClusters::mostPositions> columns;
  std::array<double, vpTriangleClusters::mostPositions> rows;
  for (std::size_t k = 0; k < cluster.positions; ++k) {
    const double depth = row(2, k);
    const double inverse = 1. / (depth < nearest ? nearest : depth);
    m_screen.inverse[k] = inverse;
    columns[k] = held(row(0, k) * inverse);
    rows[k] = held(row(1, k) * inverse);
  }
  for (std::size_t k = 0; k < cluster.positions; ++k) {
    m_screen.x[k] = vpScreenVertex::toSubPixels(columns[k]);
    m_screen.y[k] = vpScreenVertex::toSubPixels(rows[k]);
  }
}

// False where its triangles have to be clipped first.
bool vpTriangleRasterizer::isDrawable(const vpScreenVertex &vertex) const
{
  constexpr std::int32_t limit = static_cast<std::int32_t>(vpScreenVertex::limit) * vpScreenVertex::subPixels;
  return vertex.inverse * m_near < 1. && std::abs(vertex.x) < limit && std::abs(vertex.y) < limit;
}

template <bool WithTriangle>
void vpTriangleRasterizer::drawCluster(const vpTriangleClusters::Cluster &cluster, const vpFillTarget &target) const
{
  const vpTriangleClusters::Triangle *triangle = m_clusters.triangles().data() + cluster.firstTriangle;
  const vpTriangleClusters::Triangle *end = triangle + cluster.triangles;
  for (; triangle != end; ++triangle) {
    const vpScreenVertex a = m_screen.vertex(triangle->corner[0]);
    const vpScreenVertex b = m_screen.vertex(triangle->corner[1]);
    const vpScreenVertex c = m_screen.vertex(triangle->corner[2]);
    if (m_isWhole && triangle->hasBack && isFromBehind(a, b, c)) {
      continue;
    }
    if (m_isWhole || (isDrawable(a) && isDrawable(b) && isDrawable(c))) {
      if (!isBetweenPixels(a, b, c)) {
        vpFillTriangle<WithTriangle>(a, b, c, triangle->index, target);
      }
    } else {
      drawClipped<WithTriangle>(cluster, *triangle, target);
    }
  }
}

template <bool WithTriangle>
void vpTriangleRasterizer::drawClipped(const vpTriangleClusters::Cluster &cluster,
                                       const vpTriangleClusters::Triangle &triangle, const vpFillTarget &target) const
{
  Polygon polygon;
  for (const std::uint8_t corner : triangle.corner) {
    const std::size_t i = cluster.firstPosition + corner;
    polygon.add(vpTransform(m_projection, Eigen::Vector3d(m_clusters.x()[i], m_clusters.y()[i], m_clusters.z()[i])));
  }
  polygon = clip(polygon, m_near);
  std::array<vpScreenVertex, 8> vertices;
  for (std::size_t i = 0; i < polygon.count; ++i) {
    const Eigen::Vector3d &image = polygon.point[i];
    const double inverse = 1. / std::max(image.z(), m_near);
    vertices[i] = vpScreenVertex(held(image.x() * inverse), held(image.y() * inverse), inverse);
  }
  for (std::size_t i = 2; i < polygon.count; ++i) {
    vpFillTriangle<WithTriangle>(vertices[0], vertices[i - 1], vertices[i], triangle.index, target);
  }
}

END_VISP_NAMESPACE
