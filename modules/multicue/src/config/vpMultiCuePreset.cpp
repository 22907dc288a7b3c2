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

// Of a frame that looks for a lost object: the time between two images of a camera with 30 of them in a second.
constexpr double searchBudget = 33.; // Milliseconds.
// [T10]'s potential edges: so many serve better than the default where edges lie close together.
constexpr unsigned int severalCandidates = 5;

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
  settings.searchBudget = searchBudget;
}

void makeStatic(vpMultiCueSettings &settings)
{
  makeRobust(settings);
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
  searches = false;
  searchBudget = 0.;
  switch (preset) {
  case vpMultiCuePreset::ROBUST:
    return makeRobust(*this);
  case vpMultiCuePreset::FAST:
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
