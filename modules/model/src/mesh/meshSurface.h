// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef meshSurface_h
#define meshSurface_h

#include "meshCleaning.h"

BEGIN_VISP_NAMESPACE
namespace vpMeshDetail {
enum class MeshEdgeKind : char
{
  SMOOTH,      //!< Two triangles that belong together.
  CREASE,      //!< Two triangles with a fold between them.
  BORDER,      //!< One triangle.
  NON_MANIFOLD //!< More than two triangles.
};

//! Shape of a mesh whose windings agree.
struct MeshSurface
{
  std::vector<Eigen::Vector3d> normal; //!< Per triangle, unit.
  std::vector<MeshEdgeKind> edgeKind;  //!< Per edge.
  std::vector<int> face;               //!< Per triangle: number of the face that it belongs to.
  std::size_t faceCount = 0;
};

//! \param creaseAngle A fold between normals farther apart is a crease, degrees.
MeshSurface findSurface(const std::vector<Eigen::Vector3d> &vertices, const CleanMesh &mesh, double creaseAngle);

//! Corner normals, shared by the triangles of one face that meet at a vertex.
struct CornerNormals
{
  std::vector<Eigen::Vector3d> normal; //!< Unit.
  std::vector<int> index;              //!< Per corner, 3 * triangle + k: which normal.
};

//! Means of the triangles' normals, weighted by the triangles' angles at the vertex.
CornerNormals findCornerNormals(const std::vector<Eigen::Vector3d> &vertices, const CleanMesh &mesh,
                                const MeshSurface &surface);

//! Loops of border edges.
struct MeshBorders
{
  std::size_t loops = 0;
  std::vector<char> small; //!< Per edge: 1 on a loop too small to be part of the object's shape.
};

//! \param smallest Diagonal of the bounding box of the smallest loop that counts as shape, metres.
MeshBorders findBorders(const std::vector<Eigen::Vector3d> &vertices, const MeshTopology &topology, double smallest);
} // namespace vpMeshDetail
END_VISP_NAMESPACE
#endif
