// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef xmlDocument_h
#define xmlDocument_h

#include <visp3/se3/vpCompatibility.h>

#include <pugixml.hpp>

#include <cstddef>
#include <string>

BEGIN_VISP_NAMESPACE
namespace vpSettingsDetail {
struct XmlNode;

//! An XML file whose nodes are all known and whose numbers are numbers in their range.
class XmlDocument
{
public:
  //! \throw vpException naming the file, and the line and node where it is wrong.
  explicit XmlDocument(const std::string &file);

  const std::string &file() const { return m_file; }
  pugi::xml_node root() const { return m_document.document_element(); }
  //! \return The first node with this path below the root, a null one where there is none.
  pugi::xml_node find(const char *path) const;
  //! \throw vpException naming file and line of the node.
  [[noreturn]] void refuse(const pugi::xml_node &node, const std::string &reason) const;

private:
  void parse();
  void checkChildren(const pugi::xml_node &parent, const std::string &parentPath) const;
  void checkNumber(const pugi::xml_node &node, const XmlNode &known) const;
  [[noreturn]] void refuseAt(std::ptrdiff_t offset, const std::string &reason) const;

  std::string m_file;
  std::string m_text;
  pugi::xml_document m_document;
};
} // namespace vpSettingsDetail
END_VISP_NAMESPACE
#endif
