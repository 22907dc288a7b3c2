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

// Every node with a value. \param model That was taken, of the file of a camera; null in others.
void reportNodes(const pugi::xml_node &parent, const std::string &parentPath, const pugi::xml_node &model,
                 vpConfigReport &report)
{
  for (const pugi::xml_node &node : parent.children()) {
    const std::string path = parentPath.empty() ? node.name() : parentPath + '/' + node.name();
    const XmlNode *known = findXmlNode(path);
    if (known == nullptr) {
      continue; // Below a node that is not looked at.
    }
    if (path == "camera/model" && node != model) {
      report.left.push_back({path + ' ' + node.child_value("type"), "", "another model of this camera was taken"});
    } else if (known->kind == XmlNode::GROUP) {
      reportNodes(node, path, model, report);
    } else {
      (*known->setting == '\0' ? report.left : report.taken).push_back({path, known->setting, known->reason});
    }
  }
}

void reportDocument(const XmlDocument &document, const pugi::xml_node &model, vpConfigReport &report)
{
  report.format = model ? vpConfigReport::Format::CALIBRATION_XML : vpConfigReport::Format::GENERIC_XML;
  reportNodes(document.root(), "", model, report);
  report.imageWidth = document.find(model ? "camera/image_width" : "camera/width").text().as_uint();
  report.imageHeight = document.find(model ? "camera/image_height" : "camera/height").text().as_uint();
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

void requireOneCamera(const XmlDocument &document, const pugi::xml_node &camera)
{
  std::vector<std::string> names;
  for (const pugi::xml_node &one : camera.parent().children()) {
    if (std::string(one.name()) != "camera") {
      document.refuse(one, "a <camera> with a <model> must be the only node in its file: delete <" +
                               std::string(one.name()) + ">, or write px, py, u0 and v0 into the <camera> itself");
    }
    names.push_back(std::string("'") + one.child_value("name") + "' " + one.child_value("image_width") + " x " +
                    one.child_value("image_height"));
  }
  if (names.size() > 1) {
    document.refuse(camera, "there are " + std::to_string(names.size()) + " cameras (" + listText(names) +
                                "): delete all but the one that took the images");
  }
}

// Of what a calibration writes, the camera with distortion: the tracker takes it out.
pugi::xml_node chooseModel(const XmlDocument &document, const pugi::xml_node &camera)
{
  const std::string without = "perspectiveProjWithoutDistortion";
  const std::string with = "perspectiveProjWithDistortion";
  pugi::xml_node chosen;
  std::string kannalaBrandt;
  for (const pugi::xml_node &model : camera.children("model")) {
    const std::string type = model.child_value("type");
    if (type == "ProjWithKannalaBrandtDistortion") {
      kannalaBrandt = "; images of a camera with " + type + " have to be undistorted first";
      continue;
    }
    if (type != with && type != without) {
      document.refuse(model, "<type> in <model> is '" + type + "', it must be " + without + " or " + with);
    }
    if (chosen && chosen.child_value("type") == type) {
      document.refuse(model, "there are two <model> of type " + type + " in the <camera>: delete one of them");
    }
    chosen = !chosen || type == with ? model : chosen;
  }
  if (!chosen) {
    document.refuse(camera, "the <camera> has no <model> of type " + without + " or " + with + kannalaBrandt);
  }
  return chosen;
}

// A file of vpXmlParserCamera, which prints, and in some versions makes up what is missing.
void takeCameraModel(const XmlDocument &document, Draft &draft)
{
  const pugi::xml_node camera = document.find("camera/model").parent();
  requireOneCamera(document, camera);
  const pugi::xml_node model = chooseModel(document, camera);
  const std::string type = model.child_value("type");
  const bool distorted = type == "perspectiveProjWithDistortion";
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
  reportDocument(document, model, draft.report);
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
  reportDocument(document, {}, draft.report);
}
} // namespace vpSettingsDetail
END_VISP_NAMESPACE
