// SPDX-License-Identifier: GPL-2.0-or-later
#include <visp3/multicue/vpMultiCuePreset.h>

#include "config/settingsText.h"

#include <visp3/core/vpException.h>
#include <visp3/multicue/vpMbMultiCueTracker.h>

#include <array>
#include <utility>

BEGIN_VISP_NAMESPACE

namespace {
using Name = std::pair<vpMultiCuePreset, const char *>;
constexpr std::array<Name, 5> presetNames = {{{vpMultiCuePreset::ROBUST, "robust"},
                                              {vpMultiCuePreset::FAST, "fast"},
                                              {vpMultiCuePreset::STATIC, "static"},
                                              {vpMultiCuePreset::TEULIERE2010, "teuliere2010"},
                                              {vpMultiCuePreset::PETIT2014, "petit2014"}}};

// Between two images of a camera with 30 of them in a second, for a frame that looks for a lost object.
constexpr double timeOfImage = 33.; // Milliseconds.
// [T10]'s potential edges: so many serve better than the default where edges lie close together.
constexpr unsigned int severalCandidates = 5;

// STATIC. The rendered box of multicue-generate (seed 5, images 10, 30 and 50) at rest, each as 400 images with noise
// of 3 gray levels, in colour and in gray: mean deviation of the pose across the view, along it, and of its turn.
//   FAST                               0.0101 mm  0.0479 mm  0.0222 degrees
//   ROBUST                             0.0055 mm  0.0261 mm  0.0087 degrees
//   with this wander                   0.0052 mm  0.0250 mm  0.0082 degrees
//   with this contour deviation        0.0050 mm  0.0238 mm  0.0080 degrees
//   STATIC, with both                  0.0049 mm  0.0235 mm  0.0079 degrees
// A tenth of this wander gave the same; a contour deviation of 2 was worse, and one of 0.1 gave 1.5 to 2 times what
// ROBUST has. So most is gained by several cues, and a tenth by what is set here: the estimated pose is given as it is,
// not smoothed.
constexpr double restingTranslation = 0.01; // m/s per square root of a second: a hundredth of the default.
constexpr double restingRotation = 0.03;    // rad/s per square root of a second, likewise.
constexpr double restingContour = 1.;       // Pixels; lets colours count less beside edges and points.

// A build without OpenCV's modules for points goes on with the others.
int allCues()
{
  const int points = vpPointCue::isAvailable() ? vpMbMultiCueTracker::KLT_TRACKER : 0;
  return vpMbMultiCueTracker::EDGE_TRACKER | vpMbMultiCueTracker::COLOR_TRACKER | points;
}

void fuse(vpMultiCueSettings &settings)
{
  settings.cues = allCues();
  settings.predicts = true;
}

void makeRobust(vpMultiCueSettings &settings)
{
  fuse(settings);
  settings.searches = true;
  settings.frameDeadline = timeOfImage;
}

void makeStatic(vpMultiCueSettings &settings)
{
  makeRobust(settings);
  settings.prediction.translationWander = restingTranslation;
  settings.prediction.rotationWander = restingRotation;
  settings.color.contourDeviation = restingContour;
}

// [T10]: edges alone, an object that wanders, 100 particles, the best ones optimised in pose-hypothesis mode. Where all
// of them have lost the object, the search finds it again.
void followHypotheses(vpMultiCueSettings &settings)
{
  settings.edge.candidates = severalCandidates;
  settings.hypotheses.enabled = true;
  settings.particles.enabled = true;
  settings.searches = true;
}
} // namespace

const char *toString(vpMultiCuePreset preset)
{
  for (const Name &name : presetNames) {
    if (name.first == preset) {
      return name.second;
    }
  }
  throw vpException(vpException::badValue, "vpMultiCuePreset %d is not known", static_cast<int>(preset));
}

std::vector<std::string> vpMultiCuePresetNames()
{
  std::vector<std::string> names;
  for (const Name &name : presetNames) {
    names.emplace_back(name.second);
  }
  return names;
}

vpMultiCuePreset vpMultiCuePresetFromString(const std::string &name)
{
  for (const Name &known : presetNames) {
    if (name == known.second) {
      return known.first;
    }
  }
  throw vpException(vpException::badValue, "Preset '" + name + "' is not known; known are " +
                                               vpSettingsDetail::listText(vpMultiCuePresetNames()));
}

void vpMultiCueSettings::setPreset(vpMultiCuePreset preset)
{
  toString(preset);                  // Throws before anything is changed.
  const vpMultiCueSettings defaults; // So that nothing of another preset remains.
  cues = vpMbMultiCueTracker::EDGE_TRACKER;
  edge.candidates = defaults.edge.candidates;
  hypotheses = defaults.hypotheses;
  particles = defaults.particles;
  color = defaults.color;
  predicts = false;
  prediction = defaults.prediction;
  predictsRange = false;
  searches = false;
  frameDeadline = 0.;
  switch (preset) {
  case vpMultiCuePreset::ROBUST:
    return makeRobust(*this);
  case vpMultiCuePreset::FAST:
    frameDeadline = timeOfImage;
    return;
  case vpMultiCuePreset::STATIC:
    return makeStatic(*this);
  case vpMultiCuePreset::TEULIERE2010:
    return followHypotheses(*this);
  case vpMultiCuePreset::PETIT2014:
    return fuse(*this);
  }
}

END_VISP_NAMESPACE
