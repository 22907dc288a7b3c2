// SPDX-License-Identifier: GPL-2.0-or-later
#include "config/settingsTable.h"

#include "config/settingsText.h"

#include <visp3/core/vpException.h>
#include <visp3/multicue/vpCueKind.h>

#include <algorithm>
#include <cmath>
#include <tuple>
#include <type_traits>

BEGIN_VISP_NAMESPACE
namespace vpSettingsDetail {
namespace {
constexpr double infinite = std::numeric_limits<double>::infinity();

template <auto Member> auto &ofCamera(Draft &draft)
{
  return draft.camera.*Member;
}

template <auto Member> auto &ofSettings(Draft &draft)
{
  return draft.members.*Member;
}

template <auto Part, auto Member> auto &ofPart(Draft &draft)
{
  return draft.members.*Part.*Member;
}

template <auto Member> constexpr auto ofEdge = &ofPart<&vpMultiCueSettings::edge, Member>;
template <auto Member> constexpr auto ofHypotheses = &ofPart<&vpMultiCueSettings::hypotheses, Member>;
template <auto Member> constexpr auto ofView = &ofPart<&vpMultiCueSettings::view, Member>;
template <auto Member> constexpr auto ofKlt = &ofPart<&vpMultiCueSettings::klt, Member>;
template <auto Member> constexpr auto ofColor = &ofPart<&vpMultiCueSettings::color, Member>;
template <auto Member> constexpr auto ofParticles = &ofPart<&vpMultiCueSettings::particles, Member>;
template <auto Member> constexpr auto ofPrediction = &ofPart<&vpMultiCueSettings::prediction, Member>;

CueSum &ofCues(Draft &draft)
{
  return draft.cues;
}

Range between(double low, double high, const char *unit = "")
{
  return {low, high, true, unit};
}

Range above(double low, double high = infinite, const char *unit = "")
{
  return {low, high, false, unit};
}
} // namespace

CameraParts CameraParts::of(const vpCameraParameters &camera)
{
  CameraParts parts = {camera.get_px(), camera.get_py(), camera.get_u0(), camera.get_v0(), std::nullopt, std::nullopt};
  if (camera.get_projModel() != vpCameraParameters::perspectiveProjWithoutDistortion) {
    parts.kud = camera.get_kud();
    parts.kdu = camera.get_kdu();
  }
  return parts;
}

vpCameraParameters CameraParts::camera() const
{
  vpCameraParameters camera;
  if (kud || kdu) {
    camera.initPersProjWithDistortion(px, py, u0, v0, kud.value_or(0.), kdu.value_or(0.));
  } else {
    camera.initPersProjWithoutDistortion(px, py, u0, v0);
  }
  return camera;
}

bool CameraParts::operator==(const CameraParts &other) const
{
  return std::tie(px, py, u0, v0, kud, kdu) == std::tie(other.px, other.py, other.u0, other.v0, other.kud, other.kdu);
}

Draft::Draft(const vpMultiCueSettings &settings)
    : members(settings), camera(CameraParts::of(settings.camera)), cues{settings.cues}
{
}

vpMultiCueSettings Draft::settings() const
{
  vpMultiCueSettings settings = members;
  settings.cues = cues.sum;
  if (!(camera == CameraParts::of(members.camera))) {
    settings.camera = camera.camera();
  }
  return settings;
}

void Draft::setPreset(vpMultiCuePreset chosen)
{
  members.setPreset(chosen);
  cues.sum = members.cues;
  preset = chosen;
}

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
  const auto *optional = std::get_if<std::optional<double> &(*)(Draft &)>(&place);
  return optional == nullptr || (*optional)(draft).has_value();
}

