// SPDX-License-Identifier: GPL-2.0-or-later
#include "config/jsonValues.h"
#include "config/settingsJson.h"
#include "config/settingsNames.h"

#include <cmath>
#include <type_traits>

BEGIN_VISP_NAMESPACE
namespace vpSettingsDetail {
namespace {
Json numberSchema(const Range &range, bool isWhole)
{
  Json schema = {{"type", isWhole ? "integer" : "number"}};
  if (std::isfinite(range.low)) {
    schema[range.lowIncluded ? "minimum" : "exclusiveMinimum"] = range.low;
  }
  if (std::isfinite(range.high)) {
    schema["maximum"] = range.high;
  }
  return schema;
}

template <typename Value> Json typeSchema(const Entry &entry)
{
  if constexpr (std::is_same_v<Value, bool> || std::is_same_v<Value, std::optional<bool>>) {
    return {{"type", "boolean"}};
  } else if constexpr (std::is_enum_v<Value>) {
    return {{"enum", entry.words()}};
  } else if constexpr (std::is_same_v<Value, CueSum>) {
    return {{"type", "array"}, {"items", {{"enum", entry.words()}}}, {"minItems", 1}};
  } else if constexpr (std::is_same_v<Value, std::string>) {
    return {{"type", "string"}};
  } else if constexpr (std::is_same_v<Value, std::map<int, double>>) {
    Json factors = Json::object();
    for (const std::string &cue : namesOf(cueWords())) {
      factors[cue] = numberSchema(entry.range, false);
    }
    return {{"type", "object"}, {"properties", factors}, {"additionalProperties", false}};
  } else if constexpr (std::is_same_v<Value, std::vector<double>> || std::is_same_v<Value, std::vector<unsigned int>>) {
    const bool isWhole = std::is_integral_v<typename Value::value_type>;
    return {{"type", "array"}, {"items", numberSchema(entry.range, isWhole)}};
  } else {
    return numberSchema(entry.range, std::is_integral_v<Value>);
  }
}

Json entrySchema(const Entry &entry, Draft &defaults)
{
  Json schema = std::visit(
      [&](auto at) {
        using Value = std::decay_t<decltype(at(std::declval<Draft &>()))>;
        return typeSchema<Value>(entry);
      },
      entry.place);
  schema["description"] = entry.name() + ": " + entry.describe();
  if (entry.isSet(defaults) && std::string(entry.object) != "camera") { // Every camera has its own.
    schema["default"] = placeAsJson(entry, defaults);
  }
  return schema;
}

Json objectSchema(const std::string &object, Draft &defaults);

// Of what another name stands for.
Json knownSchema(const OtherName &other, Draft &defaults)
{
  return *other.knownKey == '\0'
             ? objectSchema(other.knownObject, defaults)
             : entrySchema(settingsEntry(std::string(other.knownObject) + '.' + other.knownKey), defaults);
}

Json objectSchema(const std::string &object, Draft &defaults)
{
  if (isValue(object)) {
    return entrySchema(settingsEntry(object), defaults);
  }
  Json keys = Json::object();
  for (const Entry &entry : settingsTable()) {
    if (entry.object == object) {
      keys[entry.key] = entrySchema(entry, defaults);
    }
  }
  for (const OtherName &other : otherNames()) {
    if (object == other.object && *other.key != '\0') {
      keys[other.key] = knownSchema(other, defaults);
    }
  }
  const Json schema = {{"type", "object"}, {"properties", keys}, {"additionalProperties", false}};
  return isFeature(object) ? Json{{"anyOf", {{{"type", "boolean"}}, schema}}} : schema;
}
} // namespace

std::string jsonSchemaText()
{
  Draft defaults((vpMultiCueSettings()));
  Json properties = Json::object();
  properties[schemaKey] = {{"type", "string"}};
  for (const std::string &object : objectNames()) {
    properties[object] = object == presetKey ? Json{{"enum", vpMultiCuePresetNames()}} : objectSchema(object, defaults);
  }
  for (const OtherName &other : otherNames()) {
    if (*other.key == '\0') {
      properties[other.object] = knownSchema(other, defaults);
    }
  }
  const Json schema = {
      {schemaKey, "http://json-schema.org/draft-07/schema#"},
      {"title", "Configuration of vpMbMultiCueTracker"},
      {"description", "Every key is optional. A feature is true, false or an object with its settings."},
      {"type", "object"},
      {"properties", properties},
      {"additionalProperties", false}};
  return schema.dump(2) + '\n';
}
} // namespace vpSettingsDetail
END_VISP_NAMESPACE
