// SPDX-License-Identifier: GPL-2.0-or-later
#include "vertexPool.h"

#include <algorithm>
#include <cmath>

BEGIN_VISP_NAMESPACE
namespace vpMeshDetail {
namespace {
// Cells are kept large against the tolerance, so that most points have their whole neighbourhood in one cell, and small
// against the object, so that a cell holds few points.
constexpr double smallestCell = 2e-5;

std::size_t powerOfTwoAbove(std::size_t count)
{
  std::size_t size = 64;
  while (size < count) {
    size *= 2;
  }
  return size;
}
} // namespace

VertexPool::VertexPool(const Eigen::Vector3d &lower, double diameter, double tolerance, std::size_t expected,
                       std::vector<Eigen::Vector3d> &vertices)
    : m_lower(lower), m_cellSize(std::max(2. * tolerance, smallestCell * diameter)), m_tolerance(tolerance),
      m_vertices(vertices), m_heads(powerOfTwoAbove(expected), -1)
{
}

VertexPool::Cell VertexPool::cellOf(const Eigen::Vector3d &point) const
{
  const Eigen::Vector3d cell = (point - m_lower) / m_cellSize;
  return {{static_cast<std::int64_t>(std::floor(cell.x())), static_cast<std::int64_t>(std::floor(cell.y())),
           static_cast<std::int64_t>(std::floor(cell.z()))}};
}

std::size_t VertexPool::bucketOf(const Cell &cell) const
{
  std::uint64_t hash = 0;
  for (const std::int64_t c : cell) {
    hash = (hash ^ static_cast<std::uint64_t>(c)) * 0x9e3779b97f4a7c15ULL;
    hash ^= hash >> 32U;
  }
  return static_cast<std::size_t>(hash) & (m_heads.size() - 1);
}

int VertexPool::add(const Eigen::Vector3d &point)
{
  const std::size_t bucket = bucketOf(cellOf(point));
  for (int e = m_heads[bucket]; e >= 0; e = m_entries[static_cast<std::size_t>(e)].next) {
    const Entry &entry = m_entries[static_cast<std::size_t>(e)];
    if (entry.position == point) {
      return entry.vertex;
    }
  }
  int vertex = nearestVertex(point);
  if (vertex >= 0) {
    ++m_welded;
  } else {
    vertex = addApart(point);
  }
  m_entries.push_back(Entry{point, vertex, m_heads[bucket]});
  m_heads[bucket] = static_cast<int>(m_entries.size()) - 1;
  return vertex;
}

int VertexPool::addApart(const Eigen::Vector3d &point)
{
  m_vertices.push_back(point);
  return static_cast<int>(m_vertices.size()) - 1;
}

int VertexPool::nearestVertex(const Eigen::Vector3d &point) const
{
  const Cell low = cellOf(point - Eigen::Vector3d::Constant(m_tolerance));
  const Cell high = cellOf(point + Eigen::Vector3d::Constant(m_tolerance));
  int nearest = -1;
  double smallest = m_tolerance;
  Cell cell;
  for (cell[0] = low[0]; cell[0] <= high[0]; ++cell[0]) {
    for (cell[1] = low[1]; cell[1] <= high[1]; ++cell[1]) {
      for (cell[2] = low[2]; cell[2] <= high[2]; ++cell[2]) {
        for (int e = m_heads[bucketOf(cell)]; e >= 0; e = m_entries[static_cast<std::size_t>(e)].next) {
          const int vertex = m_entries[static_cast<std::size_t>(e)].vertex;
          const double distance = (m_vertices[static_cast<std::size_t>(vertex)] - point).norm();
          if (distance <= smallest) {
            smallest = distance;
            nearest = vertex;
          }
        }
      }
    }
  }
  return nearest;
}
} // namespace vpMeshDetail
END_VISP_NAMESPACE
