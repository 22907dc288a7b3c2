// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef settingsFiles_h
#define settingsFiles_h

#include <exceptionMessage.h>
#include <meshFiles.h>

#include <visp3/core/vpException.h>
#include <visp3/multicue/vpMultiCueSettings.h>
#include <visp3/se3/vpExactNumber.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

//! Configuration files that tests write and read, and what they are compared with.
namespace settingsFiles {
using Folder = meshFiles::TemporaryFolder;
using ::messageOf;

inline std::string textOf(const std::string &file)
{
  std::ifstream stream(file, std::ios::binary);
  return std::string(std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>());
}

//! \return What is read from a file with this name and text.
inline vpMultiCueSettings read(const std::string &name, const std::string &text,
                               const vpMultiCueSettings &defaults = vpMultiCueSettings())
{
  const Folder folder;
  return vpMultiCueSettingsReader::read(folder.write(name, text), defaults);
}

//! \return The message that reading such a file ends with.
inline std::string refusal(const std::string &name, const std::string &text)
{
  return messageOf([&] { read(name, text); });
}

//! \return Settings that differ from the defaults in every member, most of them in the last digit too.
inline vpMultiCueSettings unusual()
{
  vpMultiCueSettings settings;
  settings.camera.initPersProjWithDistortion(1000. / 3., 2000. / 7., 0.1 + 0.2, -1e-17, -0.1 / 3., 0.1 / 7.);
  settings.edge.range = 100. / 9.;
  settings.edge.contrast = 10. / 3.;
  settings.edge.mu1 = 1. / 3.;
  settings.edge.mu2 = 1e22 / 3.;
  settings.edge.maskSize = 7;
  settings.edge.candidates = 1;
  settings.hypotheses = {true, 10. / 7., 77, 7, 2. / 3., 2.5, 4000000001U};
  settings.particles.enabled = true;
  settings.particles.number = 77;
  settings.particles.leastNumber = 33;
  settings.particles.mostNumber = 99;
  settings.particles.budget = 100. / 7.;
  settings.particles.translationNoise = 1. / 30.;
  settings.particles.rotationNoise = 1. / 70.;
  settings.particles.motionNoise = 4. / 3.;
  settings.particles.jumpShare = 1. / 3.;
  settings.particles.jumpFactor = 7. / 3.;
  settings.particles.noiseFrame = vpParticleSettings::CAMERA;
  settings.particles.motion = vpParticleSettings::VELOCITY;
  settings.particles.lambda = 100. / 3.;
  settings.particles.sharpness = 100. / 7.;
  settings.particles.bestShare = 1. / 7.;
  settings.particles.mostOptimised = 9;
  settings.particles.output = vpParticleSettings::MEAN;
  settings.particles.modeTranslation = 1. / 9.;
  settings.particles.modeRotation = 2. / 9.;
  settings.particles.seed = 4000000003U;
  settings.view.sampleStep = 20. / 3.;
  settings.view.appearAngle = 200. / 3.;
  settings.view.disappearAngle = 220. / 3.;
  settings.view.nearDistance = 1e-3 / 3.;
  settings.view.farDistance = 1e3 / 3.;
  settings.view.border = 1. / 7.;
  settings.view.visibilitySize = 4000000000U;
  settings.view.textureEdges = false;
  settings.klt = {321, 7, 0.1 / 3., 8. / 3., 0.1 / 7., 5, 2, 9, false, 1. / 7.};
  settings.cues = 18;
  settings.color.spacing = 10. / 3.;
  settings.color.lines = 123;
  settings.color.scales = {9, 4};
  settings.color.bands = {20. / 3., 5. / 3., 2. / 3.};
  settings.color.length = 22. / 3.;
  settings.color.alpha = 1. / 3.;
  settings.color.regularisation = 23. / 3.;
  settings.color.contourDeviation = 1. / 7.;
  settings.color.histogramLength = 50. / 3.;
  settings.color.learningRate = 1. / 7.;
  settings.color.rows = vpColorCueSettings::PIXELS;
  settings.predicts = true;
  settings.prediction = {1. / 3., 2. / 3., 4. / 3., 5. / 3., 7. / 3., false};
  settings.frameInterval = 1. / 70.;
  settings.searches = true;
  settings.frameDeadline = 1000. / 7.;
  settings.symmetries = "/objects/models_info.json";
  settings.symmetricObject = 4000000005U;
  settings.useLod = true;
  settings.minLineLength = 100. / 3.;
  settings.minPolygonArea = 1000. / 7.;
  settings.clipToImage = true;
  settings.goodRatio = 1. / 3.;
  settings.factors = {{1, 1. / 3.}, {2, 2. / 3.}, {16, 4. / 3.}};
  settings.predictsRange = true;
  settings.estimation = {
      vpEstimationSettings::LEVENBERG_MARQUARDT, 2. / 3., 17, 1. / 30., 1e-7 / 3., true, true, {1, 0, 1, 1, 1, 0}};
  settings.renderer = vpModelRenderer::CPU;
  settings.throwsOnLoss = true;
  settings.display = {true, true, true};
  settings.model = {0.001, 100. / 3., 1e-6 / 3., 1e-3 / 3., 100. / 3.};
  settings.modelFile = "/objects/thing.obj";
  return settings;
}
} // namespace settingsFiles

