// SPDX-License-Identifier: GPL-2.0-or-later
#include <visp3/multicue/vpMbMultiCueTracker.h>

#include "facade/vpTrackerImpl.h"

#include <visp3/core/vpException.h>

#include <algorithm>
#include <cmath>

BEGIN_VISP_NAMESPACE

void vpMbMultiCueTracker::setTrackerType(int type)
{
  if (type <= 0 || (type & ~vpCueKinds::allTypes()) != 0) {
    throw vpException(vpException::badValue,
                      "Tracker type %d is not known: use a sum of %s; depth trackers need a depth camera and "
                      "vpMbGenericTracker",
                      type, vpCueKinds::listText().c_str());
  }
  vpMultiCueEngine &engine = m_impl->engine();
  if ((engine.cues.type() & ~type) != 0) {
    engine.minimiser.clear(); // The last frame's features are of cues that may end now.
  }
  engine.cues.setType(type, engine.looks);
  m_impl->updatePointFilter();
  double deadline = engine.deadline.get();
  m_impl->choice.takeCues(engine.motion.predicts, engine.settings.searches, deadline);
  engine.deadline.set(deadline);
}

int vpMbMultiCueTracker::getTrackerType() const
{
  return m_impl->engine().cues.type();
}

void vpMbMultiCueTracker::setMovingEdge(const vpMe &me)
{
  setMovingEdge(me, vpMeHasNormalizedThreshold(me) ? vpEdgeCueSettings::CONTRAST : vpEdgeCueSettings::LIKELIHOOD);
}

void vpMbMultiCueTracker::setMovingEdge(const vpMe &me, vpEdgeCueSettings::ThresholdScale scale)
{
  vpEdgeCueSettings settings = m_impl->engine().cues.edges().settings();
  settings.set(me, scale);
  if (!(me.getSampleStep() >= 0.5)) {
    throw vpException(vpException::badValue, "vpMe's sample step is %g, it must be at least 0.5 pixels",
                      me.getSampleStep());
  }
  m_impl->engine().cues.edges().setSettings(settings);
  m_impl->engine().looks.options.sampleStep = me.getSampleStep();
  m_impl->me = me;
}

vpMe vpMbMultiCueTracker::getMovingEdge() const
{
  return m_impl->me;
}

void vpMbMultiCueTracker::getMovingEdge(vpMe &me) const
{
  me = m_impl->me;
}

void vpMbMultiCueTracker::setEdgeSettings(const vpEdgeCueSettings &settings)
{
  m_impl->engine().cues.edges().setSettings(settings);
  m_impl->updateMe();
}

vpEdgeCueSettings vpMbMultiCueTracker::getEdgeSettings() const
{
  return m_impl->engine().cues.edges().settings();
}

void vpMbMultiCueTracker::setKltOpencv(const vpKltOpencv &klt)
{
  vpPointCueSettings settings = m_impl->engine().cues.pointPart().settings();
  settings.set(klt);
  m_impl->engine().cues.pointPart().setSettings(settings);
}

vpKltOpencv vpMbMultiCueTracker::getKltOpencv() const
{
  const vpPointCueSettings &settings = m_impl->engine().cues.pointPart().settings();
  vpKltOpencv klt;
  klt.setMaxFeatures(settings.maxFeatures);
  klt.setWindowSize(settings.windowSize);
  klt.setQuality(settings.quality);
  klt.setMinDistance(settings.minDistance);
  klt.setHarrisFreeParameter(settings.harris);
  klt.setBlockSize(settings.blockSize);
  klt.setPyramidLevels(settings.pyramidLevels);
  return klt;
}

void vpMbMultiCueTracker::setKltMaskBorder(const unsigned int &border)
{
  vpPointCueSettings settings = m_impl->engine().cues.pointPart().settings();
  settings.maskBorder = border;
  m_impl->engine().cues.pointPart().setSettings(settings);
}

unsigned int vpMbMultiCueTracker::getKltMaskBorder() const
{
  return m_impl->engine().cues.pointPart().settings().maskBorder;
}

void vpMbMultiCueTracker::setKltThresholdAcceptation(double threshold)
{
  vpPointCueSettings settings = m_impl->engine().cues.pointPart().settings();
  settings.leastWeight = threshold;
  m_impl->engine().cues.pointPart().setSettings(settings);
}

double vpMbMultiCueTracker::getKltThresholdAcceptation() const
{
  return m_impl->engine().cues.pointPart().settings().leastWeight;
}

void vpMbMultiCueTracker::setGoodMovingEdgesRatioThreshold(double threshold)
{
  if (!(threshold >= 0. && threshold <= 1.)) {
    throw vpException(vpException::badValue, "The ratio of good moving edges is %g, it must be in [0, 1]", threshold);
  }
  m_impl->engine().settings.goodRatio = threshold;
}

double vpMbMultiCueTracker::getGoodMovingEdgesRatioThreshold() const
{
  return m_impl->engine().settings.goodRatio;
}

