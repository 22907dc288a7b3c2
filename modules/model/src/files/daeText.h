// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef daeText_h
#define daeText_h

#include <visp3/se3/vpCompatibility.h>

#include <pugixml.hpp>

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

BEGIN_VISP_NAMESPACE
namespace vpMeshDetail {
//! All text of an element, whatever comments stand in it.
std::string textOf(const pugi::xml_node &node);
//! The next word of a text whose lines do not matter; an empty one at its end.
std::string_view nextWord(std::string_view &text);

/*!
  \param node Whose text is numbers.
  \return All of them.
  \throw vpException naming the file, where one is no number, or not finite.
*/
std::vector<double> numbersOf(const std::string &file, const pugi::xml_node &node);
//! Likewise, of indices and counts.
std::vector<std::size_t> indicesOf(const std::string &file, const pugi::xml_node &node);
//! \return The count or offset that an attribute says. \throw vpException naming the file where it says none.
std::size_t countOf(const std::string &file, const pugi::xml_node &node, const char *attribute);
} // namespace vpMeshDetail
END_VISP_NAMESPACE
#endif
