// SPDX-License-Identifier: GPL-2.0-or-later
#include "generate/gridSolid.h"

#include <visp3/core/vpException.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#ifdef ENABLE_VISP_NAMESPACE
using namespace VISP_NAMESPACE_NAME;
#endif

namespace bench {
namespace {
using Point = Eigen::Vector3d;
// Grid points are exact copies of the lines' coordinates, so they can be compared as they are.
using Key = std::tuple<double, double, double>;

Key keyOf(const Point &p)
{
  return {p.x(), p.y(), p.z()};
}

GridSolid::Side makeSide(const std::array<std::vector<double>, 3> &lines, const GridSolid::Cell &cell, int axis,
                         int direction)
{
  GridSolid::Side side;
  side.axis = axis;
  side.direction = direction;
  side.cell = cell;
  const int first = (axis + 1) % 3;
  const int second = (axis + 2) % 3;
  const auto line = [&](int a, int offset) {
    return lines[static_cast<std::size_t>(a)][static_cast<std::size_t>(cell[static_cast<std::size_t>(a)] + offset)];
  };
  // Along the first axis, then along the second, is counter-clockwise about the positive normal.
  const std::array<std::array<int, 2>, 4> turn = {{{{0, 0}}, {{1, 0}}, {{1, 1}}, {{0, 1}}}};
  for (std::size_t i = 0; i < 4; ++i) {
    std::array<int, 2> at = turn[i];
    if (direction < 0) {
      at[0] = 1 - at[0];
    }
    side.corner[i](axis) = line(axis, direction > 0 ? 1 : 0);
    side.corner[i](first) = line(first, at[0]);
    side.corner[i](second) = line(second, at[1]);
  }
  return side;
}

//! Groups of sides that lie in one plane, have one colour and are joined by their edges.
class Pieces
{
public:
  Pieces(const std::vector<GridSolid::Side> &sides, const GridSolid::Color &color) : m_sides(sides), m_color(color)
  {
    for (std::size_t i = 0; i < sides.size(); ++i) {
      for (std::size_t k = 0; k < 4; ++k) {
        m_edges[{keyOf(sides[i].corner[k]), keyOf(sides[i].corner[(k + 1) % 4])}].push_back(i);
      }
    }
  }

  std::vector<std::vector<std::size_t>> all() const
  {
    std::vector<std::vector<std::size_t>> pieces;
    std::vector<char> taken(m_sides.size(), 0);
    for (std::size_t i = 0; i < m_sides.size(); ++i) {
      if (taken[i]) {
        continue;
      }
      std::vector<std::size_t> piece = {i};
      taken[i] = 1;
      for (std::size_t next = 0; next < piece.size(); ++next) {
        for (const std::size_t other : neighbours(piece[next])) {
          if (!taken[other]) {
            taken[other] = 1;
            piece.push_back(other);
          }
        }
      }
      pieces.push_back(piece);
    }
    return pieces;
  }

private:
  std::vector<std::size_t> neighbours(std::size_t i) const
  {
    std::vector<std::size_t> found;
    for (std::size_t k = 0; k < 4; ++k) {
      const auto reversed = m_edges.find({keyOf(m_sides[i].corner[(k + 1) % 4]), keyOf(m_sides[i].corner[k])});
      if (reversed == m_edges.end()) {
        continue;
      }
      for (const std::size_t other : reversed->second) {
        if (m_sides[other].axis == m_sides[i].axis && m_sides[other].direction == m_sides[i].direction &&
            (!m_color || m_color(m_sides[other]) == m_color(m_sides[i]))) {
          found.push_back(other);
        }
      }
    }
    return found;
  }

