// SPDX-License-Identifier: GPL-2.0-or-later
#include <visp3/multicue/vpMbMultiCueTracker.h>

#include "tracker/vpTrackerState.h"

#include <algorithm>
#include <cmath>

BEGIN_VISP_NAMESPACE

namespace {
// An edge or a point that is farther away than this does not support a pose, pixels.
const double edgeReach = 2.5;
const double pointReach = 2.;
// Of what the trusted frames before had: from there on a pose is taken, and below this others are looked for all
// around.
const double wellExplained = 0.8;
const double badlyExplained = 0.65;
// One cue alone does not make a pose better than those before.
const double mostOfOne = 1.2;
// Slower down than up: a wrong pose explains less, and must not become the usual one.
const double usualRiseRate = 0.1;
const double usualFallRate = 0.02;
// Turns of the object that are tried, radians.
const double turn = 0.35;

// 1 for a distance of 0, falling to 0 at the reach.
double closeness(double distance, double reach)
{
  const double share = distance / reach;
  return std::max(0., 1. - share * share);
}
} // namespace

double vpMbMultiCueTracker::edgeAgreement() const
{
  const Impl &impl = *m_impl;
  vpResidualBlock &block = m_impl->block;
  impl.edges.residuals(m_cMo, block);
  double sum = 0.;
  for (const vpResidual &row : block.rows) {
    sum += closeness(row.error, edgeReach / impl.frameCamera.get_px());
  }
  return impl.edges.matches().empty() ? 0. : sum / static_cast<double>(impl.edges.matches().size());
}

double vpMbMultiCueTracker::pointAgreement() const
{
  const Impl &impl = *m_impl;
  vpResidualBlock &block = m_impl->block;
  impl.points->residuals(m_cMo, block);
  double sum = 0.;
  for (std::size_t i = 0; i + 1 < block.rows.size(); i += 2) {
    const double distance = std::hypot(block.rows[i].error, block.rows[i + 1].error);
    sum += closeness(distance, pointReach / impl.frameCamera.get_px());
  }
  return impl.points->matches().empty() ? 0. : sum / static_cast<double>(impl.points->matches().size());
}

// How well the cues agree with the pose, each as a share of what it had in the trusted frames before. Points count only
// where there is nothing else: those of what hides the object agree with a wrong pose.
double vpMbMultiCueTracker::explainedShare()
{
  Impl &impl = *m_impl;
  Agreement &agreement = impl.agreement;
  double sum = 0.;
  int cues = 0;
  const auto add = [&](double value, double usual) {
    sum += std::min(value / std::max(usual, Impl::leastUsual), mostOfOne);
    ++cues;
  };
  if (impl.uses(EDGE_TRACKER)) {
    agreement.edges = edgeAgreement();
    add(agreement.edges, impl.usual.edges);
  }
  if (impl.uses(COLOR_TRACKER) && !impl.color.settings().scales.empty()) {
    agreement.color = impl.color.evidenceAt(m_cMo);
    add(agreement.color, impl.usual.color);
  }
  if (impl.uses(KLT_TRACKER) && cues == 0) {
    agreement.points = pointAgreement();
    add(agreement.points, impl.usual.points);
  }
  return cues > 0 ? sum / cues : 0.;
}

void vpMbMultiCueTracker::learnUsual()
{
  Impl &impl = *m_impl;
  const auto learn = [](double value, double &usual) {
    const double rate = usual > 0. ? (value > usual ? usualRiseRate : usualFallRate) : 1.;
    usual += rate * (value - usual);
  };
  learn(impl.agreement.edges, impl.usual.edges);
  learn(impl.agreement.color, impl.usual.color);
  learn(impl.agreement.points, impl.usual.points);
}

// Keeps the pose where it explains more than the best one before. \return True where that is enough.
bool vpMbMultiCueTracker::takeAttempt(bool estimated)
{
  Impl &impl = *m_impl;
  const double value = estimated ? explainedShare() : -1.;
  impl.bestIsLast = value > impl.bestExplained;
  if (impl.bestIsLast) {
    impl.bestExplained = value;
    impl.bestPose = m_cMo;
    impl.bestUsesPoints = impl.usesPoints;
  }
  return impl.bestExplained >= wellExplained;
}

// Starts elsewhere, where the image does not look as it should at the pose that was found.
void vpMbMultiCueTracker::tryOthers(const vpCueFrame &frame)
{
  Impl &impl = *m_impl;
  impl.usesPoints = false;
  impl.edges.reset(); // A jump of the light changes all contrasts at once.
  // Colours mislead where much of the object looks like what is behind it.
  m_cMo = impl.expectedPose;
  if (takeAttempt(refineFused(frame))) {
    return;
  }
  if (impl.uses(EDGE_TRACKER)) {
    m_cMo = impl.expectedPose;
    proposePose(frame);
    if (takeAttempt(refineFused(frame))) {
      return;
    }
  }
  if (impl.bestExplained < badlyExplained) {
    tryTurns(frame);
  }
}

void vpMbMultiCueTracker::tryTurns(const vpCueFrame &frame)
{
  Impl &impl = *m_impl;
  const vpHomogeneousMatrix oMb = impl.centreFrame();
  const vpHomogeneousMatrix cMb = impl.expectedPose * oMb;
  for (unsigned int i = 0; i < 6; ++i) {
    const double angle = i % 2 == 0 ? turn : -turn;
    const unsigned int axis = i / 2;
    const vpHomogeneousMatrix turned(
        vpTranslationVector(cMb[0][3], cMb[1][3], cMb[2][3]),
        vpRotationMatrix(vpThetaUVector(axis == 0 ? angle : 0., axis == 1 ? angle : 0., axis == 2 ? angle : 0.)) *
            cMb.getRotationMatrix());
    m_cMo = turned * oMb.inverse();
    updateView(frame, m_cMo, 0.);
    if (impl.uses(COLOR_TRACKER)) {
      estimateByCoarseColors(frame);
    }
    if (takeAttempt(refineFused(frame))) {
      return;
    }
  }
}

bool vpMbMultiCueTracker::estimateFused(const vpCueFrame &frame)
{
  Impl &impl = *m_impl;
  impl.bestExplained = -1.;
  estimateCoarse(frame);
  const bool estimated = refineFused(frame);
  if (takeAttempt(estimated)) {
    return true;
  }
  tryOthers(frame);
  if (impl.bestExplained < 0.) {
    return false;
  }
  if (!impl.bestIsLast) {
    m_cMo = impl.bestPose;
    impl.usesPoints = impl.bestUsesPoints;
    if (!refineFused(frame)) {
      return false;
    }
    explainedShare();
  }
  return true;
}

END_VISP_NAMESPACE
