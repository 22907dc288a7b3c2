// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef primitiveAssembler_h
#define primitiveAssembler_h

#include "modelParts.h"
#include "vertexPool.h"

#include <cstdint>
#include <string>
#include <unordered_map>
#include <utility>

BEGIN_VISP_NAMESPACE
namespace vpMeshDetail {
//! How a primitive is called in its model file.
struct Label
{
  std::string name;
  int polygon;
};

//! An edge between two polygon corners with everything that meets there.
struct PolygonEdge
{
  std::array<int, 2> vertex;              //!< The smaller index first.
  std::vector<std::pair<int, bool>> side; //!< Faces, and whether each runs from vertex[0] to vertex[1].
  std::vector<int> trackedFor;            //!< The faces among them whose outline this edge belongs to.
  int line = -1;                          //!< Face that names a line here.
  bool isLine = false;                    //!< True where a line was asked for: it is seen from all sides.
};

//! Turns the primitives of ViSP's model files into vertices, faces, triangles, edges, cylinders and circles.
class PrimitiveAssembler
{
public:
  //! \param parts, pool Must live as long as the assembler.
  PrimitiveAssembler(ModelParts &parts, VertexPool &pool);

  void addFace(const std::vector<Eigen::Vector3d> &points, const Label &label, bool closed);
  void addLine(const Eigen::Vector3d &start, const Eigen::Vector3d &end, const Label &label);
  //! \param axis Its ends, not the same point.
  void addCylinder(const std::array<Eigen::Vector3d, 2> &axis, double radius, const Label &label);
  //! \param normal Unit vector.
  void addCircle(const Eigen::Vector3d &centre, const Eigen::Vector3d &normal, double radius, const Label &label);

  //! Writes the edges and what the report says about them; call it once, last.
  void finish();

private:
  int addNamedFace(const Label &label);
  PolygonEdge &edgeBetween(int a, int b);
  void addSurface(const std::vector<int> &corners, const Eigen::Vector3d &normal, bool closed, const Label &label);
  void addOutline(const std::vector<int> &corners, bool closed, const Label &label);
  void addMantle(const std::vector<int> &rims, const vpModelCylinder &cylinder);
  void addCap(const std::vector<int> &rims, std::size_t end, const vpModelCylinder &cylinder, const Label &label);

  ModelParts &m_parts;
  VertexPool &m_pool;
  std::vector<PolygonEdge> m_edges;
  std::unordered_map<std::uint64_t, std::size_t> m_edgeAt;
};

/*!
  Number of faces to turn over so that neighbours agree about inside and outside, the smaller part of each connected
  set of faces. \param faceCount Number of faces, all sides included.
*/
std::size_t countFlippedFaces(const std::vector<PolygonEdge> &edges, std::size_t faceCount);
} // namespace vpMeshDetail
END_VISP_NAMESPACE
#endif
