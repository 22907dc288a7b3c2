// SPDX-License-Identifier: GPL-2.0-or-later
#include "judge/vpLossWatch.h"

#include "judge/vpRecallPlan.h"
#include "motion/vpEvenMotion.h"

#include <algorithm>

BEGIN_VISP_NAMESPACE

namespace {
using Reason = vpMbTrackingResult::Reason;

// An object that left the image for so many frames on end may come back anywhere; one that the image does not explain
// is followed for longer, since light and what is in front of it change more often than it jumps. Where a pose far
// off is all that explains it, the object is lost at once.
const unsigned int mostOutside = 3;
const unsigned int mostDoubtful = 30;
const unsigned int mostDoubtfulByEdges = 3; // Edges alone lead from one wrong pose to the next.
const double leastInside = 0.3;             // Share of the outline that is in the image.
const double insideToCompare = 0.7;         // What is seen of less looks like many poses.
// TRACKING is said from the one on, and as long as the other is not fallen short of.
const double trustedBelief = 0.85;
const double keptBelief = 0.7;
// A pose that is believed less than this for so many frames on end is lost: others farther off are looked for while the
// object is still near.
const double leastBelief = 0.6;
const unsigned int mostDisbelieved = 2;
// What a pose explains more than others, for a lead in the logarithm of odds; and the most of it that counts.
const double shareOfLead = 1. / 22.;
const double mostLead = 0.25;
const double rightOfTwin = 0.5; // Probability of one that has won.
const double mostSudden = 5.5;  // Frames from one that explained a right pose well to a loss that came at once.
// An object that was trusted in fewer frames until it was lost again was something else, perhaps.
const unsigned int fewTrusted = 10;
} // namespace

void vpLossWatch::beginAfterLoss(const vpHomogeneousMatrix &cMo)
{
  recallLearnt();
  beginTracks(cMo);
}

// The last frame's results are of what was learnt then.
void vpLossWatch::recallLearnt()
{
  ++m_situation.framesSinceLoss;
  const bool isFirst = m_situation.framesSinceLoss == 1;
  const std::optional<unsigned int> level =
      vpRecallPlan::level(m_situation.framesSinceLoss, m_situation.confirmations > 0);
  const bool isUnproven = isFirst && m_proof.isOpen();
  if (isUnproven) {
    m_knowledge.forgetPeriod();
  }
  const std::shared_ptr<const vpObjectKnowledge::Learnt> *recalled = level ? m_knowledge.past.recall(*level) : nullptr;
  if (recalled == nullptr && isUnproven) {
    recalled = &m_proof.known();
  }
  if (recalled == nullptr) {
    return;
  }
  m_knowledge.recall(**recalled, m_cues);
  m_motion.trustedBefore = (*recalled)->trusted;
  if (*level > 0 || (m_situation.wasFound && m_situation.trustedFrames < fewTrusted)) {
    m_knowledge.keyframes.reset();
  }
  m_situation.searched.clear();
}

// The first attempts of a frame go on from where the last one left.
void vpLossWatch::beginTracks(const vpHomogeneousMatrix &cMo)
{
  vpPoseTracks &tracks = m_situation.tracks;
  if (m_outcome.isLost()) {
    tracks.clear();
    return;
  }
  if (tracks.empty()) {
    const vpHomogeneousMatrix before =
        m_motion.mayCoast()
            ? vpEvenMotion(cMo, m_motion.kalman.velocity(), m_looks.model().centre(), -m_motion.frameInterval)
            : cMo;
    tracks.begin(cMo, before, m_situation.belief);
  }
  tracks.follow(0);
}

void vpLossWatch::decide(const Found &found, bool searches)
{
  chooseTrack(found);
  if (searches) {
    confirm(found);
  }
  believe(found, searches);
  endTracks(found.cMo);
}

// What was believed of the best pose of this frame, which may not be the one that was followed.
void vpLossWatch::chooseTrack(const Found &found)
{
  vpPoseTracks &tracks = m_situation.tracks;
  if (!m_situation.mustConfirm || found.best.explained < 0.) {
    tracks.clear();
    return;
  }
  const double inside = m_score.insideShare(found.bestPose);
  const auto seen = inside >= insideToCompare                 ? vpPoseTracks::Seen::WELL
                    : inside >= vpImageScore::insideToConfirm ? vpPoseTracks::Seen::ENOUGH
                                                              : vpPoseTracks::Seen::LITTLE;
  tracks.choose(found.bestPose, seen, m_alike.same());
  const vpPoseTracks::Track &chosen = tracks.chosen();
  m_situation.belief = chosen.belief;
  m_situation.confirmations = chosen.confirmations;
  m_motion.expect(chosen.before);
}

// The next frame goes on from the pose that this one ended with.
void vpLossWatch::endTracks(const vpHomogeneousMatrix &cMo)
{
  vpPoseTracks &tracks = m_situation.tracks;
  if (!m_situation.mustConfirm || m_outcome.isLost()) {
    tracks.clear();
    return;
  }
  if (!tracks.empty()) {
    tracks.chosen().cMo = cMo;
    tracks.chosen().belief = m_situation.belief;
    tracks.chosen().confirmations = m_situation.confirmations;
  }
}

// A pose is not trusted while hardly any of the object is in the image, nor after a loss before the next frames confirm
// it.
void vpLossWatch::confirm(const Found &found)
{
  const vpTrackingState before = m_outcome.state;
  confirmState(found);
  if (m_outcome.state != before) {
    m_outcome.reason = m_outcome.isLost() ? Reason::CONTRADICTED : Reason::CONFIRMING;
  }
}

