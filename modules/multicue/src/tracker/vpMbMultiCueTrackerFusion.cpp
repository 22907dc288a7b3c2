// SPDX-License-Identifier: GPL-2.0-or-later
#include <visp3/multicue/vpMbMultiCueTracker.h>

#include "hypotheses/vpControlPointMotion.h"
#include "frame/vpStopwatch.h"
#include "tracker/vpTrackerState.h"

#include <visp3/core/vpException.h>

#include <algorithm>
#include <cmath>

BEGIN_VISP_NAMESPACE

namespace {
// When the pose moved the control points by more than this, the match before is not one for the new pose.
const double rematchMotion = 1.5; // Pixels.
const unsigned int maxMatches = 3;
// A pose that is farther than this from the one that the frame started with has diverged, in diameters.
const double maxMotion = 1.;
// A view serves poses that move its control points by less than this, pixels.
const double nearMotion = 0.5;
// How far a point may be from where a pose that it had no part in has it, pixels.
const double nearPoint = 2.;
// How far from where it is expected the object may well be: in diameters, and radians.
const double leastMotion = 0.04;
const double mostMotion = 0.15;
// In standard deviations of how far it was from there in the frames before.
const double motionFactor = 2.;
const double motionRate = 0.2;
// What is no surprise any more: as many times what was off, at least this share of the most, and how fast it falls.
const double farFactor = 3.;
const double leastFarShare = 0.25;
const double farRate = 0.1;
// The pose's deviation is not believed to be below this share of the diameter, and this angle.
const double leastTranslation = 5e-4;
const double leastRotation = 1e-3; // Radians.
} // namespace

// Where the object is expected in the next frame.
void vpMbMultiCueTracker::predict()
{
  Impl &impl = *m_impl;
  impl.time += impl.frameInterval;
  impl.sinceUpdate += impl.frameInterval;
  impl.predictedRange = 0.;
  impl.holdsPrediction = false;
  // A pose that was found after a loss is no news to the filter before it is confirmed.
  const bool isFound = impl.mustConfirm && impl.state != vpTrackingState::LOST;
  const bool isStale = impl.searches && !impl.mayCoast();
  if (impl.predicts && impl.kalman.isStarted() && !isFound && !isStale) {
    const vpPoseKalmanFilter::Estimate expected = impl.kalman.predict(impl.sinceUpdate);
    impl.holdsPrediction = !impl.mustConfirm;
    // Of a turn that nothing shows, the filter would go on with what tilting the axis made it believe.
    m_cMo = impl.holdsTurns() ? impl.symmetries.unturned(expected.cMo, m_cMo, *impl.model) : expected.cMo;
    predictRange(expected.covariance);
  }
  if (impl.holdsPrediction) {
    impl.inertia.predict(impl.time, impl.model->centre(), impl.model->diameter());
  } else {
    impl.inertia.skip();
  }
  impl.expectedPose = m_cMo;
  impl.startPose = m_cMo;
}

// The cues that are matched take part in one minimisation.
bool vpMbMultiCueTracker::minimise(const std::vector<int> &cues)
{
  Impl &impl = *m_impl;
  impl.fusion.clear();
  for (const int cue : cues) {
    if (!impl.uses(cue) || (cue == KLT_TRACKER && !impl.usesPoints)) {
      continue;
    }
    if (cue == EDGE_TRACKER) {
      impl.fusion.add(cue, impl.edges);
    } else if (cue == COLOR_TRACKER) {
      impl.fusion.add(cue, impl.color);
    } else {
      impl.fusion.add(cue, *impl.points);
    }
  }
  if (impl.symmetries.hasAxis()) { // Only marks on the surface may show a turn.
    impl.fusion.setVisibleMotions(impl.symmetries.visibleMotions(), KLT_TRACKER, impl.symmetries.printShowsTurns());
  }
  if (impl.comparesAttempts()) {
    setPrior();
    impl.fusion.setPrior(impl.prior);
  }
  return computeVVS();
}

