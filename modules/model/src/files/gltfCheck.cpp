// SPDX-License-Identifier: GPL-2.0-or-later
#include "files/fileBytes.h"
#include "files/gltfText.h"
#include "files/gltfTransform.h"
#include "files/sceneCheck.h"

#include <visp3/core/vpException.h>

#include <algorithm>
#include <array>
#include <cstdint>

BEGIN_VISP_NAMESPACE
namespace vpMeshDetail {
namespace {
using Json = nlohmann::json;

constexpr std::uint64_t mostElements = 100000000;

// Extensions that change the look of a surface alone, or nothing that is seen.
bool isHarmless(const std::string &extension)
{
  static const std::array<const char *, 7> known = {{"KHR_lights_punctual", "KHR_texture_transform",
                                                     "KHR_texture_basisu", "EXT_texture_webp", "KHR_xmp_json_ld",
                                                     "MSFT_texture_dds", "KHR_animation_pointer"}};
  return extension.compare(0, 14, "KHR_materials_") == 0 ||
         std::find(known.begin(), known.end(), extension) != known.end();
}

class GltfCheck
{
public:
  GltfCheck(const std::string &file, const Json &root) : m_file(file), m_root(root) {}

  SceneCheck run()
  {
    m_result.materials = list("materials").size();
    checkExtensions();
    checkViews();
    checkAccessors();
    checkMeshes();
    checkMaterials();
    checkReferences("textures", "source", "images");
    checkReferences("textures", "sampler", "samplers");
    checkReferences("images", "bufferView", "bufferViews");
    const Json &scenes = list("scenes");
    const std::size_t scene = m_root.contains("scene") ? whole(m_root, "scene", "the file") : 0;
    for (const Json &node : listIn(at(scenes, scene, "scene"), "nodes")) {
      visit(asIndex(node, "a scene's node"), 1);
    }
    return m_result;
  }

private:
  [[noreturn]] void refuse(const std::string &reason) const { refuseFile(m_file, reason); }

  const Json &listIn(const Json &parent, const char *name) const
  {
    static const Json none = Json::array();
    if (!parent.is_object()) {
      refuse("is no glTF file, or broken: an object is needed where '" + std::string(name) + "' is looked for");
    }
    const auto found = parent.find(name);
    if (found != parent.end() && !found->is_array()) {
      refuse(std::string("is broken: '") + name + "' is no list");
    }
    return found == parent.end() ? none : *found;
  }

  const Json &list(const char *name) const { return listIn(m_root, name); }

  std::size_t asIndex(const Json &value, const std::string &what) const
  {
    if (!value.is_number_unsigned() || value.get<std::uint64_t>() > std::uint64_t(1) << 36U) {
      refuse("is broken: " + what + " is " + value.dump() + ", a whole number is needed");
    }
    return value.get<std::size_t>();
  }

  std::size_t whole(const Json &parent, const char *name, const std::string &what, std::size_t otherwise = 0) const
  {
    if (!parent.is_object()) {
      refuse("is broken: " + what + " is no object");
    }
    return parent.contains(name) ? asIndex(parent[name], std::string("'") + name + "' of " + what) : otherwise;
  }

  template <typename All>
  const typename All::value_type &at(const All &all, std::size_t index, const std::string &what) const
  {
    if (index >= all.size()) {
      refuse("is broken: it refers to " + what + " " + std::to_string(index) + " of " + std::to_string(all.size()));
    }
    return all[index];
  }

  void warn(const std::string &text)
  {
    std::vector<std::string> &all = m_result.warnings;
    if (std::find(all.begin(), all.end(), text) == all.end()) {
      all.push_back(text);
    }
  }

