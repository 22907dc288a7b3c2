// SPDX-License-Identifier: GPL-2.0-or-later
#include "config/settingsXml.h"

#include "config/settingsTable.h"
#include "config/settingsText.h"
#include "config/xmlDocument.h"
#include "config/xmlNodes.h"

#include <visp3/mbt/vpMbtXmlGenericParser.h>

#include <optional>
#include <string>

BEGIN_VISP_NAMESPACE
namespace vpSettingsDetail {
namespace {
// The parser's own defaults are of no concern: a value is taken over where the file has its node only. So what the file
// does not say stays as it is, with the digits that the parser would round off.
void takeParsed(const XmlDocument &document, Draft &draft)
{
  vpMbtXmlGenericParser parser(vpMbtXmlGenericParser::EDGE_PARSER | vpMbtXmlGenericParser::KLT_PARSER);
  parser.setVerbose(false);
  parser.parse(document.file());
  const XmlValues values(parser);
  for (const XmlNode &node : xmlNodes()) {
    if (node.take && document.find(node.path)) {
      node.take(values, draft);
    }
  }
}

// Not from ViSP's parser: 3.5 does not know the scale, and later ones cut off the threshold's decimals.
void takeThreshold(const XmlDocument &document, Draft &draft)
{
  const pugi::xml_node threshold = document.find("ecm/contrast/edge_threshold");
  if (!threshold) {
    return;
  }
  const bool inGrayLevels = document.find("ecm/contrast/edge_threshold_type").text().as_int() == 1;
  vpEdgeCueSettings &edge = draft.members.edge;
  edge.contrast = vpEdgeCueSettings::toContrast(
      threshold.text().as_double(), inGrayLevels ? vpEdgeCueSettings::CONTRAST : vpEdgeCueSettings::LIKELIHOOD,
      edge.maskSize);
  const Entry contrast = settingsEntry("edge.contrast");
  if (!contrast.range.contains(edge.contrast)) {
    document.refuse(threshold,
                    "<edge_threshold> in <contrast> is " + numberText(edge.contrast) + " gray levels, it must be " +
                        contrast.describe() +
                        (inGrayLevels ? "; without <edge_threshold_type> it would be in ViSP's old scale" : ""));
  }
}

// A file of vpXmlParserCamera, which prints, and in some versions makes up what is missing.
void takeCameraModel(const XmlDocument &document, Draft &draft)
{
  const pugi::xml_node model = document.find("camera/model");
  const pugi::xml_node camera = model.parent();
  if (camera.next_sibling() || camera.previous_sibling() || model.next_sibling("model")) {
    document.refuse(camera, "a <camera> with a <model> must be the only node in its file, and the <model> the only one "
                            "in its <camera>");
  }
  const std::string type = model.child_value("type");
  const bool distorted = type == "perspectiveProjWithDistortion";
  if (!distorted && type != "perspectiveProjWithoutDistortion") {
    document.refuse(model, "<type> in <model> is '" + type +
                               "', it must be perspectiveProjWithoutDistortion or perspectiveProjWithDistortion");
  }
  const auto value = [&](const char *name) {
    if (!model.child(name)) {
      document.refuse(model, std::string("<") + name + "> is missing in <model>");
    }
    return model.child(name).text().as_double();
  };
  draft.camera = {value("px"), value("py"), value("u0"), value("v0"), std::nullopt, std::nullopt};
  if (distorted) {
    draft.camera.kud = value("kud");
    draft.camera.kdu = value("kdu");
  }
}
} // namespace

void readXml(const std::string &file, Draft &draft)
{
  const ClassicLocale locale;
  const XmlDocument document(file);
  if (document.find("camera/model")) {
    takeCameraModel(document, draft);
    return;
  }
  if (document.find("camera")) { // ViSP's files have cameras without distortion.
    draft.camera.kud.reset();
    draft.camera.kdu.reset();
  }
  takeParsed(document, draft);
  takeThreshold(document, draft);
}
} // namespace vpSettingsDetail
END_VISP_NAMESPACE