// As wide as the object was off the expected poses lately. Around the predicted one, what the image does not show, as
// of an object that is nearly outside, goes on as it moved; else it may drift from one minimisation to the next.
void vpMbMultiCueTracker::setPrior()
{
  Impl &impl = *m_impl;
  const vpTrackedModel &model = *impl.model;
  const auto width = [](double variance) {
    return std::min(std::max(motionFactor * std::sqrt(variance), leastMotion), mostMotion);
  };
  vpPoseTangent deviations;
  deviations.head<3>().setConstant(width(impl.surprise[0]) * model.diameter());
  deviations.tail<3>().setConstant(width(impl.surprise[1]));
  impl.prior.set(impl.holdsPrediction ? impl.expectedPose : m_cMo, impl.centreFrame(), deviations);
}

// How far the object was from where it was expected.
void vpMbMultiCueTracker::learnSurprise()
{
  Impl &impl = *m_impl;
  const std::array<double, 2> off = impl.offExpected(m_cMo);
  for (std::size_t i = 0; i < off.size(); ++i) {
    impl.surprise[i] += motionRate * (off[i] * off[i] - impl.surprise[i]);
  }
  impl.learnFarDeviation(off);
}

// Of an object that moves evenly, a pose beside the expected one is another one; of one that is shaken it is not.
void vpMbMultiCueTracker::Impl::learnFarDeviation(const std::array<double, 2> &off)
{
  for (std::size_t i = 0; i < off.size(); ++i) {
    const double most = mostFarDeviation[i];
    const double now = std::min(std::max(farFactor * off[i], leastFarShare * most), most);
    farDeviation[i] = std::max(now, farDeviation[i] + farRate * (now - farDeviation[i]));
  }
}

// The fine levels, where edges and points take part. \return False where there is no pose.
bool vpMbMultiCueTracker::refineFused(const vpCueFrame &frame)
{
  Impl &impl = *m_impl;
  for (unsigned int i = 0; i < maxMatches; ++i) {
    updateView(frame, m_cMo, nearMotion);
    {
      const vpStopwatch stage(impl.timings.match);
      if (impl.uses(EDGE_TRACKER)) {
        matchEdges(frame);
      }
      if (impl.uses(COLOR_TRACKER)) {
        const unsigned int coarse = static_cast<unsigned int>(impl.color.settings().scales.size());
        impl.color.setLevel(coarse + i); // Beyond the finest one: that one.
        impl.color.match(frame, *impl.view);
      }
    }
    if (!minimise({EDGE_TRACKER, COLOR_TRACKER, KLT_TRACKER}) || !isBelievable()) {
      return false;
    }
    const bool finest = !impl.uses(COLOR_TRACKER) || i + 1 >= impl.color.settings().bands.size();
    if (finest && vpControlPointMotion::mean(*impl.view, m_cMo, frame.camera()) < rematchMotion) {
      break;
    }
  }
  return true;
}

// A pose that is far from the one that it started from has diverged.
bool vpMbMultiCueTracker::isBelievable() const
{
  const vpHomogeneousMatrix &start = m_impl->startPose;
  const double distance = (start.getTranslationVector() - m_cMo.getTranslationVector()).frobeniusNorm();
  return std::isfinite(m_cMo[0][0]) && distance < maxMotion * m_impl->model->diameter();
}

void vpMbMultiCueTracker::updateReferences()
{
  Impl &impl = *m_impl;
  for (std::size_t i = 0; i < impl.fusion.size(); ++i) {
    const vpCueFusion::Part &part = impl.fusion[i];
    if (part.type == EDGE_TRACKER) {
      impl.edges.updateReference(m_cMo, part.weights);
      impl.textureSupport.update(impl.edges.matches(), part.weights, *impl.view, impl.viewOptions);
    } else if (part.type == COLOR_TRACKER) {
      impl.color.updateReference(m_cMo, part.weights);
    } else {
      impl.points->updateReference(m_cMo, part.weights);
    }
  }
  if (impl.uses(KLT_TRACKER) && impl.fusion.find(KLT_TRACKER) == nullptr) {
    updateRefusedPoints();
  }
  if (impl.type != EDGE_TRACKER) {
    const vpModelView &view = *impl.view;
    const bool isConvex = impl.model->isConvex();
    if (isConvex || (view.depth() != nullptr &&
                     vpControlPointMotion::between(view, view.depthPose(), m_cMo, impl.frameCamera) < nearPoint)) {
      impl.surface.learn(m_cMo, isConvex ? nullptr : view.depth());
    }
  }
}

