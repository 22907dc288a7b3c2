// SPDX-License-Identifier: GPL-2.0-or-later
#include "meshWinding.h"

#include <Eigen/Geometry>

#include <algorithm>

BEGIN_VISP_NAMESPACE
namespace vpMeshDetail {
namespace {
class WindingFinder
{
public:
  WindingFinder(const std::vector<Eigen::Vector3d> &vertices, const std::vector<IndexTriangle> &triangles,
                const MeshTopology &topology)
      : m_vertices(vertices), m_triangles(triangles), m_topology(topology)
  {
    m_result.turned.assign(triangles.size(), 0);
    m_result.component.assign(triangles.size(), -1);
  }

  WindingRepair run()
  {
    std::vector<std::vector<int>> pieces;
    for (std::size_t t = 0; t < m_triangles.size(); ++t) {
      if (m_result.component[t] < 0) {
        pieces.push_back(collectPiece(static_cast<int>(t), static_cast<int>(pieces.size())));
      }
    }
    m_result.closed.assign(pieces.size(), 1);
    for (const MeshTopology::Edge &edge : m_topology.edges()) {
      openPiecesAt(edge);
    }
    for (std::size_t p = 0; p < pieces.size(); ++p) {
      if (isInsideOut(pieces[p], m_result.closed[p] != 0)) {
        turnPiece(pieces[p]);
      }
    }
    for (const char turned : m_result.turned) {
      m_result.turnedCount += turned != 0 ? 1U : 0U;
    }
    return std::move(m_result);
  }

private:
  char &turned(int triangle) { return m_result.turned[static_cast<std::size_t>(triangle)]; }
  int &component(int triangle) { return m_result.component[static_cast<std::size_t>(triangle)]; }

  //! True where the half-edge, its triangle turned or not, runs from the smaller to the larger vertex.
  bool isForward(int half)
  {
    return (startOf(m_triangles, half) < endOf(m_triangles, half)) != (turned(half / 3) != 0);
  }

  std::vector<int> collectPiece(int seed, int number)
  {
    std::vector<int> piece(1, seed);
    component(seed) = number;
    for (std::size_t i = 0; i < piece.size(); ++i) {
      for (int k = 0; k < 3; ++k) {
        const int half = 3 * piece[i] + k;
        const int other = m_topology.opposite(half);
        if (other >= 0 && component(triangleOf(other)) < 0) {
          component(triangleOf(other)) = number;
          turned(triangleOf(other)) = isForward(half) == isForward(other) ? 1 : 0;
          piece.push_back(triangleOf(other));
        }
      }
    }
    return piece;
  }

  // A piece is closed where the triangles of each of its edges cancel out; where two pieces touch along an edge, each
  // is looked at by itself. What cannot be oriented, such as a Moebius strip, does not cancel out either.
  void openPiecesAt(const MeshTopology::Edge &edge)
  {
    constexpr int believableSides = 64;
    for (int i = 0; i < edge.sideCount; ++i) {
      const int piece = component(triangleOf(m_topology.side(edge, i)));
      int balance = edge.sideCount > believableSides ? edge.sideCount + 1 : 0;
      for (int j = 0; j < std::min(edge.sideCount, believableSides); ++j) {
        const int half = m_topology.side(edge, j);
        if (component(triangleOf(half)) == piece) {
          balance += isForward(half) ? 1 : -1;
        }
      }
      if (balance != 0) {
        m_result.closed[static_cast<std::size_t>(piece)] = 0;
      }
    }
  }

  bool isInsideOut(const std::vector<int> &piece, bool closed)
  {
    const Eigen::Vector3d &origin = vertex(m_triangles[static_cast<std::size_t>(piece.front())][0]);
    double volume = 0.;
    std::size_t turnedCount = 0;
    for (const int t : piece) {
      const IndexTriangle &corners = m_triangles[static_cast<std::size_t>(t)];
      const double part =
          (vertex(corners[0]) - origin).dot((vertex(corners[1]) - origin).cross(vertex(corners[2]) - origin));
      volume += turned(t) != 0 ? -part : part;
      turnedCount += turned(t) != 0 ? 1U : 0U;
    }
    return closed ? volume < 0. : 2 * turnedCount > piece.size();
  }

  void turnPiece(const std::vector<int> &piece)
  {
    for (const int t : piece) {
      turned(t) = turned(t) != 0 ? 0 : 1;
    }
  }

  const Eigen::Vector3d &vertex(int index) const { return m_vertices[static_cast<std::size_t>(index)]; }

  const std::vector<Eigen::Vector3d> &m_vertices;
  const std::vector<IndexTriangle> &m_triangles;
  const MeshTopology &m_topology;
  WindingRepair m_result;
};
} // namespace

WindingRepair findTurnedTriangles(const std::vector<Eigen::Vector3d> &vertices,
                                  const std::vector<IndexTriangle> &triangles, const MeshTopology &topology)
{
  return WindingFinder(vertices, triangles, topology).run();
}
} // namespace vpMeshDetail
END_VISP_NAMESPACE
