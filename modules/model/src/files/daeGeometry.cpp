// SPDX-License-Identifier: GPL-2.0-or-later
#include "files/daeGeometry.h"

#include "files/fileBytes.h"

#include <algorithm>
#include <cmath>
#include <numeric>

BEGIN_VISP_NAMESPACE
namespace vpMeshDetail {
namespace {
// Cutting a polygon takes time that grows with the square of its corners, or worse.
constexpr std::size_t mostCorners = 1000;

// The next word of a text whose lines do not matter.
std::string_view nextWord(std::string_view &text)
{
  const char *const blanks = " \t\r\n";
  text.remove_prefix(std::min(text.find_first_not_of(blanks), text.size()));
  const std::string_view word = text.substr(0, text.find_first_of(blanks));
  text.remove_prefix(word.size());
  return word;
}
} // namespace

DaeGeometry::DaeGeometry(const std::string &file, const pugi::xml_node &geometry)
    : m_file(file), m_geometry(geometry), m_mesh(geometry.child("mesh"))
{
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

std::size_t DaeGeometry::attribute(const pugi::xml_node &node, const char *name) const
{
  long long value = 0;
  if (!parseNumber(trimmed(node.attribute(name).value()), value) || value < 0) {
    refuse(std::string(name) + "=\"" + node.attribute(name).value() + "\" of <" + node.name() +
           "> is no count or offset");
  }
  return static_cast<std::size_t>(value);
}

std::vector<std::size_t> DaeGeometry::indices(const pugi::xml_node &list) const
{
  std::vector<std::size_t> result;
  std::string_view text = list.text().get();
  for (std::string_view word = nextWord(text); !word.empty(); word = nextWord(text)) {
    long long index = 0;
    if (!parseNumber(word, index) || index < 0) {
      refuse("'" + std::string(word.substr(0, 20)) + "' in <" + list.name() + "> is no index or count");
    }
    result.push_back(static_cast<std::size_t>(index));
  }
  return result;
}

std::size_t DaeGeometry::countNumbers(const pugi::xml_node &array) const
{
  std::size_t count = 0;
  std::string_view text = array.text().get();
  for (std::string_view word = nextWord(text); !word.empty(); word = nextWord(text)) {
    double number = 0.;
    if (!parseNumber(word, number) || !std::isfinite(number)) {
      refuse("'" + std::string(word.substr(0, 20)) + "' in <" + array.name() + "> is no finite number");
    }
    ++count;
  }
  return count;
}

// How many elements an accessor has, where its array has room for them.
std::size_t DaeGeometry::elementsOf(const pugi::xml_node &source) const
{
  const pugi::xml_node array = source.child("float_array");
  const pugi::xml_node accessor = source.child("technique_common").child("accessor");
  if (!array || !accessor) {
    refuse("<source> '" + std::string(source.attribute("id").value()) + "' has no float_array and accessor");
  }
  const std::size_t count = attribute(accessor, "count");
  const std::size_t stride = accessor.attribute("stride") ? attribute(accessor, "stride") : 1;
  const std::size_t offset = accessor.attribute("offset") ? attribute(accessor, "offset") : 0;
  const std::size_t room = attribute(array, "count");
  if (stride == 0 || offset > room || count > (room - offset) / stride) {
    refuse("an accessor of " + std::to_string(count) + " elements is larger than its array of " + std::to_string(room) +
           " numbers");
  }
  return count;
}

void DaeGeometry::checkSources() const
{
  for (const pugi::xml_node &source : m_mesh.children("source")) {
    const pugi::xml_node array = source.child("float_array");
    if (array && countNumbers(array) != attribute(array, "count")) {
      refuse("count=\"" + std::string(array.attribute("count").value()) + "\" of a float_array, but it has " +
             std::to_string(countNumbers(array)) + " numbers");
    }
  }
}

std::size_t DaeGeometry::elementsFor(const pugi::xml_node &input) const
{
  pugi::xml_node source = withId(input.attribute("source").value());
  if (std::string(source.name()) == "vertices") {
    const pugi::xml_node position = source.find_child_by_attribute("input", "semantic", "POSITION");
    if (!position) {
      refuse("<vertices> has no POSITION");
    }
    source = withId(position.attribute("source").value());
  }
  return elementsOf(source);
}

void DaeGeometry::checkIndices(const pugi::xml_node &primitive, const std::vector<std::size_t> &list,
                               std::size_t stride) const
{
  for (const pugi::xml_node &input : primitive.children("input")) {
    const std::size_t elements = elementsFor(input);
    for (std::size_t i = attribute(input, "offset"); i < list.size(); i += stride) {
      if (list[i] >= elements) {
        refuse("index " + std::to_string(list[i]) + " in <" + primitive.name() + "> is out of range: there are " +
               std::to_string(elements) + " elements of " + input.attribute("semantic").value());
      }
    }
  }
}

std::size_t DaeGeometry::countPolylist(const pugi::xml_node &primitive, std::size_t corners) const
{
  const std::vector<std::size_t> sizes = indices(primitive.child("vcount"));
  if (std::accumulate(sizes.begin(), sizes.end(), std::size_t(0)) != corners ||
      sizes.size() != attribute(primitive, "count")) {
    refuse("the <vcount> of a <polylist> does not go with its count and the " + std::to_string(corners) +
           " corners of its <p>");
  }
  if (std::any_of(sizes.begin(), sizes.end(), [](std::size_t size) { return size > mostCorners; })) {
    refuse("a polygon has more than " + std::to_string(mostCorners) + " corners: export triangles");
  }
  return static_cast<std::size_t>(
      std::count_if(sizes.begin(), sizes.end(), [](std::size_t size) { return size >= 3; }));
}

// Of one <p>; \e corners in it.
std::size_t DaeGeometry::countIn(const std::string &kind, const pugi::xml_node &primitive, std::size_t corners) const
{
  if (kind == "triangles") {
    if (corners != 3 * attribute(primitive, "count")) {
      refuse("count=\"" + std::string(primitive.attribute("count").value()) + "\" of <triangles>, but its <p> has " +
             std::to_string(corners) + " corners");
    }
    return corners / 3;
  }
  if (kind == "polylist") {
    return countPolylist(primitive, corners);
  }
  if (kind == "polygons") {
    if (corners > mostCorners) {
      refuse("a polygon has more than " + std::to_string(mostCorners) + " corners: export triangles");
    }
    return corners >= 3 ? 1 : 0;
  }
  return corners >= 3 ? corners - 2 : 0; // Strips and fans.
}

std::size_t DaeGeometry::countPrimitive(const pugi::xml_node &primitive) const
{
  const pugi::xml_node vertex = primitive.find_child_by_attribute("input", "semantic", "VERTEX");
  if (!vertex || std::string(withId(vertex.attribute("source").value()).name()) != "vertices") {
    refuse(std::string("<") + primitive.name() + "> has no input VERTEX of <vertices>");
  }
  std::size_t stride = 1;
  for (const pugi::xml_node &input : primitive.children("input")) {
    stride = std::max(stride, attribute(input, "offset") + 1);
  }
  const std::string kind = primitive.name();
  const bool isOneList = kind == "triangles" || kind == "polylist";
  std::size_t lists = 0;
  std::size_t polygons = 0;
  for (const pugi::xml_node &p : primitive.children("p")) {
    const std::vector<std::size_t> list = indices(p);
    if (list.size() % stride != 0 || stride > 64) {
      refuse("the <p> of <" + kind + "> has " + std::to_string(list.size()) + " numbers, " + std::to_string(stride) +
             " are needed for each corner");
    }
    checkIndices(primitive, list, stride);
    polygons += countIn(kind, primitive, list.size() / stride);
    ++lists;
  }
  if (lists != (isOneList ? 1 : attribute(primitive, "count")) && !(isOneList && attribute(primitive, "count") == 0)) {
    refuse("count=\"" + std::string(primitive.attribute("count").value()) + "\" of <" + kind + ">, but it has " +
           std::to_string(lists) + " lists <p>");
  }
  return polygons;
}

std::size_t DaeGeometry::countPolygons() const
{
  if (!m_mesh) {
    refuse("it is no <mesh>, which alone is read: export it as triangles");
  }
  checkSources();
  std::size_t polygons = 0;
  for (const pugi::xml_node &child : m_mesh.children()) {
    const std::string name = child.name();
    if (child.child("ph")) {
      refuse("polygons with holes (<ph>) are not read: export triangles");
    }
    if (name == "triangles" || name == "polylist" || name == "polygons" || name == "tristrips" || name == "trifans") {
      polygons += countPrimitive(child);
    }
  }
  return polygons;
}
} // namespace vpMeshDetail
END_VISP_NAMESPACE