void vpLossWatch::confirmState(const Found &found)
{
  vpSituation &now = m_situation;
  // After a loss, what explains the image no better than by chance, given where it is, is no pose to go on from.
  if (now.mustConfirm && found.best.value < vpJudgedPose::oddsOf(vpJudgedPose::leastExplained)) {
    m_outcome.state = vpTrackingState::LOST;
  }
  if (m_outcome.isLost()) {
    now.confirmations = 0;
    noteLoss();
    return;
  }
  if (!now.mustConfirm && m_proof.disproves(found.cMo, m_knowledge)) {
    now.confirmations = 0;
    noteLoss();
    m_outcome.state = vpTrackingState::LOST;
    return;
  }
  const double inside = m_score.insideShare(found.cMo);
  const unsigned int mostDoubt = comparesAttempts() ? mostDoubtful : mostDoubtfulByEdges;
  const bool isExplained = m_outcome.isTracking();
  now.outsideFrames = inside < leastInside ? now.outsideFrames + 1 : 0;
  now.doubtfulFrames = isExplained ? 0 : now.doubtfulFrames + 1;
  if (now.outsideFrames >= mostOutside || now.doubtfulFrames >= mostDoubt ||
      (found.best.isFar && found.best.value < 0.)) {
    noteLoss();
  }
  if (inside < leastInside) {
    m_outcome.state = vpTrackingState::UNCERTAIN;
  }
  if (!now.mustConfirm) {
    return;
  }
  const bool confirms =
      isExplained && inside >= vpImageScore::insideToConfirm && found.best.explained >= vpPoseTracks::confirming;
  now.confirmations = confirms ? now.confirmations + 1 : 0;
  if (m_confirmation.isDue(found.cMo, found.agreement, inside)) {
    noteFound(found.cMo);
  } else {
    m_outcome.state = vpTrackingState::UNCERTAIN;
  }
}

// How the pose came about, and what it explained in the frames before, count beside this image.
void vpLossWatch::believe(const Found &found, bool searches)
{
  vpPoseBelief &belief = m_situation.belief;
  if (m_outcome.isLost()) {
    belief.lose();
    return;
  }
  const double surprise = m_motion.surpriseAt(found.cMo, m_looks.model());
  if (m_situation.mustConfirm) {
    belief.doubt();
    const double lead = std::min(std::max(shareOfLead * m_situation.tracks.lead(), 0.), mostLead);
    belief.update(surprise, found.best.explained + lead);
  } else {
    belief.updateFollowed(surprise, found.best.explained, found.best.value);
  }
  m_situation.disbelievedFrames = belief.probability() < leastBelief ? m_situation.disbelievedFrames + 1 : 0;
  if (searches && m_situation.disbelievedFrames >= mostDisbelieved) {
    noteLoss();
  }
  const double needed = m_situation.wasTracking && !found.best.isFar ? keptBelief : trustedBelief;
  const bool isBelieved = !searches || believed() >= needed;
  if (m_outcome.isTracking() && !isBelieved) {
    m_outcome.set(vpTrackingState::UNCERTAIN, Reason::CONFIRMING);
  }
}

void vpLossWatch::noteLoss()
{
  if (m_situation.mustConfirm) {
    return;
  }
  m_situation.mustConfirm = true;
  m_situation.framesSinceLoss = 0;
  m_situation.wasSudden = m_motion.time - m_knowledge.lastExplained < mostSudden * m_motion.frameInterval;
  m_twins.end();
  m_motion.expectJumps();
  m_motion.trustedBefore.reset();
}

void vpLossWatch::noteFound(const vpHomogeneousMatrix &cMo)
{
  m_situation.mustConfirm = false;
  m_situation.wasFound = true;
  m_situation.trustedFrames = 0;
  m_situation.doubtfulFrames = 0;
  m_situation.disbelievedFrames = 0;
  m_situation.searched.clear();
  if (m_motion.trustedBefore) {
    m_knowledge.past.settle();
  }
  const vpObjectMotion::Trusted &from = m_motion.trustedBefore ? *m_motion.trustedBefore : m_motion.trusted;
  startProof(std::make_shared<const vpObjectKnowledge::Learnt>(m_knowledge.now(m_cues, from)));
  m_twins.end();
  if (m_cues.uses(vpCueSet::EDGE) && !m_cues.isEdgesAlone()) {
    m_twins.start(cMo, m_halfTurns);
  }
  m_motion.forget();
}

void vpLossWatch::startProof(const std::shared_ptr<const vpObjectKnowledge::Learnt> &known)
{
  m_proof.start(known, m_knowledge.hasTexture());
  m_knowledge.beginPeriod();
}

void vpLossWatch::startOver(const vpHomogeneousMatrix &cMo)
{
  const std::shared_ptr<const vpObjectKnowledge::Learnt> known = m_proof.known();
  m_knowledge.forgetPeriod();
  m_knowledge.recall(*known, m_cues);
  m_knowledge.keyframes.reset();
  for (const vpCueSet::Used &used : m_cues.used()) {
    used.cue->noteLoss(true);
  }
  m_motion.forget();
  m_motion.expectJumps();
  m_motion.expect(cMo);
  m_motion.trusted.cMo = cMo;
  m_motion.trusted.velocity.setZero();
  m_situation.belief.start(rightOfTwin);
  m_situation.trustedFrames = 0;
  startProof(known);
  m_twins.start(cMo, m_halfTurns);
}

END_VISP_NAMESPACE
