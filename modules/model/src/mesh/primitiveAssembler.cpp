// SPDX-License-Identifier: GPL-2.0-or-later
#include "primitiveAssembler.h"

#include "polygonTriangulation.h"

#include <algorithm>

BEGIN_VISP_NAMESPACE
namespace vpMeshDetail {
namespace {
void dropRepeatedCorners(std::vector<int> &corners)
{
  corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
  while (corners.size() > 1 && corners.front() == corners.back()) {
    corners.pop_back();
  }
}

double perimeter(const std::vector<Eigen::Vector3d> &corners)
{
  double length = (corners.front() - corners.back()).norm();
  for (std::size_t i = 1; i < corners.size(); ++i) {
    length += (corners[i] - corners[i - 1]).norm();
  }
  return length;
}

Eigen::Vector3d mean(const std::vector<Eigen::Vector3d> &points)
{
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d &point : points) {
    sum += point;
  }
  return sum / static_cast<double>(points.size());
}
} // namespace

PrimitiveAssembler::PrimitiveAssembler(ModelParts &parts, VertexPool &pool) : m_parts(parts), m_pool(pool)
{
}

int PrimitiveAssembler::addNamedFace(const Label &label)
{
  vpModelFace face;
  face.name = label.name;
  face.polygon = label.polygon;
  m_parts.faces.push_back(face);
  return lastIndex(m_parts.faces);
}

PolygonEdge &PrimitiveAssembler::edgeBetween(int a, int b)
{
  const std::array<int, 2> vertex = {{std::min(a, b), std::max(a, b)}};
  const std::uint64_t key = (static_cast<std::uint64_t>(vertex[0]) << 32U) | static_cast<std::uint64_t>(vertex[1]);
  const auto found = m_edgeAt.emplace(key, m_edges.size());
  if (found.second) {
    m_edges.emplace_back();
    m_edges.back().vertex = vertex;
  }
  return m_edges[found.first->second];
}

void PrimitiveAssembler::addFace(const std::vector<Eigen::Vector3d> &points, const Label &label, bool closed)
{
  std::vector<int> corners;
  for (const Eigen::Vector3d &point : points) {
    corners.push_back(m_pool.add(point));
  }
  // Where the last corners fall on the first one, the closing edge is the one that leads there.
  closed = closed || corners.front() == corners.back();
  dropRepeatedCorners(corners);
  const Eigen::Vector3d normal = newellNormal(points);
  const double width = 2. * normal.norm() / std::max(perimeter(points), m_pool.tolerance());
  const double smallestWidth = std::max(m_pool.tolerance(), 1e-12 * perimeter(points));
  if (corners.size() < 3 || !(width > smallestWidth)) {
    addOutline(corners, closed, label);
  } else {
    addSurface(corners, normal.normalized(), closed, label);
  }
}

void PrimitiveAssembler::addSurface(const std::vector<int> &corners, const Eigen::Vector3d &normal, bool closed,
                                    const Label &label)
{
  const int index = addNamedFace(label);
  std::vector<Eigen::Vector3d> points;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    points.push_back(m_parts.vertices[static_cast<std::size_t>(corners[i])]);
    const int next = corners[(i + 1) % corners.size()];
    PolygonEdge &edge = edgeBetween(corners[i], next);
    edge.side.emplace_back(index, corners[i] < next);
    if (closed || i + 1 < corners.size()) {
      edge.trackedFor.push_back(index);
    }
  }
  vpModelFace &face = m_parts.faces.back();
  face.normal = normal;
  face.centre = mean(points);
  face.corners = corners;
  m_parts.normals.push_back(normal);
  for (const std::array<int, 3> &ear : triangulatePolygon(points, normal)) {
    vpModelTriangle triangle;
    for (std::size_t k = 0; k < 3; ++k) {
      triangle.vertex[k] = corners[static_cast<std::size_t>(ear[k])];
      triangle.normal[k] = lastIndex(m_parts.normals);
    }
    triangle.face = index;
    m_parts.triangles.push_back(triangle);
  }
}

// A polygon without area has no side to be seen from: what is left of it are lines.
void PrimitiveAssembler::addOutline(const std::vector<int> &corners, bool closed, const Label &label)
{
  if (corners.size() < 2) {
    return;
  }
  const int index = addNamedFace(label);
  m_parts.faces.back().planar = false;
  m_parts.faces.back().oriented = false;
  m_parts.faces.back().corners = corners;
  const std::size_t count = closed && corners.size() > 2 ? corners.size() : corners.size() - 1;
  for (std::size_t i = 0; i < count; ++i) {
    edgeBetween(corners[i], corners[(i + 1) % corners.size()]).line = index;
  }
}

void PrimitiveAssembler::addLine(const Eigen::Vector3d &start, const Eigen::Vector3d &end, const Label &label)
{
  const std::vector<int> corners = {m_pool.add(start), m_pool.add(end)};
  if (corners.front() != corners.back()) {
    addOutline(corners, false, label);
    edgeBetween(corners.front(), corners.back()).isLine = true;
  }
}

void PrimitiveAssembler::finish()
{
  for (PolygonEdge &edge : m_edges) {
    m_parts.report.borderEdges += edge.side.size() == 1 ? 1U : 0U;
    m_parts.report.nonManifoldEdges += edge.side.size() > 2 ? 1U : 0U;
    if (edge.trackedFor.empty() && edge.line < 0) {
      continue;
    }
    vpModelEdge tracked;
    tracked.vertex = edge.vertex;
    tracked.firstFace = static_cast<int>(m_parts.edgeFaces.size());
    if (edge.isLine || edge.trackedFor.empty()) {
      tracked.line = edge.line;
    } else {
      std::sort(edge.trackedFor.begin(), edge.trackedFor.end());
      edge.trackedFor.erase(std::unique(edge.trackedFor.begin(), edge.trackedFor.end()), edge.trackedFor.end());
      tracked.faceCount = static_cast<int>(edge.trackedFor.size());
      m_parts.edgeFaces.insert(m_parts.edgeFaces.end(), edge.trackedFor.begin(), edge.trackedFor.end());
    }
    m_parts.edges.push_back(tracked);
  }
  m_parts.report.flippedFaces += countFlippedFaces(m_edges, m_parts.faces.size());
}
} // namespace vpMeshDetail
END_VISP_NAMESPACE
