// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef meshTopology_h
#define meshTopology_h

#include <visp3/se3/vpCompatibility.h>

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <vector>

BEGIN_VISP_NAMESPACE
namespace vpMeshDetail {
//! A triangle of vertex indices.
using IndexTriangle = std::array<int, 3>;

/*!
  The edges of a set of triangles.

  A half-edge is numbered 3 * triangle + k and runs from corner k to corner k + 1 of its triangle.
*/
class MeshTopology
{
public:
  struct Edge
  {
    std::array<int, 2> vertex; //!< The smaller index first.
    int firstSide;             //!< Where its half-edges start in sides().
    int sideCount;             //!< Number of triangles that share it.
  };

  MeshTopology() = default;
  //! \param triangles Three different vertices each.
  MeshTopology(const std::vector<IndexTriangle> &triangles, std::size_t vertexCount);

  const std::vector<Edge> &edges() const { return m_edges; }
  //! Half-edges of all edges, one edge after the other.
  const std::vector<int> &sides() const { return m_sides; }
  //! Index of the edge of a half-edge.
  int edgeOf(int halfEdge) const { return m_edgeOf[static_cast<std::size_t>(halfEdge)]; }
  const Edge &edge(int index) const { return m_edges[static_cast<std::size_t>(index)]; }
  //! The i-th half-edge of an edge.
  int side(const Edge &edge, int i) const { return m_sides[static_cast<std::size_t>(edge.firstSide + i)]; }
  //! The half-edge on the other side where exactly two triangles meet, else -1.
  int opposite(int halfEdge) const;

  //! Follows the swap of corners 1 and 2 of the triangles for which \e turned is not 0.
  void turnTriangles(const std::vector<char> &turned);

private:
  std::vector<Edge> m_edges;
  std::vector<int> m_sides;
  std::vector<int> m_edgeOf;
};

inline int triangleOf(int halfEdge)
{
  return halfEdge / 3;
}

inline int startOf(const std::vector<IndexTriangle> &triangles, int halfEdge)
{
  return triangles[static_cast<std::size_t>(halfEdge / 3)][static_cast<std::size_t>(halfEdge % 3)];
}

inline int endOf(const std::vector<IndexTriangle> &triangles, int halfEdge)
{
  return triangles[static_cast<std::size_t>(halfEdge / 3)][static_cast<std::size_t>((halfEdge % 3 + 1) % 3)];
}

//! The corner that is not on the half-edge.
inline int tipOf(const std::vector<IndexTriangle> &triangles, int halfEdge)
{
  return triangles[static_cast<std::size_t>(halfEdge / 3)][static_cast<std::size_t>((halfEdge % 3 + 2) % 3)];
}
} // namespace vpMeshDetail
END_VISP_NAMESPACE
#endif
