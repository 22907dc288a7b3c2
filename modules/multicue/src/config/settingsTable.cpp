// SPDX-License-Identifier: GPL-2.0-or-later
#include "config/settingsTable.h"

#include <visp3/core/vpException.h>

#include <algorithm>

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
template <auto Member> constexpr auto ofEstimation = &ofPart<&vpMultiCueSettings::estimation, Member>;
template <auto Member> constexpr auto ofDisplay = &ofPart<&vpMultiCueSettings::display, Member>;
template <auto Member> constexpr auto ofModel = &ofPart<&vpMultiCueSettings::model, Member>;

// What is no part of the settings themselves.
template <auto Member> auto &ofDraft(Draft &draft)
{
  return draft.*Member;
}

// Of text: what it has to say.
Range text(const char *description)
{
  Range range;
  range.unit = description;
  return range;
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
  using Estimation = vpEstimationSettings;
  using Display = vpDisplaySettings;
  using Model = vpModelOptions;
  static const std::vector<Entry> table = {
      {"cues", "", &ofDraft<&Draft::cues>, {}},
      {"camera", "px", &ofCamera<&CameraParts::px>, above(0., infinite, " pixels")},
      {"camera", "py", &ofCamera<&CameraParts::py>, above(0., infinite, " pixels")},
      {"camera", "u0", &ofCamera<&CameraParts::u0>, {}},
      {"camera", "v0", &ofCamera<&CameraParts::v0>, {}},
      {"camera", "kud", &ofCamera<&CameraParts::kud>, {}},
      {"camera", "kdu", &ofCamera<&CameraParts::kdu>, {}},
      {"edge", "enabled", &ofDraft<&Draft::usesEdges>, {}},
      {"edge", "range", ofEdge<&Edge::range>, between(1., 100., " pixels")},
      {"edge", "contrast", ofEdge<&Edge::contrast>, above(0., 255., " gray levels")},
      {"edge", "mu1", ofEdge<&Edge::mu1>, between(0., 1.)},
      {"edge", "mu2", ofEdge<&Edge::mu2>, between(0., infinite)},
      {"edge", "maskSize", ofEdge<&Edge::maskSize>, between(3., 15., " pixels")},
      {"edge", "candidates", ofEdge<&Edge::candidates>, between(1., 8.)},
      {"edge", "goodRatio", &ofSettings<&Settings::goodRatio>, between(0., 1.)},
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
      {"klt", "enabled", &ofDraft<&Draft::usesPoints>, {}},
      {"klt", "maxFeatures", ofKlt<&Klt::maxFeatures>, between(1., 100000.)},
      {"klt", "windowSize", ofKlt<&Klt::windowSize>, between(3., 63., " pixels")},
      {"klt", "quality", ofKlt<&Klt::quality>, above(0., 1.)},
      {"klt", "minDistance", ofKlt<&Klt::minDistance>, between(0., 1000., " pixels")},
      {"klt", "harris", ofKlt<&Klt::harris>, between(0., 1.)},
      {"klt", "blockSize", ofKlt<&Klt::blockSize>, between(1., 63., " pixels")},
      {"klt", "pyramidLevels", ofKlt<&Klt::pyramidLevels>, between(1., 10.)},
      {"klt", "maskBorder", ofKlt<&Klt::maskBorder>, between(0., 100., " pixels")},
      {"klt", "useHarris", ofKlt<&Klt::useHarris>, {}},
      {"klt", "leastWeight", ofKlt<&Klt::leastWeight>, between(0., 0.999)},
      {"color", "enabled", &ofDraft<&Draft::usesColors>, {}},
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
      {"prediction", "range", &ofSettings<&Settings::predictsRange>, {}},
      {"frameDeadline", "", &ofSettings<&Settings::frameDeadline>, between(0., 10000., " milliseconds")},
      {"search", "enabled", &ofSettings<&Settings::searches>, {}},
      {"symmetries", "from", &ofSettings<&Settings::symmetries>,
       text("\"none\", \"find\", the path of a models_info.json, or \"\" for what the program says")},
      {"symmetries", "object", &ofSettings<&Settings::symmetricObject>,
       between(0., std::numeric_limits<unsigned int>::max())},
      {"lod", "enabled", &ofSettings<&Settings::useLod>, {}},
      {"lod", "minLineLength", &ofSettings<&Settings::minLineLength>, between(0., infinite, " pixels")},
      {"lod", "minPolygonArea", &ofSettings<&Settings::minPolygonArea>, between(0., infinite, " square pixels")},
      {"factors", "", &ofSettings<&Settings::factors>, above(0., 1e6)},
      {"estimation", "method", ofEstimation<&Estimation::method>, {}},
      {"estimation", "gain", ofEstimation<&Estimation::gain>, above(0., 10.)},
      {"estimation", "maxIterations", ofEstimation<&Estimation::maxIterations>, between(1., 10000.)},
      {"estimation", "initialMu", ofEstimation<&Estimation::initialMu>, between(0., infinite)},
      {"estimation", "convergence", ofEstimation<&Estimation::convergence>, between(0., infinite)},
      {"estimation", "covariance", ofEstimation<&Estimation::covariance>, {}},
      {"estimation", "projectionError", ofEstimation<&Estimation::projectionError>, {}},
      {"estimation", "motions", ofEstimation<&Estimation::motions>, between(0., 1.)},
      {"model", "file", &ofSettings<&Settings::modelFile>, text("the path of a model, or \"\" for none")},
      {"model", "unit", ofModel<&Model::unit>, above(0., infinite, " metres")},
      {"model", "creaseAngle", ofModel<&Model::creaseAngle>, above(0., 179.999, " degrees")},
      {"model", "weldTolerance", ofModel<&Model::weldTolerance>, between(0., 0.01, " diameters")},
      {"model", "minSize", ofModel<&Model::minSize>, above(0., infinite, " metres")},
      {"model", "maxSize", ofModel<&Model::maxSize>, above(0., infinite, " metres")},
      {"display", "features", ofDisplay<&Display::features>, {}},
      {"display", "hypotheses", ofDisplay<&Display::hypotheses>, {}},
      {"display", "particles", ofDisplay<&Display::particles>, {}},
      {"renderer", "", &ofSettings<&Settings::renderer>, {}},
      {"throwOnLoss", "", &ofSettings<&Settings::throwsOnLoss>, {}}};
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
