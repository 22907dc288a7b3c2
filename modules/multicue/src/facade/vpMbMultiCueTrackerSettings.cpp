// SPDX-License-Identifier: GPL-2.0-or-later
#include "facade/vpTrackerImpl.h"

#include <visp3/se3/vpExactNumber.h>

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
  settings.predictsRange = m_engine.motion.rangeIsPredicted;
  settings.searches = m_engine.settings.searches;
  settings.frameDeadline = m_engine.deadline.get();
  settings.symmetries = m_engine.symmetries.from();
  settings.symmetricObject = m_engine.symmetries.object();
  settings.goodRatio = m_engine.settings.goodRatio;
  settings.factors = m_engine.cues.factors;
  settings.renderer = m_engine.looks.preference();
  settings.throwsOnLoss = throwOnLoss;
  settings.display = {m_tracker.displayFeatures, displayHypotheses, m_engine.particles.isDisplayed};
  settings.model = modelOptions;
  settings.modelFile = modelFile;
  takeFromVisp(settings);
  return settings;
}

// What vpMbTracker keeps.
void vpMbMultiCueTracker::Impl::takeFromVisp(vpMultiCueSettings &settings) const
{
  settings.useLod = m_tracker.useLodGeneral;
  settings.minLineLength = m_tracker.minLineLengthThresholdGeneral;
  settings.minPolygonArea = m_tracker.minPolygonAreaThresholdGeneral;
  settings.clipToImage = (m_tracker.clippingFlag & vpPolygon3D::FOV_CLIPPING) == vpPolygon3D::FOV_CLIPPING;
  vpEstimationSettings &estimation = settings.estimation;
  estimation.method = m_tracker.m_optimizationMethod == LEVENBERG_MARQUARDT_OPT
                          ? vpEstimationSettings::LEVENBERG_MARQUARDT
                          : vpEstimationSettings::GAUSS_NEWTON;
  estimation.gain = m_tracker.m_lambda;
  estimation.maxIterations = m_tracker.m_maxIter;
  estimation.initialMu = m_tracker.m_initialMu;
  estimation.convergence = m_tracker.m_stopCriteriaEpsilon;
  estimation.covariance = m_tracker.computeCovariance;
  estimation.projectionError = m_tracker.computeProjError;
  const vpColVector motions = m_tracker.getEstimatedDoF();
  for (unsigned int i = 0; i < motions.size(); ++i) {
    estimation.motions[i] = motions[i] > 0. ? 1 : 0;
  }
}

void vpMbMultiCueTracker::Impl::giveToVisp(const vpMultiCueSettings &settings)
{
  const vpEstimationSettings &estimation = settings.estimation;
  m_tracker.m_optimizationMethod =
      estimation.method == vpEstimationSettings::LEVENBERG_MARQUARDT ? LEVENBERG_MARQUARDT_OPT : GAUSS_NEWTON_OPT;
  m_tracker.m_lambda = estimation.gain;
  m_tracker.m_maxIter = estimation.maxIterations;
  m_tracker.m_initialMu = estimation.initialMu;
  m_tracker.m_stopCriteriaEpsilon = estimation.convergence;
  m_tracker.setCovarianceComputation(estimation.covariance);
  m_tracker.setProjectionErrorComputation(estimation.projectionError);
  vpColVector motions(static_cast<unsigned int>(estimation.motions.size()));
  for (unsigned int i = 0; i < motions.size(); ++i) {
    motions[i] = estimation.motions[i];
  }
  m_tracker.setEstimatedDoF(motions);
  m_tracker.angleAppears = vpMath::rad(settings.view.appearAngle);
  m_tracker.angleDisappears = vpMath::rad(settings.view.disappearAngle);
  const unsigned int fov = vpPolygon3D::FOV_CLIPPING;
  m_tracker.setClipping(settings.clipToImage ? m_tracker.clippingFlag | fov : m_tracker.clippingFlag & ~fov);
  m_tracker.setLod(settings.useLod);
  m_tracker.setMinLineLengthThresh(settings.minLineLength);
  m_tracker.setMinPolygonAreaThresh(settings.minPolygonArea);
}

// They are read before anything is changed, since that may throw.
void vpMbMultiCueTracker::Impl::applySymmetries(const vpMultiCueSettings &settings)
{
  vpTrackerSymmetries &symmetries = m_engine.symmetries;
  const bool isOther = settings.symmetries != symmetries.from() || settings.symmetricObject != symmetries.object();
  if (isOther && !settings.symmetries.empty()) {
    const vpTrackedModel *model = m_engine.looks.pointer().get();
    symmetries.set(vpTrackerSymmetries::read(settings.symmetries, settings.symmetricObject, model), settings.symmetries,
                   settings.symmetricObject, model);
  }
}

void vpMbMultiCueTracker::Impl::apply(const vpMultiCueSettings &settings)
{
  settings.check();
  applySymmetries(settings);
  handOver();
  vpModelViewOptions &options = m_engine.looks.options;
  const double nearBefore = options.nearDistance;
  const double farBefore = options.farDistance;
  m_tracker.setCameraParameters(settings.camera);
  m_engine.cues.edges().setSettings(settings.edge);
  m_tracker.setPoseHypothesisSettings(settings.hypotheses);
  m_tracker.setParticleSettings(settings.particles);
  options.sampleStep = settings.view.sampleStep;
  options.border = settings.view.border;
  options.visibilitySize = settings.view.visibilitySize;
  options.textureEdges = settings.view.textureEdges;
  m_engine.cues.pointPart().setSettings(settings.klt);
  m_tracker.setTrackerType(settings.cues);
  m_tracker.setColorSettings(settings.color);
  m_tracker.setPrediction(settings.predicts, settings.prediction);
  m_tracker.setPredictedRange(settings.predictsRange);
  m_tracker.setFrameInterval(settings.frameInterval);
  m_tracker.setSearch(settings.searches);
  m_tracker.setFrameDeadline(settings.frameDeadline);
  m_engine.settings.goodRatio = settings.goodRatio;
  m_engine.cues.factors = settings.factors;
  m_engine.looks.setPreference(settings.renderer);
  throwOnLoss = settings.throwsOnLoss;
  m_tracker.displayFeatures = settings.display.features;
  displayHypotheses = settings.display.hypotheses;
  m_engine.particles.isDisplayed = settings.display.particles;
  modelOptions = settings.model;
  updateMe();
  if (vpIsOther(settings.view.nearDistance, nearBefore)) {
    m_tracker.setNearClippingDistance(settings.view.nearDistance);
  }
  if (vpIsOther(settings.view.farDistance, farBefore)) {
    m_tracker.setFarClippingDistance(settings.view.farDistance);
  }
  giveToVisp(settings);
}

void vpMbMultiCueTracker::Impl::take(const Impl &before)
{
  me = before.me; // As the user gave it, and not as the edges' settings say it.
  choice = before.choice;
  report = before.report;
  m_engine.rough.detector = before.m_engine.rough.detector;
}

END_VISP_NAMESPACE
