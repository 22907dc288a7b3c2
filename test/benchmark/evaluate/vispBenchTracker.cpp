// SPDX-License-Identifier: GPL-2.0-or-later
#include "evaluate/vispBenchTracker.h"

#include <visp3/core/vpException.h>
#include <visp3/cues/vpEdgeCue.h>
#include <visp3/mbt/vpMbGenericTracker.h>
#include <visp3/multicue/vpMultiCueSettings.h>

#include <map>

namespace bench {

namespace {
const std::map<std::string, int> &types()
{
  static const std::map<std::string, int> table = {
    {"visp-edge", vpMbGenericTracker::EDGE_TRACKER},
#if defined(VISP_HAVE_MODULE_KLT) && defined(VISP_HAVE_OPENCV)
    {"visp-klt", vpMbGenericTracker::KLT_TRACKER},
    {"visp-edge-klt", vpMbGenericTracker::EDGE_TRACKER | vpMbGenericTracker::KLT_TRACKER},
#endif
  };
  return table;
}

// As in the tutorials of ViSP, with a contrast of 5 gray levels, which is 10000 in the scale of ViSP 3.5.
vpMe movingEdge()
{
  vpMe me;
  me.setMaskSize(5);
  me.setMaskNumber(180);
  me.setRange(10);
  me.setThreshold(10000.);
  me.setMu1(0.5);
  me.setMu2(0.5);
  me.setSampleStep(4.);
  return me;
}

#if defined(VISP_HAVE_MODULE_KLT) && defined(VISP_HAVE_OPENCV)
// The values of ViSP's teabox tutorial.
void setPoints(vpMbGenericTracker &tracker)
{
  vpKltOpencv klt;
  klt.setMaxFeatures(300);
  klt.setWindowSize(5);
  klt.setQuality(0.015);
  klt.setMinDistance(8.);
  klt.setHarrisFreeParameter(0.01);
  klt.setBlockSize(3);
  klt.setPyramidLevels(3);
  tracker.setKltOpencv(klt);
  tracker.setKltMaskBorder(5);
}
#else
void setPoints(vpMbGenericTracker &)
{
}
#endif

// ViSP 3.5 reads a threshold that is in gray levels in its old scale.
void keepContrast(vpMbGenericTracker &tracker, const std::string &config)
{
  if ((tracker.getTrackerType() & vpMbGenericTracker::EDGE_TRACKER) != 0) {
    vpMe me = tracker.getMovingEdge();
    if (!vpMeHasNormalizedThreshold(me)) {
      const vpEdgeCueSettings settings = vpMultiCueSettingsReader::read(config, vpMultiCueSettings()).edge;
      me.setThreshold(vpEdgeCueSettings::toLikelihood(settings.contrast, me.getMaskSize()));
      tracker.setMovingEdge(me);
    }
  }
}

class VispBenchTracker : public BenchTracker
{
public:
  VispBenchTracker(int type, const SequenceObject &object, const vpCameraParameters &cam, const std::string &config)
      : m_tracker(1, type)
  {
    if ((type & vpMbGenericTracker::EDGE_TRACKER) != 0) {
      m_tracker.setMovingEdge(movingEdge());
    }
    if (type != vpMbGenericTracker::EDGE_TRACKER) {
      setPoints(m_tracker);
    }
    m_tracker.setAngleAppear(vpMath::rad(70.));
    m_tracker.setAngleDisappear(vpMath::rad(80.));
    if (!config.empty()) {
      m_tracker.loadConfigFile(config, false);
      keepContrast(m_tracker, config);
    }
    m_tracker.setCameraParameters(cam);
    m_tracker.loadModel(object.cao);
    m_tracker.setScanLineVisibilityTest(true);
  }

  void init(const BenchImage &I, const vpHomogeneousMatrix &cMo) override
  {
    m_failed = false;
    m_tracker.initFromPose(I.gray, cMo);
  }

  void track(const BenchImage &I) override
  {
    try {
      m_tracker.track(I.gray);
      m_failed = false;
    } catch (const vpException &) {
      m_failed = true; // Its way of saying that the object is lost.
    }
  }

  TrackerAnswer answer() override
  {
    TrackerAnswer answer;
    m_tracker.getPose(answer.cMo);
    answer.state = m_failed ? vpTrackingState::LOST : vpTrackingState::TRACKING;
    return answer;
  }

private:
  vpMbGenericTracker m_tracker;
  bool m_failed = false;
};
} // namespace

std::vector<std::string> vispTrackers()
{
  std::vector<std::string> names;
  for (const auto &type : types()) {
    names.push_back(type.first);
  }
  return names;
}

std::unique_ptr<BenchTracker> makeVispTracker(const std::string &name, const SequenceObject &object,
                                              const vpCameraParameters &cam, const std::string &config)
{
  return std::make_unique<VispBenchTracker>(types().at(name), object, cam, config);
}

} // namespace bench
