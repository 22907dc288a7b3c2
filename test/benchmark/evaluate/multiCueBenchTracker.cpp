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

// [T10]: edges alone, an object that wanders, 100 particles, the best ones optimised in pose-hypothesis mode. Where all
// of them have lost the object, which the paper leaves open, the search finds it again.
void useParticles(vpMbMultiCueTracker &tracker)
{
  useHypotheses(tracker);
  vpParticleSettings settings = tracker.getParticleSettings();
  settings.enabled = true;
  tracker.setParticleSettings(settings);
  tracker.setSearch(true);
}

Preset cues(int type)
{
  return [type](vpMbMultiCueTracker &tracker) { tracker.setTrackerType(type); };
}

// What each preset changes in a tracker with default settings: a new preset is a line here.
const std::map<std::string, Preset> &presets()
{
  using Tracker = vpMbMultiCueTracker;
  const int edge = Tracker::EDGE_TRACKER;
  const int point = Tracker::KLT_TRACKER;
  const int color = Tracker::COLOR_TRACKER;
  const Preset predicting = [](Tracker &tracker) {
    tracker.setTrackerType(Tracker::EDGE_TRACKER | Tracker::COLOR_TRACKER | Tracker::KLT_TRACKER);
    tracker.setPrediction(true);
  };
  const Preset searching = [predicting](Tracker &tracker) {
    predicting(tracker);
    tracker.setSearch(true);
    vpParticleSettings particles = tracker.getParticleSettings();
    particles.enabled = true;
    particles.motion = vpParticleSettings::Motion::VELOCITY;
    tracker.setParticleSettings(particles);
  };
  static const std::map<std::string, Preset> table = {
      {"edge", cues(edge)},
      {"edge-geometry",
       [](Tracker &tracker) {
         tracker.setTrackerType(Tracker::EDGE_TRACKER);
         tracker.setTextureEdges(false);
       }},
      {"edge-mh", &useHypotheses},
      {"particles", &useParticles},
      {"edge-point", cues(edge | point)},
      {"color", cues(color)},
      {"point", cues(point)},
      {"multicue", cues(edge | color | point)},
      {"multicue-kalman", predicting},
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
      {"nm-c4-c5", predicting},
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
  void startRoughly(const BenchImage &I, const vpHomogeneousMatrix &cMo, double angleDeviation,
                    double translationDeviation) override
  {
    vpPoseDeviation deviation;
    deviation.translation = translationDeviation;
    deviation.rotation = angleDeviation;
    m_tracker.initFromRoughPose(I.color, cMo, deviation);
  }
  void track(const BenchImage &I) override { m_tracker.track(I.color); }

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

  std::vector<std::string> stages() const override { return {"frame", "view", "match", "pose", "map", "particles"}; }

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
