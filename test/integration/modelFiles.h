// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef modelFiles_h
#define modelFiles_h

#include <visp3/model/vpTrackedModel.h>

#include <fstream>
#include <iomanip>
#include <string>

BEGIN_VISP_NAMESPACE

//! Writes the surface of a model as a mesh, in metres. \return \e name.
inline std::string writeModelAsObj(const vpTrackedModel &model, const std::string &name)
{
  std::ofstream file(name);
  file << std::setprecision(17);
  for (const Eigen::Vector3d &vertex : model.vertices()) {
    file << "v " << vertex.x() << " " << vertex.y() << " " << vertex.z() << "\n";
  }
  for (const vpModelTriangle &triangle : model.triangles()) {
    file << "f " << triangle.vertex[0] + 1 << " " << triangle.vertex[1] + 1 << " " << triangle.vertex[2] + 1 << "\n";
  }
  return name;
}

END_VISP_NAMESPACE
#endif
