// SPDX-License-Identifier: GPL-2.0-or-later
#include "judge/vpPoseJudge.h"

#include <algorithm>
#include <cmath>

BEGIN_VISP_NAMESPACE

namespace {
// Points on the surface count this much beside the other cues once this many of them are followed, from this number on;
// and what they have at a right pose, and count at most.
const double besideOthers = 0.6;
const std::size_t enoughPoints = 24;
const std::size_t fewestPoints = 8;
const double usualOfPoints = 0.9;
const double mostOfPoints = 1.2;
// How much colours and surface count beside the edges: they were learnt from other sides and in other light, so now and
// then they speak for wrong poses, most after a loss; edges hardly do. After a loss those that hardly varied count
// fully, since what does not have them is something else. What any pose has of the usual agreement with edges is
// chance.
const double besideEdges = 0.4;
const double aboveEdges = 0.05; // That all cues together may have more of the usual than the edges.
const double leastBesideEdges = 0.25;
const double fixedVariance = 0.1 * 0.1;
const double edgesByChance = 0.25;
// The same of the distance map.
const double mapByChance = 0.3;
// Of a pose with exp(-1) times the usual number of edges, and the most of them that counts.
// Logarithms of odds.
const double fewPenalty = 2.2;
const double mostFewPenalty = 4.4;
// Penalty of a pose with so few edges that others are looked for.
const double fewEdges = 2.2;
// Of the usual surface: from there on no other pose looks like it, and below that it shows something else.
const double decisiveSurface = 0.8;
const double contradictingSurface = 0.35;
// Of colours and surface together, how far they were steady, and what they have of the usual.
const double leastSteadiness = 0.6;
const double disowningShare = 0.25;

// Of what is usual, less what any pose has of it.
double beyondChance(double share, double byChance)
{
  return std::max(share - byChance, 0.) / (1. - byChance);
}

void add(double share, double weight, vpCueShare &sum)
{
  sum.sum += weight * share;
  sum.cues += weight;
}
} // namespace

void vpPoseJudge::lookAtEdges(const vpHomogeneousMatrix &cMo, vpAgreement &agreement) const
{
  agreement.cues[vpCueSet::EDGE] = *m_cues.edgePart().agreement(cMo, m_looks.camera());
  agreement.edgeCount = static_cast<double>(m_cues.edges().matches().size());
}

// How well the distance map agrees with the pose, as a share of what it had in trusted frames. Beside the matches,
// which clutter has for nearly every pose, it tells wrong poses: on rendered sequences with edges alone, right ones had
// 0.8 to 1.1 of it in 96 % of the frames, and wrong ones less than 0.8 in half of theirs.
double vpPoseJudge::mapShare(const vpHomogeneousMatrix &cMo, vpAgreement &agreement) const
{
  const vpPoseScore::Value value = m_score(cMo);
  agreement.mapDistance = value.isSeen ? value.distance : 1.;
  const double share = vpObjectKnowledge::countedShare(1. - agreement.mapDistance, 1. - m_knowledge.usual.mapDistance);
  return beyondChance(share, mapByChance);
}

// How much colours or surface count whose agreement has this variance.
double vpPoseJudge::weightBesideEdges(double variance) const
{
  if (!m_situation.mustConfirm) {
    return besideEdges * vpObjectKnowledge::reliability(variance);
  }
  const double fixed = fixedVariance / (fixedVariance + variance);
  return (leastBesideEdges + (1. - leastBesideEdges) * fixed * fixed) * vpObjectKnowledge::reliability(variance);
}

// While the object is followed: all other cues were learnt at its poses, and agree with one that slid off unnoticed.
double vpPoseJudge::mostBesideEdges(const vpAgreement &agreement) const
{
  const double usual = m_knowledge.usual.cues[vpCueSet::EDGE];
  const bool tells = m_cues.uses(vpCueSet::EDGE) && usual > vpObjectKnowledge::leastUsual;
  return tells && !m_situation.mustConfirm ? agreement.cues[vpCueSet::EDGE] / usual + aboveEdges : HUGE_VAL;
}

