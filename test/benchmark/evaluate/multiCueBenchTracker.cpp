// SPDX-License-Identifier: GPL-2.0-or-later
#include "evaluate/multiCueBenchTracker.h"

#include <visp3/multicue/vpMbMultiCueTracker.h>

#include <functional>
#include <map>
#include <optional>

namespace bench {

namespace {
using Change = std::function<void(vpMbMultiCueTracker &)>;

// A preset of the library, whose single settings a configuration file may change, or what is changed in a tracker of
// edges whatever the file says.
struct Preset
{
  Preset(vpMultiCuePreset known) : ofLibrary(known) {}
  template <typename Function> Preset(const Function &function) : change(function) {}

  std::optional<vpMultiCuePreset> ofLibrary;
  Change change = [](vpMbMultiCueTracker &) {};
};

void setCandidates(vpMbMultiCueTracker &tracker, unsigned int candidates)
{
  vpEdgeCueSettings settings = tracker.getEdgeSettings();
  settings.candidates = candidates;
  tracker.setEdgeSettings(settings);
}

void useHypotheses(vpMbMultiCueTracker &tracker)
{
  tracker.setTrackerType(vpMbMultiCueTracker::EDGE_TRACKER);
  vpPoseHypothesisSettings settings = tracker.getPoseHypothesisSettings();
  settings.enabled = true;
  tracker.setPoseHypothesisSettings(settings);
  setCandidates(tracker, 5);
}

Change cues(int type)
{
  return [type](vpMbMultiCueTracker &tracker) { tracker.setTrackerType(type); };
}

// To compare those of the library with, some of which have a second name here: a new one is a line.
std::map<std::string, Preset> comparedPresets()
{
  using Tracker = vpMbMultiCueTracker;
  const int edge = Tracker::EDGE_TRACKER;
  const int point = Tracker::KLT_TRACKER;
  const int color = Tracker::COLOR_TRACKER;
  const Change searching = [=](Tracker &tracker) {
    tracker.setTrackerType(edge | color | point);
    tracker.setPrediction(true);
    tracker.setSearch(true);
    vpParticleSettings particles = tracker.getParticleSettings();
    particles.enabled = true;
    particles.motion = vpParticleSettings::Motion::VELOCITY;
    tracker.setParticleSettings(particles);
  };
  return {
      {"edge", cues(edge)},
      {"edge-geometry",
       [](Tracker &tracker) {
         tracker.setTrackerType(Tracker::EDGE_TRACKER);
         tracker.setTextureEdges(false);
       }},
      {"edge-mh", &useHypotheses},
      {"particles", vpMultiCuePreset::TEULIERE2010},
      {"edge-point", cues(edge | point)},
      {"color", cues(color)},
      {"point", cues(point)},
      {"multicue", cues(edge | color | point)},
      {"multicue-kalman", vpMultiCuePreset::PETIT2014},
      {"multicue-particles", searching},
      // [P14]'s ladder: C0 edges with one candidate, C1 several, NM with colours, C4 with points, C5 with prediction.
      {"c0",
       [](Tracker &tracker) {
         tracker.setTrackerType(Tracker::EDGE_TRACKER);
         setCandidates(tracker, 1);
       }},
      {"c0-c1", cues(edge)},
      {"nm", cues(edge | color)},
      {"nm-c4", cues(edge | color | point)},
      {"nm-c4-c5", vpMultiCuePreset::PETIT2014},
  };
}

const std::map<std::string, Preset> &presets()
{
  static const std::map<std::string, Preset> table = [] {
    std::map<std::string, Preset> all = comparedPresets();
    for (const std::string &name : vpMultiCuePresetNames()) {
      all.emplace(name, vpMultiCuePresetFromString(name));
    }
    return all;
  }();
  return table;
}

class MultiCueBenchTracker : public BenchTracker
{
public:
  MultiCueBenchTracker(const Preset &preset, const SequenceObject &object, const vpCameraParameters &cam,
                       const std::string &config, int cues)
  {
    if (preset.ofLibrary) {
      m_tracker.setPreset(*preset.ofLibrary);
    }
    if (!config.empty()) {
      m_tracker.loadConfigFile(config, false);
    }
    m_tracker.setCameraParameters(cam);
    m_tracker.setModelUnit(object.meshUnit);
    m_tracker.loadModel(object.mesh.empty() ? object.cao : object.mesh);
    preset.change(m_tracker);
    if (cues != 0) {
      m_tracker.setTrackerType(cues);
    }
  }

  void init(const BenchImage &I, const vpHomogeneousMatrix &cMo) override
  {
    if (I.isGray) {
      m_tracker.initFromPose(I.gray, cMo);
    } else {
      m_tracker.initFromPose(I.color, cMo);
    }
  }
  void startRoughly(const BenchImage &I, const vpHomogeneousMatrix &cMo, double angleDeviation,
                    double translationDeviation) override
  {
    vpPoseDeviation deviation;
    deviation.translation = translationDeviation;
    deviation.rotation = angleDeviation;
    m_tracker.initFromRoughPose(I.color, cMo, deviation);
  }
  bool startAnywhere(const BenchImage &I, double nearest, double farthest) override
  {
    vpDistanceRange distances;
    distances.nearest = nearest;
    distances.farthest = farthest;
    return I.isGray ? m_tracker.initFromImage(I.gray, distances) : m_tracker.initFromImage(I.color, distances);
  }
  void track(const BenchImage &I) override
  {
    if (I.isGray) {
      m_tracker.track(I.gray);
    } else {
      m_tracker.track(I.color);
    }
  }

  TrackerAnswer answer() override
  {
    TrackerAnswer answer;
    m_tracker.getPose(answer.cMo);
    answer.state = m_tracker.getTrackingState();
    answer.score = m_tracker.getTrackingResult().score;
    const vpTrackingTimings &timings = m_tracker.getTimings();
    answer.stages = {timings.frame, timings.view, timings.match, timings.pose, timings.map, timings.particles};
    answer.minimisations = m_tracker.getNbPoseMinimisations();
    return answer;
  }

  std::string text() const override { return m_tracker.getTrackingResult().text; }
  std::vector<std::string> stages() const override { return {"frame", "view", "match", "pose", "map", "particles"}; }

private:
  vpMbMultiCueTracker m_tracker{vpMbMultiCueTracker::EDGE_TRACKER};
};
} // namespace

std::vector<std::string> multiCuePresets()
{
  std::vector<std::string> names;
  for (const auto &preset : presets()) {
    names.push_back(preset.first);
  }
  return names;
}

std::unique_ptr<BenchTracker> makeMultiCueTracker(const std::string &preset, const SequenceObject &object,
                                                  const vpCameraParameters &cam, const std::string &config, int cues)
{
  return std::make_unique<MultiCueBenchTracker>(presets().at(preset), object, cam, config, cues);
}

} // namespace bench
