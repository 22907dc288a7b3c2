// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef gltfTransform_h
#define gltfTransform_h

#include <visp3/se3/vpCompatibility.h>

#include <nlohmann/json.hpp>

#include <string>

BEGIN_VISP_NAMESPACE
namespace vpMeshDetail {
/*!
  assimp passes over a transformation of glTF that has another count of numbers, and takes any four for a rotation.
  \throw vpException naming the file where a node has such a one.
*/
void requireTransform(const std::string &file, const nlohmann::json &node);
} // namespace vpMeshDetail
END_VISP_NAMESPACE
#endif
