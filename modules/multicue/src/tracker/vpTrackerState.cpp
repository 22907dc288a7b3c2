// SPDX-License-Identifier: GPL-2.0-or-later
#include "tracker/vpTrackerState.h"

#include "frame/vpStopwatch.h"

#include <visp3/core/vpException.h>

#include <algorithm>

BEGIN_VISP_NAMESPACE

namespace {
// Rows with less robust weight do not count as support.
const double goodWeight = 0.1;
// With a residue below this the image is explained; a tenth of the control points may be without support.
const double explained = 0.8; // Pixels.
// Objects with edges that the image hardly shows never get there: a pose may leave this much more than the ones before.
const double usualFactor = 1.15;
const double usualRate = 0.2;
// Squared, in diameters or radians: nothing is known of the object's motion yet.
const double firstSurprise = 0.05 * 0.05;
const double rightAtStart = 0.98; // Of a pose that the user gave.
// What colours and surface count in a search after a loss: other sides are seen, and other light.
const double othersAfterLoss = 0.5;
const double othersByEdges = 0.15; // The same in one by edges.
// Places on the surface whose colours are remembered.
const std::size_t surfacePlaces = 500;
} // namespace

const char *toString(vpTrackingState state)
{
  switch (state) {
  case vpTrackingState::TRACKING:
    return "TRACKING";
  case vpTrackingState::UNCERTAIN:
    return "UNCERTAIN";
  case vpTrackingState::LOST:
    break;
  }
  return "LOST";
}

void vpMbMultiCueTracker::Impl::updateMe()
{
  const vpEdgeCueSettings &settings = edges.settings();
  me.setRange(static_cast<unsigned int>(settings.range));
  me.setMaskSize(settings.maskSize);
  me.setThreshold(vpEdgeCueSettings::toLikelihood(settings.contrast, settings.maskSize));
  me.setMu1(settings.mu1);
  me.setMu2(settings.mu2);
  me.setSampleStep(viewOptions.sampleStep);
}

void vpMbMultiCueTracker::Impl::take(const Impl &before)
{
  me = before.me; // As the user gave it, and not as the edges' settings say it.
  modelOptions = before.modelOptions;
  preference = before.preference;
  choice = before.choice;
  throwOnLoss = before.throwOnLoss;
  rangeIsPredicted = before.rangeIsPredicted;
  displayHypotheses = before.displayHypotheses;
  particles.isDisplayed = before.particles.isDisplayed;
  featureFactors = before.featureFactors;
  rough.detector = before.rough.detector;
}

const vpTrackedModel &vpMbMultiCueTracker::Impl::requireModel() const
{
  if (!model) {
    throw vpException(vpException::notInitialized, "No model: call loadModel() first");
  }
  return *model;
}

void vpMbMultiCueTracker::Impl::setModel(vpTrackedModel &&loaded)
{
  model = std::make_shared<const vpTrackedModel>(std::move(loaded));
  symmetries.setModel(*model);
  view = std::make_unique<vpModelView>(model);
  displayView.reset();
  depthRenderer.reset();
  sphere.reset();
  keyframes.setObject(model->centre(), model->diameter());
  rough.search.setModel(model);
  const std::vector<vpSurfaceSample> samples = vpSampleSurface(*model, surfacePlaces);
  surface.setSamples(samples);
  halfTurns.setModel(*model, samples);
  makeRenderer();
  forgetImages();
  width = 0;
  height = 0;
  state = vpTrackingState::UNCERTAIN;
}

void vpMbMultiCueTracker::Impl::makeRenderer()
{
  // The depth buffer only tells what hides what: a convex object needs none.
  renderer = model && !model->isConvex() ? vpModelRenderer::create(model, preference) : nullptr;
}

void vpMbMultiCueTracker::Impl::makeCues()
{
  if (!uses(KLT_TRACKER)) {
    points.reset();
    return;
  }
  if (points) {
    points->setSettings(klt);
    return;
  }
  points = std::make_unique<vpPointCue>(klt);
  points->setDepthSource([this](const vpHomogeneousMatrix &cMo) { return renderDepth(cMo); });
}

const vpRenderedView *vpMbMultiCueTracker::Impl::renderDepth(const vpHomogeneousMatrix &cMo)
{
  if (!depthRenderer) {
    depthRenderer = vpModelRenderer::create(model, preference);
  }
  vpRenderOptions options;
  options.nearDistance = viewOptions.nearDistance;
  depthRenderer->render(cMo, frameCamera, width, height, options, depth);
  return &depth;
}

void vpMbMultiCueTracker::Impl::countSupport(bool estimated)
{
  const auto number = [](auto count) { return static_cast<unsigned int>(count); };
  supportOf.fill(Support());
  supportOf[indexOf(EDGE_TRACKER)].expected = uses(EDGE_TRACKER) ? number(edges.matches().size()) : 0U;
  supportOf[indexOf(COLOR_TRACKER)].expected = uses(COLOR_TRACKER) ? number(color.lines().size()) : 0U;
  // Two rows each.
  supportOf[indexOf(KLT_TRACKER)].expected = uses(KLT_TRACKER) ? number(2 * points->matches().size()) : 0U;
  for (std::size_t i = 0; estimated && i < fusion.size(); ++i) {
    const std::vector<double> &weights = fusion[i].weights;
    supportOf[indexOf(fusion[i].type)].good =
        number(std::count_if(weights.begin(), weights.end(), [](double weight) { return weight > goodWeight; }));
  }
  expected = 0;
  good = 0;
  for (const Support &part : supportOf) {
    expected += part.expected;
    good += part.good;
  }
}

