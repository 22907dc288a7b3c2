// SPDX-License-Identifier: GPL-2.0-or-later
#include <visp3/multicue/vpMbMultiCueTracker.h>

#include "tracker/vpTrackerState.h"

#include <visp3/core/vpException.h>

#include <algorithm>
#include <cmath>

BEGIN_VISP_NAMESPACE

void vpMbMultiCueTracker::setTrackerType(int type)
{
  if (type <= 0 || (type & ~(EDGE_TRACKER | KLT_TRACKER | COLOR_TRACKER)) != 0) {
    throw vpException(vpException::badValue,
                      "Tracker type %d is not known: use a sum of vpMbMultiCueTracker::EDGE_TRACKER (1), KLT_TRACKER "
                      "(2) and COLOR_TRACKER (16); depth trackers need a depth camera and vpMbGenericTracker",
                      type);
  }
  const int typeBefore = m_impl->type;
  m_impl->type = type;
  try {
    m_impl->makeCues();
  } catch (...) {
    m_impl->type = typeBefore;
    throw;
  }
  updatePointFilter();
  double budget = m_impl->searchBudget.get();
  m_impl->choice.takeCues(m_impl->predicts, m_impl->searches, budget);
  m_impl->searchBudget.set(budget);
}

int vpMbMultiCueTracker::getTrackerType() const
{
  return m_impl->type;
}

void vpMbMultiCueTracker::setMovingEdge(const vpMe &me)
{
  setMovingEdge(me, vpMeHasNormalizedThreshold(me) ? vpEdgeCueSettings::CONTRAST : vpEdgeCueSettings::LIKELIHOOD);
}

void vpMbMultiCueTracker::setMovingEdge(const vpMe &me, vpEdgeCueSettings::ThresholdScale scale)
{
  vpEdgeCueSettings settings = m_impl->edges.settings();
  settings.set(me, scale);
  if (!(me.getSampleStep() >= 0.5)) {
    throw vpException(vpException::badValue, "vpMe's sample step is %g, it must be at least 0.5 pixels",
                      me.getSampleStep());
  }
  m_impl->edges.setSettings(settings);
  m_impl->viewOptions.sampleStep = me.getSampleStep();
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
  m_impl->edges.setSettings(settings);
  m_impl->updateMe();
}

vpEdgeCueSettings vpMbMultiCueTracker::getEdgeSettings() const
{
  return m_impl->edges.settings();
}

void vpMbMultiCueTracker::setKltOpencv(const vpKltOpencv &klt)
{
  m_impl->klt.set(klt);
  m_impl->makeCues();
}

vpKltOpencv vpMbMultiCueTracker::getKltOpencv() const
{
  vpKltOpencv klt;
  klt.setMaxFeatures(m_impl->klt.maxFeatures);
  klt.setWindowSize(m_impl->klt.windowSize);
  klt.setQuality(m_impl->klt.quality);
  klt.setMinDistance(m_impl->klt.minDistance);
  klt.setHarrisFreeParameter(m_impl->klt.harris);
  klt.setBlockSize(m_impl->klt.blockSize);
  klt.setPyramidLevels(m_impl->klt.pyramidLevels);
  return klt;
}

void vpMbMultiCueTracker::setKltMaskBorder(const unsigned int &border)
{
  vpPointCueSettings settings = m_impl->klt;
  settings.maskBorder = border;
  settings.check();
  m_impl->klt = settings;
  m_impl->makeCues();
}

unsigned int vpMbMultiCueTracker::getKltMaskBorder() const
{
  return m_impl->klt.maskBorder;
}

void vpMbMultiCueTracker::setGoodMovingEdgesRatioThreshold(double threshold)
{
  if (!(threshold >= 0. && threshold <= 1.)) {
    throw vpException(vpException::badValue, "The ratio of good moving edges is %g, it must be in [0, 1]", threshold);
  }
  m_impl->goodRatio = threshold;
}

double vpMbMultiCueTracker::getGoodMovingEdgesRatioThreshold() const
{
  return m_impl->goodRatio;
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
  vpMbTracker::setCameraParameters(cam);
}

void vpMbMultiCueTracker::setLod(bool useLod, const std::string &name)
{
  if (name.empty()) {
    useLodGeneral = useLod;
  }
  vpMbTracker::setLod(useLod, name);
  updateDetails();
}

void vpMbMultiCueTracker::setMinLineLengthThresh(double minLineLengthThresh, const std::string &name)
{
  if (name.empty()) {
    minLineLengthThresholdGeneral = minLineLengthThresh;
  }
  vpMbTracker::setMinLineLengthThresh(minLineLengthThresh, name);
  updateDetails();
}

