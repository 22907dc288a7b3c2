// SPDX-License-Identifier: GPL-2.0-or-later
#include "facade/vpTrackerImpl.h"

#include <algorithm>

// The settings that vpMultiCueSettings has, of all parts at once.

BEGIN_VISP_NAMESPACE

void vpMbMultiCueTracker::Impl::updateMe()
{
  const vpEdgeCueSettings &settings = m_engine.cues.edges().settings();
  me.setRange(static_cast<unsigned int>(settings.range));
  me.setMaskSize(settings.maskSize);
  me.setThreshold(vpEdgeCueSettings::toLikelihood(settings.contrast, settings.maskSize));
  me.setMu1(settings.mu1);
  me.setMu2(settings.mu2);
  me.setSampleStep(m_engine.looks.options.sampleStep);
}

// Its setters are not all virtual.
void vpMbMultiCueTracker::Impl::handOver()
{
  const vpModelViewOptions defaults;
  vpModelViewOptions &options = m_engine.looks.options;
  const unsigned int clipping = m_tracker.clippingFlag;
  options.appearAngle = std::min(vpMath::deg(m_tracker.angleAppears), 90.);
  options.disappearAngle = std::min(std::max(vpMath::deg(m_tracker.angleDisappears), options.appearAngle), 90.);
  options.nearDistance = (clipping & vpPolygon3D::NEAR_CLIPPING) != 0 ? m_tracker.distNearClip : defaults.nearDistance;
  options.farDistance = (clipping & vpPolygon3D::FAR_CLIPPING) != 0 ? m_tracker.distFarClip : defaults.farDistance;
  m_engine.settings.computesCovariance = m_tracker.computeCovariance;
}

vpMultiCueSettings vpMbMultiCueTracker::Impl::settings()
{
  handOver();
  vpMultiCueSettings settings;
  settings.camera = m_tracker.m_cam;
  settings.edge = m_engine.cues.edges().settings();
  settings.hypotheses = m_engine.edges.hypotheses().settings();
  settings.particles = m_engine.particles.settings();
  settings.view = m_engine.looks.options;
  settings.klt = m_engine.cues.pointPart().settings();
  settings.cues = m_engine.cues.type();
  settings.color = m_engine.cues.color().settings();
  settings.predicts = m_engine.motion.predicts;
  settings.prediction = m_engine.motion.kalman.settings();
  settings.frameInterval = m_engine.motion.frameInterval;
  settings.searches = m_engine.settings.searches;
  settings.searchBudget = m_engine.budget.get();
  settings.symmetries = m_engine.symmetries.from();
  settings.symmetricObject = m_engine.symmetries.object();
  settings.useLod = m_tracker.useLodGeneral;
  settings.minLineLength = m_tracker.minLineLengthThresholdGeneral;
  settings.minPolygonArea = m_tracker.minPolygonAreaThresholdGeneral;
  settings.clipToImage = (m_tracker.clippingFlag & vpPolygon3D::FOV_CLIPPING) == vpPolygon3D::FOV_CLIPPING;
  return settings;
}

void vpMbMultiCueTracker::Impl::apply(const vpMultiCueSettings &settings)
{
  settings.check();
  vpTrackerSymmetries &symmetries = m_engine.symmetries;
  const bool isOther = settings.symmetries != symmetries.from() || settings.symmetricObject != symmetries.object();
  if (isOther && !settings.symmetries.empty()) {
    const vpTrackedModel *model = m_engine.looks.pointer().get(); // Read before anything is changed: it may throw.
    symmetries.set(vpTrackerSymmetries::read(settings.symmetries, settings.symmetricObject, model), settings.symmetries,
                   settings.symmetricObject, model);
  }
  handOver();
  vpModelViewOptions &options = m_engine.looks.options;
  const double nearBefore = options.nearDistance;
  const double farBefore = options.farDistance;
  m_tracker.setCameraParameters(settings.camera);
  m_engine.cues.edges().setSettings(settings.edge);
  m_tracker.setPoseHypothesisSettings(settings.hypotheses);
  m_tracker.setParticleSettings(settings.particles);
  options.sampleStep = settings.view.sampleStep;
  options.textureEdges = settings.view.textureEdges;
  m_engine.cues.pointPart().setSettings(settings.klt);
  m_tracker.setTrackerType(settings.cues);
  m_tracker.setColorSettings(settings.color);
  m_tracker.setPrediction(settings.predicts, settings.prediction);
  m_tracker.setFrameInterval(settings.frameInterval);
  m_tracker.setSearch(settings.searches);
  m_tracker.setSearchBudget(settings.searchBudget);
  updateMe();
  m_tracker.angleAppears = vpMath::rad(settings.view.appearAngle);
  m_tracker.angleDisappears = vpMath::rad(settings.view.disappearAngle);
  if (settings.view.nearDistance != nearBefore) {
    m_tracker.setNearClippingDistance(settings.view.nearDistance);
  }
  if (settings.view.farDistance != farBefore) {
    m_tracker.setFarClippingDistance(settings.view.farDistance);
  }
  const unsigned int fov = vpPolygon3D::FOV_CLIPPING;
  m_tracker.setClipping(settings.clipToImage ? m_tracker.clippingFlag | fov : m_tracker.clippingFlag & ~fov);
  m_tracker.setLod(settings.useLod);
  m_tracker.setMinLineLengthThresh(settings.minLineLength);
  m_tracker.setMinPolygonAreaThresh(settings.minPolygonArea);
}

void vpMbMultiCueTracker::Impl::take(const Impl &before)
{
  me = before.me; // As the user gave it, and not as the edges' settings say it.
  modelOptions = before.modelOptions;
  choice = before.choice;
  throwOnLoss = before.throwOnLoss;
  displayHypotheses = before.displayHypotheses;
  m_engine.looks.setPreference(before.m_engine.looks.preference());
  m_engine.motion.rangeIsPredicted = before.m_engine.motion.rangeIsPredicted;
  m_engine.particles.isDisplayed = before.m_engine.particles.isDisplayed;
  m_engine.cues.factors = before.m_engine.cues.factors;
  m_engine.rough.detector = before.m_engine.rough.detector;
}

END_VISP_NAMESPACE
