// SPDX-License-Identifier: GPL-2.0-or-later
#include "files/daeGeometry.h"
#include "files/fileBytes.h"
#include "files/sceneCheck.h"

#include <pugixml.hpp>

#include <algorithm>
#include <cstring>
#include <map>
#include <sstream>

BEGIN_VISP_NAMESPACE
namespace vpMeshDetail {
namespace {
class DaeCheck
{
public:
  explicit DaeCheck(const std::string &file) : m_file(file) {}

  SceneCheck run()
  {
    const std::string text = readBytes(m_file);
    const pugi::xml_parse_result parsed = m_document.load_buffer(text.data(), text.size());
    if (!parsed) {
      const auto end = text.begin() + std::min<std::ptrdiff_t>(parsed.offset, static_cast<std::ptrdiff_t>(text.size()));
      refuseLine(m_file, 1 + static_cast<std::size_t>(std::count(text.begin(), end, '\n')),
                 std::string("this is no XML, or cut off: ") + parsed.description());
    }
    if (std::string(m_document.document_element().name()) != "COLLADA") {
      refuseFile(m_file, "is no COLLADA file: its first element is not COLLADA");
    }
    checkUnit();
    collect();
    const pugi::xml_node instance = m_document.document_element().child("scene").child("instance_visual_scene");
    if (instance) {
      visit(referred(instance), 1);
    }
    m_result.content = geometryAlone();
    return m_result;
  }

private:
  [[noreturn]] void refuse(const std::string &reason) const { refuseFile(m_file, reason); }

  void checkUnit() const
  {
    const pugi::xml_attribute meter = m_document.document_element().child("asset").child("unit").attribute("meter");
    double metres = 0.;
    if (meter && (!parseNumber(trimmed(meter.value()), metres) || !(metres > 0.))) {
      refuse("has unit " + std::string(meter.value()) + ": metres per unit must be a number above 0 (meter=\"1\")");
    }
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
    if (name == "geometry") {
      m_polygons[id] = DaeGeometry(m_file, node).countPolygons();
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

  void visit(const pugi::xml_node &node, std::size_t depth)
  {
    if (depth > deepestNode || ++m_visits > mostNodes) {
      refuse("has nodes that are nested more than " + std::to_string(deepestNode) + " deep, or more than " +
             std::to_string(mostNodes) + " in all: does a node contain itself?");
    }
    for (const pugi::xml_node child : node.children()) {
      const std::string name = child.name();
      if (name == "node") {
        visit(child, depth + 1);
      } else if (name == "instance_node") {
        visit(referred(child), depth + 1);
      } else if (name == "instance_geometry") {
        addGeometry(referred(child));
      } else if (name == "instance_controller") {
        addController(referred(child));
      }
    }
  }

  void addGeometry(const pugi::xml_node &geometry)
  {
    const auto found = m_polygons.find(geometry.attribute("id").value());
    if (found == m_polygons.end() || std::string(geometry.name()) != "geometry") {
      refuse("has an instance_geometry of something that is no geometry");
    }
    m_result.polygons += found->second;
    if (m_result.polygons > mostPolygons) {
      refuse("has more than " + std::to_string(mostPolygons) + " polygons: reduce them");
    }
  }

  // A skin or morph names its geometry, or another controller: the geometry takes its place.
  void addController(pugi::xml_node instance)
  {
    warn("its skeleton or morph targets are left out: the mesh is read as it is stored, not as they would pose it");
    pugi::xml_node controller = referred(instance);
    for (std::size_t depth = 0; std::string(controller.name()) == "controller"; ++depth) {
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
    addGeometry(controller);
    instance.set_name("instance_geometry");
    instance.attribute("url").set_value((std::string("#") + controller.attribute("id").value()).c_str());
  }

  void warn(const std::string &text)
  {
    std::vector<std::string> &all = m_result.warnings;
    if (std::find(all.begin(), all.end(), text) == all.end()) {
      all.push_back(text);
    }
  }

  // Without what moves or lights the scene: none of it is of use, and assimp may stumble over it.
  std::string geometryAlone()
  {
    pugi::xml_node root = m_document.document_element();
    for (const char *name : {"library_animations", "library_animation_clips", "library_controllers", "library_cameras",
                             "library_lights", "library_physics_scenes", "library_physics_models",
                             "library_force_fields", "library_kinematics_models", "library_kinematics_scenes"}) {
      while (root.remove_child(name)) {
      }
    }
    std::ostringstream text;
    m_document.save(text, "", pugi::format_raw);
    return text.str();
  }

  std::string m_file;
  pugi::xml_document m_document;
  SceneCheck m_result;
  std::map<std::string, pugi::xml_node> m_byId;
  std::map<std::string, std::size_t> m_polygons; // Of geometries by their id.
  std::size_t m_visits = 0;
};
} // namespace

SceneCheck checkDae(const std::string &file)
{
  return DaeCheck(file).run();
}
} // namespace vpMeshDetail
END_VISP_NAMESPACE
