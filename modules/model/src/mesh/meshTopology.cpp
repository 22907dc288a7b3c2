// SPDX-License-Identifier: GPL-2.0-or-later
#include "meshTopology.h"

#include "groupedIndices.h"

#include <algorithm>

BEGIN_VISP_NAMESPACE
namespace vpMeshDetail {
MeshTopology::MeshTopology(const std::vector<IndexTriangle> &triangles, std::size_t vertexCount)
    : m_edgeOf(3 * triangles.size())
{
  const auto low = [&](int h) { return std::min(startOf(triangles, h), endOf(triangles, h)); };
  const auto high = [&](int h) { return std::max(startOf(triangles, h), endOf(triangles, h)); };
  GroupedIndices atVertex(vertexCount, 3 * triangles.size(), low);
  m_sides.reserve(3 * triangles.size());
  m_edges.reserve(3 * triangles.size() / 2);
  for (std::size_t v = 0; v < vertexCount; ++v) {
    std::sort(atVertex.begin(v), atVertex.end(v), [&](int a, int b) {
      const int highA = high(a);
      const int highB = high(b);
      return highA != highB ? highA < highB : a < b;
    });
    int lastHigh = -1;
    for (const int *h = atVertex.begin(v); h != atVertex.end(v); ++h) {
      if (high(*h) != lastHigh) {
        lastHigh = high(*h);
        m_edges.push_back(Edge{{{static_cast<int>(v), lastHigh}}, static_cast<int>(m_sides.size()), 0});
      }
      ++m_edges.back().sideCount;
      m_edgeOf[static_cast<std::size_t>(*h)] = static_cast<int>(m_edges.size()) - 1;
      m_sides.push_back(*h);
    }
  }
}

int MeshTopology::opposite(int halfEdge) const
{
  const Edge &shared = edge(edgeOf(halfEdge));
  if (shared.sideCount != 2) {
    return -1;
  }
  const int first = side(shared, 0);
  return first == halfEdge ? side(shared, 1) : first;
}

void MeshTopology::turnTriangles(const std::vector<char> &turned)
{
  // With corners 1 and 2 swapped, half-edges 0 and 2 take each other's place.
  for (std::size_t t = 0; t < turned.size(); ++t) {
    if (turned[t] != 0) {
      std::swap(m_edgeOf[3 * t], m_edgeOf[3 * t + 2]);
    }
  }
  for (int &half : m_sides) {
    if (turned[static_cast<std::size_t>(triangleOf(half))] != 0) {
      half = 3 * triangleOf(half) + 2 - half % 3;
    }
  }
}
} // namespace vpMeshDetail
END_VISP_NAMESPACE
