// SPDX-License-Identifier: GPL-2.0-or-later
#include "view/vpModelTopology.h"

#include "mesh/nearGroups.h"
#include "mesh/triangleCorners.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

BEGIN_VISP_NAMESPACE

namespace {
// Triangles of a patch.
const std::size_t patchSize = 64;

// Edges that turn by less than this at a common vertex are one smooth curve cut into pieces, not a corner.
const double maxTurnCosine = std::cos(35. * M_PI / 180.);

Eigen::Vector3d directionFrom(const vpTrackedModel &model, int edge, int vertex)
{
  const vpModelEdge &e = model.edges()[static_cast<std::size_t>(edge)];
  const int other = e.vertex[0] == vertex ? e.vertex[1] : e.vertex[0];
  return (model.vertices()[static_cast<std::size_t>(other)] - model.vertices()[static_cast<std::size_t>(vertex)])
      .normalized();
}

// The edge that continues `edge` beyond `vertex`, -1 at a corner or a junction.
int continuation(const vpTrackedModel &model, const std::vector<int> &edgesAtVertex, int edge, int vertex)
{
  if (edgesAtVertex.size() != 2) {
    return -1;
  }
  const int next = edgesAtVertex[0] == edge ? edgesAtVertex[1] : edgesAtVertex[0];
  const double cosine = -directionFrom(model, edge, vertex).dot(directionFrom(model, next, vertex));
  return cosine > maxTurnCosine ? next : -1;
}

int otherEnd(const vpModelEdge &edge, int vertex)
{
  return edge.vertex[0] == vertex ? edge.vertex[1] : edge.vertex[0];
}

// From the line through a along unit d into the triangle with third corner c; zero where c is on the line.
Eigen::Vector3d into(const Eigen::Vector3d &a, const Eigen::Vector3d &d, const Eigen::Vector3d &c)
{
  const Eigen::Vector3d across = (c - a) - d * d.dot(c - a);
  const double length = across.norm();
  return length > 1e-9 * (c - a).norm() ? Eigen::Vector3d(across / length) : Eigen::Vector3d::Zero();
}
} // namespace

vpModelTopology::vpModelTopology(const vpTrackedModel &model)
{
  linkEdges(model);
  findSides(model);
  collectFacings(model);
  findSlopes(model);
  findPatches(model);
  joinSmoothTriangles();
}

void vpModelTopology::linkEdges(const vpTrackedModel &model)
{
  std::vector<std::vector<int>> edgesAt(model.vertices().size());
  for (std::size_t i = 0; i < model.edges().size(); ++i) {
    for (int vertex : model.edges()[i].vertex) {
      edgesAt[static_cast<std::size_t>(vertex)].push_back(static_cast<int>(i));
    }
  }
  std::vector<char> used(model.edges().size(), 0);
  m_links.reserve(model.edges().size());
  for (std::size_t i = 0; i < model.edges().size(); ++i) {
    if (!used[i]) {
      walkChain(model, static_cast<int>(i), edgesAt, used);
    }
  }
}

void vpModelTopology::walkChain(const vpTrackedModel &model, int edge, const std::vector<std::vector<int>> &edgesAt,
                                std::vector<char> &used)
{
  // Back to where the curve begins (or once around a closed one), then forward to its end.
  int start = edge;
  int vertex = model.edges()[static_cast<std::size_t>(edge)].vertex[0];
  for (int next = continuation(model, edgesAt[static_cast<std::size_t>(vertex)], start, vertex);
       next >= 0 && next != edge;
       next = continuation(model, edgesAt[static_cast<std::size_t>(vertex)], start, vertex)) {
    start = next;
    vertex = otherEnd(model.edges()[static_cast<std::size_t>(next)], vertex);
  }

  Chain chain;
  chain.first = static_cast<int>(m_links.size());
  for (int current = start; current >= 0 && !used[static_cast<std::size_t>(current)];) {
    const vpModelEdge &e = model.edges()[static_cast<std::size_t>(current)];
    used[static_cast<std::size_t>(current)] = 1;
    Link link;
    link.edge = current;
    link.reversed = e.vertex[0] != vertex;
    m_links.push_back(link);
    vertex = otherEnd(e, vertex);
    current = continuation(model, edgesAt[static_cast<std::size_t>(vertex)], current, vertex);
  }
  chain.count = static_cast<int>(m_links.size()) - chain.first;
  m_chains.push_back(chain);
}

