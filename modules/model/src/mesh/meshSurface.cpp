// SPDX-License-Identifier: GPL-2.0-or-later
#include "meshSurface.h"

#include <visp3/core/vpMath.h>

#include <Eigen/Geometry>

#include <cmath>

BEGIN_VISP_NAMESPACE
namespace vpMeshDetail {
namespace {
std::vector<Eigen::Vector3d> triangleNormals(const std::vector<Eigen::Vector3d> &vertices, const CleanMesh &mesh)
{
  std::vector<Eigen::Vector3d> normals(mesh.triangles.size());
  for (std::size_t t = 0; t < normals.size(); ++t) {
    const IndexTriangle &corners = mesh.triangles[t];
    const Eigen::Vector3d &first = vertices[static_cast<std::size_t>(corners[0])];
    normals[t] = (vertices[static_cast<std::size_t>(corners[1])] - first)
                     .cross(vertices[static_cast<std::size_t>(corners[2])] - first)
                     .normalized();
  }
  for (std::size_t t = 0; t < normals.size(); ++t) {
    normals[t] = normals[static_cast<std::size_t>(mesh.carrier[t])];
  }
  return normals;
}

//! True where both triangles have their outside on the same side; not so along one edge of a Moebius strip.
bool windingsAgree(const CleanMesh &mesh, const MeshTopology::Edge &edge)
{
  return startOf(mesh.triangles, mesh.topology.side(edge, 0)) == endOf(mesh.triangles, mesh.topology.side(edge, 1));
}

MeshEdgeKind kindOf(const CleanMesh &mesh, const std::vector<Eigen::Vector3d> &normals, const MeshTopology::Edge &edge,
                    double smallestCosine)
{
  if (edge.sideCount != 2) {
    return edge.sideCount == 1 ? MeshEdgeKind::BORDER : MeshEdgeKind::NON_MANIFOLD;
  }
  const double cosine = normals[static_cast<std::size_t>(triangleOf(mesh.topology.side(edge, 0)))].dot(
      normals[static_cast<std::size_t>(triangleOf(mesh.topology.side(edge, 1)))]);
  const bool folded = (windingsAgree(mesh, edge) ? cosine : -cosine) < smallestCosine;
  return folded ? MeshEdgeKind::CREASE : MeshEdgeKind::SMOOTH;
}

void spreadFace(const CleanMesh &mesh, MeshSurface &surface, int seed)
{
  const int number = static_cast<int>(surface.faceCount);
  std::vector<int> waiting(1, seed);
  surface.face[static_cast<std::size_t>(seed)] = number;
  while (!waiting.empty()) {
    const int t = waiting.back();
    waiting.pop_back();
    for (int half = 3 * t; half < 3 * t + 3; ++half) {
      const int edge = mesh.topology.edgeOf(half);
      if (surface.edgeKind[static_cast<std::size_t>(edge)] != MeshEdgeKind::SMOOTH ||
          !windingsAgree(mesh, mesh.topology.edge(edge))) {
        continue;
      }
      const int next = triangleOf(mesh.topology.opposite(half));
      int &face = surface.face[static_cast<std::size_t>(next)];
      if (face < 0) {
        face = number;
        waiting.push_back(next);
      }
    }
  }
}
} // namespace

MeshSurface findSurface(const std::vector<Eigen::Vector3d> &vertices, const CleanMesh &mesh, double creaseAngle)
{
  MeshSurface surface;
  surface.normal = triangleNormals(vertices, mesh);
  surface.edgeKind.reserve(mesh.topology.edges().size());
  const double smallestCosine = std::cos(vpMath::rad(creaseAngle));
  for (const MeshTopology::Edge &edge : mesh.topology.edges()) {
    surface.edgeKind.push_back(kindOf(mesh, surface.normal, edge, smallestCosine));
  }
  surface.face.assign(mesh.triangles.size(), -1);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (surface.face[t] < 0) {
      spreadFace(mesh, surface, static_cast<int>(t));
      ++surface.faceCount;
    }
  }
  return surface;
}
} // namespace vpMeshDetail
END_VISP_NAMESPACE
