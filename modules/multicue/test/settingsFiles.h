// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef settingsFiles_h
#define settingsFiles_h

#include <meshFiles.h>

#include <visp3/core/vpException.h>
#include <visp3/multicue/vpMultiCueSettings.h>

#include <fstream>
#include <iterator>
#include <string>

//! Configuration files that tests write and read, and what they are compared with.
namespace settingsFiles {
using Folder = meshFiles::TemporaryFolder;

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

//! \return The message of the exception that an action ends with; "" where there is none.
template <typename Action> std::string messageOf(const Action &action)
{
  try {
    action();
  } catch (const vpException &error) {
    return error.what();
  }
  return "";
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
  settings.klt = {321, 7, 0.1 / 3., 8. / 3., 0.1 / 7., 5, 2, 9};
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
  settings.searchBudget = 1000. / 7.;
  settings.symmetries = "/objects/models_info.json";
  settings.symmetricObject = 4000000005U;
  settings.useLod = true;
  settings.minLineLength = 100. / 3.;
  settings.minPolygonArea = 1000. / 7.;
  settings.clipToImage = true;
  return settings;
}
} // namespace settingsFiles

// In ViSP's namespace, where Catch2 looks for them.
BEGIN_VISP_NAMESPACE
//! Compares every member, to the last digit.
inline bool operator==(const vpPointCueSettings &a, const vpPointCueSettings &b)
{
  return a.maxFeatures == b.maxFeatures && a.windowSize == b.windowSize && a.quality == b.quality &&
         a.minDistance == b.minDistance && a.harris == b.harris && a.blockSize == b.blockSize &&
         a.pyramidLevels == b.pyramidLevels && a.useHarris == b.useHarris && a.maskBorder == b.maskBorder;
}
inline bool operator==(const vpEdgeCueSettings &a, const vpEdgeCueSettings &b)
{
  return a.range == b.range && a.contrast == b.contrast && a.mu1 == b.mu1 && a.mu2 == b.mu2 &&
         a.maskSize == b.maskSize && a.candidates == b.candidates;
}
inline bool operator==(const vpPoseHypothesisSettings &a, const vpPoseHypothesisSettings &b)
{
  return a.enabled == b.enabled && a.lambda == b.lambda && a.draws == b.draws && a.minimisations == b.minimisations &&
         a.mergeTolerance == b.mergeTolerance && a.reach == b.reach && a.seed == b.seed;
}
inline bool operator==(const vpModelViewOptions &a, const vpModelViewOptions &b)
{
  return a.sampleStep == b.sampleStep && a.appearAngle == b.appearAngle && a.disappearAngle == b.disappearAngle &&
         a.nearDistance == b.nearDistance && a.farDistance == b.farDistance && a.border == b.border &&
         a.visibilitySize == b.visibilitySize && a.textureEdges == b.textureEdges;
}
inline bool sameCamera(const vpCameraParameters &a, const vpCameraParameters &b)
{
  return a.get_projModel() == b.get_projModel() && a.get_px() == b.get_px() && a.get_py() == b.get_py() &&
         a.get_u0() == b.get_u0() && a.get_v0() == b.get_v0() && a.get_kud() == b.get_kud() &&
         a.get_kdu() == b.get_kdu();
}
inline bool operator==(const vpColorCueSettings &a, const vpColorCueSettings &b)
{
  return a.spacing == b.spacing && a.lines == b.lines && a.scales == b.scales && a.bands == b.bands &&
         a.length == b.length && a.alpha == b.alpha && a.regularisation == b.regularisation &&
         a.contourDeviation == b.contourDeviation && a.histogramLength == b.histogramLength &&
         a.learningRate == b.learningRate && a.rows == b.rows;
}
inline bool operator==(const vpPoseKalmanSettings &a, const vpPoseKalmanSettings &b)
{
  return a.translationWander == b.translationWander && a.rotationWander == b.rotationWander &&
         a.startTranslation == b.startTranslation && a.startRotation == b.startRotation &&
         a.longestGap == b.longestGap && a.smooth == b.smooth;
}
inline bool operator==(const vpParticleSettings &a, const vpParticleSettings &b)
{
  return a.enabled == b.enabled && a.number == b.number && a.leastNumber == b.leastNumber &&
         a.mostNumber == b.mostNumber && a.budget == b.budget && a.translationNoise == b.translationNoise &&
         a.rotationNoise == b.rotationNoise && a.motionNoise == b.motionNoise && a.jumpShare == b.jumpShare &&
         a.jumpFactor == b.jumpFactor && a.noiseFrame == b.noiseFrame && a.motion == b.motion && a.lambda == b.lambda &&
         a.sharpness == b.sharpness && a.bestShare == b.bestShare && a.mostOptimised == b.mostOptimised &&
         a.output == b.output && a.modeTranslation == b.modeTranslation && a.modeRotation == b.modeRotation &&
         a.seed == b.seed;
}
inline bool operator==(const vpMultiCueSettings &a, const vpMultiCueSettings &b)
{
  return sameCamera(a.camera, b.camera) && a.edge == b.edge && a.hypotheses == b.hypotheses &&
         a.particles == b.particles && a.view == b.view && a.klt == b.klt && a.cues == b.cues && a.color == b.color &&
         a.predicts == b.predicts && a.prediction == b.prediction && a.frameInterval == b.frameInterval &&
         a.searches == b.searches && a.searchBudget == b.searchBudget && a.symmetries == b.symmetries &&
         a.symmetricObject == b.symmetricObject && a.useLod == b.useLod && a.minLineLength == b.minLineLength &&
         a.minPolygonArea == b.minPolygonArea && a.clipToImage == b.clipToImage;
}
END_VISP_NAMESPACE

#endif
