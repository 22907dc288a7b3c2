// SPDX-License-Identifier: GPL-2.0-or-later
#include "files/gltfText.h"

#include "files/fileBytes.h"

#include <visp3/model/vpJsonWatch.h>

#include <array>
#include <cstdint>

BEGIN_VISP_NAMESPACE
namespace vpMeshDetail {
namespace {
using Json = nlohmann::json;

constexpr int deepestJson = 100;
constexpr std::size_t headerBytes = 20; // Of a .glb file and its first chunk.

std::uint32_t wordAt(const std::string &bytes, std::size_t at)
{
  // Little endian, whatever the processor is.
  std::uint32_t word = 0;
  for (std::size_t i = 4; i > 0; --i) {
    word = (word << 8U) | static_cast<unsigned char>(bytes[at + i - 1]);
  }
  return word;
}

void append(std::string &bytes, std::size_t word)
{
  for (unsigned int shift = 0; shift < 32; shift += 8) {
    bytes += static_cast<char>((word >> shift) & 255U);
  }
}

// Members with these names alone.
template <std::size_t Count> Json only(const Json &all, const std::array<const char *, Count> &names)
{
  Json some = Json::object();
  for (const char *name : names) {
    if (all.is_object() && all.contains(name)) {
      some[name] = all[name];
    }
  }
  return some;
}

template <std::size_t Count> void keep(Json &list, const std::array<const char *, Count> &names)
{
  for (Json &one : list) {
    one = only(one, names);
  }
}
} // namespace

GltfText::GltfText(const std::string &file)
{
  std::string json;
  split(file, json);
  const vpJsonWatch watch(deepestJson,
                          [&file](const std::string &reason) { refuseFile(file, "cannot be read: " + reason); });
  try {
    m_root = Json::parse(json, watch);
  } catch (const Json::exception &e) {
    refuseFile(file, std::string("is no glTF file, or broken: ") + e.what());
  }
  if (!m_root.is_object()) {
    refuseFile(file, "is no glTF file: it is no JSON object");
  }
}

void GltfText::split(const std::string &file, std::string &json)
{
  std::string bytes = readBytes(file);
  m_isBinary = bytes.compare(0, 4, "glTF") == 0;
  if (!m_isBinary) {
    dropByteOrderMark(file, bytes);
    json = std::move(bytes);
    return;
  }
  if (bytes.size() < headerBytes || wordAt(bytes, 8) > bytes.size() || wordAt(bytes, 12) > bytes.size() - headerBytes) {
    refuseFile(file, "is cut off: its header says " + std::to_string(bytes.size() < 12 ? 0 : wordAt(bytes, 8)) +
                         " bytes, it has " + std::to_string(bytes.size()));
  }
  json = bytes.substr(headerBytes, wordAt(bytes, 12));
  m_chunks = bytes.substr(headerBytes + json.size());
  if (m_chunks.size() >= 8 && wordAt(m_chunks, 0) > m_chunks.size() - 8) {
    refuseFile(file, "is cut off: its data have " + std::to_string(m_chunks.size() - 8) + " bytes of " +
                         std::to_string(wordAt(m_chunks, 0)));
  }
}

std::string GltfText::geometryAlone() const
{
  Json root =
      only(m_root, std::array<const char *, 12>{{"asset", "scene", "scenes", "nodes", "meshes", "materials", "textures",
                                                 "images", "samplers", "accessors", "bufferViews", "buffers"}});
  if (root.contains("nodes")) {
    keep(root["nodes"],
         std::array<const char *, 7>{{"name", "mesh", "children", "matrix", "translation", "rotation", "scale"}});
  }
  for (Json &mesh : root.contains("meshes") ? root["meshes"] : root["meshes"] = Json::array()) {
    mesh = only(mesh, std::array<const char *, 2>{{"name", "primitives"}});
    for (Json &primitive : mesh.contains("primitives") ? mesh["primitives"] : mesh["primitives"] = Json::array()) {
      primitive = only(primitive, std::array<const char *, 4>{{"attributes", "indices", "material", "mode"}});
      primitive["attributes"] =
          only(primitive["attributes"], std::array<const char *, 3>{{"POSITION", "TEXCOORD_0", "COLOR_0"}});
    }
  }
  std::string text = root.dump();
  if (!m_isBinary) {
    return text;
  }
  text.resize((text.size() + 3) / 4 * 4, ' ');
  std::string bytes = "glTF";
  append(bytes, 2);
  append(bytes, headerBytes + text.size() + m_chunks.size());
  append(bytes, text.size());
  return bytes + "JSON" + text + m_chunks;
}
} // namespace vpMeshDetail
END_VISP_NAMESPACE
