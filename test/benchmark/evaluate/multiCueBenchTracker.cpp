// SPDX-License-Identifier: GPL-2.0-or-later
#include "evaluate/multiCueBenchTracker.h"

#include <visp3/multicue/vpMbMultiCueTracker.h>

#include <functional>
#include <map>

namespace bench {

namespace {
using Preset = std::function<void(vpMbMultiCueTracker &)>;

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

// What each preset changes in a tracker with default settings: a new preset is a line here.
const std::map<std::string, Preset> &presets()
{
  using Tracker = vpMbMultiCueTracker;
  const int all = Tracker::EDGE_TRACKER | Tracker::COLOR_TRACKER | Tracker::KLT_TRACKER;
  static const std::map<std::string, Preset> table = {
      {"edge", [](Tracker &tracker) { tracker.setTrackerType(Tracker::EDGE_TRACKER); }},
      {"edge-texture",
       [](Tracker &tracker) {
         tracker.setTrackerType(Tracker::EDGE_TRACKER);
         tracker.setTextureEdges(true);
       }},
      {"edge-geometry",
       [](Tracker &tracker) {
         tracker.setTrackerType(Tracker::EDGE_TRACKER);
         tracker.setTextureEdges(false);
       }},
      {"edge-mh", &useHypotheses},
      {"edge-mh-texture",
       [](Tracker &tracker) {
         useHypotheses(tracker);
         tracker.setTextureEdges(true);
       }},
      {"color", [](Tracker &tracker) { tracker.setTrackerType(Tracker::COLOR_TRACKER); }},
      {"point", [](Tracker &tracker) { tracker.setTrackerType(Tracker::KLT_TRACKER); }},
      {"edge-point", [](Tracker &tracker) { tracker.setTrackerType(Tracker::EDGE_TRACKER | Tracker::KLT_TRACKER); }},
      // [P14]'s ladder: C0 edges with one candidate, C1 several, NM with colours, C4 with points, C5 with prediction.
      {"c0",
       [](Tracker &tracker) {
         tracker.setTrackerType(Tracker::EDGE_TRACKER);
         setCandidates(tracker, 1);
       }},
      {"c0-c1", [](Tracker &tracker) { tracker.setTrackerType(Tracker::EDGE_TRACKER); }},
      {"nm", [](Tracker &tracker) { tracker.setTrackerType(Tracker::EDGE_TRACKER | Tracker::COLOR_TRACKER); }},
      {"nm-c4", [](Tracker &tracker) { tracker.setTrackerType(all); }},
      {"nm-c4-c5",
       [](Tracker &tracker) {
         tracker.setTrackerType(all);
         tracker.setPrediction(true);
       }},
      {"multicue", [](Tracker &tracker) { tracker.setTrackerType(all); }},
      {"multicue-texture",
       [](Tracker &tracker) {
         tracker.setTrackerType(all);
         tracker.setTextureEdges(true);
       }},
      {"multicue-kalman-texture",
       [](Tracker &tracker) {
         tracker.setTrackerType(all);
         tracker.setPrediction(true);
         tracker.setTextureEdges(true);
       }},
      {"multicue-kalman",
       [](Tracker &tracker) {
         tracker.setTrackerType(all);
         tracker.setPrediction(true);
       }},
  };
  return table;
}

class MultiCueBenchTracker : public BenchTracker
{
public:
  MultiCueBenchTracker(const Preset &preset, const SequenceObject &object, const vpCameraParameters &cam,
                       const std::string &config)
  {
    if (!config.empty()) {
      m_tracker.loadConfigFile(config, false);
    }
    m_tracker.setCameraParameters(cam);
    m_tracker.setModelUnit(object.meshUnit);
    m_tracker.loadModel(object.mesh.empty() ? object.cao : object.mesh);
    preset(m_tracker);
  }

  void init(const BenchImage &I, const vpHomogeneousMatrix &cMo) override { m_tracker.initFromPose(I.color, cMo); }
  void track(const BenchImage &I) override { m_tracker.track(I.color); }

  TrackerAnswer answer() override
  {
    TrackerAnswer answer;
    m_tracker.getPose(answer.cMo);
    answer.state = m_tracker.getTrackingState();
    answer.score = m_tracker.getSupport();
    const vpTrackingTimings &timings = m_tracker.getTimings();
    answer.stages = {timings.frame, timings.view, timings.match, timings.pose};
    answer.minimisations = m_tracker.getNbPoseMinimisations();
    return answer;
  }

  std::vector<std::string> stages() const override { return {"frame", "view", "match", "pose"}; }

private:
  vpMbMultiCueTracker m_tracker;
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
                                                  const vpCameraParameters &cam, const std::string &config)
{
  return std::make_unique<MultiCueBenchTracker>(presets().at(preset), object, cam, config);
}

} // namespace bench