void vpPoseJudge::addEdges(const vpHomogeneousMatrix &cMo, vpVerdict &verdict) const
{
  lookAtEdges(cMo, verdict.agreement);
  const double share =
      vpObjectKnowledge::countedShare(verdict.agreement.cues[vpCueSet::EDGE], m_knowledge.usual.cues[vpCueSet::EDGE]);
  const double matched = beyondChance(share, edgesByChance);
  add(m_cues.isEdgesAlone() ? 0.5 * (matched + mapShare(cMo, verdict.agreement)) : matched,
      vpObjectKnowledge::reliability(m_knowledge.unsteadiness.cues[vpCueSet::EDGE]), verdict.share);
}

void vpPoseJudge::addCuesBesideEdges(const vpHomogeneousMatrix &cMo, vpVerdict &verdict) const
{
  for (const vpCueSet::Used &used : m_cues.used()) {
    if (used.kind->vote != vpCueVote::BESIDE_EDGES) {
      continue;
    }
    const std::optional<double> agreement = used.cue->agreement(cMo, m_looks.camera());
    if (agreement) {
      const int type = used.kind->type;
      verdict.agreement.cues[type] = *agreement;
      add(vpObjectKnowledge::countedShare(std::max(*agreement, 0.), m_knowledge.usual.cues[type]),
          weightBesideEdges(m_knowledge.unsteadiness.cues[type]), verdict.share);
    }
  }
}

void vpPoseJudge::addSurface(const vpHomogeneousMatrix &cMo, vpVerdict &verdict) const
{
  vpAgreement &agreement = verdict.agreement;
  const vpSurfaceMemory::Agreement seen = m_knowledge.surface.agreement(cMo);
  agreement.surface = seen.correlation;
  agreement.surfaceKnown = seen.known;
  agreement.surfaceWeight = vpObjectKnowledge::weightOf(seen);
  const double usual = m_knowledge.usual.surface;
  if (!(usual > 0.)) {
    return;
  }
  if (m_situation.mustConfirm) {
    const double variance = m_knowledge.surfaceVariance(m_knowledge.turnSince(cMo, m_motion));
    agreement.surfaceOdds = m_knowledge.surfaceOdds(seen, variance);
    agreement.isRefuted = m_knowledge.isRefutedBy(seen, variance);
  }
  add(vpObjectKnowledge::countedShare(std::max(seen.correlation, 0.), usual),
      agreement.surfaceWeight * weightBesideEdges(m_knowledge.unsteadiness.surface), verdict.share);
}

// While the object is followed: points that agreed with trusted poses do not slide along an edge, as other cues may do.
// Their share is that of those which were found again, for what hides the object, or turns away, is not their fault.
// After a loss they count only where there is nothing else: those of what hid the object agree with a wrong pose.
void vpPoseJudge::addPoints(const vpHomogeneousMatrix &cMo, vpVerdict &verdict) const
{
  vpTrackedPoints &points = m_cues.pointPart();
  if (!(verdict.share.cues > 0.)) {
    double &agreement = verdict.agreement.cues[vpCueSet::POINT];
    agreement = *points.agreement(cMo, m_looks.camera());
    add(vpObjectKnowledge::countedShare(agreement, m_knowledge.usual.cues[vpCueSet::POINT]), 1., verdict.share);
    return;
  }
  if (m_situation.mustConfirm) {
    return;
  }
  const vpTrackedPoints::Agreeing agreeing = points.agreeing(cMo, m_looks.camera());
  if (agreeing.found <= fewestPoints) {
    return;
  }
  const double share = agreeing.sum / (usualOfPoints * static_cast<double>(agreeing.found));
  const double number =
      static_cast<double>(agreeing.found - fewestPoints) / static_cast<double>(enoughPoints - fewestPoints);
  add(std::min(share, mostOfPoints), besideOthers * std::min(number, 1.), verdict.share);
}

