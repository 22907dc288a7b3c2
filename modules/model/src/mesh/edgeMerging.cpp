// SPDX-License-Identifier: GPL-2.0-or-later
#include "edgeMerging.h"

#include "groupedIndices.h"

#include <algorithm>
#include <utility>

BEGIN_VISP_NAMESPACE
namespace vpMeshDetail {
namespace {
// A vertex may be left out if it is closer to the line than this share of the joined edge's length.
constexpr double straightness = 1e-4;
// Edges that form a larger angle are never on one line; cosine of 1 degree.
constexpr double followingCosine = 0.99984769515639127;

class EdgeMerger
{
public:
  EdgeMerger(const std::vector<Eigen::Vector3d> &vertices, const std::vector<int> &edgeFaces,
             const std::vector<vpModelEdge> &edges)
      : m_vertices(vertices), m_edgeFaces(edgeFaces), m_edges(edges),
        m_atVertex(vertices.size(), 2 * edges.size(), [this](int end) { return vertexAt(end); }),
        m_used(edges.size(), 0)
  {
  }

  std::vector<vpModelEdge> run()
  {
    for (std::size_t e = 0; e < m_edges.size(); ++e) {
      if (m_used[e] != 0) {
        continue;
      }
      m_used[e] = 1;
      std::vector<int> path = follow(static_cast<int>(2 * e));
      std::reverse(path.begin(), path.end());
      const std::vector<int> forward = follow(static_cast<int>(2 * e + 1));
      path.insert(path.end(), forward.begin(), forward.end());
      addStraightParts(path, m_edges[e]);
    }
    return std::move(m_merged);
  }

private:
  //! The ends of edge e are numbered 2 e and 2 e + 1.
  int vertexAt(int end) const
  {
    return m_edges[static_cast<std::size_t>(end / 2)].vertex[static_cast<std::size_t>(end % 2)];
  }

  const Eigen::Vector3d &position(int vertex) const { return m_vertices[static_cast<std::size_t>(vertex)]; }

  //! Unit vector from an end of an edge to its other end.
  Eigen::Vector3d directionFrom(int end) const
  {
    return (position(vertexAt(end ^ 1)) - position(vertexAt(end))).normalized();
  }

  bool haveSameFaces(const vpModelEdge &a, const vpModelEdge &b) const
  {
    return a.faceCount == b.faceCount &&
           std::equal(m_edgeFaces.begin() + a.firstFace, m_edgeFaces.begin() + a.firstFace + a.faceCount,
                      m_edgeFaces.begin() + b.firstFace);
  }

  //! The end, at the same vertex, of the only edge that can continue an edge beyond one of its ends; -1 for none.
  int continuation(int end) const
  {
    const auto v = static_cast<std::size_t>(vertexAt(end));
    const Eigen::Vector3d direction = directionFrom(end);
    int found = -1;
    for (const int *other = m_atVertex.begin(v); other != m_atVertex.end(v); ++other) {
      if (*other == end || direction.dot(directionFrom(*other)) > -followingCosine ||
          !haveSameFaces(m_edges[static_cast<std::size_t>(end / 2)], m_edges[static_cast<std::size_t>(*other / 2)])) {
        continue;
      }
      if (found >= 0) {
        return -1;
      }
      found = *other;
    }
    return found;
  }

  //! Vertices from an end of an edge onwards, that end included.
  std::vector<int> follow(int end)
  {
    std::vector<int> path(1, vertexAt(end));
    for (int next = continuation(end); next >= 0; next = continuation(end)) {
      char &used = m_used[static_cast<std::size_t>(next / 2)];
      if (used != 0 || continuation(next) != end) {
        break;
      }
      used = 1;
      end = next ^ 1;
      path.push_back(vertexAt(end));
    }
    return path;
  }

  void addStraightParts(const std::vector<int> &path, const vpModelEdge &like)
  {
    std::vector<std::pair<std::size_t, std::size_t>> parts(1, {0, path.size() - 1});
    while (!parts.empty()) {
      const std::pair<std::size_t, std::size_t> part = parts.back();
      parts.pop_back();
      const std::size_t corner = farthestFromLine(path, part.first, part.second);
      if (corner == part.first) {
        m_merged.push_back(like);
        m_merged.back().vertex = {{path[part.first], path[part.second]}};
      } else {
        parts.emplace_back(corner, part.second);
        parts.emplace_back(part.first, corner);
      }
    }
  }

  //! Place of the vertex that is farthest from the line between two others, \e first if all are close enough.
  std::size_t farthestFromLine(const std::vector<int> &path, std::size_t first, std::size_t last) const
  {
    const Eigen::Vector3d &start = position(path[first]);
    const Eigen::Vector3d chord = position(path[last]) - start;
    const Eigen::Vector3d direction = chord.stableNormalized();
    double largest = straightness * chord.norm();
    std::size_t farthest = first;
    for (std::size_t i = first + 1; i < last; ++i) {
      const Eigen::Vector3d fromStart = position(path[i]) - start;
      const double distance = (fromStart - direction.dot(fromStart) * direction).norm();
      if (distance > largest) {
        largest = distance;
        farthest = i;
      }
    }
    return farthest;
  }

  const std::vector<Eigen::Vector3d> &m_vertices;
  const std::vector<int> &m_edgeFaces;
  const std::vector<vpModelEdge> &m_edges;
  GroupedIndices m_atVertex;
  std::vector<char> m_used;
  std::vector<vpModelEdge> m_merged;
};
} // namespace

std::vector<vpModelEdge> mergeStraightEdges(const std::vector<Eigen::Vector3d> &vertices,
                                            const std::vector<int> &edgeFaces, const std::vector<vpModelEdge> &edges)
{
  return EdgeMerger(vertices, edgeFaces, edges).run();
}
} // namespace vpMeshDetail
END_VISP_NAMESPACE
