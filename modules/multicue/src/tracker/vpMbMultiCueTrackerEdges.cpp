// SPDX-License-Identifier: GPL-2.0-or-later
#include <visp3/multicue/vpMbMultiCueTracker.h>

#include "tracker/vpTrackerState.h"

#include <algorithm>

// Where edges are the only cue, an image's evidence for a pose is all that tells a right one from a wrong one.

BEGIN_VISP_NAMESPACE

namespace {
// Right poses have as much where the image shows the object at all.
const double leastUsualEvidence = 0.1;
// What a pose may have less of it than in the frame before: what passes in front of an object hides it bit by bit, and
// an object that jumped is lost at once, wherever its edges are taken for others.
const double mostDrop = 0.3;
// What a pose has to have of the usual evidence after a loss. With edges that have the contrasts from before the loss
// it is believed at once; light that changed may leave a right one with others, and some frames on end have to show it.
// Of wrong poses, one frame in a hundred has 0.75 to 0.8 of the usual evidence.
const double confirmingShare = 0.8;
const unsigned int neededFrames = 10;
// How far from where it was trusted last a lost object is looked for in the first frame, and in each frame more: in
// the usual offsets of a start.
const double firstReach = 1.5;
const double reachPerFrame = 0.5;
const double mostReach = 4.;
} // namespace

// Evidence as a share of that of the trusted frames before, both beyond what chance has.
double vpMbMultiCueTracker::Impl::shareOfEvidence(double evidence) const
{
  const double known = std::max(usual.evidence, leastUsualEvidence) - evidenceByChance;
  return std::max(evidence - evidenceByChance, 0.) / known;
}

// Whether the image shows the object at the pose that was estimated.
void vpMbMultiCueTracker::judgeByEvidence(bool estimated)
{
  Impl &impl = *m_impl;
  judge(estimated);
  if (impl.searches) {
    return; // judgeByMap() decides.
  }
  lookAtEdges();
  impl.agreement.evidence = impl.edges.evidence(m_cMo);
  const double share = estimated ? impl.shareOfEvidence(impl.agreement.evidence) : 0.;
  impl.best = Impl::Attempt();
  impl.best.cMo = m_cMo;
  impl.best.explained = impl.best.value = share;
  if (impl.state != vpTrackingState::LOST) {
    impl.state = std::max(impl.state, impl.stateOf(share));
    impl.outcome = impl.outcomeOf(impl.state);
  }
}

// From the pose before; where the image does not show the object there, in another light, and around the pose that was
// trusted last.
void vpMbMultiCueTracker::followEdges(const vpCueFrame &frame, const vpHomogeneousMatrix &cMoBefore)
{
  Impl &impl = *m_impl;
  const double shareBefore = impl.isJudged ? impl.best.explained : 0.;
  const auto isLost = [&] {
    const bool hasDropped = !impl.searches && shareBefore - impl.best.explained > mostDrop;
    return hasDropped || impl.state == vpTrackingState::LOST;
  };
  judgeByEvidence(estimate(frame));
  if (isLost()) {
    // A jump of the light changes all contrasts at once: with others the edges may be there yet.
    m_cMo = cMoBefore;
    computeView(frame, m_cMo);
    impl.edges.adaptToLight(frame, *impl.view);
    judgeByEvidence(estimate(frame));
  }
  if (impl.searches) {
    return;
  }
  if (isLost() && !impl.edgesBeforeLoss) {
    impl.edgesBeforeLoss = impl.edges;
  }
  if (impl.edgesBeforeLoss) {
    captureAgain(frame);
    confirmByEvidence(frame);
  }
}

// After a loss a pose is looked for as at a start.
void vpMbMultiCueTracker::captureAgain(const vpCueFrame &frame)
{
  Impl &impl = *m_impl;
  const vpHomogeneousMatrix cMo = m_cMo;
  const double share = impl.state == vpTrackingState::LOST ? 0. : impl.best.explained;
  const double reach = std::min(firstReach + reachPerFrame * impl.framesSinceLoss, mostReach);
  capture(frame, impl.trusted.cMo, reach);
  impl.edges.reset();
  judgeByEvidence(estimateFrom(frame, false));
  if (impl.best.explained < share) {
    m_cMo = cMo;
    judgeByEvidence(estimateFrom(frame, false));
  }
}

// Without a search nothing else is compared with a pose that was found after a loss: some frames have to show it.
void vpMbMultiCueTracker::confirmByEvidence(const vpCueFrame &frame)
{
  Impl &impl = *m_impl;
  ++impl.framesSinceLoss;
  if (impl.state != vpTrackingState::TRACKING || impl.best.explained < confirmingShare) {
    impl.confirmations = 0;
  } else {
    vpEdgeCue &before = *impl.edgesBeforeLoss;
    before.match(frame, *impl.view);
    const bool isSame = impl.shareOfEvidence(before.evidence(m_cMo)) >= confirmingShare;
    impl.confirmations += isSame ? neededFrames : 1;
  }
  if (impl.confirmations >= neededFrames) {
    impl.edgesBeforeLoss.reset();
    impl.confirmations = 0;
    impl.framesSinceLoss = 0;
  } else if (impl.state == vpTrackingState::TRACKING) {
    impl.state = vpTrackingState::UNCERTAIN;
    impl.outcome = vpMbTrackingResult::Reason::CONFIRMING;
  }
}

// With a search for what is lost the distance map decides, since what hides the object leaves few of the matches of a
// right pose.
void vpMbMultiCueTracker::judgeByMap(const vpCueFrame &frame)
{
  Impl &impl = *m_impl;
  if (!impl.particles.settings().enabled && impl.scoredFrame != frame.number()) {
    impl.scoreRegion(frame, impl.regionAround(m_cMo));
  }
  lookAtEdges(); // For what is usual of the matches.
  double share = mapShare();
  if (impl.stateOf(share) != vpTrackingState::TRACKING && impl.scoredFrame != frame.number()) {
    impl.scoreFrame(frame); // The pose may be outside the region.
    share = mapShare();
  }
  impl.best = Impl::Attempt();
  impl.best.cMo = m_cMo;
  impl.best.explained = impl.best.value = share;
  if (impl.state != vpTrackingState::LOST) {
    impl.state = impl.stateOf(share);
    impl.outcome = impl.outcomeOf(impl.state);
  }
}

END_VISP_NAMESPACE
