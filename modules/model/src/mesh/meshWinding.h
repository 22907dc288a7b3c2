// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef meshWinding_h
#define meshWinding_h

#include "meshTopology.h"

BEGIN_VISP_NAMESPACE
namespace vpMeshDetail {
//! Which triangles to turn over, and what they form.
struct WindingRepair
{
  std::vector<char> turned;   //!< Per triangle: 1 where its corners have to be swapped.
  std::vector<int> component; //!< Per triangle: number of the connected piece of surface that it belongs to.
  std::vector<char> closed;   //!< Per piece: 1 where it encloses a volume.
  std::size_t turnedCount = 0;
};

/*!
  Makes neighbours agree about inside and outside.

  Pieces of surface are connected by edges with two triangles. A closed piece has its outside where its volume is
  positive, an open one where most of its triangles had it.
*/
WindingRepair findTurnedTriangles(const std::vector<Eigen::Vector3d> &vertices,
                                  const std::vector<IndexTriangle> &triangles, const MeshTopology &topology);
} // namespace vpMeshDetail
END_VISP_NAMESPACE
#endif