vpVerdict vpPoseJudge::at(const vpHomogeneousMatrix &cMo) const
{
  vpVerdict verdict;
  if (m_cues.uses(vpCueSet::EDGE)) {
    addEdges(cMo, verdict);
  }
  addCuesBesideEdges(cMo, verdict);
  addSurface(cMo, verdict);
  if (m_cues.uses(vpCueSet::POINT)) {
    addPoints(cMo, verdict);
  }
  verdict.share.most = mostBesideEdges(verdict.agreement);
  verdict.explained = m_knowledge.explainedBy(verdict.share, cMo);
  return verdict;
}

vpVerdict vpPoseJudge::byEvidence(const vpHomogeneousMatrix &cMo) const
{
  vpVerdict verdict;
  lookAtEdges(cMo, verdict.agreement);
  verdict.agreement.evidence = m_cues.edges().evidence(cMo);
  verdict.explained = m_knowledge.shareOfEvidence(verdict.agreement.evidence);
  return verdict;
}

vpVerdict vpPoseJudge::byMap(const vpHomogeneousMatrix &cMo) const
{
  vpVerdict verdict;
  lookAtEdges(cMo, verdict.agreement); // For what is usual of the matches.
  verdict.explained = mapShare(cMo, verdict.agreement);
  return verdict;
}

vpAgreement vpPoseJudge::agreementAtStart(const vpHomogeneousMatrix &cMo, bool looksAtMap) const
{
  vpAgreement agreement;
  if (m_cues.uses(vpCueSet::EDGE)) {
    lookAtEdges(cMo, agreement);
    agreement.evidence = m_cues.edges().evidence(cMo);
  }
  if (looksAtMap) {
    mapShare(cMo, agreement);
  }
  for (const vpCueSet::Used &used : m_cues.used()) {
    if (used.kind->vote == vpCueVote::BESIDE_EDGES) {
      agreement.cues[used.kind->type] = used.cue->agreement(cMo, m_looks.camera()).value_or(0.);
    }
  }
  return agreement;
}

// Seen from its edge, an object lies on many a line of the image.
double vpPoseJudge::fewEdgesPenalty(const vpAgreement &agreement) const
{
  if (!(m_knowledge.usual.edgeCount > 0.)) {
    return 0.;
  }
  const double few = std::log(m_knowledge.usual.edgeCount / (agreement.edgeCount + 1.));
  return std::min(std::max(fewPenalty * few, 0.), mostFewPenalty);
}

bool vpPoseJudge::isContradicted(const vpAgreement &agreement) const
{
  return agreement.surfaceWeight > vpObjectKnowledge::leastTexture &&
         agreement.surface < contradictingSurface * m_knowledge.usual.surface;
}

// Colours and surface, where they were steady, have hardly anything at the pose of what they had.
bool vpPoseJudge::isDisowned(const vpAgreement &agreement) const
{
  const vpAgreement &usual = m_knowledge.usual;
  const vpAgreement &unsteadiness = m_knowledge.unsteadiness;
  double seen = 0.;
  double steadiness = 0.;
  const auto see = [&](double value, double usualValue, double variance, double share) {
    if (usualValue > 0.) {
      const double weight = vpObjectKnowledge::reliability(variance);
      steadiness += weight;
      seen += weight * share * std::max(vpObjectKnowledge::countedShare(value, usualValue), 0.);
    }
  };
  for (const vpCueSet::Used &used : m_cues.used()) {
    if (used.kind->vote == vpCueVote::BESIDE_EDGES) {
      const int type = used.kind->type;
      see(agreement.cues[type], usual.cues[type], unsteadiness.cues[type], 1.);
    }
  }
  see(agreement.surface, usual.surface, unsteadiness.surface, agreement.surfaceWeight);
  return steadiness > leastSteadiness && seen < disowningShare * steadiness;
}

bool vpPoseJudge::isDecisive(const vpAgreement &agreement) const
{
  if (m_cues.isEdgesAlone()) { // There are many edges that no object of this shape has.
    return false;
  }
  if (m_knowledge.surface.texture() < vpObjectKnowledge::leastTexture) {
    return m_situation.confirmations > 0;
  }
  return fewEdgesPenalty(agreement) < fewEdges && agreement.surfaceWeight > vpObjectKnowledge::leastTexture &&
         agreement.surface > decisiveSurface * m_knowledge.usual.surface;
}

END_VISP_NAMESPACE
