// SPDX-License-Identifier: GPL-2.0-or-later
#include <visp3/multicue/vpMbMultiCueTracker.h>

#include "hypotheses/vpControlPointMotion.h"
#include "tracker/vpStopwatch.h"
#include "tracker/vpTrackerState.h"

#include <visp3/core/vpException.h>

#include <Eigen/LU>

#include <algorithm>
#include <cmath>

BEGIN_VISP_NAMESPACE

namespace {
// When the pose moved the control points by more than this, the match before is not one for the new pose.
const double rematchMotion = 1.5; // Pixels.
const unsigned int maxMatches = 3;
// A pose that is farther than this from the one that the frame started with has diverged, in diameters.
const double maxMotion = 1.;
// Fewer points found tell no pose by themselves.
const std::size_t fewestPoints = 12;
// Share of the points looked for that have to agree on a pose.
const double leastAgreeing = 0.5;
// The pose's deviation is not believed to be below this share of the diameter, and this angle.
const double leastTranslation = 5e-4;
const double leastRotation = 1e-3; // Radians.
} // namespace

// Where the object is expected in the next frame.
void vpMbMultiCueTracker::predict()
{
  Impl &impl = *m_impl;
  impl.sinceUpdate += impl.frameInterval;
  if (impl.predicts && impl.kalman.isStarted()) {
    m_cMo = impl.kalman.predict(impl.sinceUpdate).cMo;
  }
}

// The cues that are matched take part in one minimisation.
bool vpMbMultiCueTracker::minimise(const std::vector<int> &cues)
{
  Impl &impl = *m_impl;
  impl.fusion.clear();
  for (const int cue : cues) {
    if (!impl.uses(cue)) {
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
  return computeVVS();
}

// Few points, or many that disagree, are those of something else, or of a pose too far away to find them.
bool vpMbMultiCueTracker::pointsAgree() const
{
  const std::vector<double> &weights = m_impl->fusion[0].weights;
  const auto kept = static_cast<std::size_t>(
      std::count_if(weights.begin(), weights.end(), [](double weight) { return weight > 0.; }));
  return kept >= 2 * fewestPoints &&
         static_cast<double>(kept) >= 2. * leastAgreeing * static_cast<double>(m_impl->points->matches().size());
}

// Points and the coarse levels of the colours reach far, and bring the pose to where the fine cues find theirs.
void vpMbMultiCueTracker::estimateCoarse(const vpCueFrame &frame)
{
  Impl &impl = *m_impl;
  computeView(frame, m_cMo);
  if (impl.uses(KLT_TRACKER)) {
    {
      const vpStopwatch stage(impl.timings.match);
      impl.points->match(frame, *impl.view);
    }
    const vpHomogeneousMatrix cMoBefore = m_cMo;
    if (!minimise({KLT_TRACKER}) || !pointsAgree()) {
      m_cMo = cMoBefore;
    }
  }
  const unsigned int coarse = static_cast<unsigned int>(impl.color.settings().scales.size());
  const unsigned int matches = impl.uses(COLOR_TRACKER) && coarse > 0 ? coarse + 1 : 0;
  for (unsigned int i = 0; i < matches; ++i) {
    computeView(frame, m_cMo);
    {
      const vpStopwatch stage(impl.timings.match);
      impl.color.setLevel(i > 0 ? i - 1 : 0); // The coarsest one twice: its lines reach farther when they lie better.
      impl.color.match(frame, *impl.view);
    }
    const vpHomogeneousMatrix cMoBefore = m_cMo;
    if (!minimise({COLOR_TRACKER, KLT_TRACKER})) {
      m_cMo = cMoBefore;
    }
  }
}

bool vpMbMultiCueTracker::estimateFused(const vpCueFrame &frame)
{
  Impl &impl = *m_impl;
  const vpHomogeneousMatrix cMoStart = m_cMo;
  estimateCoarse(frame);
  for (unsigned int i = 0; i < maxMatches; ++i) {
    computeView(frame, m_cMo);
    {
      const vpStopwatch stage(impl.timings.match);
      if (impl.uses(EDGE_TRACKER)) {
        impl.edges.match(frame, *impl.view);
      }
      if (impl.uses(COLOR_TRACKER)) {
        const unsigned int coarse = static_cast<unsigned int>(impl.color.settings().scales.size());
        impl.color.setLevel(coarse + i); // Beyond the finest one: that one.
        impl.color.match(frame, *impl.view);
      }
    }
    if (!minimise({EDGE_TRACKER, COLOR_TRACKER, KLT_TRACKER})) {
      return false;
    }
    const vpHomogeneousMatrix moved = cMoStart * m_cMo.inverse();
    const double distance = (cMoStart.getTranslationVector() - m_cMo.getTranslationVector()).frobeniusNorm();
    if (!std::isfinite(moved[0][0]) || !(distance < maxMotion * impl.model->diameter())) {
      return false;
    }
    const bool finest = !impl.uses(COLOR_TRACKER) || i + 1 >= impl.color.settings().bands.size();
    if (finest && vpControlPointMotion::mean(*impl.view, m_cMo, frame.camera()) < rematchMotion) {
      break;
    }
  }
  return true;
}

// Only from poses that are trusted: what is learnt from a wrong one keeps it wrong.
void vpMbMultiCueTracker::updateReferences()
{
  Impl &impl = *m_impl;
  for (std::size_t i = 0; i < impl.fusion.size(); ++i) {
    const vpCueFusion::Part &part = impl.fusion[i];
    if (part.type == EDGE_TRACKER) {
      impl.edges.updateReference(m_cMo, part.weights);
    } else if (part.type == COLOR_TRACKER) {
      impl.color.updateReference(m_cMo, part.weights);
    } else {
      impl.points->updateReference(m_cMo, part.weights);
    }
  }
}

void vpMbMultiCueTracker::updateMotion()
{
  Impl &impl = *m_impl;
  if (!impl.predicts) {
    return;
  }
  vpPoseMatrix6 information = impl.fusion.information();
  const double z = std::max(m_cMo[2][3], 1e-9);
  const double translation = leastTranslation * impl.model->diameter();
  // A prior as weak as the whole scene keeps unobserved motions finite.
  information.diagonal().head<3>().array() += 1. / (z * z);
  information.diagonal().tail<3>().array() += 1.;
  vpPoseMatrix6 covariance = information.inverse();
  covariance = 0.5 * (covariance + covariance.transpose()).eval();
  covariance.diagonal().head<3>().array() += translation * translation;
  covariance.diagonal().tail<3>().array() += leastRotation * leastRotation;
  impl.kalman.update(m_cMo, covariance, impl.sinceUpdate);
  impl.sinceUpdate = 0.;
}

// What the image shows at the pose that the user gave.
void vpMbMultiCueTracker::learnStart(const vpCueFrame &frame)
{
  Impl &impl = *m_impl;
  impl.frameCamera = frame.camera();
  if (!impl.uses(COLOR_TRACKER) && !impl.uses(KLT_TRACKER)) {
    return;
  }
  computeView(frame, m_cMo);
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

void vpMbMultiCueTracker::initFromPose(const vpImage<vpRGBa> &I_color, const vpHomogeneousMatrix &cMo)
{
  setPose(I_color, cMo);
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
}

void vpMbMultiCueTracker::setFrameInterval(double seconds)
{
  if (!(seconds > 0.) || !std::isfinite(seconds)) {
    throw vpException(vpException::badValue, "The time between two images is %g s, it must be above 0", seconds);
  }
  m_impl->frameInterval = seconds;
}

END_VISP_NAMESPACE
