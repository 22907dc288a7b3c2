// SPDX-License-Identifier: GPL-2.0-or-later
#include "config/xmlDocument.h"

#include "config/settingsText.h"
#include "config/xmlNodes.h"

#include <visp3/core/vpException.h>

#include <algorithm>

BEGIN_VISP_NAMESPACE
namespace vpSettingsDetail {
namespace {
std::string quoted(const pugi::xml_node &node)
{
  return std::string("<") + node.name() + '>';
}

// \param name A node that was found there; empty for a text.
std::string knownBelow(const std::string &path, const std::string &name = "")
{
  const std::vector<std::string> known = xmlNodesBelow(path);
  if (known.empty()) {
    return "it holds a value and no nodes";
  }
  const std::string nearest = name.empty() ? "" : "the nearest is <" + nearestName(name, known) + ">, ";
  return nearest + "known there are " + listText(known);
}
} // namespace

XmlDocument::XmlDocument(const std::string &file) : m_file(file), m_text(readTextFile(file))
{
  parse();
  checkChildren(m_document.document_element(), "");
}

pugi::xml_node XmlDocument::find(const char *path) const
{
  return m_document.document_element().first_element_by_path(path);
}

void XmlDocument::parse()
{
  const pugi::xml_parse_result result = m_document.load_buffer(m_text.data(), m_text.size());
  if (!result) {
    refuseAt(result.offset, std::string("this is no XML: ") + result.description());
  }
}

void XmlDocument::refuse(const pugi::xml_node &node, const std::string &reason) const
{
  refuseAt(node.offset_debug(), reason);
}

void XmlDocument::refuseAt(std::ptrdiff_t offset, const std::string &reason) const
{
  const std::ptrdiff_t size = static_cast<std::ptrdiff_t>(m_text.size());
  const auto line = 1 + std::count(m_text.begin(), m_text.begin() + std::clamp(offset, std::ptrdiff_t(0), size), '\n');
  throw vpException(vpException::badValue,
                    "Configuration file '" + m_file + "', line " + std::to_string(line) + ": " + reason);
}

void XmlDocument::checkChildren(const pugi::xml_node &parent, const std::string &parentPath) const
{
  for (const pugi::xml_node &node : parent.children()) {
    if (node.type() != pugi::node_element) {
      refuse(parent, quoted(parent) + " holds the text '" + node.value() + "', but " + knownBelow(parentPath));
    }
    const std::string path = parentPath.empty() ? node.name() : parentPath + '/' + node.name();
    const XmlNode *known = findXmlNode(path);
    if (!known) {
      refuse(node, quoted(node) + " is not known in " + quoted(parent) + "; " + knownBelow(parentPath, node.name()));
    }
    // ViSP's parser takes the last of two, or parts of both. A calibration has several cameras and models.
    const bool isCalibration = path == "camera/model" || (path == "camera" && node.child("model"));
    if (known->kind != XmlNode::ANYTHING && !isCalibration && parent.child(node.name()) != node) {
      refuse(node, quoted(node) + " is there twice in " + quoted(parent) + ": delete one of both");
    }
    if (known->kind == XmlNode::GROUP) {
      checkChildren(node, path);
    } else if (known->kind != XmlNode::ANYTHING) {
      checkNumber(node, *known);
    }
  }
}

void XmlDocument::checkNumber(const pugi::xml_node &node, const XmlNode &known) const
{
  for (const pugi::xml_node &child : node.children()) {
    if (child.type() == pugi::node_element) {
      refuse(child, quoted(child) + " is not known in " + quoted(node) + "; " + knownBelow(known.path));
    }
    if (child != node.first_child()) { // Only the first part of it would be read.
      refuse(node, quoted(node) + " has a comment in its number: put it before or after the node");
    }
  }
  const bool whole = known.kind == XmlNode::WHOLE;
  const std::string text = node.text().get();
  const std::optional<double> value = whole ? parseWholeNumber(text) : parseNumber(text);
  if (!value || !known.range.contains(*value)) {
    refuse(node, quoted(node) + " in " + quoted(node.parent()) + " is '" + text + "', it must be " +
                     known.range.describe(whole ? "whole number" : "number"));
  }
}
} // namespace vpSettingsDetail
END_VISP_NAMESPACE
