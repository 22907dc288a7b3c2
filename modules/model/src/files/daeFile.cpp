// SPDX-License-Identifier: GPL-2.0-or-later
#include "files/daeGeometry.h"
#include "files/daeMaterials.h"
#include "files/daeText.h"
#include "files/daeTransform.h"
#include "files/fileBytes.h"
#include "files/meshFormats.h"
#include "files/sceneCheck.h"

#include <pugixml.hpp>

#include <algorithm>
#include <cstring>
#include <map>
#include <memory>

BEGIN_VISP_NAMESPACE
namespace vpMeshDetail {
namespace {
using Bindings = std::map<std::string, std::string>; // From symbols of materials to references to them.

class DaeReader
{
public:
  explicit DaeReader(MeshSink &sink) : m_sink(sink), m_file(sink.file()) {}

  void read()
  {
    parse();
    const pugi::xml_node root = m_document.document_element();
    const Eigen::Affine3d metresFromUnits = Eigen::Affine3d::Identity() * Eigen::Scaling(unit());
    collect();
    m_materials = std::make_unique<DaeMaterials>(m_file, root, m_warnings);
    const pugi::xml_node instance = root.child("scene").child("instance_visual_scene");
    if (instance) {
      visit(referred(instance), metresFromUnits, 1);
    }
    for (const std::string &warning : m_warnings) {
      m_sink.builder().addWarning(warning);
    }
  }

private:
  [[noreturn]] void refuse(const std::string &reason) const { refuseFile(m_file, reason); }

  void parse()
  {
    const std::string text = readBytes(m_file);
    const pugi::xml_parse_result parsed = m_document.load_buffer(text.data(), text.size());
    if (!parsed) {
      const auto end = text.begin() + std::min<std::ptrdiff_t>(parsed.offset, static_cast<std::ptrdiff_t>(text.size()));
      refuseLine(m_file, 1 + static_cast<std::size_t>(std::count(text.begin(), end, '\n')),
                 std::string("this is no XML, or cut off: ") + parsed.description());
    }
    if (std::strcmp(m_document.document_element().name(), "COLLADA") != 0) {
      refuse("is no COLLADA file: its first element is not COLLADA");
    }
  }

  double unit() const
  {
    const pugi::xml_attribute meter = m_document.document_element().child("asset").child("unit").attribute("meter");
    double metres = 1.;
    if (meter && (!parseNumber(trimmed(meter.value()), metres) || !(metres > 0.))) {
      refuse("has unit " + std::string(meter.value()) + ": metres per unit must be a number above 0 (meter=\"1\")");
    }
    return metres;
  }

  // All elements by their id, without recursion: a file may be nested deeper than the stack is high.
  void collect()
  {
    std::size_t depth = 0;
    for (pugi::xml_node node = m_document.document_element(); node;) {
      add(node);
      if (node.first_child()) {
        node = node.first_child();
        requireShallow(++depth);
        continue;
      }
      while (node && !node.next_sibling()) {
        node = node.parent();
        --depth;
      }
      node = node.next_sibling();
    }
  }

  void requireShallow(std::size_t depth) const
  {
    if (depth > deepestNode) {
      refuse("has elements that are nested more than " + std::to_string(deepestNode) + " deep");
    }
  }

  void add(const pugi::xml_node &node)
  {
    const std::string name = node.name();
    if (name != "geometry" && name != "node" && name != "controller" && name != "visual_scene") {
      return;
    }
    const std::string id = node.attribute("id").value();
    if (!id.empty() && !m_byId.emplace(name + "#" + id, node).second) {
      refuse("has two elements <" + name + "> with the id '" + id + "'");
    }
  }

  // What <instance_...> of this name refers to.
  pugi::xml_node referred(const pugi::xml_node &instance) const
  {
    const std::string url = instance.attribute("url").value();
    const auto found = m_byId.find(std::string(instance.name()).substr(std::strlen("instance_")) + url);
    if (found == m_byId.end()) {
      refuse("has no triangles for <" + std::string(instance.name()) + "> '" + url +
             "': nothing in the file has this id; export the model again, as a single file");
    }
    return found->second;
  }

  void visit(const pugi::xml_node &node, const Eigen::Affine3d &fileFromParent, std::size_t depth)
  {
    if (depth > deepestNode || ++m_visits > mostNodes) {
      refuse("has nodes that are nested more than " + std::to_string(deepestNode) + " deep, or more than " +
             std::to_string(mostNodes) + " in all: does a node contain itself?");
    }
    const Eigen::Affine3d fileFromNode = fileFromParent * transformOf(m_file, node);
    for (const pugi::xml_node &child : node.children()) {
      const std::string name = child.name();
      if (name == "node") {
        visit(child, fileFromNode, depth + 1);
      } else if (name == "instance_node") {
        visit(referred(child), fileFromNode, depth + 1);
      } else if (name == "instance_geometry") {
        addGeometry(referred(child), bindingsOf(child), fileFromNode);
      } else if (name == "instance_controller") {
        addGeometry(geometryOf(referred(child)), bindingsOf(child), fileFromNode);
      }
    }
  }