  void checkExtensions()
  {
    for (const Json &name : list("extensionsRequired")) {
      if (!name.is_string() || !isHarmless(name.get<std::string>())) {
        refuse("requires the extension " + name.dump() +
               ", which is not known: export it without (no compression, no quantization)");
      }
    }
    for (const Json &name : list("extensionsUsed")) {
      if (name == "KHR_texture_transform") {
        warn("KHR_texture_transform is not applied: texture images may be misplaced");
      } else if (name == "EXT_mesh_gpu_instancing") {
        refuse("has copies of meshes by EXT_mesh_gpu_instancing, which is not known: export it without");
      }
    }
  }

  void checkViews() const
  {
    const Json &buffers = list("buffers");
    for (const Json &view : list("bufferViews")) {
      const std::size_t length =
          whole(at(buffers, whole(view, "buffer", "a buffer view"), "buffer"), "byteLength", "a buffer");
      const std::size_t start = whole(view, "byteOffset", "a buffer view");
      if (start > length || whole(view, "byteLength", "a buffer view") > length - start) {
        refuse("is broken: a buffer view is larger than its buffer");
      }
    }
  }

  std::size_t elementBytes(const Json &accessor) const
  {
    static const std::map<std::string, std::size_t> parts = {{"SCALAR", 1}, {"VEC2", 2}, {"VEC3", 3}, {"VEC4", 4},
                                                             {"MAT2", 4},   {"MAT3", 9}, {"MAT4", 16}};
    static const std::map<std::size_t, std::size_t> bytes = {{5120, 1}, {5121, 1}, {5122, 2},
                                                             {5123, 2}, {5125, 4}, {5126, 4}};
    const auto part = parts.find(accessor.value("type", std::string()));
    const auto size = bytes.find(whole(accessor, "componentType", "an accessor"));
    if (part == parts.end() || size == bytes.end()) {
      refuse("is broken: an accessor has the type " + accessor.value("type", std::string("(none)")) +
             " and a componentType that are no pair of glTF");
    }
    return part->second * size->second;
  }

  void checkAccessors() const
  {
    const Json &views = list("bufferViews");
    for (const Json &accessor : list("accessors")) {
      const std::size_t count = whole(accessor, "count", "an accessor");
      const std::size_t size = elementBytes(accessor);
      if (count > mostElements) {
        refuse("has an accessor of " + std::to_string(count) + " elements, more than is believed");
      }
      if (accessor.contains("sparse") || !accessor.contains("bufferView")) {
        refuse("has an accessor that is sparse or without data: export the model without sparse accessors");
      }
      const Json &view = at(views, whole(accessor, "bufferView", "an accessor"), "buffer view");
      const std::size_t stride = std::max(whole(view, "byteStride", "a buffer view", size), std::size_t(1));
      const std::size_t end =
          whole(accessor, "byteOffset", "an accessor") + (count == 0 ? 0 : (count - 1) * stride + size);
      if (end > whole(view, "byteLength", "a buffer view")) {
        refuse("is broken: an accessor of " + std::to_string(count) + " elements is larger than its buffer view");
      }
    }
  }

  void checkMaterials()
  {
    for (const Json &material : list("materials")) {
      const Json pbr = material.is_object() ? material.value("pbrMetallicRoughness", Json::object()) : Json::object();
      const Json texture = pbr.is_object() ? pbr.value("baseColorTexture", Json::object()) : Json::object();
      if (texture.is_object() && texture.value("texCoord", 0) != 0) {
        warn("a texture image may be misplaced: it has other texture coordinates than the first ones, TEXCOORD_0");
      }
    }
  }

  // Each index in the members of a list is one of another list.
  void checkReferences(const char *name, const char *member, const char *others) const
  {
    for (const Json &one : list(name)) {
      if (one.is_object() && one.contains(member)) {
        at(list(others), whole(one, member, name), others);
      }
    }
  }

  void checkMeshes()
  {
    for (const Json &mesh : list("meshes")) {
      std::size_t polygons = 0;
      for (const Json &primitive : listIn(mesh, "primitives")) {
        polygons += polygonsOf(primitive);
        if (primitive.contains("targets")) {
          warn("morph targets are left out: the mesh is read as it is stored");
        }
      }
      m_polygons.push_back(polygons);
    }
  }

