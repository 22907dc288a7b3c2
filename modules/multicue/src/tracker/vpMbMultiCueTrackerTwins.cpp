// SPDX-License-Identifier: GPL-2.0-or-later
#include <visp3/multicue/vpMbMultiCueTracker.h>

#include "tracker/vpTrackerState.h"
#include "motion/vpTurnBetween.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

BEGIN_VISP_NAMESPACE

namespace {
// Logarithm of the odds for one share of the surface's usual agreement, about this one.
const double gainOfSurface = 4.;
const double neutralSurface = 0.5;
// What the images before count beside this one: those of a twin that differs in nothing tell less and less.
const double keptLead = 0.9;
const unsigned int mostComparisons = 60; // Frames in which a twin did not win are enough.
// In each of so many others are looked for around the pose; poses drawn for that, and those that are compared.
const unsigned int searchInterval = 10;
const std::size_t searched = 80;
const std::size_t mostFound = 4;
// A pose that slipped by less than this (radians) is turned back to; where its twin has less than these odds before it.
const double mostSlip = 0.5;
const double leastOdds = 2.;
// What a pose a little beside the right one may gain now and then.
const double negligibleLead = 4.;
const double rightOfTwin = 0.5; // Probability of one that has won.
} // namespace

// After the object was found at a pose.
void vpMbMultiCueTracker::Impl::startTwins(const vpHomogeneousMatrix &cMo)
{
  endTwins();
  if (!uses(EDGE_TRACKER) || type == EDGE_TRACKER) {
    return;
  }
  twinFrames = 0;
  for (const vpHomogeneousMatrix &turned : halfTurns.turned(cMo)) {
    twins.push_back({cMo.inverse() * turned, 0.});
  }
}

void vpMbMultiCueTracker::Impl::endTwins()
{
  twins.clear();
  twinFrames = mostComparisons;
}

// How far the surface that was known before the object was found speaks for a pose, as a logarithm of odds.
double vpMbMultiCueTracker::Impl::surfaceEvidence(const vpHomogeneousMatrix &cMo) const
{
  if (!(usual.surface > 0.)) {
    return 0.;
  }
  const vpSurfaceMemory::Agreement seen = surface.agreement(cMo, proof.known->surface);
  const double variance = surfaceVariance(vpTurnBetween(proof.known->trusted.cMo, cMo));
  const double share = std::min(countedShare(seen.correlation, proof.known->usual.surface), 1.);
  return gainOfSurface * weightOf(seen) * reliability(variance) * (share - neutralSurface);
}

// Brings the cues to a pose, and looks at its contours. \return False where that fails.
bool vpMbMultiCueTracker::refineTwin(const vpCueFrame &frame, const vpHomogeneousMatrix &cMo,
                                     vpContourEvidence &contours)
{
  m_cMo = m_impl->startPose = cMo;
  updateView(frame, m_cMo, 0.);
  if (!refineFused(frame)) {
    return false;
  }
  match(frame, m_cMo);
  contours.set(m_impl->edges, m_cMo);
  return true;
}

// The pose that was found may be one that looks much alike: where it is turned by half. What only one of them has tells
// them apart, in some images.
void vpMbMultiCueTracker::compareTwins(const vpCueFrame &frame)
{
  Impl &impl = *m_impl;
  if (impl.mustConfirm || impl.twinFrames >= mostComparisons || impl.searchBudget.isSpent()) {
    return;
  }
  if (++impl.twinFrames % searchInterval == 0) {
    searchTwins(frame);
  }
  if (impl.twins.empty()) {
    return;
  }
  // The contrasts of edges that are remembered are those of the pose that is followed.
  std::swap(impl.edges, impl.plainEdges);
  impl.edges.setSettings(impl.plainEdges.settings());
  impl.edges.reset();
  impl.usesPoints = false;
  impl.holdsPrediction = false;
  impl.bestIsLast = false;
  weighTwins(frame);
  const std::optional<vpHomogeneousMatrix> right = rightTwin(frame);
  std::swap(impl.edges, impl.plainEdges);
  if (right) {
    impl.startOver(*right);
    impl.best = Impl::Attempt();
    attemptFrom(frame, *right, false);
  }
}

