// SPDX-License-Identifier: GPL-2.0-or-later
#include "engine/vpRoughStarter.h"

#include <algorithm>
#include <cmath>

BEGIN_VISP_NAMESPACE

namespace {
using Reason = vpMbTrackingResult::Reason;

const unsigned int refinements = 4;
// A further one has to gain as much.
const double leastGain = 1e-3;
// Of the control points that are found and of the model's colours, beside edges anywhere near: a model's colours agree
// with many poses about the right one, and control points with few.
const double foundWeight = 2.;
const double colorWeight = 0.25;
// Of what is needed in the end, for a first look.
const double firstShare = 0.8;
const double keptShare = 0.5; // For what is refused to count where it is found again.
const unsigned int placesAtStart = 12;
const unsigned int placesAfter = 6;
const unsigned int framesToConfirm = 3;
const unsigned int mostFrames = 6;
const double spreadPerFrame = 0.15;
// Squared, in units of what particles of one mode are apart; the object may move from image to image.
const double samePlace = 4.;

// All poses of one source count as much as those of another.
void append(const std::vector<vpWeightedPose> &poses, std::vector<vpWeightedPose> &all)
{
  double total = 0.;
  for (const vpWeightedPose &pose : poses) {
    total += pose.weight;
  }
  for (const vpWeightedPose &pose : poses) {
    all.push_back({pose.cMo, pose.weight / total});
  }
}
} // namespace

const vpStartSearch &vpRoughStarter::look(const vpFrameContext &frame)
{
  m_rough.search.setFrame(frame.image, m_score.sphere(), m_looks.preference(), m_looks.options.textureEdges);
  return m_rough.search;
}

double vpRoughStarter::edgeAgreement(const vpHomogeneousMatrix &cMo) const
{
  return m_cues.uses(vpCueSet::EDGE) ? *m_cues.edgePart().agreement(cMo, m_looks.camera()) : 0.;
}

// How well the image agrees with the pose that was estimated last; edges are seen in any light, colours are not.
double vpRoughStarter::valueOf(const vpHomogeneousMatrix &cMo) const
{
  const vpStartSearch::Value seen = m_rough.search(cMo);
  return seen.edges + foundWeight * edgeAgreement(cMo) + colorWeight * m_rough.search.trust() * seen.colors;
}

// With the colours that the image has where the object is taken to be.
vpEstimate vpRoughStarter::estimate(const vpFrameContext &frame, const vpHomogeneousMatrix &cMo)
{
  m_learning.forget();
  m_motion.expect(cMo);
  if (m_cues.isEdgesAlone()) {
    return m_edges.from(frame, cMo, false);
  }
  m_learning.learnStart(frame, cMo);
  return m_fused.from(frame, {cMo, m_cues.uses(vpCueSet::COLOR) ? vpStart::BY_COLORS : vpStart::AS_VIEWED});
}

vpRoughStarter::Refined vpRoughStarter::refine(const vpFrameContext &frame, const vpHomogeneousMatrix &cMo)
{
  Refined best{cMo};
  vpHomogeneousMatrix from = cMo;
  for (unsigned int i = 0; i < refinements; ++i) {
    const vpEstimate estimated = estimate(frame, from);
    from = estimated.cMo;
    const double value = estimated.isFound ? valueOf(from) : -HUGE_VAL;
    if (!(value > best.value + leastGain)) {
      break;
    }
    best = {from, value};
  }
  if (!(best.value > -HUGE_VAL)) {
    best.value = m_rough.search(best.cMo).total - 1.; // Any estimated pose is better.
  }
  return best;
}

// Those near the poses that were given, and those of all of the image where that was asked for.
std::vector<vpPoseCandidate> vpRoughStarter::candidates(const vpFrameContext &frame,
                                                        const std::vector<vpWeightedPose> &starts)
{
  const vpStartSearch &search = look(frame);
  std::vector<vpPoseCandidate> found;
  if (m_rough.anywhere) {
    m_rough.imageSearch.setFrame(frame.image, m_score.sphere(), m_looks.preference(), search);
    m_rough.imageSearch.setSymmetries(m_alike.symmetries());
    found = m_rough.imageSearch.find(*m_rough.anywhere, m_rough.tries);
  }
  if (!starts.empty()) {
    const vpPoseSearch::Spread spread = m_rough.spread.grown(1. + spreadPerFrame * m_rough.tries);
    const std::vector<vpPoseCandidate> near = search.find(starts, spread, m_rough.tries);
    found.insert(found.end(), near.begin(), near.end());
  }
  return found;
}

