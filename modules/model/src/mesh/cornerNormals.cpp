// SPDX-License-Identifier: GPL-2.0-or-later
#include "meshSurface.h"

#include "groupedIndices.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

BEGIN_VISP_NAMESPACE
namespace vpMeshDetail {
namespace {
double angleAt(const std::vector<Eigen::Vector3d> &vertices, const IndexTriangle &corners, std::size_t k)
{
  const Eigen::Vector3d &tip = vertices[static_cast<std::size_t>(corners[k])];
  const Eigen::Vector3d a = vertices[static_cast<std::size_t>(corners[(k + 1) % 3])] - tip;
  const Eigen::Vector3d b = vertices[static_cast<std::size_t>(corners[(k + 2) % 3])] - tip;
  return std::atan2(a.cross(b).norm(), a.dot(b));
}
} // namespace

CornerNormals findCornerNormals(const std::vector<Eigen::Vector3d> &vertices, const CleanMesh &mesh,
                                const MeshSurface &surface)
{
  const auto faceAt = [&](int corner) { return surface.face[static_cast<std::size_t>(corner / 3)]; };
  CornerNormals result;
  result.index.resize(3 * mesh.triangles.size());
  result.normal.reserve(vertices.size());
  GroupedIndices around(vertices.size(), result.index.size(), [&](int corner) {
    return mesh.triangles[static_cast<std::size_t>(corner / 3)][static_cast<std::size_t>(corner % 3)];
  });
  for (std::size_t v = 0; v < vertices.size(); ++v) {
    int *const end = around.end(v);
    std::sort(around.begin(v), end,
              [&](int a, int b) { return faceAt(a) != faceAt(b) ? faceAt(a) < faceAt(b) : a < b; });
    for (int *first = around.begin(v); first != end;) {
      Eigen::Vector3d sum = Eigen::Vector3d::Zero();
      int *corner = first;
      for (; corner != end && faceAt(*corner) == faceAt(*first); ++corner) {
        const auto t = static_cast<std::size_t>(*corner / 3);
        if (!mesh.isSliver(t)) {
          sum += angleAt(vertices, mesh.triangles[t], static_cast<std::size_t>(*corner % 3)) * surface.normal[t];
        }
        result.index[static_cast<std::size_t>(*corner)] = static_cast<int>(result.normal.size());
      }
      const double length = sum.norm();
      // Normals cancel out where a face folds back onto itself.
      result.normal.push_back(length > 1e-9 ? Eigen::Vector3d(sum / length)
                                            : surface.normal[static_cast<std::size_t>(*first / 3)]);
      first = corner;
    }
  }
  return result;
}
} // namespace vpMeshDetail
END_VISP_NAMESPACE
