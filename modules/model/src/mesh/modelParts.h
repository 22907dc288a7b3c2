// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef modelParts_h
#define modelParts_h

#include <visp3/model/vpTrackedModel.h>

BEGIN_VISP_NAMESPACE
namespace vpMeshDetail {
//! A model in the making: the members of vpTrackedModel, open to the steps that fill them.
struct ModelParts
{
  std::vector<Eigen::Vector3d> vertices;
  std::vector<Eigen::Vector3d> normals;
  std::vector<vpModelTriangle> triangles;
  std::vector<vpModelFace> faces;
  std::vector<vpModelEdge> edges;
  std::vector<int> edgeFaces;
  std::vector<vpModelCylinder> cylinders;
  std::vector<vpModelCircle> circles;
  std::vector<int> smoothTriangles;
  vpModelAppearance appearance;
  vpModelReport report;
};

//! Index of the element that was added last.
template <class Element> int lastIndex(const std::vector<Element> &list)
{
  return static_cast<int>(list.size()) - 1;
}

//! Per face: 1 where it has a surface, 0 where it only names a line or a circle.
inline std::vector<char> facesWithSurface(const ModelParts &parts)
{
  std::vector<char> surface(parts.faces.size(), 0);
  for (const vpModelTriangle &triangle : parts.triangles) {
    surface[static_cast<std::size_t>(triangle.face)] = 1;
  }
  return surface;
}
} // namespace vpMeshDetail
END_VISP_NAMESPACE
#endif
