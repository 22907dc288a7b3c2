// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpIcosphere_h
#define vpIcosphere_h

#include <visp3/se3/vpCompatibility.h>

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

BEGIN_VISP_NAMESPACE

/*!
  Directions all around, the vertices of an icosahedron whose edges are halved again and again. Those of a lower level
  come first.
*/
class vpIcosphere
{
public:
  //! Indices have 16 bits.
  static constexpr unsigned int mostLevels = 4;

  //! \param level The finest one, at most mostLevels.
  explicit vpIcosphere(unsigned int level);

  //! Number of vertices up to a level.
  static constexpr std::size_t count(unsigned int level) { return (std::size_t{10} << (2 * level)) + 2; }

  const std::vector<Eigen::Vector3d> &directions() const { return m_directions; }

  //! The vertex of a level whose angle to a direction of any length is least; 0 where the direction has no length.
  std::size_t nearest(const Eigen::Vector3d &direction, unsigned int level) const;

  std::size_t memory() const;

private:
  using Index = std::uint16_t;
  using Triangle = std::array<Index, 3>;

  // What finds the nearest vertex of one level.
  struct Level
  {
    std::vector<std::array<Index, 6>> neighbours; // Of each vertex; where it has five, the first one twice.
    std::vector<Index> start;                     // Vertex near the cells of a cube around the sphere.
    int cells = 0;                                // Along the cube's edge.
  };

  std::vector<Triangle> addIcosahedron();
  std::vector<Triangle> halveEdges(const std::vector<Triangle> &triangles);
  void addLevel(const std::vector<Triangle> &triangles);
  void fillStarts(Level &level) const;
  std::size_t climb(const Level &level, std::size_t from, const Eigen::Vector3d &direction) const;

  std::vector<Eigen::Vector3d> m_directions;
  std::vector<Level> m_levels;
};

END_VISP_NAMESPACE
#endif
