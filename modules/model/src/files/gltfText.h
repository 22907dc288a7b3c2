// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef gltfText_h
#define gltfText_h

#include <visp3/se3/vpCompatibility.h>

#include <nlohmann/json.hpp>

#include <string>

BEGIN_VISP_NAMESPACE
namespace vpMeshDetail {
//! The JSON of a .gltf or .glb file.
class GltfText
{
public:
  //! \throw vpException naming the file where it is cut off or no JSON.
  explicit GltfText(const std::string &file);

  const nlohmann::json &root() const { return m_root; }
  //! \return The file's bytes with nothing in them but geometry and materials: what assimp cannot stumble over.
  std::string geometryAlone() const;

private:
  void split(const std::string &file, std::string &json);

  bool m_isBinary = false;
  std::string m_chunks; // Of a .glb file, after the one with the JSON.
  nlohmann::json m_root;
};
} // namespace vpMeshDetail
END_VISP_NAMESPACE
#endif
