// SPDX-License-Identifier: GPL-2.0-or-later
#include "config/settingsVispJson.h"

#include "config/vispJsonCarrier.h"
#include "config/vispJsonParts.h"

#include <visp3/core/vpException.h>

#include <algorithm>

BEGIN_VISP_NAMESPACE
namespace vpSettingsDetail {
namespace {
using Json = VispJsonCarrier::Json;
using Format = vpConfigReport::Format;

constexpr const char *ownSteps = "the estimation ends by itself where steps no longer move anything";
constexpr const char *ownWeights = "each cue is weighed by its own errors, and by 'factors'";
constexpr const char *needsMask = "a mask is given by setMask()";
constexpr const char *needsDepth = "it needs a depth camera";

[[noreturn]] void refuse(const std::string &reason)
{
  throw vpException(vpException::badValue, reason);
}

bool has(const Json &list, const std::vector<std::string> &words)
{
  return list.is_array() && std::any_of(list.begin(), list.end(), [&](const Json &one) {
           return std::any_of(words.begin(), words.end(), [&](const std::string &word) { return one == word; });
         });
}

void takeClipping(const std::string &place, VispJsonCarrier &carrier)
{
  carrier.objectAt(place);
  const Json flags = carrier.at(place + "/flags");
  carrier.leave(place, "'flags' do not ask for it");
  if (has(flags, {"near", "all"})) {
    carrier.take(place + "/near", "view.nearDistance");
  }
  if (has(flags, {"far", "all"})) {
    carrier.take(place + "/far", "view.farDistance");
  }
  if (has(flags, {"fov", "all"})) {
    carrier.set("view.clipToImage", true);
  }
  carrier.note(place + "/flags", "view.clipToImage", "and which of near and far are taken");
}

// \return The name of a cue here; empty where there is none.
std::string cueOf(const std::string &theirs)
{
  if (theirs == "edge" || theirs == "silhouetteMe") {
    return "edge";
  }
  return theirs == "klt" ? "point" : theirs == "silhouetteColor" ? "color" : "";
}

std::string reasonAgainst(const std::string &theirs)
{
  return theirs.compare(0, 5, "depth") == 0 ? needsDepth : "there is no such cue here";
}

class Cues
{
public:
  // \param place Of the word. \param theirs What is to be tracked.
  void add(const std::string &place, const std::string &theirs, VispJsonCarrier &carrier)
  {
    const std::string ours = cueOf(theirs);
    if (ours.empty()) {
      carrier.leave(place, reasonAgainst(theirs));
      return;
    }
    if (!has(m_names, {ours})) {
      m_names.push_back(ours);
    }
    carrier.set("cues", m_names);
    carrier.note(place, "cues");
  }

private:
  Json m_names = Json::array();
};

void takeTypes(const std::string &place, VispJsonCarrier &carrier)
{
  const Json types = carrier.has(place) ? carrier.at(place) : Json::array();
  if (!types.is_array()) {
    refuse("'type' is to be a list of names");
  }
  Cues cues;
  for (std::size_t i = 0; i < types.size(); ++i) {
    cues.add(place + "/" + std::to_string(i), types[i].is_string() ? types[i].get<std::string>() : types[i].dump(),
             carrier);
  }
}

VispJson readGeneric(const Json &json)
{
  VispJsonCarrier carrier(json);
  const Json &trackers = carrier.objectAt("/trackers");
  const std::string name = json.value("referenceCameraName", std::string());
  const std::string chosen = trackers.contains(name) || trackers.empty() ? name : trackers.begin().key();
  const std::string place = "/trackers/" + VispJsonCarrier::escaped(chosen);
  if (!trackers.contains(chosen) || carrier.objectAt(place).empty()) {
    refuse("it has no tracker '" + chosen + "' in 'trackers'");
  }
  for (const auto &other : trackers.items()) {
    if (other.key() != chosen) {
      carrier.leave("/trackers/" + VispJsonCarrier::escaped(other.key()), "one camera is tracked with");
    }
  }
  takeCamera(place + "/camera", carrier);
  takeEdges(place + "/edge", carrier);
  takePoints(place + "/klt", carrier);
  takeClipping(place + "/clipping", carrier);
  takeTypes(place + "/type", carrier);
  carrier.take(place + "/angleAppear", "view.appearAngle");
  carrier.take(place + "/angleDisappear", "view.disappearAngle");
  carrier.take(place + "/display/features", "display.features");
  for (const std::string &lod : {std::string("/lod"), place + "/lod"}) {
    carrier.take(lod + "/useLod", "lod.enabled");
    carrier.take(lod + "/minLineLengthThresholdGeneral", "lod.minLineLength");
    carrier.take(lod + "/minPolygonAreaThresholdGeneral", "lod.minPolygonArea");
  }
  carrier.leave(place + "/normals", needsDepth);
  carrier.leave(place + "/dense", needsDepth);
  carrier.leave(place + "/visibilityTest", "hidden edges are always removed");
  carrier.leave(place + "/camTref", "one camera is its own reference");
  carrier.leave("/referenceCameraName", "it says which tracker is taken");
  carrier.leave("/version", "it is that of the file's layout");
  return carrier.result(Format::GENERIC_JSON);
}

void takeFeature(const std::string &place, Cues &cues, VispJsonCarrier &carrier)
{
  const Json &feature = carrier.at(place);
  const std::string type = feature.is_object() ? feature.value("type", std::string()) : feature.dump();
  cues.add(place + "/type", type, carrier);
  if (type == "silhouetteMe") {
    takeEdges(place + "/movingEdge", carrier);
    carrier.take(place + "/numCandidates", "edge.candidates");
  } else if (type == "klt") {
    takePoints(place, carrier);
    carrier.leave(place + "/newPointsMinPixelDistance", "klt.minDistance holds for new points too");
    carrier.leave(place + "/minimumNumPoints", "points are added in each frame");
    carrier.leave(place + "/maxReprojectionErrorPixels", "the robust estimation tells");
  } else if (type == "silhouetteColor") {
    carrier.take(place + "/ccd/h", "color.length");
    carrier.take(place + "/maxNumPoints", "color.lines");
    carrier.leave(place + "/ccd", "the statistics adapt themselves to the contour's uncertainty");
    carrier.leave(place + "/temporalSmoothing", "color.alpha is the share of the current frame");
    carrier.leave(place + "/displayType", "features are drawn in one way");
  }
  if (cueOf(type).empty() && feature.is_object()) {
    carrier.leave(place, reasonAgainst(type));
  }
  carrier.leave(place + "/weight", ownWeights);
  for (const char *name : {"/convergencePixelThreshold", "/convergenceRatio", "/convergenceThreshold"}) {
    carrier.leave(place + name, ownSteps);
  }
  for (const char *name : {"/useMask", "/minMaskConfidence"}) {
    carrier.leave(place + name, needsMask);
  }
}

void takeRenderedModel(VispJsonCarrier &carrier)
{
  const Json &model = carrier.at("/model");
  const std::string file = model.is_string() ? model.get<std::string>() : "";
  const std::string end = file.substr(std::min(file.rfind('.'), file.size()));
  if (end == ".bam" || end == ".egg") {
    carrier.leave("/model", "Panda3D alone reads this format: give loadModel() the mesh that it was made of");
    return;
  }
  carrier.take("/model", "model.file",
               "ViSP's renderer turns .obj files by a quarter about x, so that their poses differ by that turn");
}

VispJson readRenderBased(const Json &json)
{
  VispJsonCarrier carrier(json);
  carrier.objectAt("/camera");
  takeCamera("/camera/intrinsics", carrier);
  takeRenderedModel(carrier);
  carrier.take("/vvs/gain", "estimation.gain");
  carrier.take("/vvs/maxIterations", "estimation.maxIterations");
  Cues cues;
  const Json features = carrier.has("/features") ? carrier.at("/features") : Json::array();
  for (std::size_t i = 0; i < features.size(); ++i) {
    takeFeature("/features/" + std::to_string(i), cues, carrier);
  }
  carrier.leave("/camera", "the images tell their size");
  carrier.leave("/vvs", "damping is that of 'estimation', Gauss and Newton's method without any by default");
  carrier.leave("/silhouetteExtractionSettings", "contours are found on the mesh, and not in a rendered depth image");
  carrier.leave("/mask", needsMask);
  carrier.leave("/drift", "state and score are always judged");
  carrier.leave("/odometry", "the motion is predicted by 'prediction'");
  carrier.leave("/verbose", "loadConfigFile() has an argument for it");
  carrier.leave("/displaySilhouette", "display() always draws the model");
  VispJson result = carrier.result(Format::RENDER_BASED_JSON);
  const auto size = [&](const char *name) {
    const Json &number = carrier.at(std::string("/camera/") + name);
    return number.is_number_unsigned() ? number.get<unsigned int>() : 0U;
  };
  result.report.imageWidth = size("width");
  result.report.imageHeight = size("height");
  return result;
}
} // namespace

VispJson readVispJson(const Json &json)
{
  const bool isGeneric = json.contains("trackers") || json.contains("referenceCameraName");
  const bool isRenderBased =
      json.contains("features") || json.contains("vvs") ||
      (json.contains("camera") && json["camera"].is_object() && json["camera"].contains("intrinsics"));
  if (!isGeneric && !isRenderBased) {
    return VispJson();
  }
  try {
    return isGeneric ? readGeneric(json) : readRenderBased(json);
  } catch (const std::exception &e) {
    const auto *error = dynamic_cast<const vpException *>(&e);
    refuse(std::string("this is a configuration of ") + (isGeneric ? "vpMbGenericTracker" : "vpRBTracker") +
           ", and it is broken: " + (error != nullptr ? error->getMessage() : e.what()) +
           "; mend it, or write the settings in the JSON of vpMbMultiCueTracker or the XML of vpMbGenericTracker");
  }
}
} // namespace vpSettingsDetail
END_VISP_NAMESPACE
