// SPDX-License-Identifier: GPL-2.0-or-later
#include "vpTriangleClusters.h"

#include "../mesh/nearGroups.h"
#include "../mesh/triangleCorners.h"

#include <algorithm>

BEGIN_VISP_NAMESPACE

using vpMeshDetail::corner;
using vpMeshDetail::normalOf;

namespace {
//! True where the corners go counterclockwise around the normals, of a face whose back is never seen.
bool hasBack(const vpTrackedModel &model, const vpModelTriangle &triangle)
{
  const vpModelFace &face = model.faces()[static_cast<std::size_t>(triangle.face)];
  if (!model.report().closed || !face.oriented) {
    return false;
  }
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();
  for (const int index : triangle.normal) {
    normal += index < 0 ? face.normal : model.normals()[static_cast<std::size_t>(index)];
  }
  return normalOf(model, triangle).dot(normal) > 0.;
}
} // namespace

vpTriangleClusters::vpTriangleClusters(const vpTrackedModel &model)
{
  std::vector<Eigen::Vector3d> middles;
  middles.reserve(model.triangles().size());
  for (const vpModelTriangle &triangle : model.triangles()) {
    middles.push_back((corner(model, triangle, 0) + corner(model, triangle, 1) + corner(model, triangle, 2)) / 3.);
  }
  const vpMeshDetail::NearGroups groups = vpMeshDetail::findNearGroups(middles, mostTriangles);
  m_triangles.reserve(middles.size());
  for (std::size_t i = 0; i < groups.size(); ++i) {
    add(model, groups.order.data() + groups.start[i], groups.order.data() + groups.start[i + 1]);
  }
}

void vpTriangleClusters::add(const vpTrackedModel &model, const std::size_t *first, const std::size_t *last)
{
  Cluster cluster{m_x.size(), 0, m_triangles.size(), static_cast<std::size_t>(last - first), {}};
  std::vector<int> vertices;
  std::vector<Eigen::Vector3d> positions;
  std::vector<Eigen::Vector3d> normals;
  bool haveBacks = true;
  for (; first != last; ++first) {
    const vpModelTriangle &source = model.triangles()[*first];
    Triangle triangle{{}, hasBack(model, source), static_cast<int>(*first)};
    for (std::size_t k = 0; k < 3; ++k) {
      const auto known = std::find(vertices.begin(), vertices.end(), source.vertex[k]);
      triangle.corner[k] = static_cast<std::uint8_t>(known - vertices.begin());
      if (known == vertices.end()) {
        vertices.push_back(source.vertex[k]);
        positions.push_back(corner(model, source, k));
      }
    }
    m_triangles.push_back(triangle);
    normals.push_back(normalOf(model, source).normalized());
    haveBacks = haveBacks && triangle.hasBack;
  }
  for (const Eigen::Vector3d &position : positions) {
    m_x.push_back(position.x());
    m_y.push_back(position.y());
    m_z.push_back(position.z());
  }
  cluster.positions = positions.size();
  if (haveBacks) {
    cluster.backs = vpMeshDetail::NormalCone(positions, normals);
  }
  m_clusters.push_back(cluster);
}

END_VISP_NAMESPACE
