// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef daeGeometry_h
#define daeGeometry_h

#include <visp3/se3/vpCompatibility.h>

#include <pugixml.hpp>

#include <cstddef>
#include <map>
#include <string>
#include <vector>

BEGIN_VISP_NAMESPACE
namespace vpMeshDetail {
//! The polygons of a <geometry> of COLLADA.
class DaeGeometry
{
public:
  //! Numbers in elements of some components each.
  struct Source
  {
    std::vector<double> numbers;
    std::size_t count = 0;               //!< Of elements.
    std::size_t stride = 1;              //!< From one element to the next.
    std::size_t offset = 0;              //!< Of the first element.
    std::vector<std::string> components; //!< Their names in lower case, in the order in which they stand.

    double at(std::size_t element, std::size_t component) const
    {
      return numbers[offset + element * stride + component];
    }
  };

  //! Where a corner has its position, colour or texture coordinate.
  struct Input
  {
    const Source *source = nullptr;      //!< Null where it has none.
    std::size_t offset = 0;              //!< Among a corner's indices.
    std::vector<std::size_t> components; //!< Of an element: of X, Y and Z for instance.

    double at(std::size_t element, std::size_t k) const { return source->at(element, components[k]); }
  };

  //! Polygons of one material.
  struct Primitive
  {
    std::string material; //!< Symbol.
    Input position;
    Input color;
    Input texture;
    std::size_t stride = 1;           //!< Indices of each corner.
    std::vector<std::size_t> indices; //!< All are in range.
    std::vector<std::size_t> sizes;   //!< Corners of each polygon, three or more.
  };

  /*!
    \throw vpException naming the file where a count is not that of what follows, an index is out of range, something
    that is no number stands among numbers, or a part would be left out.
  */
  DaeGeometry(const std::string &file, const pugi::xml_node &geometry);

  const std::vector<Primitive> &primitives() const { return m_primitives; }
  std::size_t polygons() const;

private:
  [[noreturn]] void refuse(const std::string &reason) const;
  pugi::xml_node withId(const std::string &reference) const;
  pugi::xml_node arrayOf(const pugi::xml_node &accessor) const;
  const Source &source(const pugi::xml_node &node);
  Input input(const pugi::xml_node &node, const std::vector<std::string> &names);
  void readInputs(const pugi::xml_node &node, Primitive &primitive);
  void readPrimitive(const pugi::xml_node &node);
  void checkIndices(const Primitive &primitive, const Input &input) const;
  void addPolygons(const pugi::xml_node &node, const std::vector<std::size_t> &list, Primitive &primitive) const;
  void addPolylist(const pugi::xml_node &node, const std::vector<std::size_t> &list, Primitive &primitive) const;
  void addPolygon(const std::vector<std::size_t> &list, const std::vector<std::size_t> &corners,
                  Primitive &primitive) const;

  std::string m_file;
  pugi::xml_node m_geometry;
  pugi::xml_node m_mesh;
  std::map<std::string, Source> m_sources; // By their ids; a map does not move them.
  std::vector<Primitive> m_primitives;
};
} // namespace vpMeshDetail
END_VISP_NAMESPACE
#endif