vpTrackingState vpMbMultiCueTracker::Impl::stateOf(double share)
{
  if (share < vpJudgedPose::leastExplained) {
    return vpTrackingState::LOST;
  }
  return share < vpJudgedPose::badlyExplained ? vpTrackingState::UNCERTAIN : vpTrackingState::TRACKING;
}

vpMbTrackingResult::Reason vpMbMultiCueTracker::Impl::outcomeOf(vpTrackingState state)
{
  switch (state) {
  case vpTrackingState::TRACKING:
    return vpMbTrackingResult::Reason::WELL_EXPLAINED;
  case vpTrackingState::UNCERTAIN:
    return vpMbTrackingResult::Reason::PARTLY_EXPLAINED;
  case vpTrackingState::LOST:
    break;
  }
  return vpMbTrackingResult::Reason::CONTRADICTED;
}

double vpMbMultiCueTracker::Impl::explainedResidue() const
{
  return std::max(explained, usualFactor * usualResidue);
}

void vpMbMultiCueTracker::Impl::learnResidue()
{
  const double residue = bestResidue();
  if (std::isfinite(residue)) {
    usualResidue += usualResidue > 0. ? usualRate * (residue - usualResidue) : residue;
  }
}

vpViewSphere &vpMbMultiCueTracker::Impl::viewSphere()
{
  if (!sphere) {
    vpViewSphereOptions options;
    options.points = 100;
    sphere = std::make_unique<vpViewSphere>(model, options,
                                            model->isConvex() ? nullptr : vpModelRenderer::create(model, preference));
    poseScore.setSphere(sphere.get());
    aligner.setSphere(sphere.get());
    contourScan.setSphere(sphere.get());
  }
  return *sphere;
}

void vpMbMultiCueTracker::Impl::scoreFrame(const vpCueFrame &frame)
{
  if (scoredFrame != frame.number()) {
    scoreRegion(frame, {0, 0, static_cast<int>(frame.width()), static_cast<int>(frame.height())});
    scoredFrame = frame.number();
  }
}

void vpMbMultiCueTracker::Impl::scoreRegion(const vpCueFrame &frame, const vpImageRegion &region)
{
  viewSphere();
  const vpStopwatch stage(timings.map);
  distanceMap.compute(frame, region);
  const bool hasColors = uses(COLOR_TRACKER) && color.histograms().isKnown();
  if (hasColors) {
    oddsMap.compute(frame, color.histograms(), region);
  }
  aligner.setImage(hasColors ? &oddsMap : nullptr, &distanceMap, frame.camera(), frame.width(), frame.height());
  if (type != EDGE_TRACKER) {
    surface.setFrame(frame);
  }
  weighScore(false);
  poseScore.setImage(uses(EDGE_TRACKER) ? &distanceMap : nullptr, hasColors ? &oddsMap : nullptr,
                     type != EDGE_TRACKER ? &surface : nullptr, frame.camera(), frame.width(), frame.height());
}

void vpMbMultiCueTracker::Impl::weighScore(bool byEdges)
{
  const double others = byEdges ? othersByEdges : mustConfirm ? othersAfterLoss : 1.;
  poseScore.setWeights(reliability(unsteadiness.edges), others * reliability(unsteadiness.color),
                       others * reliability(unsteadiness.surface));
}

void vpMbMultiCueTracker::Impl::forgetImages()
{
  captured.reset();
  surface.reset();
  keyframes.reset();
  keyframeIsProvisional = false;
  searched.clear();
  framesSinceLoss = 0;
  confirmations = 0;
  tracks.clear();
  mustConfirm = false;
  past.clear();
  proof = Proof();
  endTwins();
  turnEffect.reset();
  turns = 0;
  period = 0;
  lastExplained = time;
  wasSudden = false;
  wasFound = false;
  trustedBefore.reset();
  outsideFrames = 0;
  doubtfulFrames = 0;
  disbelievedFrames = 0;
  edgesBeforeLoss.reset();
  scoredFrame = 0;
  particles.clear();
  edges = vpEdgeCue(edges.settings());
  textureSupport.reset(viewOptions);
  color.reset();
  usesPoints = true;
  usual = Agreement();
  unsteadiness = Agreement();
  surprise.fill(firstSurprise);
  farDeviation = mostFarDeviation;
  belief.start(rightAtStart);
  if (points) {
    points->reset();
  }
  forgetMotion();
  fusion.clear();
  isJudged = false;
  hypotheses.clear();
  otherHypotheses.clear();
  draws = 0;
  captures = 0;
  usualResidue = 0.;
  minimisations = 0;
  expected = 0;
  good = 0;
  supportOf.fill(Support());
  outcome = vpMbTrackingResult::Reason::NOT_STARTED;
}

END_VISP_NAMESPACE