void vpModelTopology::findSides(const vpTrackedModel &model)
{
  m_intoFace.assign(model.edgeFaces().size(), Eigen::Vector3d::Zero());
  std::vector<std::vector<int>> trianglesAt(model.vertices().size());
  for (std::size_t i = 0; i < model.triangles().size(); ++i) {
    for (int vertex : model.triangles()[i].vertex) {
      trianglesAt[static_cast<std::size_t>(vertex)].push_back(static_cast<int>(i));
    }
  }

  for (const vpModelEdge &edge : model.edges()) {
    const Eigen::Vector3d &a = model.vertices()[static_cast<std::size_t>(edge.vertex[0])];
    const Eigen::Vector3d d = directionFrom(model, static_cast<int>(&edge - model.edges().data()), edge.vertex[0]);
    for (int index : trianglesAt[static_cast<std::size_t>(edge.vertex[0])]) {
      const vpModelTriangle &triangle = model.triangles()[static_cast<std::size_t>(index)];
      for (int slot = edge.firstFace; slot < edge.firstFace + edge.faceCount; ++slot) {
        if (model.edgeFaces()[static_cast<std::size_t>(slot)] != triangle.face) {
          continue;
        }
        // A long edge may run along several triangles: one that starts at its first vertex tells the side.
        for (std::size_t k = 0; k < 3; ++k) {
          const Eigen::Vector3d &b = model.vertices()[static_cast<std::size_t>(triangle.vertex[k])];
          const Eigen::Vector3d &c = model.vertices()[static_cast<std::size_t>(triangle.vertex[(k + 1) % 3])];
          const Eigen::Vector3d &e = model.vertices()[static_cast<std::size_t>(triangle.vertex[(k + 2) % 3])];
          const bool first = triangle.vertex[k] == edge.vertex[0];
          const bool second = triangle.vertex[(k + 1) % 3] == edge.vertex[0];
          if ((first && (c - b).normalized().dot(d) > 1. - 1e-9) ||
              (second && (b - c).normalized().dot(d) > 1. - 1e-9)) {
            m_intoFace[static_cast<std::size_t>(slot)] = into(a, d, e);
          }
        }
      }
    }
  }
}

void vpModelTopology::collectFacings(const vpTrackedModel &model)
{
  std::vector<int> index(model.normals().size(), -1);
  m_facingCorners.resize(model.smoothTriangles().size());
  for (std::size_t i = 0; i < m_facingCorners.size(); ++i) {
    const vpModelTriangle &triangle = model.triangles()[static_cast<std::size_t>(model.smoothTriangles()[i])];
    for (std::size_t k = 0; k < 3; ++k) {
      int &facing = index[static_cast<std::size_t>(triangle.normal[k])];
      if (facing < 0) {
        facing = static_cast<int>(m_facings.x.size());
        const Eigen::Vector3d &normal = model.normals()[static_cast<std::size_t>(triangle.normal[k])];
        const Eigen::Vector3d &vertex = model.vertices()[static_cast<std::size_t>(triangle.vertex[k])];
        m_facings.x.push_back(static_cast<float>(normal.x()));
        m_facings.y.push_back(static_cast<float>(normal.y()));
        m_facings.z.push_back(static_cast<float>(normal.z()));
        m_facings.offset.push_back(static_cast<float>(normal.dot(vertex)));
      }
      m_facingCorners[i][k] = facing;
    }
  }
}

void vpModelTopology::findSlopes(const vpTrackedModel &model)
{
  m_slopes.reserve(model.smoothTriangles().size());
  for (const int index : model.smoothTriangles()) {
    const vpModelTriangle &triangle = model.triangles()[static_cast<std::size_t>(index)];
    const Eigen::Vector3d &a = vpMeshDetail::corner(model, triangle, 0);
    const Eigen::Vector3d e1 = vpMeshDetail::corner(model, triangle, 1) - a;
    const Eigen::Vector3d e2 = vpMeshDetail::corner(model, triangle, 2) - a;
    const Eigen::Vector3d normal = vpMeshDetail::normalOf(model, triangle);
    const bool oriented = model.faces()[static_cast<std::size_t>(triangle.face)].oriented;
    m_slopes.push_back({a, {{e2.cross(normal), normal.cross(e1)}}, oriented});
  }
}

void vpModelTopology::findPatches(const vpTrackedModel &model)
{
  std::vector<Eigen::Vector3d> places;
  places.reserve(m_slopes.size());
  for (const Slope &slope : m_slopes) {
    places.push_back(slope.corner);
  }
  const vpMeshDetail::NearGroups groups = vpMeshDetail::findNearGroups(places, patchSize);
  m_patches.resize(groups.size());
  for (std::size_t i = 0; i < groups.size(); ++i) {
    std::vector<Eigen::Vector3d> points;
    std::vector<Eigen::Vector3d> normals;
    for (std::size_t k = groups.start[i]; k < groups.start[i + 1]; ++k) {
      const int index = model.smoothTriangles()[groups.order[k]];
      const vpModelTriangle &triangle = model.triangles()[static_cast<std::size_t>(index)];
      m_patches[i].triangles.push_back(static_cast<int>(groups.order[k]));
      for (std::size_t corner = 0; corner < 3; ++corner) {
        points.push_back(vpMeshDetail::corner(model, triangle, corner));
        normals.push_back(model.normals()[static_cast<std::size_t>(triangle.normal[corner])]);
      }
    }
    m_patches[i].normals = vpMeshDetail::NormalCone(points, normals);
  }
}

void vpModelTopology::joinSmoothTriangles()
{
  struct Side
  {
    std::size_t triangle;
    std::size_t corner;
  };
  m_neighbours.assign(m_facingCorners.size(), std::array<int, 3>{{-1, -1, -1}});
  std::unordered_map<std::uint64_t, Side> open;
  open.reserve(m_facingCorners.size() * 2);
  for (std::size_t i = 0; i < m_facingCorners.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      const auto ends = std::minmax(m_facingCorners[i][k], m_facingCorners[i][(k + 1) % 3]);
      const std::uint64_t key =
          (static_cast<std::uint64_t>(ends.first) << 32) | static_cast<std::uint64_t>(ends.second);
      const auto found = open.find(key);
      if (found == open.end()) {
        open[key] = Side{i, k};
        continue;
      }
      m_neighbours[i][k] = static_cast<int>(found->second.triangle);
      m_neighbours[found->second.triangle][found->second.corner] = static_cast<int>(i);
      open.erase(found);
    }
  }
}

END_VISP_NAMESPACE
