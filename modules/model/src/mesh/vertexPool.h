// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vertexPool_h
#define vertexPool_h

#include <visp3/se3/vpCompatibility.h>

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

BEGIN_VISP_NAMESPACE
namespace vpMeshDetail {
/*!
  Welds points: those within a tolerance of a vertex become that vertex.

  A point is compared with the first one of each vertex only, so that a row of close points does not shrink to one.
*/
class VertexPool
{
public:
  /*!
    \param lower Lower corner of a box around all points to come, metres.
    \param diameter Diagonal of that box, metres, > 0.
    \param tolerance Distance up to which points are one, metres, >= 0.
    \param expected Rough number of points to come.
    \param vertices Where new vertices are appended; must live as long as the pool.
  */
  VertexPool(const Eigen::Vector3d &lower, double diameter, double tolerance, std::size_t expected,
             std::vector<Eigen::Vector3d> &vertices);

  //! \return Index of the vertex that \e point is, or has become.
  int add(const Eigen::Vector3d &point);

  //! \return Index of a new vertex that nothing is welded to.
  int addApart(const Eigen::Vector3d &point);

  //! Number of positions that were moved onto a slightly different one.
  std::size_t welded() const { return m_welded; }
  double tolerance() const { return m_tolerance; }

private:
  using Cell = std::array<std::int64_t, 3>;
  struct Entry
  {
    Eigen::Vector3d position;
    int vertex;
    int next;
  };

  Cell cellOf(const Eigen::Vector3d &point) const;
  std::size_t bucketOf(const Cell &cell) const;
  int nearestVertex(const Eigen::Vector3d &point) const;

  Eigen::Vector3d m_lower;
  double m_cellSize;
  double m_tolerance;
  std::vector<Eigen::Vector3d> &m_vertices;
  std::vector<int> m_heads;
  std::vector<Entry> m_entries;
  std::size_t m_welded = 0;
};
} // namespace vpMeshDetail
END_VISP_NAMESPACE
#endif
