// SPDX-License-Identifier: GPL-2.0-or-later
#include "generate/surfaceNet.h"

#include <cmath>

namespace bench {
namespace {
using Point = Eigen::Vector3d;
using Function = std::function<double(const Point &)>;

//! The grid of values, and the vertices of its cells.
class Net
{
public:
  Net(const Function &distance, const Point &low, const Point &high, double cell)
      : m_distance(distance), m_low(low), m_cell(cell)
  {
    for (int axis = 0; axis < 3; ++axis) {
      m_size[static_cast<std::size_t>(axis)] = static_cast<int>(std::ceil((high(axis) - low(axis)) / cell)) + 1;
    }
    m_values.reserve(static_cast<std::size_t>(m_size[0]) * static_cast<std::size_t>(m_size[1] * m_size[2]));
    for (int k = 0; k < m_size[2]; ++k) {
      for (int j = 0; j < m_size[1]; ++j) {
        for (int i = 0; i < m_size[0]; ++i) {
          m_values.push_back(distance(low + cell * Point(i, j, k)));
        }
      }
    }
    m_vertex.assign(m_values.size(), -1);
  }

  SurfaceNet make()
  {
    for (int k = 1; k + 1 < m_size[2]; ++k) {
      for (int j = 1; j + 1 < m_size[1]; ++j) {
        for (int i = 1; i + 1 < m_size[0]; ++i) {
          for (int axis = 0; axis < 3; ++axis) {
            addQuad({{i, j, k}}, static_cast<std::size_t>(axis));
          }
        }
      }
    }
    return m_net;
  }

private:
  using Index = std::array<int, 3>;

  std::size_t at(const Index &i) const
  {
    return static_cast<std::size_t>(i[0] + m_size[0] * (i[1] + m_size[1] * i[2]));
  }

  //! The two triangles around a grid edge that starts at a grid point.
  void addQuad(const Index &start, std::size_t axis)
  {
    Index end = start;
    ++end[axis];
    const bool inside = m_values[at(start)] < 0.;
    if (inside == (m_values[at(end)] < 0.)) {
      return;
    }
    const std::size_t u = (axis + 1) % 3;
    const std::size_t v = (axis + 2) % 3;
    std::array<int, 4> corners{};
    const std::array<std::array<int, 2>, 4> around = {{{{1, 1}}, {{0, 1}}, {{0, 0}}, {{1, 0}}}};
    for (std::size_t c = 0; c < 4; ++c) {
      Index cell = start;
      // Outward along the axis where its start is inside.
      const std::array<int, 2> &back = around[inside ? c : 3 - c];
      cell[u] -= back[0];
      cell[v] -= back[1];
      corners[c] = vertexOf(cell);
    }
    m_net.triangles.push_back({{corners[0], corners[1], corners[2]}});
    m_net.triangles.push_back({{corners[0], corners[2], corners[3]}});
  }

  int vertexOf(const Index &cell)
  {
    int &vertex = m_vertex[at(cell)];
    if (vertex < 0) {
      vertex = static_cast<int>(m_net.vertices.size());
      m_net.vertices.push_back(onSurface(crossing(cell)));
    }
    return vertex;
  }

  //! Mean of the places where the cell's edges cut the surface.
  Point crossing(const Index &cell) const
  {
    Point sum = Point::Zero();
    int count = 0;
    for (int corner = 0; corner < 8; ++corner) {
      for (int axis = 0; axis < 3; ++axis) {
        if ((corner >> axis & 1) != 0) {
          continue;
        }
        Index from = cell;
        for (int a = 0; a < 3; ++a) {
          from[static_cast<std::size_t>(a)] += corner >> a & 1;
        }
        Index to = from;
        ++to[static_cast<std::size_t>(axis)];
        const double here = m_values[at(from)];
        const double there = m_values[at(to)];
        if ((here < 0.) != (there < 0.)) {
          Point place(from[0], from[1], from[2]);
          place(axis) += here / (here - there);
          sum += place;
          ++count;
        }
      }
    }
    return m_low + m_cell * sum / std::max(1, count);
  }

  Point onSurface(Point p) const
  {
    const double h = 0.05 * m_cell;
    for (int i = 0; i < 3; ++i) {
      const double value = m_distance(p);
      Point gradient;
      for (int axis = 0; axis < 3; ++axis) {
        const Point step = h * Point::Unit(axis);
        gradient(axis) = (m_distance(p + step) - m_distance(p - step)) / (2. * h);
      }
      p -= gradient * (value / std::max(gradient.squaredNorm(), 0.1));
    }
    return p;
  }

  const Function &m_distance;
  Point m_low;
  double m_cell;
  Index m_size{};
  std::vector<double> m_values;
  std::vector<int> m_vertex; //!< Per cell, named by its lowest corner; -1 where it has none yet.
  SurfaceNet m_net;
};
} // namespace

SurfaceNet makeSurfaceNet(const Function &distance, const Point &low, const Point &high, double cell)
{
  return Net(distance, low, high, cell).make();
}

} // namespace bench
