// SPDX-License-Identifier: GPL-2.0-or-later
#include "track/trackKeys.h"

#include <visp3/core/vpException.h>
#include <visp3/multicue/vpCueKind.h>

#include <functional>
#include <vector>

namespace programs {
namespace {
struct Key
{
  std::string name;
  std::string help;
  std::function<void(vpMbMultiCueTracker &, ViewState &)> apply;
};

// The last cue stays: there is no tracking without one.
void toggleCue(vpMbMultiCueTracker &tracker, ViewState &view, const vpCueKind &kind)
{
  const int type = tracker.getTrackerType() ^ kind.type;
  if (type != 0) {
    tracker.setTrackerType(type);
  }
  const bool isOn = (tracker.getTrackerType() & kind.type) != 0;
  view.message = kind.name + (isOn ? " on" : " off");
}

void toggleHypotheses(vpMbMultiCueTracker &tracker, ViewState &view)
{
  view.hypotheses = !view.hypotheses;
  vpPoseHypothesisSettings settings = tracker.getPoseHypothesisSettings();
  settings.enabled = view.hypotheses;
  tracker.setPoseHypothesisSettings(settings);
  view.message = view.hypotheses ? "hypotheses on" : "hypotheses off";
}

void toggleParticles(vpMbMultiCueTracker &tracker, ViewState &view)
{
  view.particles = !view.particles;
  vpParticleSettings settings = tracker.getParticleSettings();
  settings.enabled = view.particles;
  tracker.setParticleSettings(settings);
  view.message = view.particles ? "particles on" : "particles off";
}

void addPresets(std::vector<Key> &keys)
{
  int number = 0;
  for (const std::string &name : vpMultiCuePresetNames()) {
    keys.push_back({std::to_string(++number), "preset " + name, [name](vpMbMultiCueTracker &tracker, ViewState &view) {
                      tracker.setPreset(vpMultiCuePresetFromString(name));
                      view.hypotheses = tracker.getPoseHypothesisSettings().enabled;
                      view.particles = tracker.getParticleSettings().enabled;
                      view.message = "preset " + name;
                    }});
  }
}

void addCues(std::vector<Key> &keys)
{
  for (const vpCueKind &kind : vpCueKinds::all()) {
    keys.push_back({kind.name.substr(0, 1), "cue " + kind.name + " on or off",
                    [&kind](vpMbMultiCueTracker &tracker, ViewState &view) { toggleCue(tracker, view, kind); }});
  }
}

const std::vector<Key> &keys()
{
  static const std::vector<Key> table = [] {
    std::vector<Key> all = {
        {"q", "end", [](vpMbMultiCueTracker &, ViewState &view) { view.quit = true; }},
        {" ", "pause and go on", [](vpMbMultiCueTracker &, ViewState &view) { view.paused = !view.paused; }},
        {"n", "pause, and take the next frame",
         [](vpMbMultiCueTracker &, ViewState &view) { view.paused = view.step = true; }},
        {"r", "start anew: by clicks or the tag where they are given, else about the last pose",
         [](vpMbMultiCueTracker &, ViewState &view) { view.restart = true; }},
        {"f", "features on or off", [](vpMbMultiCueTracker &, ViewState &view) { view.features = !view.features; }},
        {"h", "pose hypotheses on or off", toggleHypotheses},
        {"a", "particles on or off", toggleParticles}};
    addPresets(all);
    addCues(all);
    return all;
  }();
  return table;
}
} // namespace

std::string keysHelp()
{
  std::string text;
  for (const Key &key : keys()) {
    const std::string left = "  " + (key.name == " " ? "space" : key.name);
    text += left + std::string(22 - left.size(), ' ') + key.help + "\n";
  }
  return text;
}

void applyKey(const std::string &name, vpMbMultiCueTracker &tracker, ViewState &view)
{
  for (const Key &key : keys()) {
    if (key.name == name || (key.name == " " && name == "space")) {
      view.message.clear();
      try {
        key.apply(tracker, view);
      } catch (const vpException &e) {
        view.message = e.getStringMessage(); // Such as a cue that the library was built without.
      }
      return;
    }
  }
}

} // namespace programs