  const std::vector<GridSolid::Side> &m_sides;
  const GridSolid::Color &m_color;
  std::map<std::pair<Key, Key>, std::vector<std::size_t>> m_edges;
};

//! The border of a piece: the edges whose reverse is not in it, end to end, without corners on straight lines.
std::vector<Point> border(const std::vector<GridSolid::Side> &sides, const std::vector<std::size_t> &piece)
{
  std::map<std::pair<Key, Key>, std::pair<Point, Point>> edges;
  for (const std::size_t i : piece) {
    for (std::size_t k = 0; k < 4; ++k) {
      const Point &from = sides[i].corner[k];
      const Point &to = sides[i].corner[(k + 1) % 4];
      if (edges.erase({keyOf(to), keyOf(from)}) == 0) {
        edges[{keyOf(from), keyOf(to)}] = {from, to};
      }
    }
  }
  std::map<Key, Point> next;
  for (const auto &edge : edges) {
    next[edge.first.first] = edge.second.second;
  }
  std::vector<Point> loop = {edges.begin()->second.first};
  while (loop.size() <= edges.size()) {
    const Point to = next.at(keyOf(loop.back()));
    if (to == loop.front()) {
      break;
    }
    loop.push_back(to);
  }
  if (loop.size() != edges.size()) {
    throw vpException(vpException::badValue, "a plane piece of a solid has a hole, which a .cao cannot hold");
  }
  std::vector<Point> corners;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Point before = loop[i] - loop[(i + loop.size() - 1) % loop.size()];
    const Point after = loop[(i + 1) % loop.size()] - loop[i];
    if (std::abs(before.normalized().dot(after.normalized())) < 0.5) {
      corners.push_back(loop[i]);
    }
  }
  return corners;
}
} // namespace

GridSolid::GridSolid(const std::array<std::vector<double>, 3> &lines, const std::function<bool(const Cell &)> &isSolid)
{
  const auto count = [&](std::size_t axis) { return static_cast<int>(lines[axis].size()) - 1; };
  const auto solidAt = [&](const Cell &cell) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (cell[axis] < 0 || cell[axis] >= count(axis)) {
        return false;
      }
    }
    return isSolid(cell);
  };
  for (int i = 0; i < count(0); ++i) {
    for (int j = 0; j < count(1); ++j) {
      for (int k = 0; k < count(2); ++k) {
        const Cell cell = {{i, j, k}};
        for (int side = 0; side < 6 && isSolid(cell); ++side) {
          const int axis = side / 2;
          const int direction = side % 2 == 0 ? 1 : -1;
          Cell beside = cell;
          beside[static_cast<std::size_t>(axis)] += direction;
          if (!solidAt(beside)) {
            m_sides.push_back(makeSide(lines, cell, axis, direction));
          }
        }
      }
    }
  }
}

void GridSolid::addTo(SyntheticObject &object, const Color &color, int part) const
{
  for (const Side &side : m_sides) {
    const Eigen::Vector3f c = color(side);
    for (std::size_t half = 0; half < 2; ++half) {
      ColoredTriangle triangle;
      triangle.position = {{side.corner[0], side.corner[1 + half], side.corner[2 + half]}};
      triangle.color.fill(c);
      triangle.texture.fill(Eigen::Vector2f::Zero());
      triangle.part = part;
      object.triangles.push_back(triangle);
    }
  }
}

void GridSolid::addTo(CaoText &cao, const std::string &name, const Color &color) const
{
  const std::vector<std::vector<std::size_t>> pieces = Pieces(m_sides, color).all();
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    cao.addFace(border(m_sides, pieces[i]), name + "_" + std::to_string(i));
  }
}

GridSolid boxSolid(const Eigen::Vector3d &centre, const Eigen::Vector3d &size)
{
  std::array<std::vector<double>, 3> lines;
  for (int axis = 0; axis < 3; ++axis) {
    lines[static_cast<std::size_t>(axis)] = {centre(axis) - size(axis) / 2., centre(axis) + size(axis) / 2.};
  }
  return GridSolid(lines, [](const GridSolid::Cell &) { return true; });
}

std::vector<double> gridLines(double size, const std::vector<double> &inner)
{
  std::vector<double> lines = {-size / 2.};
  lines.insert(lines.end(), inner.begin(), inner.end());
  lines.push_back(size / 2.);
  return lines;
}

} // namespace bench
