// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef benchTrackerStages_h
#define benchTrackerStages_h

#include "stages/benchFailure.h"
#include "stages/benchScene.h"

#include <visp3/core/vpTrackingException.h>

#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>

/*!
  \file trackerStages.h
  Whole frames. A tracker that does not follow the object fails the benchmark: its time would mean nothing.
*/

namespace bench {

inline bool isFollowing(const vpMbMultiCueTracker &tracker)
{
  return tracker.getTrackingState() == vpTrackingState::TRACKING;
}
//! ViSP's trackers throw where they do not follow.
inline bool isFollowing(const vpMbGenericTracker &)
{
  return true;
}

//! A tracker on its way through the images of a scene.
template <typename Tracker> class Follower
{
public:
  Follower(BenchScene &scene, Tracker &tracker) : m_scene(scene), m_tracker(tracker)
  {
    m_tracker.initFromPose(m_scene.image(0), BenchScene::pose(0));
  }
  //! \return False where the object is lost, or the pose more than a centimetre off.
  bool follow()
  {
    try {
      m_tracker.track(m_scene.image(++m_frame));
    } catch (const vpTrackingException &) {
      return false;
    }
    return isFollowing(m_tracker) && millimetresOff() < 10.;
  }
  double millimetresOff() const
  {
    vpHomogeneousMatrix cMo;
    m_tracker.getPose(cMo);
    const vpHomogeneousMatrix truth = BenchScene::pose(m_frame);
    return 1000. * (cMo.getTranslationVector() - truth.getTranslationVector()).frobeniusNorm();
  }

private:
  BenchScene &m_scene;
  Tracker &m_tracker;
  int m_frame = 0;
};

template <typename Tracker> void trackFrames(benchmark::State &state, BenchScene &scene, Tracker &tracker)
{
  Follower<Tracker> follower(scene, tracker);
  for (auto _ : state) {
    if (!follower.follow()) {
      failBenchmark(state, "the object was lost");
      break;
    }
  }
  state.counters["mm_off"] = follower.millimetresOff();
}

inline void trackOurs(benchmark::State &state, BenchScene &scene)
{
  trackFrames(state, scene, scene.tracker());
  state.counters["points"] = scene.tracker().getNbFeaturesEdge();
}

inline void trackVisp(benchmark::State &state, BenchScene &scene)
{
  trackFrames(state, scene, scene.vispTracker());
  state.counters["points"] = scene.vispTracker().getNbFeaturesEdge();
}

inline double median(std::vector<double> values)
{
  std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2), values.end());
  return values[values.size() / 2];
}

//! Both in turns, so that whatever else the machine does falls on both: the time is ours, the ratio that of the
//! medians.
inline void trackBoth(benchmark::State &state, BenchScene &scene)
{
  using Clock = std::chrono::steady_clock;
  const auto seconds = [](Clock::duration time) { return std::chrono::duration<double>(time).count(); };
  Follower<vpMbMultiCueTracker> ours(scene, scene.tracker());
  Follower<vpMbGenericTracker> visp(scene, scene.vispTracker());
  std::vector<double> ourTimes;
  std::vector<double> vispTimes;
  for (auto _ : state) {
    const Clock::time_point start = Clock::now();
    const bool weFollow = ours.follow();
    const Clock::time_point between = Clock::now();
    const bool vispFollows = visp.follow();
    const Clock::time_point end = Clock::now();
    ourTimes.push_back(seconds(between - start));
    vispTimes.push_back(seconds(end - between));
    state.SetIterationTime(ourTimes.back());
    if (!weFollow || !vispFollows) {
      failBenchmark(state, "the object was lost");
      break;
    }
  }
  state.counters["visp_us"] = 1e6 * median(vispTimes);
  state.counters["ours/visp"] = median(ourTimes) / median(vispTimes);
}

} // namespace bench
#endif
