// SPDX-License-Identifier: GPL-2.0-or-later
#include "config/settingsJson.h"

#include "config/settingsTable.h"
#include "config/settingsText.h"
#include "config/settingsVispJson.h"

#include <visp3/core/vpException.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <type_traits>

BEGIN_VISP_NAMESPACE
namespace vpSettingsDetail {
namespace {
using Json = nlohmann::ordered_json; // In the order of the table.

const std::string presetKey = "preset";

[[noreturn]] void refuse(const std::string &file, const std::string &reason)
{
  throw vpException(vpException::badValue, "Configuration file '" + file + "': " + reason);
}

constexpr int deepest = 20;

Json parse(const std::string &file)
{
  const bool throwing = true, withComments = true;
  // What is nested deeper than any setting would be written into messages by functions that call themselves.
  const auto shallow = [&](int depth, Json::parse_event_t, Json &) {
    if (depth > deepest) {
      refuse(file, "it is nested more than " + std::to_string(deepest) + " deep");
    }
    return true;
  };
  try {
    return Json::parse(readTextFile(file), shallow, throwing, withComments);
  } catch (const Json::exception &error) {
    const std::string message = error.what();
    const std::size_t end = message.find("] "); // Of the library's name for the error.
    refuse(file, "this is no JSON: " + (end == std::string::npos ? message : message.substr(end + 2)));
  }
}

std::vector<std::string> objectNames()
{
  std::vector<std::string> names = {presetKey};
  for (const Entry &entry : settingsTable()) {
    if (names.empty() || names.back() != entry.object) {
      names.push_back(entry.object);
    }
  }
  return names;
}

std::vector<std::string> keysOf(const std::string &object)
{
  std::vector<std::string> keys;
  for (const Entry &entry : settingsTable()) {
    if (entry.object == object) {
      keys.push_back(entry.key);
    }
  }
  return keys;
}

void requireKnown(const std::string &file, const std::string &what, const std::string &name,
                  const std::vector<std::string> &known)
{
  if (std::find(known.begin(), known.end(), name) == known.end()) {
    refuse(file, "'" + name + "' is not known " + what + "; known are " + listText(known));
  }
}

template <typename Value> bool hasType(const Json &json)
{
  if constexpr (std::is_same_v<Value, bool>) {
    return json.is_boolean();
  } else if constexpr (std::is_integral_v<Value>) {
    return json.is_number_integer();
  } else {
    return json.is_number();
  }
}

// The range is tested before the value becomes an integer, which may have no room for it.
template <typename Value>
auto assign(const Json &json, const Range &range, Value &value) -> std::enable_if_t<std::is_arithmetic_v<Value>, bool>
{
  if (!hasType<Value>(json) || (json.is_number() && !range.contains(json.get<double>()))) {
    return false;
  }
  value = json.get<Value>();
  return true;
}

bool assign(const Json &json, const Range &range, std::optional<double> &value)
{
  return assign(json, range, value.emplace());
}

template <typename Value> bool assign(const Json &json, const Range &range, std::vector<Value> &values)
{
  if (!json.is_array()) {
    return false;
  }
  values.assign(json.size(), Value());
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!assign(json[i], range, values[i])) {
      return false;
    }
  }
  return true;
}

std::optional<int> meaning(const Json &json, const Words &words)
{
  for (const auto &[name, value] : words) {
    if (json == name) {
      return value;
    }
  }
  return std::nullopt;
}

template <typename Enum>
auto assign(const Json &json, const Range &, Enum &choice) -> std::enable_if_t<std::is_enum_v<Enum>, bool>
{
  const std::optional<int> value = meaning(json, wordsOf(Enum()));
  choice = value ? static_cast<Enum>(*value) : choice;
  return value.has_value();
}

bool assign(const Json &json, const Range &, std::string &text)
{
  text = json.is_string() ? json.get<std::string>() : std::string();
  return json.is_string();
}

bool assign(const Json &json, const Range &, CueSum &cues)
{
  cues.sum = 0;
  for (const Json &one : json.is_array() ? json : Json::array()) {
    const std::optional<int> value = meaning(one, cueWords());
    if (!value) {
      return false;
    }
    cues.sum |= *value;
  }
  return cues.sum != 0;
}

Json toJson(const std::optional<double> &value)
{
  return *value;
}

template <typename Enum> Json wordOf(Enum choice)
{
  for (const auto &[name, value] : wordsOf(choice)) {
    if (value == static_cast<int>(choice)) {
      return name;
    }
  }
  return nullptr;
}

Json toJson(const CueSum &cues)
{
  Json names = Json::array();
  for (const auto &[name, value] : cueWords()) {
    if ((cues.sum & value) != 0) {
      names.push_back(name);
    }
  }
  return names;
}

template <typename Value> Json toJson(const Value &value)
{
  if constexpr (std::is_enum_v<Value>) {
    return wordOf(value);
  } else {
    return value;
  }
}

void readValue(const std::string &file, const Entry &entry, const Json &given, Draft &draft)
{
  if (!std::visit([&](auto at) { return assign(given, entry.range, at(draft)); }, entry.place)) {
    refuse(file, entry.name() + " is " + given.dump() + ", it must be " + entry.describe());
  }
  draft.said.insert(entry.name());
}

// Before all others, which override it.
void readPreset(const std::string &file, const Json &json, Draft &draft)
{
  const std::vector<std::string> known = vpMultiCuePresetNames();
  const std::string name = json.is_string() ? json.get<std::string>() : std::string();
  if (std::find(known.begin(), known.end(), name) == known.end()) {
    refuse(file, presetKey + " is " + json.dump() + ", it must be one of " + listText(known));
  }
  draft.setPreset(vpMultiCuePresetFromString(name));
}

void readObject(const std::string &file, const std::string &object, const Json &json, Draft &draft)
{
  requireKnown(file, "as an object", object, objectNames());
  if (keysOf(object) == std::vector<std::string>{""}) {
    readValue(file, settingsEntry(object), json, draft);
    return;
  }
  if (!json.is_object()) {
    refuse(file, "'" + object + "' is " + json.dump() + ", it must be an object {...} with any of the keys " +
                     listText(keysOf(object)));
  }
  for (const auto &[key, value] : json.items()) {
    requireKnown(file, "in '" + object + "'", key, keysOf(object));
    readValue(file, settingsEntry(object + '.' + key), value, draft);
  }
}
} // namespace

namespace {
// In the words of this tracker, whichever one of ViSP it was written for.
Json parseKnown(const std::string &file, Draft &draft)
{
  Json json = parse(file);
  if (!json.is_object()) {
    refuse(file, "it must be an object {...} with any of " + listText(objectNames()));
  }
  try {
    VispJson other = readVispJson(json);
    draft.tracker = other.tracker;
    draft.left = other.left;
    return other.tracker.empty() ? json : other.known;
  } catch (const vpException &error) {
    refuse(file, error.getMessage());
  }
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
    if (object != presetKey) {
      readObject(file, object, value, draft);
    }
  }
}

std::string jsonText(const vpMultiCueSettings &settings)
{
  Draft draft(settings);
  Json json = Json::object();
  for (const Entry &entry : settingsTable()) {
    if (entry.isSet(draft)) {
      Json &place = *entry.key == '\0' ? json[entry.object] : json[entry.object][entry.key];
      std::visit([&](auto at) { place = toJson(at(draft)); }, entry.place);
    }
  }
  return json.dump(2) + '\n';
}
} // namespace vpSettingsDetail
END_VISP_NAMESPACE
