// SPDX-License-Identifier: GPL-2.0-or-later
#include "files/daeGeometry.h"

#include "files/daeText.h"
#include "files/fileBytes.h"

#include <algorithm>
#include <cstring>
#include <numeric>

BEGIN_VISP_NAMESPACE
namespace vpMeshDetail {
namespace {
// Cutting a polygon takes time that grows with the square of its corners, or worse.
constexpr std::size_t mostCorners = 1000;
// Inputs of a corner; files have up to five.
constexpr std::size_t mostInputs = 64;

bool isPolygons(const std::string &name)
{
  return name == "triangles" || name == "polylist" || name == "polygons" || name == "tristrips" || name == "trifans";
}

bool hasSemantic(const pugi::xml_node &input, const char *semantic)
{
  return std::strcmp(input.attribute("semantic").value(), semantic) == 0;
}
} // namespace

DaeGeometry::DaeGeometry(const std::string &file, const pugi::xml_node &geometry)
    : m_file(file), m_geometry(geometry), m_mesh(geometry.child("mesh"))
{
  if (!m_mesh) {
    refuse("it is no <mesh>, which alone is read: export it as triangles");
  }
  for (const pugi::xml_node &child : m_mesh.children()) {
    if (isPolygons(child.name())) {
      readPrimitive(child);
    }
  }
}

std::size_t DaeGeometry::polygons() const
{
  return std::accumulate(m_primitives.begin(), m_primitives.end(), std::size_t(0),
                         [](std::size_t sum, const Primitive &primitive) { return sum + primitive.sizes.size(); });
}

void DaeGeometry::refuse(const std::string &reason) const
{
  refuseFile(m_file, "is broken in its geometry '" + std::string(m_geometry.attribute("id").value()) + "': " + reason);
}

pugi::xml_node DaeGeometry::withId(const std::string &reference) const
{
  for (const pugi::xml_node &child : m_mesh.children()) {
    if (!reference.empty() && reference.compare(1, std::string::npos, child.attribute("id").value()) == 0) {
      return child;
    }
  }
  refuse("'" + reference + "' is not in it");
}

// The array may be that of another source.
pugi::xml_node DaeGeometry::arrayOf(const pugi::xml_node &accessor) const
{
  const std::string reference = accessor.attribute("source").value();
  for (const pugi::xml_node &other : m_mesh.children("source")) {
    const pugi::xml_node array = other.child("float_array");
    if (array && !reference.empty() && reference.compare(1, std::string::npos, array.attribute("id").value()) == 0) {
      return array;
    }
  }
  refuse("an <accessor> refers to '" + reference + "', which is no <float_array> in it");
}

const DaeGeometry::Source &DaeGeometry::source(const pugi::xml_node &node)
{
  const auto [known, isNew] = m_sources.try_emplace(node.attribute("id").value());
  Source &result = known->second;
  if (!isNew) {
    return result;
  }
  const pugi::xml_node accessor = node.child("technique_common").child("accessor");
  if (!accessor) {
    refuse("<source> '" + std::string(node.attribute("id").value()) + "' has no accessor");
  }
  const pugi::xml_node array = arrayOf(accessor);
  result.numbers = numbersOf(m_file, array);
  if (result.numbers.size() != countOf(m_file, array, "count")) {
    refuse("count=\"" + std::string(array.attribute("count").value()) + "\" of a float_array, but it has " +
           std::to_string(result.numbers.size()) + " numbers");
  }
  result.count = countOf(m_file, accessor, "count");
  result.stride = accessor.attribute("stride") ? countOf(m_file, accessor, "stride") : 1;
  result.offset = accessor.attribute("offset") ? countOf(m_file, accessor, "offset") : 0;
  const std::size_t room = result.numbers.size();
  if (result.stride == 0 || result.offset > room || result.count > (room - result.offset) / result.stride) {
    refuse("an accessor of " + std::to_string(result.count) + " elements is larger than its array of " +
           std::to_string(room) + " numbers");
  }
  for (const pugi::xml_node &param : accessor.children("param")) {
    result.components.push_back(lowerCase(param.attribute("name").value()));
  }
  return result;
}

// \param names Of the components that are needed, which stand in this order where they have other names, or none.
DaeGeometry::Input DaeGeometry::input(const pugi::xml_node &node, const std::vector<std::string> &names)
{
  Input result;
  pugi::xml_node from = withId(node.attribute("source").value());
  if (std::strcmp(from.name(), "vertices") == 0) {
    const pugi::xml_node position = from.find_child_by_attribute("input", "semantic", "POSITION");
    if (!position) {
      refuse("<vertices> has no POSITION");
    }
    from = withId(position.attribute("source").value());
  }
  result.source = &source(from);
  result.offset = node.attribute("offset") ? countOf(m_file, node, "offset") : 0;
  const std::vector<std::string> &all = result.source->components;
  const bool named = std::all_of(names.begin(), names.end(), [&](const std::string &name) {
    return std::find(all.begin(), all.end(), name) != all.end();
  });
  for (std::size_t k = 0; k < names.size(); ++k) {
    const auto found = std::find(all.begin(), all.end(), names[k]);
    result.components.push_back(named ? static_cast<std::size_t>(found - all.begin()) : k);
  }
  if ((!named && !all.empty() && all.size() < names.size()) ||
      *std::max_element(result.components.begin(), result.components.end()) >= result.source->stride) {
    refuse("<source> '" + std::string(from.attribute("id").value()) + "' has elements without " + names.front() +
           " to " + names.back());
  }
  return result;
}

void DaeGeometry::readInputs(const pugi::xml_node &node, Primitive &primitive)
{
  for (const pugi::xml_node &one : node.children("input")) {
    primitive.stride = std::max(primitive.stride, countOf(m_file, one, "offset") + 1);
    if (hasSemantic(one, "VERTEX")) {
      primitive.position = input(one, {"x", "y", "z"});
    } else if (hasSemantic(one, "COLOR") && primitive.color.source == nullptr) {
      primitive.color = input(one, {"r", "g", "b"});
    } else if (hasSemantic(one, "TEXCOORD") && primitive.texture.source == nullptr) {
      primitive.texture = input(one, {"s", "t"});
    }
  }
  if (primitive.position.source == nullptr) {
    refuse(std::string("<") + node.name() + "> has no input VERTEX of <vertices>");
  }
  if (primitive.stride > mostInputs) {
    refuse(std::string("<") + node.name() + "> has an input with an offset of more than " + std::to_string(mostInputs));
  }
  // Colours and texture coordinates may be those of the vertices.
  const pugi::xml_node vertex = node.find_child_by_attribute("input", "semantic", "VERTEX");
  const pugi::xml_node vertices = withId(vertex.attribute("source").value());
  for (const pugi::xml_node &one : vertices.children("input")) {
    Input *place = hasSemantic(one, "COLOR")      ? &primitive.color
                   : hasSemantic(one, "TEXCOORD") ? &primitive.texture
                                                  : nullptr;
    if (place != nullptr && place->source == nullptr) {
      *place = input(one, place == &primitive.color ? std::vector<std::string>{"r", "g", "b"}
                                                    : std::vector<std::string>{"s", "t"});
      place->offset = primitive.position.offset;
    }
  }
}

void DaeGeometry::checkIndices(const Primitive &primitive, const Input &input) const
{
  for (std::size_t i = input.offset; input.source != nullptr && i < primitive.indices.size(); i += primitive.stride) {
    if (primitive.indices[i] >= input.source->count) {
      refuse("index " + std::to_string(primitive.indices[i]) + " is out of range: there are " +
             std::to_string(input.source->count) + " elements, the first is 0");
    }
  }
}

void DaeGeometry::readPrimitive(const pugi::xml_node &node)
{
  const std::string kind = node.name();
  if (node.child("ph")) {
    refuse("polygons with holes (<ph>) are not read: export triangles");
  }
  Primitive primitive;
  primitive.material = node.attribute("material").value();
  readInputs(node, primitive);
  const bool isOneList = kind == "triangles" || kind == "polylist";
  const std::size_t count = countOf(m_file, node, "count");
  std::size_t lists = 0;
  for (const pugi::xml_node &p : node.children("p")) {
    const std::vector<std::size_t> list = indicesOf(m_file, p);
    if (list.size() % primitive.stride != 0) {
      refuse("the <p> of <" + kind + "> has " + std::to_string(list.size()) + " numbers, " +
             std::to_string(primitive.stride) + " are needed for each corner");
    }
    addPolygons(node, list, primitive);
    ++lists;
  }
  if (lists != (isOneList ? 1 : count) && !(isOneList && lists == 0 && count == 0)) {
    refuse("count=\"" + std::to_string(count) + "\" of <" + kind + ">, but it has " + std::to_string(lists) +
           " lists <p>");
  }
  for (const Input *input : {&primitive.position, &primitive.color, &primitive.texture}) {
    checkIndices(primitive, *input);
  }
  m_primitives.push_back(std::move(primitive));
}

// \param list Of one <p>.
void DaeGeometry::addPolygons(const pugi::xml_node &node, const std::vector<std::size_t> &list,
                              Primitive &primitive) const
{
  const std::string kind = node.name();
  const std::size_t corners = list.size() / primitive.stride;
  if (kind == "polylist") {
    addPolylist(node, list, primitive);
  } else if (kind == "triangles") {
    if (corners != 3 * countOf(m_file, node, "count")) {
      refuse("count=\"" + std::string(node.attribute("count").value()) + "\" of <triangles>, but its <p> has " +
             std::to_string(corners) + " corners");
    }
    primitive.indices = list;
    primitive.sizes.assign(corners / 3, 3);
  } else if (kind == "polygons") {
    std::vector<std::size_t> all(corners);
    std::iota(all.begin(), all.end(), std::size_t(0));
    addPolygon(list, all, primitive);
  } else { // Each corner of a strip makes a triangle with the two before, and of a fan with the first and the one
           // before.
    for (std::size_t k = 2; k < corners; ++k) {
      const std::size_t odd = k % 2;
      addPolygon(list,
                 kind == "trifans" ? std::vector<std::size_t>{0, k - 1, k}
                                   : std::vector<std::size_t>{k - 2 + odd, k - 1 - odd, k},
                 primitive);
    }
  }
}

void DaeGeometry::addPolylist(const pugi::xml_node &node, const std::vector<std::size_t> &list,
                              Primitive &primitive) const
{
  const std::vector<std::size_t> sizes = indicesOf(m_file, node.child("vcount"));
  const std::size_t corners = list.size() / primitive.stride;
  if (sizes.size() != countOf(m_file, node, "count") ||
      std::any_of(sizes.begin(), sizes.end(), [&](std::size_t size) { return size > corners; }) ||
      std::accumulate(sizes.begin(), sizes.end(), std::size_t(0)) != corners) {
    refuse("the <vcount> of a <polylist> does not go with its count and the " + std::to_string(corners) +
           " corners of its <p>");
  }
  std::vector<std::size_t> polygon;
  std::size_t first = 0;
  for (const std::size_t size : sizes) {
    polygon.resize(size);
    std::iota(polygon.begin(), polygon.end(), first);
    addPolygon(list, polygon, primitive);
    first += size;
  }
}

// \param corners Which of the list's. What has less than three is no surface.
void DaeGeometry::addPolygon(const std::vector<std::size_t> &list, const std::vector<std::size_t> &corners,
                             Primitive &primitive) const
{
  if (corners.size() > mostCorners) {
    refuse("a polygon has more than " + std::to_string(mostCorners) + " corners: export triangles");
  }
  if (corners.size() < 3) {
    return;
  }
  primitive.sizes.push_back(corners.size());
  for (const std::size_t corner : corners) {
    const auto first = list.begin() + static_cast<std::ptrdiff_t>(corner * primitive.stride);
    primitive.indices.insert(primitive.indices.end(), first, first + static_cast<std::ptrdiff_t>(primitive.stride));
  }
}
} // namespace vpMeshDetail
END_VISP_NAMESPACE
