// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mtlFile_h
#define mtlFile_h

#include <visp3/se3/vpCompatibility.h>

#include <Eigen/Core>

#include <map>
#include <optional>
#include <string>

BEGIN_VISP_NAMESPACE
namespace vpMeshDetail {
//! What is of use in a material of an .obj file.
struct MtlMaterial
{
  std::optional<Eigen::Vector3f> color; //!< In [0, 1].
  std::string image;                    //!< As the file names it; empty where there is none.
};

//! Adds the materials of an .mtl file by their names. Attributes other than Kd and map_Kd say nothing of use.
void readMtl(const std::string &file, std::map<std::string, MtlMaterial> &materials);
} // namespace vpMeshDetail
END_VISP_NAMESPACE
#endif
