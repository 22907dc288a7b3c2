// SPDX-License-Identifier: GPL-2.0-or-later
#include "engine/vpEdgeFollower.h"

#include <algorithm>

BEGIN_VISP_NAMESPACE

namespace {
// What a pose may have less of the usual evidence than in the frame before: what passes in front of an object hides it
// bit by bit, and an object that jumped is lost at once, wherever its edges are taken for others.
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

void vpEdgeFollower::forgetImages()
{
  m_verdict = vpVerdict();
  m_edgesBeforeLoss.reset();
}

// Whether the image shows the object at the pose that was estimated.
vpHomogeneousMatrix vpEdgeFollower::judged(const vpEstimate &estimate)
{
  m_outcome.judge(estimate.isFound, m_cues, m_minimiser.fusion(), m_settings.goodRatio);
  if (m_settings.searches) {
    return estimate.cMo; // judgeByMap() decides.
  }
  m_verdict = m_judge.byEvidence(estimate.cMo);
  m_verdict.explained = estimate.isFound ? m_verdict.explained : 0.;
  if (!m_outcome.isLost()) {
    const vpTrackingState bySupport = m_outcome.state;
    m_outcome.judgeShare(m_verdict.explained);
    m_outcome.state = std::max(m_outcome.state, bySupport);
    m_outcome.reason = vpTrackingOutcome::reasonOf(m_outcome.state);
  }
  return estimate.cMo;
}

vpHomogeneousMatrix vpEdgeFollower::follow(const vpFrameContext &frame, const vpHomogeneousMatrix &expected,
                                           const vpHomogeneousMatrix &before)
{
  const double shareBefore = m_outcome.isJudged ? m_verdict.explained : 0.;
  const auto isLost = [&] {
    const bool hasDropped = !m_settings.searches && shareBefore - m_verdict.explained > mostDrop;
    return hasDropped || m_outcome.isLost();
  };
  vpHomogeneousMatrix cMo = judged(m_edges.estimate(frame, expected));
  if (isLost()) {
    // A jump of the light changes all contrasts at once: with others the edges may be there yet.
    m_cues.edges().adaptToLight(frame.image, m_looks.compute(frame, before));
    cMo = judged(m_edges.estimate(frame, before));
  }
  if (m_settings.searches) {
    return cMo;
  }
  if (isLost() && !m_edgesBeforeLoss) {
    m_edgesBeforeLoss = m_cues.edges();
  }
  if (m_edgesBeforeLoss) {
    cMo = captureAgain(frame, cMo);
    confirm(frame, cMo);
  }
  return cMo;
}

// After a loss a pose is looked for as at a start.
vpHomogeneousMatrix vpEdgeFollower::captureAgain(const vpFrameContext &frame, const vpHomogeneousMatrix &cMo)
{
  const double share = m_outcome.isLost() ? 0. : m_verdict.explained;
  const double reach = std::min(firstReach + reachPerFrame * m_situation.framesSinceLoss, mostReach);
  const vpHomogeneousMatrix captured = m_capture.find(frame, m_motion.trusted.cMo, reach);
  m_cues.edges().reset();
  const vpHomogeneousMatrix found = judged(m_edges.from(frame, captured, false));
  return m_verdict.explained < share ? judged(m_edges.from(frame, cMo, false)) : found;
}

// Without a search nothing else is compared with a pose that was found after a loss: some frames have to show it.
void vpEdgeFollower::confirm(const vpFrameContext &frame, const vpHomogeneousMatrix &cMo)
{
  ++m_situation.framesSinceLoss;
  if (!m_outcome.isTracking() || m_verdict.explained < confirmingShare) {
    m_situation.confirmations = 0;
  } else {
    vpEdgeCue &before = *m_edgesBeforeLoss;
    before.match(frame.image, m_looks.view());
    const bool isSame = m_knowledge.shareOfEvidence(before.evidence(cMo)) >= confirmingShare;
    m_situation.confirmations += isSame ? neededFrames : 1;
  }
  if (m_situation.confirmations >= neededFrames) {
    m_edgesBeforeLoss.reset();
    m_situation.confirmations = 0;
    m_situation.framesSinceLoss = 0;
  } else if (m_outcome.isTracking()) {
    m_outcome.set(vpTrackingState::UNCERTAIN, vpMbTrackingResult::Reason::CONFIRMING);
  }
}

void vpEdgeFollower::judgeByMap(const vpFrameContext &frame, const vpHomogeneousMatrix &cMo, bool isMapped)
{
  if (!isMapped && !m_score.hasWhole(frame)) {
    m_score.setRegion(frame, m_looks.regionAround(cMo));
  }
  m_verdict = m_judge.byMap(cMo);
  if (vpTrackingOutcome::stateOf(m_verdict.explained) != vpTrackingState::TRACKING && !m_score.hasWhole(frame)) {
    m_score.setFrame(frame); // The pose may be outside the region.
    m_verdict = m_judge.byMap(cMo);
  }
  m_outcome.judgeShare(m_verdict.explained);
}

vpHomogeneousMatrix vpEdgeFollower::compareHint(const vpFrameContext &frame, const vpHomogeneousMatrix &tracked)
{
  const bool isLost = m_outcome.isLost();
  const vpStartSearch &seen = m_starter.look(frame);
  const vpEdgeCue references = m_cues.edges();
  double best = (isLost ? 0. : seen(tracked).total) + vpHintedStarts::leastGain;
  std::optional<vpHomogeneousMatrix> taken;
  for (const vpHomogeneousMatrix &start : m_hints.take(frame)) {
    m_cues.edges().reset();
    const vpEstimate estimate = m_edges.from(frame, start, false);
    const double value = estimate.isFound ? seen(estimate.cMo).total : -HUGE_VAL;
    if (value > best) {
      best = value + vpHintedStarts::leastGain; // The hint itself comes first, and is likelier than those about it.
      taken = estimate.cMo;
    }
  }
  if (taken) {
    m_motion.forget();
  } else {
    m_cues.edges() = references;
  }
  const vpHomogeneousMatrix cMo = taken.value_or(tracked);
  if (!taken && isLost) {
    return cMo;
  }
  const vpHomogeneousMatrix refined = judged(m_edges.from(frame, cMo, false));
  if (m_edgesBeforeLoss) {
    confirm(frame, refined);
  }
  return refined;
}

END_VISP_NAMESPACE