bool vpRoughStarter::search(const vpFrameContext &frame, vpHomogeneousMatrix &cMo)
{
  m_looks.setImage(frame.image);
  std::vector<vpWeightedPose> starts;
  append(m_rough.candidates, starts);
  append(m_rough.detected, starts);
  if (m_rough.tries > 0) {
    starts.push_back({cMo, 1.}); // Where the image before had it, or nearly so.
  }
  if (m_rough.hasHint) {
    starts.push_back({m_rough.hint, 1.});
    m_rough.hasHint = false;
  }
  Refined best{starts.empty() ? cMo : vpRoughStart::heaviest(starts)};
  for (const vpPoseCandidate &candidate : candidates(frame, starts)) {
    Refined refined = refine(frame, candidate.cMo);
    if (m_rough.anywhere) {
      refined.value = m_rough.imageSearch.standing(refined.cMo);
    }
    if (refined.value > best.value) {
      best = refined;
    }
  }
  cMo = best.cMo;
  ++m_rough.tries;
  return take(frame, cMo);
}

// Learns what the image shows at the pose, and accepts or refuses it.
bool vpRoughStarter::take(const vpFrameContext &frame, const vpHomogeneousMatrix &cMo)
{
  m_learning.forget();
  m_learning.trust(cMo);
  m_motion.expect(cMo);
  m_learning.learnStart(frame, cMo);
  if (m_cues.isEdgesAlone()) {
    m_edges.match(frame, cMo);
  } else {
    m_fused.refine(frame, {cMo, vpStart::AS_VIEWED}, true); // So that all cues are matched.
  }
  vpStartEvidence &evidence = m_rough.evidence;
  const vpHomogeneousMatrix cMb = cMo * m_looks.centreFrame();
  if (evidence.isEnough(keptShare) && m_alike.distance(cMb, m_rough.refused) < samePlace) {
    evidence.noteFoundAgain();
  } else {
    evidence.clear();
    evidence.setTries(m_rough.tries);
  }
  m_rough.refused = cMb;
  addEvidence(cMo, placesAtStart);
  std::string missing = evidence.text(firstShare);
  if (missing.empty() && m_rough.anywhere) {
    missing = m_rough.imageSearch.missing(cMo);
  }
  const bool isAccepted = missing.empty();
  m_rough.phase = isAccepted ? vpRoughStart::UNCONFIRMED : vpRoughStart::REFUSED;
  if (isAccepted) {
    m_outcome.set(vpTrackingState::UNCERTAIN, Reason::CONFIRMING);
    m_outcome.text = std::string(m_rough.anywhere ? "the object was found in the image"
                                                  : "a pose was found near to the one that was given") +
                     ", and has to explain more images";
  } else {
    m_outcome.set(vpTrackingState::LOST, Reason::CONTRADICTED);
    m_outcome.text = "no pose was accepted: at the best one, " + missing;
  }
  return isAccepted;
}

// What speaks for the pose that was estimated last, in the image that the search has.
void vpRoughStarter::addEvidence(const vpHomogeneousMatrix &cMo, unsigned int places)
{
  vpStartEvidence::Support support;
  support.hasEdges = m_cues.uses(vpCueSet::EDGE);
  support.edges = edgeAgreement(cMo);
  support.hasColors = m_cues.hasCoarseColors();
  support.colors = support.hasColors ? m_cues.color().evidenceAt(cMo) : 0.;
  const std::uint64_t seed = m_rough.tries + (static_cast<std::uint64_t>(m_rough.evidence.frames()) << 32U);
  const vpPoseSearch::Spread spread = m_rough.spread.grown(1. + spreadPerFrame * (m_rough.tries - 1U));
  m_rough.evidence.add(m_rough.search(cMo), m_rough.search.clutter(cMo, spread, seed, places), support,
                       m_rough.search.trust());
}

bool vpRoughStarter::resume(const vpFrameContext &frame, bool searches, vpHomogeneousMatrix &cMo)
{
  if (m_rough.phase != vpRoughStart::REFUSED) {
    return true;
  }
  if (searches || m_rough.hasHint) {
    search(frame, cMo);
  }
  m_rough.hasHint = m_rough.hasHint && m_rough.phase == vpRoughStart::UNCONFIRMED;
  m_outcome.isJudged = true;
  return m_rough.phase == vpRoughStart::UNCONFIRMED;
}

void vpRoughStarter::confirm(const vpFrameContext &frame, const vpHomogeneousMatrix &cMo)
{
  if (m_rough.phase != vpRoughStart::UNCONFIRMED) {
    return;
  }
  if (!m_outcome.isLost()) {
    look(frame);
    addEvidence(cMo, placesAfter);
    const std::string missing = m_rough.evidence.text(1.);
    if (m_rough.evidence.frames() > framesToConfirm && missing.empty()) {
      m_rough.clear();
      return;
    }
    if (m_rough.evidence.frames() <= mostFrames && m_rough.evidence.isEnough(firstShare)) {
      m_outcome.set(vpTrackingState::UNCERTAIN, Reason::CONFIRMING);
      return;
    }
    m_outcome.reason = Reason::CONTRADICTED;
    m_outcome.text = "the pose that was accepted at the start is not confirmed: " + missing;
  }
  m_outcome.state = vpTrackingState::LOST;
  m_rough.phase = vpRoughStart::REFUSED;
}

END_VISP_NAMESPACE