// Points had no part in the pose: those that agree with it nevertheless are the object's.
void vpMbMultiCueTracker::updateRefusedPoints()
{
  Impl &impl = *m_impl;
  vpResidualBlock &block = impl.block;
  impl.points->residuals(m_cMo, block);
  std::vector<double> weights;
  const double largest = nearPoint / impl.frameCamera.get_px();
  for (const vpResidual &row : block.rows) {
    weights.push_back(std::fabs(row.error) < largest ? 1. : 0.);
  }
  impl.points->updateReference(m_cMo, weights);
}

// \param doubt Factor of the covariance, for a pose that is not trusted.
void vpMbMultiCueTracker::updateMotion(double doubt)
{
  Impl &impl = *m_impl;
  if (!impl.usesVelocity()) {
    return;
  }
  const double translation = leastTranslation * impl.model->diameter();
  vpPoseMatrix6 covariance = impl.uncertainty.covariance();
  if (impl.holdsTurns()) {
    covariance = impl.symmetries.settled(covariance, m_cMo);
  }
  covariance.diagonal().head<3>().array() += translation * translation;
  covariance.diagonal().tail<3>().array() += leastRotation * leastRotation;
  covariance *= doubt;
  impl.kalman.update(m_cMo, covariance, impl.sinceUpdate);
  impl.sinceUpdate = 0.;
}

// What the image shows at the pose that the user gave.
void vpMbMultiCueTracker::learnStart(const vpCueFrame &frame)
{
  Impl &impl = *m_impl;
  impl.frameCamera = frame.camera();
  computeView(frame, m_cMo);
  if (impl.type != EDGE_TRACKER) {
    impl.surface.setFrame(frame);
    learnReferencesOfStart(frame);
    learnKeyframe(frame);
    impl.keyframeIsProvisional = true;
  }
  learnUsualOfStart(frame);
}

// Edges need none.
void vpMbMultiCueTracker::learnReferencesOfStart(const vpCueFrame &frame)
{
  Impl &impl = *m_impl;
  impl.fusion.clear();
  if (impl.uses(COLOR_TRACKER)) {
    impl.color.setLevel(impl.color.levels());
    impl.color.match(frame, *impl.view);
    impl.fusion.add(COLOR_TRACKER, impl.color);
  }
  if (impl.uses(KLT_TRACKER)) {
    impl.points->match(frame, *impl.view);
    impl.fusion.add(KLT_TRACKER, *impl.points);
  }
  const unsigned int rows = impl.fusion.start(m_cMo);
  vpColVector trusted(rows);
  trusted = 1.;
  impl.fusion.keepWeights(trusted);
  updateReferences();
}

void vpMbMultiCueTracker::setColorSettings(const vpColorCueSettings &settings)
{
  m_impl->color.setSettings(settings);
}

vpColorCueSettings vpMbMultiCueTracker::getColorSettings() const
{
  return m_impl->color.settings();
}

void vpMbMultiCueTracker::setPrediction(bool flag, const vpPoseKalmanSettings &settings)
{
  m_impl->kalman.setSettings(settings);
  m_impl->kalman.reset();
  m_impl->predicts = flag;
  m_impl->choice.keepsPrediction = true;
}

void vpMbMultiCueTracker::setSearch(bool flag)
{
  m_impl->searches = flag;
  m_impl->choice.keepsSearch = true;
}

void vpMbMultiCueTracker::setSearchBudget(double milliseconds)
{
  m_impl->searchBudget.set(milliseconds);
  m_impl->choice.keepsBudget = true;
}

double vpMbMultiCueTracker::getSearchBudget() const
{
  return m_impl->searchBudget.get();
}

void vpMbMultiCueTracker::setFrameInterval(double seconds)
{
  if (!(seconds > 0.) || !std::isfinite(seconds)) {
    throw vpException(vpException::badValue, "The time between two images is %g s, it must be above 0", seconds);
  }
  m_impl->frameInterval = seconds;
}

END_VISP_NAMESPACE
