// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef xmlNodes_h
#define xmlNodes_h

#include "config/settingsTable.h"

#include <visp3/mbt/vpMbtXmlGenericParser.h>

#include <string>
#include <vector>

BEGIN_VISP_NAMESPACE
namespace vpSettingsDetail {
//! What ViSP's parser read.
struct XmlValues
{
  explicit XmlValues(const vpMbtXmlGenericParser &parser);

  const vpMbtXmlGenericParser &parser;
  vpCameraParameters camera;
  vpMe me;
};

//! A node that ViSP's files have.
struct XmlNode
{
  enum Kind
  {
    GROUP, //!< Holds other nodes.
    NUMBER,
    WHOLE,   //!< ViSP would cut off decimals.
    ANYTHING //!< Text or nodes, not looked at here.
  };
  using Take = void (*)(const XmlValues &, Draft &draft);

  const char *path; //!< From below the root, for instance "ecm/mask/size".
  Kind kind;
  Range range = {};         //!< Of a number.
  const char *setting = ""; //!< What it is here, for instance "edge.maskSize"; empty where there is nothing like it.
  const char *reason = "";  //!< Why it is left, or what differs.
  Take take = nullptr;      //!< Carries over what the parser read; null where other functions do.
};

//! The nodes that the parsers of ViSP 3.5 to 3.7 know, and deprecated ones that files still have.
const std::vector<XmlNode> &xmlNodes();
//! \return The node with this path, null where none is known.
const XmlNode *findXmlNode(const std::string &path);
//! \return Names of the nodes that are known below the one with this path, "" for the root.
std::vector<std::string> xmlNodesBelow(const std::string &path);
} // namespace vpSettingsDetail
END_VISP_NAMESPACE
#endif
