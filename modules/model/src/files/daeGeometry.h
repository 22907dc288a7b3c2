// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef daeGeometry_h
#define daeGeometry_h

#include <visp3/se3/vpCompatibility.h>

#include <pugixml.hpp>

#include <cstddef>
#include <string>
#include <vector>

BEGIN_VISP_NAMESPACE
namespace vpMeshDetail {
//! Checks the counts and indices of a <geometry> of COLLADA.
class DaeGeometry
{
public:
  DaeGeometry(const std::string &file, const pugi::xml_node &geometry);
  /*!
    \return Triangles and polygons in it.
    \throw vpException naming file and geometry where a count is not that of what follows, an index is out of range,
    something that is no number stands among numbers, or a part would be left out.
  */
  std::size_t countPolygons() const;

private:
  [[noreturn]] void refuse(const std::string &reason) const;
  pugi::xml_node withId(const std::string &reference) const;
  std::size_t attribute(const pugi::xml_node &node, const char *name) const;
  std::vector<std::size_t> indices(const pugi::xml_node &list) const;
  std::size_t countNumbers(const pugi::xml_node &array) const;
  std::size_t elementsOf(const pugi::xml_node &source) const;
  std::size_t elementsFor(const pugi::xml_node &input) const;
  void checkSources() const;
  std::size_t countPrimitive(const pugi::xml_node &primitive) const;
  std::size_t countIn(const std::string &kind, const pugi::xml_node &primitive, std::size_t corners) const;
  std::size_t countPolylist(const pugi::xml_node &primitive, std::size_t corners) const;
  void checkIndices(const pugi::xml_node &primitive, const std::vector<std::size_t> &list, std::size_t stride) const;

  std::string m_file;
  pugi::xml_node m_geometry;
  pugi::xml_node m_mesh;
};
} // namespace vpMeshDetail
END_VISP_NAMESPACE
#endif
