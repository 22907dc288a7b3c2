// SPDX-License-Identifier: GPL-2.0-or-later
#include "meshCleaning.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <utility>

BEGIN_VISP_NAMESPACE
namespace vpMeshDetail {
namespace {
constexpr int noCarrier = -1;

const Eigen::Vector3d &at(const std::vector<Eigen::Vector3d> &vertices, int index)
{
  return vertices[static_cast<std::size_t>(index)];
}

//! Which of the sides of a triangle is the longest: k, for the one from corner k to the next.
int longestSide(const std::vector<Eigen::Vector3d> &vertices, const IndexTriangle &corners)
{
  int longest = 0;
  double length = -1.;
  for (std::size_t k = 0; k < 3; ++k) {
    const double side = (at(vertices, corners[(k + 1) % 3]) - at(vertices, corners[k])).squaredNorm();
    if (side > length) {
      length = side;
      longest = static_cast<int>(k);
    }
  }
  return longest;
}

bool isFlat(const std::vector<Eigen::Vector3d> &vertices, const IndexTriangle &corners, double tolerance)
{
  const auto k = static_cast<std::size_t>(longestSide(vertices, corners));
  const Eigen::Vector3d &start = at(vertices, corners[k]);
  const Eigen::Vector3d side = at(vertices, corners[(k + 1) % 3]) - start;
  const double area = side.cross(at(vertices, corners[(k + 2) % 3]) - start).norm();
  return !(area > tolerance * side.norm());
}

void keep(CleanMesh &mesh, const std::vector<char> &kept)
{
  std::size_t count = 0;
  for (std::size_t t = 0; t < kept.size(); ++t) {
    if (kept[t] != 0) {
      mesh.triangles[count] = mesh.triangles[t];
      mesh.source[count] = mesh.source[t];
      ++count;
    }
  }
  mesh.triangles.resize(count);
  mesh.source.resize(count);
}

void findCarriers(CleanMesh &mesh, const std::vector<Eigen::Vector3d> &vertices, double tolerance)
{
  mesh.carrier.resize(mesh.triangles.size());
  std::vector<int> slivers;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const bool flat = isFlat(vertices, mesh.triangles[t], tolerance);
    mesh.carrier[t] = flat ? noCarrier : static_cast<int>(t);
    if (flat) {
      slivers.push_back(static_cast<int>(t));
    }
  }
  // The neighbour across the longest side is in the plane that a sliver belongs to, or is a sliver with a carrier. Real
  // meshes have short rows of slivers; the limit is for broken ones.
  constexpr int longestRow = 64;
  bool changed = true;
  for (int pass = 0; pass < longestRow && changed; ++pass) {
    changed = false;
    for (const int t : slivers) {
      int &carrier = mesh.carrier[static_cast<std::size_t>(t)];
      const int longest = longestSide(vertices, mesh.triangles[static_cast<std::size_t>(t)]);
      for (int k = 0; k < 3 && carrier == noCarrier; ++k) {
        const int other = mesh.topology.opposite(3 * t + (longest + k) % 3);
        carrier = other < 0 ? noCarrier : mesh.carrier[static_cast<std::size_t>(triangleOf(other))];
        changed = changed || carrier != noCarrier;
      }
    }
    slivers.erase(std::remove_if(slivers.begin(), slivers.end(),
                                 [&](int t) { return mesh.carrier[static_cast<std::size_t>(t)] != noCarrier; }),
                  slivers.end());
  }
}

//! Marks the later ones of triangles that have the same corners; they meet at any of their edges.
std::size_t dropDuplicates(const CleanMesh &mesh, std::vector<char> &kept)
{
  std::size_t count = 0;
  std::vector<std::pair<int, int>> tips;
  for (const MeshTopology::Edge &edge : mesh.topology.edges()) {
    tips.clear();
    for (int i = 0; i < edge.sideCount; ++i) {
      const int half = mesh.topology.side(edge, i);
      tips.emplace_back(tipOf(mesh.triangles, half), triangleOf(half));
    }
    std::sort(tips.begin(), tips.end());
    for (std::size_t i = 1; i < tips.size(); ++i) {
      char &state = kept[static_cast<std::size_t>(tips[i].second)];
      if (tips[i].first == tips[i - 1].first && state != 0) {
        state = 0;
        ++count;
      }
    }
  }
  return count;
}
} // namespace

CleanMesh cleanMesh(const std::vector<Eigen::Vector3d> &vertices, const std::vector<IndexTriangle> &triangles,
                    double tolerance)
{
  CleanMesh mesh;
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    const IndexTriangle &corners = triangles[t];
    if (corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0]) {
      continue;
    }
    mesh.triangles.push_back(corners);
    mesh.source.push_back(static_cast<int>(t));
  }
  mesh.degenerate = triangles.size() - mesh.triangles.size();
  for (bool clean = false; !clean;) {
    mesh.topology = MeshTopology(mesh.triangles, vertices.size());
    findCarriers(mesh, vertices, tolerance);
    std::vector<char> kept(mesh.triangles.size(), 1);
    mesh.duplicates += dropDuplicates(mesh, kept);
    for (std::size_t t = 0; t < kept.size(); ++t) {
      if (mesh.carrier[t] == noCarrier && kept[t] != 0) {
        kept[t] = 0;
        ++mesh.degenerate;
      }
    }
    clean = std::find(kept.begin(), kept.end(), 0) == kept.end();
    keep(mesh, kept);
  }
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    mesh.degenerate += mesh.isSliver(t) ? 1U : 0U;
  }
  return mesh;
}
} // namespace vpMeshDetail
END_VISP_NAMESPACE