void vpMbMultiCueTracker::setCameraParameters(const vpCameraParameters &cam)
{
  if (!(cam.get_px() > 0.) || !(cam.get_py() > 0.) ||
      !std::isfinite(cam.get_px() + cam.get_py() + cam.get_u0() + cam.get_v0())) {
    throw vpException(vpException::badValue,
                      "The camera is singular (px %g, py %g, u0 %g, v0 %g): give focal lengths above 0 and a principal "
                      "point, in pixels",
                      cam.get_px(), cam.get_py(), cam.get_u0(), cam.get_v0());
  }
  if (!std::isfinite(cam.get_kud() + cam.get_kdu())) {
    throw vpException(vpException::badValue, "The camera's distortion (kud %g, kdu %g) is not finite", cam.get_kud(),
                      cam.get_kdu());
  }
  vpMbTracker::setCameraParameters(cam);
}

void vpMbMultiCueTracker::setLod(bool useLod, const std::string &name)
{
  if (name.empty()) {
    useLodGeneral = useLod;
  }
  vpMbTracker::setLod(useLod, name);
  m_impl->updateDetails();
}

void vpMbMultiCueTracker::setMinLineLengthThresh(double minLineLengthThresh, const std::string &name)
{
  if (name.empty()) {
    minLineLengthThresholdGeneral = minLineLengthThresh;
  }
  vpMbTracker::setMinLineLengthThresh(minLineLengthThresh, name);
  m_impl->updateDetails();
}

void vpMbMultiCueTracker::setMinPolygonAreaThresh(double minPolygonAreaThresh, const std::string &name)
{
  if (name.empty()) {
    minPolygonAreaThresholdGeneral = minPolygonAreaThresh;
  }
  vpMbTracker::setMinPolygonAreaThresh(minPolygonAreaThresh, name);
  m_impl->updateDetails();
}

void vpMbMultiCueTracker::setRenderer(vpModelRenderer::Preference preference)
{
  m_impl->engine().looks.setPreference(preference);
}

void vpMbMultiCueTracker::setTextureEdges(bool flag)
{
  m_impl->engine().looks.options.textureEdges = flag;
}

bool vpMbMultiCueTracker::getTextureEdges() const
{
  return m_impl->engine().looks.options.textureEdges;
}

void vpMbMultiCueTracker::setFeatureFactors(const std::map<vpTrackerType, double> &mapOfFeatureFactors)
{
  for (const auto &[cue, factor] : mapOfFeatureFactors) {
    if (vpCueKinds::find(cue) == nullptr || !(factor > 0.) || !(factor < 1e6)) {
      throw vpException(vpException::badValue,
                        "The factor of cue %d is %g: give one of %s a factor above 0 and below 1e6, and leave cues out "
                        "by setTrackerType()",
                        static_cast<int>(cue), factor, vpCueKinds::listText().c_str());
    }
  }
  for (const auto &[cue, factor] : mapOfFeatureFactors) {
    m_impl->engine().cues.factors[cue] = factor;
  }
}

void vpMbMultiCueTracker::setColorSettings(const vpColorCueSettings &settings)
{
  m_impl->engine().cues.color().setSettings(settings);
}

vpColorCueSettings vpMbMultiCueTracker::getColorSettings() const
{
  return m_impl->engine().cues.color().settings();
}

void vpMbMultiCueTracker::setPoseHypothesisSettings(const vpPoseHypothesisSettings &settings)
{
  m_impl->engine().edges.setSettings(settings);
}

vpPoseHypothesisSettings vpMbMultiCueTracker::getPoseHypothesisSettings() const
{
  return m_impl->engine().edges.hypotheses().settings();
}

void vpMbMultiCueTracker::setParticleSettings(const vpParticleSettings &settings)
{
  m_impl->engine().particles.setSettings(settings);
  if (!settings.enabled) {
    m_impl->engine().particles.clear();
  }
}

vpParticleSettings vpMbMultiCueTracker::getParticleSettings() const
{
  return m_impl->engine().particles.settings();
}

void vpMbMultiCueTracker::setPrediction(bool flag, const vpPoseKalmanSettings &settings)
{
  vpObjectMotion &motion = m_impl->engine().motion;
  motion.kalman.setSettings(settings);
  motion.kalman.reset();
  motion.predicts = flag;
  m_impl->choice.keepsPrediction = true;
}

void vpMbMultiCueTracker::setPredictedRange(bool flag)
{
  m_impl->engine().motion.rangeIsPredicted = flag;
}

void vpMbMultiCueTracker::setFrameInterval(double seconds)
{
  if (!(seconds > 0.) || !std::isfinite(seconds)) {
    throw vpException(vpException::badValue, "The time between two images is %g s, it must be above 0", seconds);
  }
  m_impl->engine().motion.frameInterval = seconds;
}

void vpMbMultiCueTracker::setSearch(bool flag)
{
  m_impl->engine().settings.searches = flag;
  m_impl->choice.keepsSearch = true;
}

void vpMbMultiCueTracker::setSymmetries(const vpModelSymmetries &symmetries)
{
  m_impl->engine().symmetries.set(symmetries, "", 0, m_impl->engine().looks.pointer().get());
}

const vpModelSymmetries &vpMbMultiCueTracker::getSymmetries() const
{
  return m_impl->engine().symmetries.known();
}

void vpMbMultiCueTracker::setDetector(const vpPoseDetector &detector)
{
  m_impl->engine().rough.detector = detector;
}

void vpMbMultiCueTracker::setThrowOnLoss(bool flag)
{
  m_impl->throwOnLoss = flag;
}

END_VISP_NAMESPACE
