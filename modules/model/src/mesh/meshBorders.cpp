// SPDX-License-Identifier: GPL-2.0-or-later
#include "meshSurface.h"

#include "boundingBox.h"
#include "groupedIndices.h"

BEGIN_VISP_NAMESPACE
namespace vpMeshDetail {
namespace {
class BorderWalker
{
public:
  BorderWalker(const MeshTopology &topology, std::size_t vertexCount)
      : m_topology(topology), m_border(borderEdges(topology)),
        m_atVertex(vertexCount, 2 * m_border.size(), [this](int end) { return vertexAt(end); }),
        m_walked(m_border.size(), 0)
  {
  }

  std::size_t count() const { return m_border.size(); }
  bool isWalked(std::size_t i) const { return m_walked[i] != 0; }

  //! Walks along the border from its i-th edge. \return True if the walk came back to where it started.
  bool walk(std::size_t i, std::vector<int> &edges)
  {
    edges.assign(1, m_border[i]);
    m_walked[i] = 1;
    const int start = vertexAt(static_cast<int>(2 * i));
    int end = static_cast<int>(2 * i + 1);
    while (vertexAt(end) != start) {
      const int next = nextEnd(vertexAt(end));
      if (next < 0) {
        return false;
      }
      const auto edge = static_cast<std::size_t>(next / 2);
      m_walked[edge] = 1;
      edges.push_back(m_border[edge]);
      end = next ^ 1;
    }
    return true;
  }

private:
  static std::vector<int> borderEdges(const MeshTopology &topology)
  {
    std::vector<int> border;
    for (std::size_t e = 0; e < topology.edges().size(); ++e) {
      if (topology.edges()[e].sideCount == 1) {
        border.push_back(static_cast<int>(e));
      }
    }
    return border;
  }

  //! The ends of the i-th border edge are numbered 2 i and 2 i + 1.
  int vertexAt(int end) const
  {
    return m_topology.edge(m_border[static_cast<std::size_t>(end / 2)]).vertex[static_cast<std::size_t>(end % 2)];
  }

  int nextEnd(int vertex) const
  {
    const auto v = static_cast<std::size_t>(vertex);
    for (const int *end = m_atVertex.begin(v); end != m_atVertex.end(v); ++end) {
      if (!isWalked(static_cast<std::size_t>(*end / 2))) {
        return *end;
      }
    }
    return -1;
  }

  const MeshTopology &m_topology;
  std::vector<int> m_border;
  GroupedIndices m_atVertex;
  std::vector<char> m_walked;
};
} // namespace

MeshBorders findBorders(const std::vector<Eigen::Vector3d> &vertices, const MeshTopology &topology, double smallest)
{
  MeshBorders borders;
  borders.small.assign(topology.edges().size(), 0);
  BorderWalker walker(topology, vertices.size());
  std::vector<int> edges;
  for (std::size_t i = 0; i < walker.count(); ++i) {
    if (walker.isWalked(i) || !walker.walk(i, edges)) {
      continue;
    }
    ++borders.loops;
    BoundingBox box;
    for (const int e : edges) {
      box.add(vertices[static_cast<std::size_t>(topology.edge(e).vertex[0])]);
      box.add(vertices[static_cast<std::size_t>(topology.edge(e).vertex[1])]);
    }
    if (box.diagonal() < smallest) {
      for (const int e : edges) {
        borders.small[static_cast<std::size_t>(e)] = 1;
      }
    }
  }
  return borders;
}
} // namespace vpMeshDetail
END_VISP_NAMESPACE
