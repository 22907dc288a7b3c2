// SPDX-License-Identifier: GPL-2.0-or-later
#include "symmetry/vpTriangleGrid.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>

BEGIN_VISP_NAMESPACE

namespace {
const double cellsAlong = 24.;
// Of many triangles a cell is to hold few: the surface goes through cells as the square of their number along.
const double trianglesPerCell = 2.;

double cellSize(const vpTrackedModel &model, double reach)
{
  const double along =
      std::max(cellsAlong, std::sqrt(static_cast<double>(model.triangles().size()) / trianglesPerCell));
  return std::max((model.boxMax() - model.boxMin()).maxCoeff() / along, 2. * reach);
}
// Normals of the same bit of surface differ by less: a round side may be made of few triangles.
const double sameNormal = 0.85;

// Shares of the ends of a segment in its point nearest to another one.
double shareAlong(const Eigen::Vector3d &point, const Eigen::Vector3d &a, const Eigen::Vector3d &b)
{
  const double squared = (b - a).squaredNorm();
  return squared > 0. ? std::min(std::max((point - a).dot(b - a) / squared, 0.), 1.) : 0.;
}

// Of the corners in the nearest point of a triangle.
Eigen::Vector3d nearestWeights(const Eigen::Vector3d &point, const Eigen::Matrix3d &corners)
{
  const Eigen::Vector3d u = corners.col(1) - corners.col(0);
  const Eigen::Vector3d v = corners.col(2) - corners.col(0);
  const Eigen::Vector3d n = u.cross(v);
  const Eigen::Vector3d w = point - corners.col(0);
  const double squared = n.squaredNorm();
  if (squared > 0.) {
    const double second = w.cross(v).dot(n) / squared;
    const double third = u.cross(w).dot(n) / squared;
    if (second >= 0. && third >= 0. && second + third <= 1.) {
      return {1. - second - third, second, third};
    }
  }
  Eigen::Vector3d best = Eigen::Vector3d::Zero();
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 3; ++i) {
    const int next = (i + 1) % 3;
    const double share = shareAlong(point, corners.col(i), corners.col(next));
    Eigen::Vector3d weights = Eigen::Vector3d::Zero();
    weights[i] = 1. - share;
    weights[next] = share;
    const double distance = (corners * weights - point).squaredNorm();
    if (distance < least) {
      least = distance;
      best = weights;
    }
  }
  return best;
}
} // namespace

vpTriangleGrid::vpTriangleGrid(const vpTrackedModel &model, double reach) : m_model(model), m_reach(reach)
{
  const Eigen::Vector3d extent = model.boxMax() - model.boxMin();
  m_size = cellSize(model, reach);
  m_origin = model.boxMin().array() - reach;
  m_cells = ((extent.array() + 2. * reach) / m_size).floor().cast<int>() + 1;
  for (const vpModelTriangle &triangle : model.triangles()) {
    const auto at = [&](std::size_t i) { return model.vertices()[static_cast<std::size_t>(triangle.vertex[i])]; };
    m_normals.push_back((at(1) - at(0)).cross(at(2) - at(0)).normalized());
  }
  const int count = static_cast<int>(model.triangles().size());
  m_starts.assign(static_cast<std::size_t>(m_cells.prod()) + 1, 0);
  for (int t = 0; t < count; ++t) {
    forEachCell(t, [this](std::size_t cell) { ++m_starts[cell + 1]; });
  }
  for (std::size_t i = 1; i < m_starts.size(); ++i) {
    m_starts[i] += m_starts[i - 1];
  }
  m_triangles.resize(m_starts.back());
  std::vector<std::size_t> next(m_starts.begin(), m_starts.end() - 1);
  for (int t = 0; t < count; ++t) {
    forEachCell(t, [&](std::size_t cell) { m_triangles[next[cell]++] = t; });
  }
}

const Eigen::Vector3d &vpTriangleGrid::corner(int triangle, std::size_t i) const
{
  const vpModelTriangle &one = m_model.triangles()[static_cast<std::size_t>(triangle)];
  return m_model.vertices()[static_cast<std::size_t>(one.vertex[i])];
}

Eigen::Array3i vpTriangleGrid::cellOf(const Eigen::Vector3d &point) const
{
  return ((point - m_origin) / m_size).array().floor().cast<int>();
}

std::size_t vpTriangleGrid::indexOf(const Eigen::Array3i &cell) const
{
  return static_cast<std::size_t>((cell.z() * m_cells.y() + cell.y()) * m_cells.x() + cell.x());
}

// The cells whose points may be within reach of a triangle.
template <typename Use> void vpTriangleGrid::forEachCell(int triangle, const Use &use) const
{
  const Eigen::Vector3d a = corner(triangle, 0);
  const Eigen::Vector3d low = a.cwiseMin(corner(triangle, 1)).cwiseMin(corner(triangle, 2)).array() - m_reach;
  const Eigen::Vector3d high = a.cwiseMax(corner(triangle, 1)).cwiseMax(corner(triangle, 2)).array() + m_reach;
  const Eigen::Array3i first = cellOf(low).max(0);
  const Eigen::Array3i last = cellOf(high).min(m_cells - 1);
  const double room = 0.5 * std::sqrt(3.) * m_size + m_reach;
  for (int z = first.z(); z <= last.z(); ++z) {
    for (int y = first.y(); y <= last.y(); ++y) {
      for (int x = first.x(); x <= last.x(); ++x) {
        const Eigen::Vector3d middle = m_origin + m_size * Eigen::Vector3d(x + 0.5, y + 0.5, z + 0.5);
        if (std::fabs(normal(triangle).dot(middle - a)) <= room) {
          use(indexOf({x, y, z}));
        }
      }
    }
  }
}

vpSurfacePlace vpTriangleGrid::nearest(const Eigen::Vector3d &point, const Eigen::Vector3d &normal) const
{
  vpSurfacePlace place;
  const Eigen::Array3i cell = cellOf(point);
  if ((cell < 0).any() || (cell >= m_cells).any()) {
    return place;
  }
  const std::size_t index = indexOf(cell);
  const bool isAnySide = normal.isZero();
  double least = m_reach * m_reach;
  for (std::size_t i = m_starts[index]; i < m_starts[index + 1]; ++i) {
    const int triangle = m_triangles[i];
    if (!isAnySide && std::fabs(normal.dot(this->normal(triangle))) < sameNormal) {
      continue;
    }
    Eigen::Matrix3d corners;
    corners << corner(triangle, 0), corner(triangle, 1), corner(triangle, 2);
    const Eigen::Vector3d weights = nearestWeights(point, corners);
    const double distance = (corners * weights - point).squaredNorm();
    if (distance <= least) {
      least = distance;
      place.triangle = triangle;
      place.weights = weights;
    }
  }
  return place;
}

END_VISP_NAMESPACE