// In ViSP's namespace, where Catch2 looks for them. Every member is compared to the last digit: what was written has to
// be what is read.
BEGIN_VISP_NAMESPACE
//! The numbers of one object and of another one.
using vpNumbers = std::vector<double>;
inline bool vpSameNumbers(const vpNumbers &a, const vpNumbers &b)
{
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), vpIsSame);
}
inline vpNumbers vpNumbersOf(const vpPointCueSettings &s)
{
  return {
      double(s.maxFeatures),   double(s.windowSize), s.quality,           s.minDistance, s.harris, double(s.blockSize),
      double(s.pyramidLevels), double(s.maskBorder), double(s.useHarris), s.leastWeight};
}
inline vpNumbers vpNumbersOf(const vpEdgeCueSettings &s)
{
  return {s.range, s.contrast, s.mu1, s.mu2, double(s.maskSize), double(s.candidates)};
}
inline vpNumbers vpNumbersOf(const vpPoseHypothesisSettings &s)
{
  return {double(s.enabled), s.lambda, double(s.draws), double(s.minimisations),
          s.mergeTolerance,  s.reach,  double(s.seed)};
}
inline vpNumbers vpNumbersOf(const vpModelViewOptions &s)
{
  return {s.sampleStep,  s.appearAngle, s.disappearAngle,         s.nearDistance,
          s.farDistance, s.border,      double(s.visibilitySize), double(s.textureEdges)};
}
inline vpNumbers vpNumbersOf(const vpCameraParameters &s)
{
  return {double(s.get_projModel()), s.get_px(), s.get_py(), s.get_u0(), s.get_v0(), s.get_kud(), s.get_kdu()};
}
inline vpNumbers vpNumbersOf(const vpColorCueSettings &s)
{
  vpNumbers numbers = {s.spacing,          double(s.lines),   s.length,       s.alpha,        s.regularisation,
                       s.contourDeviation, s.histogramLength, s.learningRate, double(s.rows), double(s.scales.size())};
  numbers.insert(numbers.end(), s.scales.begin(), s.scales.end());
  numbers.insert(numbers.end(), s.bands.begin(), s.bands.end());
  return numbers;
}
inline vpNumbers vpNumbersOf(const vpPoseKalmanSettings &s)
{
  return {s.translationWander, s.rotationWander, s.startTranslation, s.startRotation, s.longestGap, double(s.smooth)};
}
inline vpNumbers vpNumbersOf(const vpParticleSettings &s)
{
  return {double(s.enabled), double(s.number),   double(s.leastNumber), double(s.mostNumber),
          s.budget,          s.translationNoise, s.rotationNoise,       s.motionNoise,
          s.jumpShare,       s.jumpFactor,       double(s.noiseFrame),  double(s.motion),
          s.lambda,          s.sharpness,        s.bestShare,           double(s.mostOptimised),
          double(s.output),  s.modeTranslation,  s.modeRotation,        double(s.seed)};
}
inline vpNumbers vpNumbersOf(const vpEstimationSettings &s)
{
  vpNumbers numbers = {
      double(s.method),         s.gain, double(s.maxIterations), s.initialMu, s.convergence, double(s.covariance),
      double(s.projectionError)};
  numbers.insert(numbers.end(), s.motions.begin(), s.motions.end());
  return numbers;
}
inline vpNumbers vpNumbersOf(const vpDisplaySettings &s)
{
  return {double(s.features), double(s.hypotheses), double(s.particles)};
}
inline vpNumbers vpNumbersOf(const vpModelOptions &s)
{
  return {s.unit, s.creaseAngle, s.weldTolerance, s.minSize, s.maxSize};
}
//! The factor of each cue, 1 where none was set.
inline vpNumbers vpNumbersOf(const std::map<int, double> &factors)
{
  vpNumbers numbers;
  for (const int type : {1, 2, 16}) {
    numbers.push_back(factors.count(type) > 0 ? factors.at(type) : 1.);
  }
  return numbers;
}
template <typename Settings>
auto operator==(const Settings &a, const Settings &b) -> decltype(vpSameNumbers(vpNumbersOf(a), vpNumbersOf(b)))
{
  return vpSameNumbers(vpNumbersOf(a), vpNumbersOf(b));
}
inline bool sameCamera(const vpCameraParameters &a, const vpCameraParameters &b)
{
  return vpSameNumbers(vpNumbersOf(a), vpNumbersOf(b));
}
inline bool operator==(const vpMultiCueSettings &a, const vpMultiCueSettings &b)
{
  const auto others = [](const vpMultiCueSettings &s) {
    return vpNumbers{double(s.cues),     double(s.predicts),    s.frameInterval,           double(s.predictsRange),
                     double(s.searches), s.frameDeadline,       double(s.symmetricObject), double(s.useLod),
                     s.minLineLength,    s.minPolygonArea,      double(s.clipToImage),     s.goodRatio,
                     double(s.renderer), double(s.throwsOnLoss)};
  };
  return sameCamera(a.camera, b.camera) && a.edge == b.edge && a.hypotheses == b.hypotheses &&
         a.particles == b.particles && a.view == b.view && a.klt == b.klt && a.color == b.color &&
         a.prediction == b.prediction && a.estimation == b.estimation && a.display == b.display && a.model == b.model &&
         vpSameNumbers(vpNumbersOf(a.factors), vpNumbersOf(b.factors)) && a.symmetries == b.symmetries &&
         a.modelFile == b.modelFile && vpSameNumbers(others(a), others(b));
}
END_VISP_NAMESPACE

#endif
