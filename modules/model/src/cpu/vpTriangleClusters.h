// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpTriangleClusters_h
#define vpTriangleClusters_h

#include "../mesh/normalCone.h"

#include <visp3/model/vpTrackedModel.h>

#include <array>
#include <cstdint>
#include <vector>

BEGIN_VISP_NAMESPACE

/*!
  The triangles of a model in groups that lie near one another, each with corners of its own: they are projected in
  plain loops, into memory that stays in the cache, and a group that faces away from the camera costs one test.
*/
class vpTriangleClusters
{
public:
  //! Corners as numbers in the cluster, and the triangle's number in the model.
  struct Triangle
  {
    std::array<std::uint8_t, 3> corner;
    bool hasBack; //!< Its back is inside a closed surface.
    int index;
  };

  struct Cluster
  {
    std::size_t firstPosition;
    std::size_t positions;
    std::size_t firstTriangle;
    std::size_t triangles;
    vpMeshDetail::NormalCone backs; //!< Of triangles that all have a back that is never seen.
  };

  //! Most triangles of a cluster: their corners can be counted in a byte.
  static constexpr std::size_t mostTriangles = 64;
  static constexpr std::size_t mostPositions = 3 * mostTriangles;

  explicit vpTriangleClusters(const vpTrackedModel &model);

  const std::vector<Cluster> &clusters() const { return m_clusters; }
  const std::vector<Triangle> &triangles() const { return m_triangles; }
  //! \name Positions, object frame
  //! @{
  const std::vector<double> &x() const { return m_x; }
  const std::vector<double> &y() const { return m_y; }
  const std::vector<double> &z() const { return m_z; }
  //! @}

private:
  void add(const vpTrackedModel &model, const std::size_t *first, const std::size_t *last);

  std::vector<Cluster> m_clusters;
  std::vector<Triangle> m_triangles;
  std::vector<double> m_x;
  std::vector<double> m_y;
  std::vector<double> m_z;
};

END_VISP_NAMESPACE
#endif
