// SPDX-License-Identifier: GPL-2.0-or-later
#include "meshAssembler.h"

#include "edgeMerging.h"
#include "meshSurface.h"
#include "meshWinding.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

BEGIN_VISP_NAMESPACE
namespace vpMeshDetail {
namespace {
// A face is planar if its triangles' normals are this close to their mean; cosine of 1 degree.
constexpr double planarCosine = 0.99984769515639127;

class MeshAssembler
{
public:
  MeshAssembler(ModelParts &parts, const WeldedSoup &soup, const vpModelAppearance &appearance)
      : m_parts(parts), m_soup(soup), m_appearance(appearance), m_firstFace(static_cast<int>(parts.faces.size())),
        m_mesh(cleanMesh(parts.vertices, soup.triangles, soup.tolerance)),
        m_winding(findTurnedTriangles(parts.vertices, m_mesh.triangles, m_mesh.topology))
  {
    for (std::size_t t = 0; t < m_mesh.triangles.size(); ++t) {
      if (m_winding.turned[t] != 0) {
        std::swap(m_mesh.triangles[t][1], m_mesh.triangles[t][2]);
      }
    }
    m_mesh.topology.turnTriangles(m_winding.turned);
    m_surface = findSurface(parts.vertices, m_mesh, soup.creaseAngle);
  }

  void run()
  {
    addFaces();
    addTriangles();
    addEdges();
    m_parts.report.degenerateTriangles += m_mesh.degenerate;
    m_parts.report.duplicateTriangles += m_mesh.duplicates;
    m_parts.report.flippedTriangles += m_winding.turnedCount;
  }

private:
  struct Moments
  {
    double area = 0.;
    Eigen::Vector3d normal = Eigen::Vector3d::Zero();
    Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  };

  std::size_t faceOf(std::size_t triangle) const { return static_cast<std::size_t>(m_surface.face[triangle]); }

  Eigen::Vector3d corner(std::size_t triangle, std::size_t k) const
  {
    return m_parts.vertices[static_cast<std::size_t>(m_mesh.triangles[triangle][k])];
  }

  std::vector<Moments> faceMoments() const
  {
    std::vector<Moments> moments(m_surface.faceCount);
    for (std::size_t t = 0; t < m_mesh.triangles.size(); ++t) {
      if (m_mesh.isSliver(t)) {
        continue;
      }
      const Eigen::Vector3d a = corner(t, 0);
      const Eigen::Vector3d b = corner(t, 1);
      const Eigen::Vector3d c = corner(t, 2);
      const double area = 0.5 * (b - a).cross(c - a).norm();
      Moments &face = moments[faceOf(t)];
      face.area += area;
      face.normal += area * m_surface.normal[t];
      face.centre += area / 3. * (a + b + c);
    }
    return moments;
  }

  void addFaces()
  {
    for (const Moments &moments : faceMoments()) {
      vpModelFace face;
      face.normal = moments.normal.stableNormalized();
      face.centre = moments.centre / moments.area;
      m_parts.faces.push_back(face);
    }
    for (std::size_t t = 0; t < m_mesh.triangles.size(); ++t) {
      vpModelFace &face = m_parts.faces[static_cast<std::size_t>(m_firstFace) + faceOf(t)];
      face.planar = face.planar && m_surface.normal[t].dot(face.normal) >= planarCosine;
      face.oriented = m_winding.closed[static_cast<std::size_t>(m_winding.component[t])] != 0;
    }
  }

  void addTriangles()
  {
    const CornerNormals normals = findCornerNormals(m_parts.vertices, m_mesh, m_surface);
    const int firstNormal = static_cast<int>(m_parts.normals.size());
    m_parts.normals.insert(m_parts.normals.end(), normals.normal.begin(), normals.normal.end());
    m_parts.triangles.reserve(m_parts.triangles.size() + m_mesh.triangles.size());
    padAppearance();
    for (std::size_t t = 0; t < m_mesh.triangles.size(); ++t) {
      if (m_mesh.isSliver(t)) {
        continue;
      }
      vpModelTriangle triangle;
      triangle.vertex = m_mesh.triangles[t];
      for (std::size_t k = 0; k < 3; ++k) {
        triangle.normal[k] = firstNormal + normals.index[3 * t + k];
      }
      triangle.face = m_firstFace + m_surface.face[t];
      m_parts.triangles.push_back(triangle);
      addAppearance(t);
      if (!m_parts.faces[static_cast<std::size_t>(triangle.face)].planar) {
        m_parts.smoothTriangles.push_back(lastIndex(m_parts.triangles));
      }
    }
  }

