// SPDX-License-Identifier: GPL-2.0-or-later
#include "config/jsonValues.h"

#include <optional>
#include <type_traits>

BEGIN_VISP_NAMESPACE
namespace vpSettingsDetail {
namespace {
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

std::optional<int> meaning(const Json &json, const Words &words)
{
  for (const auto &[name, value] : words) {
    if (json == name) {
      return value;
    }
  }
  return std::nullopt;
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

template <typename Value> bool assign(const Json &json, const Range &range, std::optional<Value> &value)
{
  return assign(json, range, value.emplace());
}

bool assign(const Json &json, const Range &range, std::map<int, double> &factors)
{
  if (!json.is_object()) {
    return false;
  }
  for (const auto &[name, value] : json.items()) {
    const std::optional<int> type = meaning(name, cueWords());
    if (!type || !assign(value, range, factors[*type])) {
      return false;
    }
  }
  return true;
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

template <typename Value> Json toJson(const std::optional<Value> &value)
{
  return *value;
}

// All cues, those too whose factor nobody set.
Json toJson(const std::map<int, double> &factors)
{
  Json json = Json::object();
  for (const auto &[name, type] : cueWords()) {
    const auto found = factors.find(type);
    json[name] = found == factors.end() ? 1. : found->second;
  }
  return json;
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
} // namespace

bool readPlace(const Entry &entry, const Json &given, Draft &draft)
{
  return std::visit([&](auto at) { return assign(given, entry.range, at(draft)); }, entry.place);
}

Json placeAsJson(const Entry &entry, Draft &draft)
{
  return std::visit([&](auto at) { return toJson(at(draft)); }, entry.place);
}
} // namespace vpSettingsDetail
END_VISP_NAMESPACE
