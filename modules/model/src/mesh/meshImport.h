// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef meshImport_h
#define meshImport_h

#include <visp3/core/vpHomogeneousMatrix.h>
#include <visp3/model/vpTrackedModelBuilder.h>

#include <string>

BEGIN_VISP_NAMESPACE
namespace vpMeshDetail {
/*!
  Adds the triangles of a mesh file.
  \param file Path of a file that exists.
  \param unit Metres per unit of the file.
  \param oMm Pose of the mesh's frame in the object frame.
  \param builder Where the triangles go, in the file's unit.
  \throw vpException naming the file where it cannot be read or has no triangles.
*/
void importMesh(const std::string &file, double unit, const vpHomogeneousMatrix &oMm, vpTrackedModelBuilder &builder);
} // namespace vpMeshDetail
END_VISP_NAMESPACE
#endif