  //! Triangles of primitives, which came first, have neither colour nor texture.
  void padAppearance()
  {
    vpModelAppearance &all = m_parts.appearance;
    const std::size_t count = m_parts.triangles.size();
    if (!m_appearance.color.empty()) {
      const Eigen::Vector3f gray = vpTrackedModelBuilder::Corner().color;
      all.color.assign(count, {{gray, gray, gray}});
    }
    if (!m_appearance.image.empty()) {
      const Eigen::Vector2f zero = Eigen::Vector2f::Zero();
      all.texture.assign(count, {{zero, zero, zero}});
      all.image.assign(count, -1);
      all.images = m_appearance.images;
    }
  }

  void addAppearance(std::size_t triangle)
  {
    const auto source = static_cast<std::size_t>(m_mesh.source[triangle]);
    const bool turned = m_winding.turned[triangle] != 0;
    vpModelAppearance &all = m_parts.appearance;
    if (!m_appearance.color.empty()) {
      all.color.push_back(m_appearance.color[source]);
      if (turned) {
        std::swap(all.color.back()[1], all.color.back()[2]);
      }
    }
    if (!m_appearance.image.empty()) {
      all.image.push_back(m_appearance.image[source]);
      all.texture.push_back(m_appearance.texture[source]);
      if (turned) {
        std::swap(all.texture.back()[1], all.texture.back()[2]);
      }
    }
  }

  //! Appends the faces on the sides of an edge of the mesh to \e faces, each once.
  void appendFaces(const MeshTopology::Edge &edge, std::vector<int> &faces) const
  {
    const auto first = static_cast<std::ptrdiff_t>(faces.size());
    for (int i = 0; i < edge.sideCount; ++i) {
      const int triangle = triangleOf(m_mesh.topology.side(edge, i));
      faces.push_back(m_firstFace + m_surface.face[static_cast<std::size_t>(triangle)]);
    }
    std::sort(faces.begin() + first, faces.end());
    faces.erase(std::unique(faces.begin() + first, faces.end()), faces.end());
  }

  void addEdges()
  {
    const MeshBorders borders = findBorders(m_parts.vertices, m_mesh.topology, m_soup.smallestLoop);
    m_parts.report.holes += borders.loops;
    std::vector<vpModelEdge> edges;
    std::vector<int> edgeFaces;
    for (std::size_t e = 0; e < m_mesh.topology.edges().size(); ++e) {
      const MeshTopology::Edge &edge = m_mesh.topology.edges()[e];
      m_parts.report.borderEdges += edge.sideCount == 1 ? 1U : 0U;
      m_parts.report.nonManifoldEdges += edge.sideCount > 2 ? 1U : 0U;
      if (m_surface.edgeKind[e] != MeshEdgeKind::SMOOTH && borders.small[e] == 0) {
        vpModelEdge tracked;
        tracked.vertex = edge.vertex;
        tracked.firstFace = static_cast<int>(edgeFaces.size());
        appendFaces(edge, edgeFaces);
        tracked.faceCount = static_cast<int>(edgeFaces.size()) - tracked.firstFace;
        edges.push_back(tracked);
      }
    }
    for (vpModelEdge edge : mergeStraightEdges(m_parts.vertices, edgeFaces, edges)) {
      const auto first = edgeFaces.begin() + edge.firstFace;
      edge.firstFace = static_cast<int>(m_parts.edgeFaces.size());
      m_parts.edgeFaces.insert(m_parts.edgeFaces.end(), first, first + edge.faceCount);
      m_parts.edges.push_back(edge);
    }
  }

  ModelParts &m_parts;
  const WeldedSoup &m_soup;
  const vpModelAppearance &m_appearance;
  int m_firstFace;
  CleanMesh m_mesh;
  WindingRepair m_winding;
  MeshSurface m_surface;
};
} // namespace

void addMesh(ModelParts &parts, const WeldedSoup &soup, const vpModelAppearance &appearance)
{
  MeshAssembler(parts, soup, appearance).run();
}
} // namespace vpMeshDetail
END_VISP_NAMESPACE
