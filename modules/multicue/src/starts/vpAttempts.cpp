// SPDX-License-Identifier: GPL-2.0-or-later
#include "starts/vpAttempts.h"

#include <algorithm>

BEGIN_VISP_NAMESPACE

namespace {
// After a loss:
const double wellExplained = 0.8;     // Of what the trusted frames before had: from there on a pose is taken.
const double unknownAfterLoss = 0.25; // Weight of a surface that was never seen.
// Logarithms of odds:
const double changePenalty = 1.1;   // Of half a turn, or two diameters.
const double depthPenalty = 3.3;    // Of a distance that is e times what it was.
const std::size_t mostAttempts = 4; // From one search.
// Poses that look alike and are nearer than this to one another are the same one, diameters.
const double sameAlike = 0.05;
} // namespace

void vpAttempts::begin()
{
  m_attempted.clear();
  m_best = Attempt();
  m_last = vpEstimate();
  m_verdict = vpVerdict();
}

void vpAttempts::setBest(const Attempt &attempt)
{
  m_best = attempt;
  m_bestIsLast = false;
}

void vpAttempts::setOnly(const vpHomogeneousMatrix &cMo, double explained)
{
  m_best = Attempt();
  m_best.cMo = cMo;
  m_best.explained = explained;
  m_best.value = vpJudgedPose::oddsOf(explained);
}

bool vpAttempts::attempt(const vpFrameContext &frame, const vpStart &start)
{
  if (hasBest() && frame.deadline.putsOff(vpPutOff::STARTS)) {
    return false;
  }
  const vpTimedWork work(frame.deadline, vpPutOff::STARTS);
  vpStart likely = start;
  if (start.way == vpStart::BY_COLORS || start.way == vpStart::FINE) {
    likely.cMo = m_alike.nearest(start.cMo);
  }
  m_last = m_estimator.from(frame, likely);
  return take(m_last);
}

bool vpAttempts::attemptBest(const vpFrameContext &frame, vpPoseSearch &search, bool byColors)
{
  search.keepBest(mostAttempts, vpPoseSearch::same());
  bool isEnough = false;
  for (const vpPoseCandidate &candidate : search.candidates()) {
    isEnough = attempt(frame, {candidate.cMo, byColors ? vpStart::BY_COLORS : vpStart::FINE});
    if (isEnough) {
      break;
    }
  }
  return isEnough;
}

// Keeps the pose where it explains more than the best one before. \return True where that is enough.
bool vpAttempts::take(const vpEstimate &estimate)
{
  if (estimate.isFound) {
    m_verdict = m_judge.at(estimate.cMo);
    m_attempted.push_back(estimate.cMo);
  }
  const double share = estimate.isFound ? m_verdict.explained : -1.;
  const double odds = m_motion.oddsAt(estimate.cMo, m_looks.model());
  const double value = m_situation.mustConfirm ? valueAfterLoss(estimate, share) : vpJudgedPose::oddsOf(share) + odds;
  const Attempt attempt = {
      {share, value, odds < vpObjectMotion::farOdds}, estimate.cMo, m_verdict.share, estimate.usesPoints};
  m_bestIsLast = estimate.isFound && attempt.value > m_best.value;
  if (m_bestIsLast) {
    m_best = attempt;
  }
  if (m_situation.mustConfirm) {
    return m_best.explained >= wellExplained && m_bestIsLast && m_judge.isDecisive(m_verdict.agreement) &&
           !mustCompare(estimate.cMo);
  }
  return m_best.value >= vpJudgedPose::enoughOdds;
}

// What was never seen is no evidence for a pose. Half a turn of a symmetric object explains as much: the one nearer to
// the last trusted pose is likelier.
double vpAttempts::valueAfterLoss(const vpEstimate &estimate, double share)
{
  const vpAgreement &agreement = m_verdict.agreement;
  const vpHomogeneousMatrix &cMo = estimate.cMo;
  const double unknown =
      unknownAfterLoss * vpSurfaceTrust(m_knowledge.surface.texture()) * (1. - agreement.surfaceKnown);
  const double change = changePenalty * m_whereabouts.changeSince(cMo);
  const double value = vpJudgedPose::oddsOf((2. * share + unknown * vpUnknownCorrelation) / (2. + unknown)) +
                       agreement.surfaceOdds - m_judge.fewEdgesPenalty(agreement) -
                       depthPenalty * m_whereabouts.depthChange(cMo);
  if (!estimate.isFound) {
    return value - change;
  }
  vpContourEvidence contours;
  if (m_cues.uses(vpCueSet::EDGE)) {
    contours.set(m_cues.edges(), cMo);
  }
  return m_situation.tracks.add(cMo, share, value, change, m_alike.same(), contours);
}

// True where others have to be looked for before a pose that explains the image is confirmed.
bool vpAttempts::mustCompare(const vpHomogeneousMatrix &cMo)
{
  return m_situation.confirmations > 0 && !m_situation.tracks.wasCompared() &&
         m_score.insideShare(cMo) >= vpImageScore::insideToConfirm;
}

void vpAttempts::learnKeyframes()
{
  if (hasBest()) {
    const double share = m_knowledge.explainedBy(m_best.share, m_best.cMo);
    m_best.value += vpJudgedPose::oddsOf(share) - vpJudgedPose::oddsOf(m_best.explained);
    m_best.explained = share;
  }
}

vpEstimate vpAttempts::settle(const vpFrameContext &frame)
{
  if (!hasBest()) {
    return m_last;
  }
  if (!m_bestIsLast) {
    m_last = m_estimator.refine(frame, {m_best.cMo, vpStart::AS_VIEWED}, m_best.usesPoints);
    if (!m_last.isFound) {
      return m_last;
    }
    m_verdict = m_judge.at(m_last.cMo);
  }
  return nearestAlike(frame, m_last);
}

// After a loss the estimation may lead to another one of the poses that look alike than the nearest to the last.
vpEstimate vpAttempts::nearestAlike(const vpFrameContext &frame, const vpEstimate &estimate)
{
  if (!m_situation.mustConfirm) {
    return estimate;
  }
  const vpHomogeneousMatrix alike = m_alike.nearest(estimate.cMo);
  const double diameter = m_looks.model().diameter();
  if (vpModelSymmetries::distance(alike, estimate.cMo, m_looks.model().centre(), 0.5 * diameter) <
      sameAlike * diameter) {
    return estimate;
  }
  m_last = m_estimator.refine(frame, {alike, vpStart::AS_VIEWED}, estimate.usesPoints);
  m_verdict = m_judge.at(m_last.cMo);
  return m_last;
}

END_VISP_NAMESPACE