std::string Entry::describe() const
{
  return std::visit(
      [&](auto at) -> std::string {
        using Value = std::decay_t<decltype(at(std::declval<Draft &>()))>;
        if constexpr (std::is_same_v<Value, bool>) {
          return "true or false";
        } else if constexpr (std::is_enum_v<Value>) {
          return "one of " + listText(namesOf(wordsOf(Value())));
        } else if constexpr (std::is_same_v<Value, CueSum>) {
          return "a list of one or more of " + listText(namesOf(cueWords()));
        } else if constexpr (std::is_same_v<Value, std::string>) {
          return "\"none\", \"find\", the path of a models_info.json, or \"\" for what the program says";
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

const std::vector<Entry> &settingsTable()
{
  using Settings = vpMultiCueSettings;
  using Edge = vpEdgeCueSettings;
  using Hypotheses = vpPoseHypothesisSettings;
  using View = vpModelViewOptions;
  using Klt = vpPointCueSettings;
  using Color = vpColorCueSettings;
  using Prediction = vpPoseKalmanSettings;
  using Particles = vpParticleSettings;
  static const std::vector<Entry> table = {
      {"cues", "", &ofCues, {}},
      {"camera", "px", &ofCamera<&CameraParts::px>, above(0., infinite, " pixels")},
      {"camera", "py", &ofCamera<&CameraParts::py>, above(0., infinite, " pixels")},
      {"camera", "u0", &ofCamera<&CameraParts::u0>, {}},
      {"camera", "v0", &ofCamera<&CameraParts::v0>, {}},
      {"camera", "kud", &ofCamera<&CameraParts::kud>, {}},
      {"camera", "kdu", &ofCamera<&CameraParts::kdu>, {}},
      {"edge", "range", ofEdge<&Edge::range>, between(1., 100., " pixels")},
      {"edge", "contrast", ofEdge<&Edge::contrast>, above(0., 255., " gray levels")},
      {"edge", "mu1", ofEdge<&Edge::mu1>, between(0., 1.)},
      {"edge", "mu2", ofEdge<&Edge::mu2>, between(0., infinite)},
      {"edge", "maskSize", ofEdge<&Edge::maskSize>, between(3., 15., " pixels")},
      {"edge", "candidates", ofEdge<&Edge::candidates>, between(1., 8.)},
      {"hypotheses", "enabled", ofHypotheses<&Hypotheses::enabled>, {}},
      {"hypotheses", "lambda", ofHypotheses<&Hypotheses::lambda>, between(0., 100.)},
      {"hypotheses", "draws", ofHypotheses<&Hypotheses::draws>, between(1., 10000.)},
      {"hypotheses", "minimisations", ofHypotheses<&Hypotheses::minimisations>, between(1., 1000.)},
      {"hypotheses", "mergeTolerance", ofHypotheses<&Hypotheses::mergeTolerance>, above(0., 100., " pixels")},
      {"hypotheses", "reach", ofHypotheses<&Hypotheses::reach>, between(1., 10.)},
      {"hypotheses", "seed", ofHypotheses<&Hypotheses::seed>, between(0., std::numeric_limits<unsigned int>::max())},
      {"particles", "enabled", ofParticles<&Particles::enabled>, {}},
      {"particles", "number", ofParticles<&Particles::number>, between(10., 10000.)},
      {"particles", "leastNumber", ofParticles<&Particles::leastNumber>, between(10., 10000.)},
      {"particles", "mostNumber", ofParticles<&Particles::mostNumber>, between(10., 10000.)},
      {"particles", "budget", ofParticles<&Particles::budget>, between(0., 1000., " milliseconds")},
      {"particles", "translationNoise", ofParticles<&Particles::translationNoise>, above(0., 1., " diameters")},
      {"particles", "rotationNoise", ofParticles<&Particles::rotationNoise>, above(0., 1., " radians")},
      {"particles", "motionNoise", ofParticles<&Particles::motionNoise>, between(0., 10.)},
      {"particles", "jumpShare", ofParticles<&Particles::jumpShare>, between(0., 0.9)},
      {"particles", "jumpFactor", ofParticles<&Particles::jumpFactor>, between(1., 100.)},
      {"particles", "noiseFrame", ofParticles<&Particles::noiseFrame>, {}},
      {"particles", "motion", ofParticles<&Particles::motion>, {}},
      {"particles", "lambda", ofParticles<&Particles::lambda>, between(0., 1000.)},
      {"particles", "sharpness", ofParticles<&Particles::sharpness>, between(0., 1000.)},
      {"particles", "bestShare", ofParticles<&Particles::bestShare>, between(0., 1.)},
      {"particles", "mostOptimised", ofParticles<&Particles::mostOptimised>, between(0., 100.)},
      {"particles", "output", ofParticles<&Particles::output>, {}},
      {"particles", "modeTranslation", ofParticles<&Particles::modeTranslation>, above(0., 10., " diameters")},
      {"particles", "modeRotation", ofParticles<&Particles::modeRotation>, above(0., 3., " radians")},
      {"particles", "seed", ofParticles<&Particles::seed>, between(0., std::numeric_limits<unsigned int>::max())},
      {"view", "sampleStep", ofView<&View::sampleStep>, between(0.5, infinite, " pixels")},
      {"view", "appearAngle", ofView<&View::appearAngle>, above(0., 90., " degrees")},
      {"view", "disappearAngle", ofView<&View::disappearAngle>, above(0., 90., " degrees")},
      {"view", "nearDistance", ofView<&View::nearDistance>, above(0., infinite, " metres")},
      {"view", "farDistance", ofView<&View::farDistance>, between(0., infinite, " metres")},
      {"view", "border", ofView<&View::border>, between(0., infinite, " pixels")},
      {"view", "visibilitySize", ofView<&View::visibilitySize>,
       between(16., std::numeric_limits<unsigned int>::max(), " pixels")},
      {"view", "textureEdges", ofView<&View::textureEdges>, {}},
      {"view", "clipToImage", &ofSettings<&Settings::clipToImage>, {}},
      {"klt", "maxFeatures", ofKlt<&Klt::maxFeatures>, between(1., 100000.)},
      {"klt", "windowSize", ofKlt<&Klt::windowSize>, between(3., 63., " pixels")},
      {"klt", "quality", ofKlt<&Klt::quality>, above(0., 1.)},
      {"klt", "minDistance", ofKlt<&Klt::minDistance>, between(0., 1000., " pixels")},
      {"klt", "harris", ofKlt<&Klt::harris>, between(0., 1.)},
      {"klt", "blockSize", ofKlt<&Klt::blockSize>, between(1., 63., " pixels")},
      {"klt", "pyramidLevels", ofKlt<&Klt::pyramidLevels>, between(1., 10.)},
      {"klt", "maskBorder", ofKlt<&Klt::maskBorder>, between(0., 100., " pixels")},
      {"color", "spacing", ofColor<&Color::spacing>, between(1., 100., " pixels")},
      {"color", "lines", ofColor<&Color::lines>, between(10., 5000.)},
      {"color", "scales", ofColor<&Color::scales>, between(1., 20., " pixels")},
      {"color", "bands", ofColor<&Color::bands>, between(0.5, 20., " pixels")},
      {"color", "length", ofColor<&Color::length>, between(3., 60., " pixels")},
      {"color", "alpha", ofColor<&Color::alpha>, above(0., 1.)},
      {"color", "regularisation", ofColor<&Color::regularisation>, between(1., 100., " gray levels")},
      {"color", "contourDeviation", ofColor<&Color::contourDeviation>, between(0.05, 5., " pixels")},
      {"color", "histogramLength", ofColor<&Color::histogramLength>, between(3., 60., " pixels")},
      {"color", "learningRate", ofColor<&Color::learningRate>, between(0., 1.)},
      {"color", "rows", ofColor<&Color::rows>, {}},
      {"prediction", "enabled", &ofSettings<&Settings::predicts>, {}},
      {"prediction", "frameInterval", &ofSettings<&Settings::frameInterval>, above(0., infinite, " seconds")},
      {"prediction", "translationWander", ofPrediction<&Prediction::translationWander>, above(0.)},
      {"prediction", "rotationWander", ofPrediction<&Prediction::rotationWander>, above(0.)},
      {"prediction", "startTranslation", ofPrediction<&Prediction::startTranslation>, above(0., infinite, " m/s")},
      {"prediction", "startRotation", ofPrediction<&Prediction::startRotation>, above(0., infinite, " rad/s")},
      {"prediction", "longestGap", ofPrediction<&Prediction::longestGap>, above(0., infinite, " seconds")},
      {"prediction", "smooth", ofPrediction<&Prediction::smooth>, {}},
      {"search", "", &ofSettings<&Settings::searches>, {}},
      {"searchBudget", "", &ofSettings<&Settings::searchBudget>, between(0., 10000., " milliseconds")},
      {"symmetries", "from", &ofSettings<&Settings::symmetries>, {}},
      {"symmetries", "object", &ofSettings<&Settings::symmetricObject>,
       between(0., std::numeric_limits<unsigned int>::max())},
      {"lod", "use", &ofSettings<&Settings::useLod>, {}},
      {"lod", "minLineLength", &ofSettings<&Settings::minLineLength>, between(0., infinite, " pixels")},
      {"lod", "minPolygonArea", &ofSettings<&Settings::minPolygonArea>, between(0., infinite, " square pixels")}};
  return table;
}

const Entry &settingsEntry(std::string_view name)
{
  const std::vector<Entry> &table = settingsTable();
  const auto found = std::find_if(table.begin(), table.end(), [&](const Entry &entry) { return entry.name() == name; });
  if (found == table.end()) {
    throw vpException(vpException::fatalError, "There is no setting '" + std::string(name) + "'");
  }
  return *found;
}
} // namespace vpSettingsDetail
END_VISP_NAMESPACE
