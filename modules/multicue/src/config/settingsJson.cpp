// SPDX-License-Identifier: GPL-2.0-or-later
#include "config/settingsJson.h"

#include "config/jsonValues.h"
#include "config/settingsNames.h"
#include "config/settingsText.h"
#include "config/settingsVispJson.h"

#include <visp3/core/vpException.h>
#include <visp3/model/vpJsonWatch.h>
#include <visp3/multicue/vpCueKind.h>

#include <algorithm>
#include <set>
#include <string_view>
#include <vector>

BEGIN_VISP_NAMESPACE
namespace vpSettingsDetail {
namespace {
[[noreturn]] void refuse(const std::string &file, const std::string &reason)
{
  throw vpException(vpException::badValue, "Configuration file '" + file + "': " + reason);
}

// What is nested deeper than any setting would be written into messages by functions that call themselves.
constexpr int deepest = 20;

Json parse(const std::string &file)
{
  const bool throwing = true, withComments = true;
  try {
    const vpJsonWatch watch(deepest, [&file](const std::string &reason) { refuse(file, reason); });
    return Json::parse(readTextFile(file), watch, throwing, withComments);
  } catch (const Json::exception &error) {
    const std::string message = error.what();
    const std::size_t end = message.find("] "); // Of the library's name for the error.
    refuse(file, "this is no JSON: " + (end == std::string::npos ? message : message.substr(end + 2)));
  }
}

// Where one of several words was meant.
std::string nearestWord(const Json &given, const std::vector<std::string> &words)
{
  return given.is_string() && !words.empty() ? "; the nearest is '" + nearestName(given.get<std::string>(), words) + "'"
                                             : "";
}

void readValue(const std::string &file, const Entry &entry, const Json &given, Draft &draft)
{
  if (!readPlace(entry, given, draft)) {
    refuse(file, entry.name() + " is " + given.dump() + ", it must be " + entry.describe() +
                     nearestWord(given, entry.words()));
  }
  draft.said.insert(entry.name());
}

// Before all others, which override it.
void readPreset(const std::string &file, const Json &json, Draft &draft)
{
  const std::vector<std::string> known = vpMultiCuePresetNames();
  const std::string name = json.is_string() ? json.get<std::string>() : std::string();
  if (std::find(known.begin(), known.end(), name) == known.end()) {
    refuse(file, std::string(presetKey) + " is " + json.dump() + ", it must be one of " + listText(known) +
                     nearestWord(json, known));
  }
  draft.setPreset(vpMultiCuePresetFromString(name));
  draft.said.insert(presetKey);
}

// true and false, which are short for an object that says nothing else.
void readSwitch(const std::string &file, const std::string &object, bool isOn, Draft &draft)
{
  if (object == "symmetries") {
    readValue(file, settingsEntry("symmetries.from"), isOn ? "find" : "none", draft);
  } else {
    readValue(file, settingsEntry(object + '.' + enabledKey), isOn, draft);
  }
}

void readObject(const std::string &file, const std::string &object, const Json &json, Draft &draft);
void readKey(const std::string &file, const std::string &object, const std::string &key, const Json &value,
             Draft &draft);

void readAs(const std::string &file, const OtherName &known, const Json &json, Draft &draft)
{
  if (*known.knownKey == '\0') {
    readObject(file, known.knownObject, json, draft);
  } else {
    readKey(file, known.knownObject, known.knownKey, json, draft);
  }
}

void readKey(const std::string &file, const std::string &object, const std::string &key, const Json &value,
             Draft &draft)
{
  for (const OtherName &other : otherNames()) {
    if (object == other.object && key == other.key) {
      return readAs(file, other, value, draft);
    }
  }
  const std::vector<std::string> known = keysOf(object);
  if (std::find(known.begin(), known.end(), key) == known.end()) {
    std::string elsewhere;
    for (const Entry &entry : settingsTable()) {
      elsewhere = entry.key == key ? "; it belongs to '" + std::string(entry.object) + "'" : elsewhere;
    }
    refuse(file, unknownText("in '" + object + "'", key, known) + elsewhere);
  }
  readValue(file, settingsEntry(object + '.' + key), value, draft);
}

void readObject(const std::string &file, const std::string &object, const Json &json, Draft &draft)
{
  for (const OtherName &other : otherNames()) {
    if (object == other.object && *other.key == '\0') {
      return readAs(file, other, json, draft);
    }
  }
  const std::vector<std::string> objects = objectNames();
  if (std::find(objects.begin(), objects.end(), object) == objects.end()) {
    refuse(file, unknownText("as an object", object, objects));
  }
  if (isValue(object)) {
    return readValue(file, settingsEntry(object), json, draft);
  }
  if (json.is_boolean() && isFeature(object)) {
    return readSwitch(file, object, json.get<bool>(), draft);
  }
  if (!json.is_object()) {
    refuse(file, "'" + object + "' is " + json.dump() + ", it must be " + (isFeature(object) ? "true, false or " : "") +
                     "an object {...} with any of the keys " + listText(keysOf(object)));
  }
  for (const auto &[key, value] : json.items()) {
    readKey(file, object, key, value, draft);
  }
}

// In the words of this tracker, whichever one of ViSP it was written for.
Json parseKnown(const std::string &file, Draft &draft)
{
  Json json = parse(file);
  if (!json.is_object()) {
    refuse(file, "it must be an object {...} with any of " + listText(objectNames()));
  }
  try {
    VispJson other = readVispJson(json);
    draft.report = other.report;
    if (other.report.format != vpConfigReport::Format::NONE) {
      return other.known;
    }
  } catch (const vpException &error) {
    refuse(file, error.getMessage());
  }
  draft.report.format = vpConfigReport::Format::MULTI_CUE_JSON;
  return json;
}

void requireOneWord(const std::string &file, const Draft &draft)
{
  const auto require = [&](const std::optional<bool> &isOn, const char *object, const char *cue) {
    const auto words = cueWords();
    const auto kind = std::find_if(words.begin(), words.end(), [&](const auto &word) { return word.first == cue; });
    const bool isAmong = (draft.cues.sum & kind->second) != 0;
    if (isOn && *isOn != isAmong && draft.said.count("cues") > 0) {
      refuse(file, std::string("'") + object + "' is " + (*isOn ? "on" : "off") + ", but 'cues' " +
                       (isAmong ? "has " : "has no ") + cue + ": say it in one of both places");
    }
  };
  require(draft.usesEdges, "edge", "edge");
  require(draft.usesPoints, "klt", "point");
  require(draft.usesColors, "color", "color");
}
} // namespace

void readJson(const std::string &file, Draft &draft)
{
  const Json json = parseKnown(file, draft);
  if (json.contains("camera")) { // A camera's distortion belongs to its other values and does not outlive them.
    draft.camera.kud.reset();
    draft.camera.kdu.reset();
  }
  if (json.contains(presetKey)) {
    readPreset(file, json[presetKey], draft);
  }
  for (const auto &[object, value] : json.items()) {
    if (object != presetKey && object != schemaKey) {
      readObject(file, object, value, draft);
    }
  }
  requireOneWord(file, draft);
  if (draft.report.format == vpConfigReport::Format::MULTI_CUE_JSON) {
    for (const std::string &name : draft.said) {
      draft.report.taken.push_back({name, name, ""});
    }
  }
}

std::string jsonText(const vpMultiCueSettings &settings, std::optional<vpMultiCuePreset> preset)
{
  Draft draft(settings);
  Json json = Json::object();
  if (preset) {
    json[presetKey] = toString(*preset);
    draft.sayCuesBeside(*preset);
  }
  for (const Entry &entry : settingsTable()) {
    const bool isSaid = preset && std::string_view(entry.object) == "cues";
    if (entry.isSet(draft) && !isSaid) {
      Json &place = *entry.key == '\0' ? json[entry.object] : json[entry.object][entry.key];
      place = placeAsJson(entry, draft);
    }
  }
  return json.dump(2) + '\n';
}
} // namespace vpSettingsDetail
END_VISP_NAMESPACE