  static Bindings bindingsOf(const pugi::xml_node &instance)
  {
    Bindings bindings;
    for (const pugi::xml_node &one : instance.child("bind_material").child("technique_common").children()) {
      bindings[one.attribute("symbol").value()] = one.attribute("target").value();
    }
    return bindings;
  }

  // A skin or morph names its geometry, or another controller.
  pugi::xml_node geometryOf(pugi::xml_node controller)
  {
    m_warnings.emplace_back("its skeleton or morph targets are left out: the mesh is read as it is stored, not as they "
                            "would pose it");
    for (std::size_t depth = 0; std::strcmp(controller.name(), "controller") == 0; ++depth) {
      requireShallow(depth);
      const pugi::xml_node skin = controller.child("skin") ? controller.child("skin") : controller.child("morph");
      const std::string source = skin.attribute("source").value();
      auto found = m_byId.find("geometry" + source);
      found = found == m_byId.end() ? m_byId.find("controller" + source) : found;
      if (found == m_byId.end()) {
        refuse("has no triangles for a controller: nothing in the file has the id '" + source + "'");
      }
      controller = found->second;
    }
    return controller;
  }

  void addGeometry(const pugi::xml_node &node, const Bindings &bindings, const Eigen::Affine3d &fileFromMesh)
  {
    const auto geometry = m_geometries.try_emplace(node.attribute("id").value(), m_file, node).first;
    m_polygons += geometry->second.polygons();
    if (m_polygons > mostPolygons) {
      refuse("has more than " + std::to_string(mostPolygons) + " polygons: reduce them");
    }
    for (const DaeGeometry::Primitive &primitive : geometry->second.primitives()) {
      DaeMaterial material;
      if (!primitive.material.empty()) {
        const auto bound = bindings.find(primitive.material);
        material = m_materials->find(bound == bindings.end() ? "#" + primitive.material : bound->second);
      }
      addPrimitive(primitive, material, fileFromMesh);
    }
  }

  void addPrimitive(const DaeGeometry::Primitive &primitive, const DaeMaterial &material,
                    const Eigen::Affine3d &fileFromMesh)
  {
    const bool mirrored = fileFromMesh.linear().determinant() < 0.;
    const int image =
        primitive.texture.source == nullptr || material.image.empty() ? -1 : m_sink.imageAt(material.image);
    std::size_t first = 0;
    std::vector<MeshSink::Corner> corners;
    for (const std::size_t size : primitive.sizes) {
      corners.clear();
      for (std::size_t k = 0; k < size; ++k) {
        corners.push_back(cornerOf(primitive, &primitive.indices[(first + k) * primitive.stride], material));
        corners.back().position = fileFromMesh * corners.back().position;
      }
      if (mirrored) {
        std::reverse(corners.begin(), corners.end());
      }
      m_sink.addPolygon(corners, image);
      first += size;
    }
  }

  static MeshSink::Corner cornerOf(const DaeGeometry::Primitive &primitive, const std::size_t *indices,
                                   const DaeMaterial &material)
  {
    MeshSink::Corner corner;
    const auto at = [&](const DaeGeometry::Input &input, std::size_t k) { return input.at(indices[input.offset], k); };
    corner.position << at(primitive.position, 0), at(primitive.position, 1), at(primitive.position, 2);
    corner.color = material.color.value_or(corner.color);
    if (primitive.color.source != nullptr) {
      const Eigen::Vector3d color(at(primitive.color, 0), at(primitive.color, 1), at(primitive.color, 2));
      corner.color = toColor(color, color.maxCoeff());
    }
    if (primitive.texture.source != nullptr) {
      corner.texture << static_cast<float>(at(primitive.texture, 0)),
          1.F - static_cast<float>(at(primitive.texture, 1));
    }
    return corner;
  }

  MeshSink &m_sink;
  std::string m_file;
  pugi::xml_document m_document;
  std::map<std::string, pugi::xml_node> m_byId;
  std::map<std::string, DaeGeometry> m_geometries; // Those that were needed, by their ids.
  std::unique_ptr<DaeMaterials> m_materials;
  std::vector<std::string> m_warnings;
  std::size_t m_visits = 0;
  std::size_t m_polygons = 0;
};
} // namespace

void readDae(MeshSink &sink)
{
  DaeReader(sink).read();
}
} // namespace vpMeshDetail
END_VISP_NAMESPACE