void vpMbMultiCueTracker::setMinPolygonAreaThresh(double minPolygonAreaThresh, const std::string &name)
{
  if (name.empty()) {
    minPolygonAreaThresholdGeneral = minPolygonAreaThresh;
  }
  vpMbTracker::setMinPolygonAreaThresh(minPolygonAreaThresh, name);
  updateDetails();
}

void vpMbMultiCueTracker::setRenderer(vpModelRenderer::Preference preference)
{
  m_impl->preference = preference;
  m_impl->makeRenderer();
}

void vpMbMultiCueTracker::setTextureEdges(bool flag)
{
  m_impl->viewOptions.textureEdges = flag;
}

bool vpMbMultiCueTracker::getTextureEdges() const
{
  return m_impl->viewOptions.textureEdges;
}

const vpModelViewOptions &vpMbMultiCueTracker::viewOptions() const
{
  // vpMbTracker holds these, and its setters are not all virtual.
  const vpModelViewOptions defaults;
  vpModelViewOptions &options = m_impl->viewOptions;
  options.appearAngle = std::min(vpMath::deg(angleAppears), 90.);
  options.disappearAngle = std::min(std::max(vpMath::deg(angleDisappears), options.appearAngle), 90.);
  options.nearDistance = (clippingFlag & vpPolygon3D::NEAR_CLIPPING) != 0 ? distNearClip : defaults.nearDistance;
  options.farDistance = (clippingFlag & vpPolygon3D::FAR_CLIPPING) != 0 ? distFarClip : defaults.farDistance;
  return options;
}

vpMultiCueSettings vpMbMultiCueTracker::currentSettings() const
{
  vpMultiCueSettings settings;
  settings.camera = m_cam;
  settings.edge = m_impl->edges.settings();
  settings.hypotheses = m_impl->hypotheses.settings();
  settings.particles = m_impl->particles.settings();
  settings.view = viewOptions();
  settings.klt = m_impl->klt;
  settings.cues = m_impl->type;
  settings.color = m_impl->color.settings();
  settings.predicts = m_impl->predicts;
  settings.prediction = m_impl->kalman.settings();
  settings.frameInterval = m_impl->frameInterval;
  settings.searches = m_impl->searches;
  settings.searchBudget = m_impl->searchBudget.get();
  settings.symmetries = m_impl->symmetries.from();
  settings.symmetricObject = m_impl->symmetries.object();
  settings.useLod = useLodGeneral;
  settings.minLineLength = minLineLengthThresholdGeneral;
  settings.minPolygonArea = minPolygonAreaThresholdGeneral;
  settings.clipToImage = (clippingFlag & vpPolygon3D::FOV_CLIPPING) == vpPolygon3D::FOV_CLIPPING;
  return settings;
}

void vpMbMultiCueTracker::applySettings(const vpMultiCueSettings &settings)
{
  settings.check();
  vpTrackerSymmetries &symmetries = m_impl->symmetries;
  const bool isOther = settings.symmetries != symmetries.from() || settings.symmetricObject != symmetries.object();
  if (isOther && !settings.symmetries.empty()) {
    const vpTrackedModel *model = m_impl->model.get(); // Read before anything is changed: it may throw.
    symmetries.set(vpTrackerSymmetries::read(settings.symmetries, settings.symmetricObject, model), settings.symmetries,
                   settings.symmetricObject, model);
  }
  const double nearBefore = viewOptions().nearDistance;
  const double farBefore = viewOptions().farDistance;
  setCameraParameters(settings.camera);
  m_impl->edges.setSettings(settings.edge);
  setPoseHypothesisSettings(settings.hypotheses);
  setParticleSettings(settings.particles);
  m_impl->viewOptions.sampleStep = settings.view.sampleStep;
  m_impl->viewOptions.textureEdges = settings.view.textureEdges;
  m_impl->klt = settings.klt;
  setTrackerType(settings.cues);
  setColorSettings(settings.color);
  setPrediction(settings.predicts, settings.prediction);
  setFrameInterval(settings.frameInterval);
  setSearch(settings.searches);
  setSearchBudget(settings.searchBudget);
  m_impl->updateMe();
  angleAppears = vpMath::rad(settings.view.appearAngle);
  angleDisappears = vpMath::rad(settings.view.disappearAngle);
  if (settings.view.nearDistance != nearBefore) {
    setNearClippingDistance(settings.view.nearDistance);
  }
  if (settings.view.farDistance != farBefore) {
    setFarClippingDistance(settings.view.farDistance);
  }
  const unsigned int fov = vpPolygon3D::FOV_CLIPPING;
  setClipping(settings.clipToImage ? clippingFlag | fov : clippingFlag & ~fov);
  setLod(settings.useLod);
  setMinLineLengthThresh(settings.minLineLength);
  setMinPolygonAreaThresh(settings.minPolygonArea);
}

END_VISP_NAMESPACE
