// SPDX-License-Identifier: GPL-2.0-or-later
#include "config/settingsTable.h"

#include "config/settingsText.h"

#include <visp3/multicue/vpCueKind.h>

#include <cmath>
#include <type_traits>

BEGIN_VISP_NAMESPACE
namespace vpSettingsDetail {
bool Range::contains(double value) const
{
  return std::isfinite(value) && (lowIncluded ? value >= low : value > low) && value <= high;
}

std::string Range::describe(const std::string &noun) const
{
  const std::string start = "a " + noun;
  if (std::isinf(low)) {
    return start + unit;
  }
  if (std::isinf(high)) {
    return start + (lowIncluded ? " of at least " : " above ") + numberText(low) + unit;
  }
  return start + " in " + (lowIncluded ? "[" : "(") + numberText(low) + ", " + numberText(high) + "]" + unit;
}

std::string Entry::name() const
{
  return *key == '\0' ? std::string(object) : std::string(object) + '.' + key;
}

namespace {
template <typename Value> struct IsList : std::false_type
{
};
template <typename Value> struct IsList<std::vector<Value>> : std::true_type
{
};
} // namespace

std::vector<double> Entry::values(Draft &draft) const
{
  return std::visit(
      [&](auto at) -> std::vector<double> {
        using Value = std::decay_t<decltype(at(draft))>;
        if constexpr (std::is_same_v<Value, std::optional<double>>) {
          return at(draft) ? std::vector<double>{*at(draft)} : std::vector<double>();
        } else if constexpr (IsList<Value>::value) {
          return std::vector<double>(at(draft).begin(), at(draft).end());
        } else if constexpr (std::is_same_v<Value, std::map<int, double>>) {
          std::vector<double> factors;
          for (const auto &[type, factor] : at(draft)) {
            factors.push_back(factor);
          }
          return factors;
        } else if constexpr (std::is_arithmetic_v<Value>) {
          return {static_cast<double>(at(draft))};
        } else {
          return {};
        }
      },
      place);
}

bool Entry::isSet(Draft &draft) const
{
  const auto *number = std::get_if<std::optional<double> &(*)(Draft &)>(&place);
  const auto *flag = std::get_if<std::optional<bool> &(*)(Draft &)>(&place);
  return (number == nullptr || (*number)(draft)) && (flag == nullptr || (*flag)(draft));
}

std::vector<std::string> Entry::words() const
{
  return std::visit(
      [](auto at) -> std::vector<std::string> {
        using Value = std::decay_t<decltype(at(std::declval<Draft &>()))>;
        if constexpr (std::is_enum_v<Value>) {
          return namesOf(wordsOf(Value()));
        } else if constexpr (std::is_same_v<Value, CueSum>) {
          return namesOf(cueWords());
        } else {
          return {};
        }
      },
      place);
}

std::string Entry::describe() const
{
  return std::visit(
      [&](auto at) -> std::string {
        using Value = std::decay_t<decltype(at(std::declval<Draft &>()))>;
        if constexpr (std::is_same_v<Value, bool> || std::is_same_v<Value, std::optional<bool>>) {
          return "true or false";
        } else if constexpr (std::is_enum_v<Value>) {
          return "one of " + listText(namesOf(wordsOf(Value())));
        } else if constexpr (std::is_same_v<Value, CueSum>) {
          return "a list of one or more of " + listText(namesOf(cueWords()));
        } else if constexpr (std::is_same_v<Value, std::map<int, double>>) {
          return "an object {...} with " + range.describe("number") + " for any of the keys " +
                 listText(namesOf(cueWords()));
        } else if constexpr (std::is_same_v<Value, std::string>) {
          return range.unit;
        } else if constexpr (IsList<Value>::value) {
          return "a list [...], each " +
                 range.describe(std::is_integral_v<typename Value::value_type> ? "whole number" : "number");
        } else {
          return range.describe(std::is_integral_v<Value> ? "whole number" : "number");
        }
      },
      place);
}

const Words &wordsOf(vpColorCueSettings::Rows)
{
  static const Words words = {{"lines", vpColorCueSettings::LINES}, {"pixels", vpColorCueSettings::PIXELS}};
  return words;
}

const Words &wordsOf(vpParticleSettings::NoiseFrame)
{
  static const Words words = {{"object", vpParticleSettings::OBJECT}, {"camera", vpParticleSettings::CAMERA}};
  return words;
}

const Words &wordsOf(vpParticleSettings::Motion)
{
  static const Words words = {{"random walk", vpParticleSettings::RANDOM_WALK},
                              {"velocity", vpParticleSettings::VELOCITY}};
  return words;
}

const Words &wordsOf(vpParticleSettings::Output)
{
  static const Words words = {{"mean", vpParticleSettings::MEAN}, {"best mode", vpParticleSettings::BEST_MODE}};
  return words;
}

const Words &wordsOf(vpEstimationSettings::Method)
{
  static const Words words = {{"gauss newton", vpEstimationSettings::GAUSS_NEWTON},
                              {"levenberg marquardt", vpEstimationSettings::LEVENBERG_MARQUARDT}};
  return words;
}

const Words &wordsOf(vpModelRenderer::Preference)
{
  static const Words words = {
      {"automatic", vpModelRenderer::AUTOMATIC}, {"egl", vpModelRenderer::EGL}, {"cpu", vpModelRenderer::CPU}};
  return words;
}

Words cueWords()
{
  Words words;
  for (const vpCueKind &kind : vpCueKinds::all()) {
    words.emplace_back(kind.name, kind.type);
  }
  return words;
}

std::vector<std::string> namesOf(const Words &words)
{
  std::vector<std::string> names;
  for (const auto &[name, value] : words) {
    names.emplace_back(name);
  }
  return names;
}
} // namespace vpSettingsDetail
END_VISP_NAMESPACE
