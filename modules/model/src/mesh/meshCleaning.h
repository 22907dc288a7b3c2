// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef meshCleaning_h
#define meshCleaning_h

#include "meshTopology.h"

BEGIN_VISP_NAMESPACE
namespace vpMeshDetail {
/*!
  Triangles that can be worked with.

  Slivers, triangles whose corners lie on a line, stay in for the time being: without them a closed mesh would seem to
  have a crack. They have no normal of their own and take that of another triangle, their carrier.
*/
struct CleanMesh
{
  std::vector<IndexTriangle> triangles;
  std::vector<int> source;  //!< Per triangle: its number in the input.
  std::vector<int> carrier; //!< Per triangle: the triangle whose normal it has, itself unless it is a sliver.
  MeshTopology topology;
  std::size_t degenerate = 0; //!< Triangles dropped because two corners are one, and slivers.
  std::size_t duplicates = 0; //!< Triangles dropped because another one has the same corners.

  bool isSliver(std::size_t triangle) const { return carrier[triangle] != static_cast<int>(triangle); }
};

/*!
  \param vertices Welded.
  \param triangles Vertex indices, in the order of the input.
  \param tolerance A triangle that is less high than that is a sliver, metres.
*/
CleanMesh cleanMesh(const std::vector<Eigen::Vector3d> &vertices, const std::vector<IndexTriangle> &triangles,
                    double tolerance);
} // namespace vpMeshDetail
END_VISP_NAMESPACE
#endif