// The pose may have slipped to contours beside its own, while little of the object was in the image.
void vpMbMultiCueTracker::searchTwins(const vpCueFrame &frame)
{
  Impl &impl = *m_impl;
  const vpHomogeneousMatrix cMo = impl.best.cMo;
  impl.scoreFrame(frame);
  vpPoseSearch search(impl.poseScore, *impl.model, impl.draws++);
  search.setSymmetries(impl.symmetries.get());
  search.setPrior(cMo, vpPoseSearch::near(), vpPoseSearch::usualPrior);
  search.scatter({cMo}, vpPoseSearch::near(), searched);
  impl.settle(search);
  search.keepBest(mostFound, vpPoseSearch::same());
  for (const vpPoseCandidate &candidate : search.candidates()) {
    impl.twins.push_back({cMo.inverse() * impl.nearestAlike(candidate.cMo), 0.});
  }
}

// Those that lost are forgotten, and those that lead to the same pose.
void vpMbMultiCueTracker::weighTwins(const vpCueFrame &frame)
{
  Impl &impl = *m_impl;
  const vpHomogeneousMatrix cMo = impl.best.cMo;
  match(frame, cMo);
  vpContourEvidence followed;
  followed.set(impl.edges, cMo);
  const double surfaceOfFollowed = impl.surfaceEvidence(cMo);
  std::vector<Impl::Twin> kept;
  for (Impl::Twin &twin : impl.twins) {
    if (impl.searchBudget.isSpent()) {
      kept.push_back(twin);
      continue;
    }
    vpContourEvidence other;
    if (!refineTwin(frame, cMo * twin.oMt, other) || impl.sameTrack()(m_cMo, cMo)) {
      continue;
    }
    twin.lead = keptLead * twin.lead + vpContourEvidence::oddsOf(followed.advantageOver(other)) + surfaceOfFollowed -
                impl.surfaceEvidence(m_cMo);
    twin.oMt = cMo.inverse() * m_cMo;
    if (twin.lead < vpContourEvidence::decisiveOdds) {
      kept.push_back(twin);
    }
  }
  impl.twins = std::move(kept);
}

// The one that won, if any. The pose that is followed may only have slipped: then the twin turned back shows as much.
std::optional<vpHomogeneousMatrix> vpMbMultiCueTracker::rightTwin(const vpCueFrame &frame)
{
  Impl &impl = *m_impl;
  const auto best = std::min_element(impl.twins.begin(), impl.twins.end(),
                                     [](const Impl::Twin &a, const Impl::Twin &b) { return a.lead < b.lead; });
  if (best == impl.twins.end() || best->lead > -vpContourEvidence::decisiveOdds) {
    return std::nullopt;
  }
  const vpHomogeneousMatrix cMo = impl.best.cMo;
  vpContourEvidence won;
  if (!refineTwin(frame, cMo * best->oMt, won)) {
    return std::nullopt;
  }
  const vpHomogeneousMatrix right = m_cMo;
  for (const vpHomogeneousMatrix &turned : impl.halfTurns.turned(right)) {
    vpContourEvidence back;
    if (vpTurnBetween(turned, cMo) < mostSlip && refineTwin(frame, turned, back) &&
        vpContourEvidence::oddsOf(won.advantageOver(back)) < leastOdds) {
      return m_cMo;
    }
  }
  return right;
}

// At a twin that won: what was learnt since the object was found is of the wrong pose.
void vpMbMultiCueTracker::Impl::startOver(const vpHomogeneousMatrix &cMo)
{
  forgetPeriod();
  recall(*proof.known);
  edges.reset();
  keyframes.reset();
  if (points) {
    points->reset();
  }
  forgetMotion();
  belief.start(rightOfTwin);
  expectedPose = startPose = cMo;
  farDeviation = mostFarDeviation;
  trusted.cMo = cMo;
  trusted.velocity.setZero();
  trustedFrames = 0;
  startProof(proof.known);
  startTwins(cMo);
}

// The twins count as long as they have more of their own than the pose that is followed.
double vpMbMultiCueTracker::Impl::believed() const
{
  double least = 0.;
  for (const Twin &twin : twins) {
    least = std::min(least, twin.lead + negligibleLead);
  }
  const double probability = belief.probability();
  return probability / (probability + (1. - probability) * std::exp(-least));
}

END_VISP_NAMESPACE
