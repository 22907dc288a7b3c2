// SPDX-License-Identifier: GPL-2.0-or-later
#include "sphere/vpIcosphere.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

BEGIN_VISP_NAMESPACE

namespace {
// Cells along an edge of the cube at level 0; as the vertices, they get twice as dense with each level. A cell is small
// enough that the vertex nearest to its middle is nearest to all of it, or a neighbour of that one.
const int coarsestCells = 4;

// The cell of the cube that a ray from its middle meets. \pre The direction is finite and not zero.
std::size_t cellOf(const Eigen::Vector3d &direction, int cells)
{
  int axis = 0;
  const double largest = direction.cwiseAbs().maxCoeff(&axis);
  const double scale = 0.5 * cells / largest;
  const auto place = [&](int other) {
    return std::min(static_cast<int>(direction[other] * scale + 0.5 * cells), cells - 1);
  };
  const int side = 2 * axis + (direction[axis] < 0. ? 1 : 0);
  return static_cast<std::size_t>((side * cells + place((axis + 1) % 3)) * cells + place((axis + 2) % 3));
}
} // namespace

vpIcosphere::vpIcosphere(unsigned int level)
{
  m_directions.reserve(count(level));
  std::vector<Triangle> triangles = addIcosahedron();
  addLevel(triangles);
  for (unsigned int i = 0; i < level; ++i) {
    triangles = halveEdges(triangles);
    addLevel(triangles);
  }
}

// Its corners are those of three golden rectangles; its edges are the shortest of the lines between them.
std::vector<vpIcosphere::Triangle> vpIcosphere::addIcosahedron()
{
  const double golden = 0.5 * (1. + std::sqrt(5.));
  for (int axis = 0; axis < 3; ++axis) {
    for (const double one : {-1., 1.}) {
      for (const double other : {-golden, golden}) {
        Eigen::Vector3d corner = Eigen::Vector3d::Zero();
        corner[(axis + 1) % 3] = one;
        corner[(axis + 2) % 3] = other;
        m_directions.push_back(corner.normalized());
      }
    }
  }
  const auto areNeighbours = [this](Index a, Index b) { return m_directions[a].dot(m_directions[b]) > 0.4; };
  std::vector<Triangle> triangles;
  for (Index a = 0; a < 12; ++a) {
    for (Index b = static_cast<Index>(a + 1); b < 12; ++b) {
      for (Index c = static_cast<Index>(b + 1); c < 12; ++c) {
        if (areNeighbours(a, b) && areNeighbours(b, c) && areNeighbours(c, a)) {
          triangles.push_back({{a, b, c}});
        }
      }
    }
  }
  return triangles;
}

std::vector<vpIcosphere::Triangle> vpIcosphere::halveEdges(const std::vector<Triangle> &triangles)
{
  std::map<std::pair<Index, Index>, Index> middles;
  const auto middleOf = [&](Index a, Index b) {
    const auto found = middles.emplace(std::minmax({a, b}), static_cast<Index>(m_directions.size()));
    if (found.second) {
      m_directions.push_back((m_directions[a] + m_directions[b]).normalized());
    }
    return found.first->second;
  };
  std::vector<Triangle> parts;
  for (const Triangle &t : triangles) {
    const Index ab = middleOf(t[0], t[1]);
    const Index bc = middleOf(t[1], t[2]);
    const Index ca = middleOf(t[2], t[0]);
    parts.insert(parts.end(), {{{t[0], ab, ca}}, {{t[1], bc, ab}}, {{t[2], ca, bc}}, {{ab, bc, ca}}});
  }
  return parts;
}

void vpIcosphere::addLevel(const std::vector<Triangle> &triangles)
{
  std::vector<std::vector<Index>> around(m_directions.size());
  for (const Triangle &t : triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      around[t[k]].push_back(t[(k + 1) % 3]);
      around[t[k]].push_back(t[(k + 2) % 3]);
    }
  }
  Level level;
  for (std::vector<Index> &neighbours : around) {
    std::sort(neighbours.begin(), neighbours.end());
    neighbours.erase(std::unique(neighbours.begin(), neighbours.end()), neighbours.end());
    std::array<Index, 6> all;
    all.fill(neighbours.front());
    std::copy(neighbours.begin(), neighbours.end(), all.begin());
    level.neighbours.push_back(all);
  }
  fillStarts(level);
  m_levels.push_back(std::move(level));
}

void vpIcosphere::fillStarts(Level &level) const
{
  level.cells = coarsestCells << m_levels.size();
  level.start.reserve(static_cast<std::size_t>(6 * level.cells * level.cells));
  std::size_t nearest = 0;
  const auto middle = [&level](int cell) { return (2. * cell + 1.) / level.cells - 1.; };
  for (int side = 0; side < 6; ++side) {
    for (int i = 0; i < level.cells; ++i) {
      for (int j = 0; j < level.cells; ++j) {
        Eigen::Vector3d direction;
        direction[side / 2] = side % 2 == 0 ? 1. : -1.;
        direction[(side / 2 + 1) % 3] = middle(i);
        direction[(side / 2 + 2) % 3] = middle(j);
        nearest = climb(level, nearest, direction);
        level.start.push_back(static_cast<Index>(nearest));
      }
    }
  }
}

// From vertex to vertex while one of its neighbours is nearer. The triangles are a Delaunay triangulation (all their
// angles are below 90 degrees), and in such a one a vertex that no neighbour beats is the nearest of all.
std::size_t vpIcosphere::climb(const Level &level, std::size_t from, const Eigen::Vector3d &direction) const
{
  double best = m_directions[from].dot(direction);
  for (;;) {
    std::size_t next = from;
    for (const Index neighbour : level.neighbours[from]) {
      const double cosine = m_directions[neighbour].dot(direction);
      if (cosine > best) {
        best = cosine;
        next = neighbour;
      }
    }
    if (next == from) {
      return from;
    }
    from = next;
  }
}

std::size_t vpIcosphere::nearest(const Eigen::Vector3d &direction, unsigned int level) const
{
  const double largest = direction.cwiseAbs().maxCoeff();
  if (!(largest > 0.) || !direction.allFinite()) {
    return 0;
  }
  const Level &at = m_levels[level];
  return climb(at, at.start[cellOf(direction, at.cells)], direction);
}

std::size_t vpIcosphere::memory() const
{
  std::size_t bytes = sizeof(*this) + m_directions.capacity() * sizeof(Eigen::Vector3d);
  for (const Level &level : m_levels) {
    bytes += sizeof(level) + level.neighbours.capacity() * sizeof(level.neighbours[0]) +
             level.start.capacity() * sizeof(Index);
  }
  return bytes;
}

END_VISP_NAMESPACE