  std::size_t polygonsOf(const Json &primitive)
  {
    const Json &accessors = list("accessors");
    if (!primitive.is_object() || !primitive.contains("attributes") || !primitive["attributes"].is_object() ||
        !primitive["attributes"].contains("POSITION")) {
      return 0;
    }
    const Json &positions = at(accessors, whole(primitive["attributes"], "POSITION", "a primitive"), "accessor");
    if (whole(positions, "componentType", "an accessor") != 5126 || positions["type"] != "VEC3") {
      refuse("has positions that are not three 32-bit floats: export it without quantization");
    }
    checkAttributes(primitive["attributes"]);
    if (primitive.contains("material")) {
      at(list("materials"), whole(primitive, "material", "a primitive"), "material");
    }
    std::size_t corners = whole(positions, "count", "an accessor");
    if (primitive.contains("indices")) {
      corners = whole(at(accessors, whole(primitive, "indices", "a primitive"), "accessor"), "count", "an accessor");
    }
    switch (whole(primitive, "mode", "a primitive", 4)) {
    case 4:
      if (corners % 3 != 0) {
        refuse("is broken: " + std::to_string(corners) + " corners do not make whole triangles");
      }
      return corners / 3;
    case 5:
    case 6:
      return corners < 3 ? 0 : corners - 2;
    default:
      return 0; // Points and lines.
    }
  }

  void checkAttributes(const Json &attributes)
  {
    for (const char *name : {"TEXCOORD_0", "COLOR_0"}) {
      if (attributes.contains(name)) {
        const Json &accessor = at(list("accessors"), whole(attributes, name, "a primitive"), "accessor");
        if (whole(accessor, "componentType", "an accessor") != 5126 && std::string(name) == "TEXCOORD_0") {
          refuse("has texture coordinates that are not 32-bit floats: export it without quantization");
        }
      }
    }
  }

  void visit(std::size_t index, std::size_t depth)
  {
    const Json &node = at(list("nodes"), index, "node");
    if (depth > deepestNode || ++m_visits > mostNodes) {
      refuse("has nodes that are nested more than " + std::to_string(deepestNode) + " deep, or more than " +
             std::to_string(mostNodes) + " in all: does a node contain itself?");
    }
    if (node.is_object() && node.contains("mesh")) {
      m_result.polygons += at(m_polygons, whole(node, "mesh", "a node"), "mesh");
      if (m_result.polygons > mostPolygons) {
        refuse("has more than " + std::to_string(mostPolygons) + " triangles: reduce them");
      }
    }
    requireTransform(m_file, node);
    if (node.is_object() && node.contains("skin")) {
      warn("its skeleton is left out: the mesh is read as it is stored, not as the bones would pose it");
    }
    for (const Json &child : listIn(node, "children")) {
      visit(asIndex(child, "a node's child"), depth + 1);
    }
  }

  std::string m_file;
  const Json &m_root;
  SceneCheck m_result;
  std::vector<std::size_t> m_polygons; // Of the meshes.
  std::size_t m_visits = 0;
};
} // namespace

SceneCheck checkGltf(const std::string &file)
{
  const GltfText text(file);
  const Json asset = text.root().value("asset", Json::object());
  const bool tells = asset.is_object() && asset.contains("version") && asset["version"].is_string();
  const std::string version = tells ? asset["version"].get<std::string>() : std::string();
  if (version.compare(0, 2, "2.") != 0) {
    refuseFile(file, "is glTF of version '" + version + "': export it as glTF 2.0");
  }
  try {
    SceneCheck check = GltfCheck(file, text.root()).run();
    check.content = text.geometryAlone();
    return check;
  } catch (const Json::exception &e) {
    refuseFile(file, std::string("is broken: ") + e.what());
  }
}
} // namespace vpMeshDetail
END_VISP_NAMESPACE
