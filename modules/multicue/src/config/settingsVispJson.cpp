// SPDX-License-Identifier: GPL-2.0-or-later
#include "config/settingsVispJson.h"

#include "config/settingsText.h"

#include <visp3/core/vpException.h>
#include <visp3/cues/vpEdgeCue.h>

#include <algorithm>
#include <initializer_list>

BEGIN_VISP_NAMESPACE
namespace vpSettingsDetail {
namespace {
using Json = nlohmann::ordered_json;

[[noreturn]] void refuse(const std::string &reason)
{
  throw vpException(vpException::badValue, reason);
}

const Json &object(const Json &parent, const std::string &name)
{
  static const Json none = Json::object();
  if (!parent.is_object() || !parent.contains(name)) {
    return none;
  }
  if (!parent[name].is_object()) {
    refuse("'" + name + "' is no object {...}");
  }
  return parent[name];
}

// Carries members over under other names, and notes the rest.
class Carrier
{
public:
  explicit Carrier(VispJson &result) : m_result(result) {}

  struct Name
  {
    const char *theirs;
    const char *object;
    const char *ours;
  };

  void carry(const Json &from, const std::string &place, const std::vector<Name> &names,
             const std::vector<std::string> &otherwise)
  {
    for (const auto &[key, value] : from.items()) {
      const std::string &theirs = key;
      const auto name = std::find_if(names.begin(), names.end(), [&](const Name &one) { return theirs == one.theirs; });
      if (name != names.end()) {
        m_result.known[name->object][name->ours] = value;
      } else if (std::find(otherwise.begin(), otherwise.end(), theirs) == otherwise.end()) {
        m_result.left.push_back(place.empty() ? theirs : place + "." + theirs);
      }
    }
  }

private:
  VispJson &m_result;
};

void takeCamera(const Json &camera, const std::string &place, VispJson &result)
{
  const std::string model = camera.value("model", std::string("perspectiveWithoutDistortion"));
  const bool distorted = model == "perspectiveWithDistortion";
  if (!distorted && model != "perspectiveWithoutDistortion") {
    refuse("the camera model '" + model +
           "' is not known: perspectiveWithoutDistortion and perspectiveWithDistortion are");
  }
  std::vector<std::string> needed = {"px", "py", "u0", "v0"};
  if (distorted) {
    needed.insert(needed.end(), {"kud", "kdu"});
  }
  for (const std::string &name : needed) {
    if (!camera.contains(name)) {
      refuse("the camera has no '" + name + "'");
    }
    result.known["camera"][name] = camera[name];
  }
  needed.insert(needed.end(), {"model", "kud", "kdu"}); // What a camera without distortion says of it is 0.
  Carrier(result).carry(camera, place, {}, needed);
}

void takeEdges(const Json &edge, const std::string &place, VispJson &result)
{
  Carrier(result).carry(
      edge, place, {{"maskSize", "edge", "maskSize"}, {"range", "edge", "range"}, {"sampleStep", "view", "sampleStep"}},
      {"mu", "threshold", "thresholdType"});
  if (edge.contains("mu")) {
    const Json &mu = edge["mu"];
    if (!mu.is_array() || mu.size() != 2) {
      refuse("'mu' of the edges is to be a list of two numbers");
    }
    result.known["edge"]["mu1"] = mu[0];
    result.known["edge"]["mu2"] = mu[1];
  }
  if (!edge.contains("threshold")) {
    return;
  }
  const Json maskSize = edge.value("maskSize", Json(vpEdgeCueSettings().maskSize));
  if (!edge["threshold"].is_number() || !maskSize.is_number_unsigned() || maskSize.get<double>() > 100.) {
    refuse("'threshold' and 'maskSize' of the edges are to be numbers");
  }
  const bool inGrayLevels = edge.value("thresholdType", std::string("old")) == "normalized";
  result.known["edge"]["contrast"] = vpEdgeCueSettings::toContrast(
      edge["threshold"].get<double>(), inGrayLevels ? vpEdgeCueSettings::CONTRAST : vpEdgeCueSettings::LIKELIHOOD,
      maskSize.get<unsigned int>());
}

void takePoints(const Json &klt, const std::string &place, const std::vector<std::string> &otherwise, VispJson &result)
{
  std::vector<Carrier::Name> names;
  for (const char *name :
       {"maxFeatures", "windowSize", "quality", "minDistance", "harris", "blockSize", "pyramidLevels", "maskBorder"}) {
    names.push_back({name, "klt", name});
  }
  Carrier(result).carry(klt, place, names, otherwise);
}

bool has(const Json &list, std::initializer_list<const char *> words)
{
  return list.is_array() && std::any_of(list.begin(), list.end(), [&](const Json &one) {
           return std::any_of(words.begin(), words.end(), [&](const char *word) { return one == word; });
         });
}

void takeClipping(const Json &clipping, VispJson &result)
{
  const Json flags = clipping.value("flags", Json::array());
  if (has(flags, {"near", "all"}) && clipping.contains("near")) {
    result.known["view"]["nearDistance"] = clipping["near"];
  }
  if (has(flags, {"far", "all"}) && clipping.contains("far")) {
    result.known["view"]["farDistance"] = clipping["far"];
  }
  if (has(flags, {"fov", "all"})) {
    result.known["view"]["clipToImage"] = true;
  }
}

void takeCue(const std::string &theirs, const std::string &place, VispJson &result)
{
  const std::string ours = theirs == "edge" || theirs == "silhouetteMe" ? "edge"
                           : theirs == "klt"                            ? "point"
                           : theirs == "silhouetteColor"                ? "color"
                                                                        : "";
  if (ours.empty()) {
    result.left.push_back(place + " '" + theirs + "'");
  } else if (!has(result.known.value("cues", Json::array()), {ours.c_str()})) {
    result.known["cues"].push_back(ours);
  }
}

void takeGeneric(const Json &json, VispJson &result)
{
  const Json &trackers = object(json, "trackers");
  const std::string name = json.value("referenceCameraName", std::string());
  const std::string chosen = trackers.contains(name) || trackers.empty() ? name : trackers.begin().key();
  const Json &tracker = object(trackers, chosen);
  if (tracker.empty()) {
    refuse("it has no tracker '" + chosen + "' in 'trackers'");
  }
  for (const auto &other : trackers.items()) {
    if (other.key() != chosen) {
      result.left.push_back("camera '" + other.key() + "'");
    }
  }
  if (!object(tracker, "camera").empty()) {
    takeCamera(object(tracker, "camera"), "camera", result);
  }
  takeEdges(object(tracker, "edge"), "edge", result);
  takePoints(object(tracker, "klt"), "klt", {}, result);
  takeClipping(object(tracker, "clipping"), result);
  for (const Json &type : tracker.value("type", Json::array())) {
    takeCue(type.is_string() ? type.get<std::string>() : type.dump(), "type", result);
  }
  Carrier(result).carry(tracker, "",
                        {{"angleAppear", "view", "appearAngle"}, {"angleDisappear", "view", "disappearAngle"}},
                        {"camera", "edge", "klt", "clipping", "type", "camTref"});
  Carrier(result).carry(object(json, "lod"), "lod",
                        {{"useLod", "lod", "use"},
                         {"minLineLengthThresholdGeneral", "lod", "minLineLength"},
                         {"minPolygonAreaThresholdGeneral", "lod", "minPolygonArea"}},
                        {});
  Carrier(result).carry(json, "", {}, {"referenceCameraName", "trackers", "version", "lod"});
}

void takeRenderBased(const Json &json, VispJson &result)
{
  const Json &camera = object(json, "camera");
  if (!object(camera, "intrinsics").empty()) {
    takeCamera(object(camera, "intrinsics"), "camera.intrinsics", result);
  }
  for (const Json &feature : json.value("features", Json::array())) {
    const std::string type = feature.is_object() ? feature.value("type", std::string()) : feature.dump();
    takeCue(type, "feature", result);
    if (type == "silhouetteMe") {
      takeEdges(object(feature, "movingEdge"), "movingEdge", result);
      Carrier(result).carry(feature, type, {{"numCandidates", "edge", "candidates"}}, {"type", "movingEdge"});
    } else if (type == "klt") {
      takePoints(feature, type, {"type"}, result);
    }
  }
  Carrier(result).carry(json, "", {}, {"camera", "features"});
}
} // namespace

VispJson readVispJson(const Json &json)
{
  VispJson result;
  result.known = Json::object();
  try {
    if (json.contains("trackers") || json.contains("referenceCameraName")) {
      result.tracker = "vpMbGenericTracker";
      takeGeneric(json, result);
    } else if (json.contains("features") || json.contains("vvs") ||
               (json.contains("camera") && json["camera"].is_object() && json["camera"].contains("intrinsics"))) {
      result.tracker = "vpRBTracker";
      takeRenderBased(json, result);
    }
  } catch (const std::exception &e) {
    const auto *error = dynamic_cast<const vpException *>(&e);
    refuse("this is a configuration of " + result.tracker +
           ", and it is broken: " + (error != nullptr ? error->getMessage() : e.what()) +
           "; mend it, or write the settings in the JSON of vpMbMultiCueTracker or the XML of vpMbGenericTracker");
  }
  return result;
}
} // namespace vpSettingsDetail
END_VISP_NAMESPACE
