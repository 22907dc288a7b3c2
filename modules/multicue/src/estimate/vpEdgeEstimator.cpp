// SPDX-License-Identifier: GPL-2.0-or-later
#include "estimate/vpEdgeEstimator.h"

#include "frame/vpStopwatch.h"
#include "hypotheses/vpControlPointMotion.h"
#include "hypotheses/vpMotionFrame.h"
#include "motion/vpPoseCheck.h"

#include <algorithm>
#include <utility>

BEGIN_VISP_NAMESPACE

namespace {
// A match serves poses that move its control points by less than this: then normals and neighbourhoods are the same.
const double rematchMotion = 1.5; // Pixels.
const unsigned int maxMatches = 3;
// A pose that moved its control points by more than this many search ranges in one match has diverged.
const double maxMotion = 2.;
// With a residue below this the image is explained; a tenth of the control points may be without support.
const double explained = 0.8; // Pixels.
// Objects with edges that the image hardly shows never get there: a pose may leave this much more than the ones before.
const double usualFactor = 1.15;
const double usualRate = 0.2;
// Hypotheses with less weight than this are not looked at again, nor more of them than these.
const double leastWeight = 0.02;
const std::size_t maxFinalists = 3;
// Matches for a pose that a longer reach led to.
const unsigned int maxRefinements = 2;
} // namespace

void vpEdgeEstimator::setSettings(const vpPoseHypothesisSettings &settings)
{
  m_hypotheses.setSettings(settings);
  m_other.setSettings(settings);
  if (!settings.enabled) {
    m_hypotheses.clear();
  }
}

void vpEdgeEstimator::forgetImages()
{
  m_hypotheses.clear();
  m_other.clear();
  m_usualResidue = 0.;
  m_minimisations = 0;
}

double vpEdgeEstimator::explainedResidue() const
{
  return std::max(explained, usualFactor * m_usualResidue);
}

void vpEdgeEstimator::learnResidue()
{
  const double residue = bestResidue();
  if (std::isfinite(residue)) {
    m_usualResidue += m_usualResidue > 0. ? usualRate * (residue - m_usualResidue) : residue;
  }
}

// Of those of a frame; each search has at least one.
unsigned int vpEdgeEstimator::minimisationsLeft() const
{
  const unsigned int most = m_hypotheses.settings().minimisations;
  return most > m_minimisations ? most - m_minimisations : 1U;
}

vpPoseMatrix6 vpEdgeEstimator::freeMotions() const
{
  const vpPoseMatrix6 chosen = vpMotionFrame::toEigen(m_minimiser.chosenMotions());
  // Edges of the texture show such turns, too.
  const bool edgesShowTurns =
      m_symmetries.printShowsTurns() && m_looks.options.textureEdges && !m_looks.view().textureEdges().empty();
  return !m_symmetries.hasAxis() || edgesShowTurns ? chosen : vpPoseMatrix6(m_symmetries.visibleMotions() * chosen);
}

void vpEdgeEstimator::restrictMotions()
{
  const Eigen::Matrix<double, 6, 6, Eigen::RowMajor> both = freeMotions();
  m_motions.resize(6, 6, false, false);
  std::copy(both.data(), both.data() + 36, m_motions.data);
  m_hypotheses.setEstimatedMotions(m_motions);
}

void vpEdgeEstimator::matchView(const vpFrameContext &frame)
{
  const vpStopwatch stage(frame.timings.match);
  m_cues.edges().match(frame.image, m_looks.view());
}

void vpEdgeEstimator::match(const vpFrameContext &frame, const vpHomogeneousMatrix &cMo)
{
  m_looks.compute(frame, cMo);
  matchView(frame);
}

void vpEdgeEstimator::matchNear(const vpFrameContext &frame, const vpHomogeneousMatrix &cMo)
{
  m_looks.computeNear(frame, cMo);
  matchView(frame);
}

bool vpEdgeEstimator::serves(const vpFrameContext &frame, const vpHomogeneousMatrix &cMo) const
{
  return vpControlPointMotion::mean(m_looks.view(), cMo, frame.image.camera()) < rematchMotion;
}

vpEstimate vpEdgeEstimator::estimate(const vpFrameContext &frame, const vpHomogeneousMatrix &cMo)
{
  if (!m_hypotheses.settings().enabled) {
    return from(frame, cMo, false);
  }
  const Proposal proposed = proposal(frame, cMo);
  return from(frame, proposed.cMo, proposed.isMatched);
}

vpEstimate vpEdgeEstimator::from(const vpFrameContext &frame, const vpHomogeneousMatrix &cMo, bool isMatched)
{
  vpEstimate result{cMo, false, false};
  const double limit = maxMotion * m_cues.edges().settings().range;
  for (unsigned int i = 0; i < maxMatches; ++i) {
    if (!isMatched) {
      match(frame, result.cMo);
    }
    isMatched = false;
    if (!m_minimiser.minimise(frame, {vpCueSet::EDGE, nullptr}, m_cues, m_symmetries, m_looks.model().diameter(),
                              result.cMo) ||
        !vpPoseCheck::isFinite(result.cMo)) {
      return result;
    }
    const double motion = vpControlPointMotion::mean(m_looks.view(), result.cMo, frame.image.camera());
    if (motion > limit) {
      return result;
    }
    if (motion < rematchMotion) {
      break;
    }
  }
  result.isFound = true;
  return result;
}

vpHomogeneousMatrix vpEdgeEstimator::propose(const vpFrameContext &frame, const vpHomogeneousMatrix &cMo)
{
  return proposal(frame, cMo).cMo;
}

// From the pose before; and where that leaves the image unexplained, with a longer reach, for there the object may have
// moved by more than the range.
vpEdgeEstimator::Proposal vpEdgeEstimator::proposal(const vpFrameContext &frame, const vpHomogeneousMatrix &cMo)
{
  const vpPoseHypothesisSettings &settings = m_hypotheses.settings();
  const bool mayReach = settings.reach > 1.;
  restrictMotions();
  match(frame, cMo);
  // Several poses that explain the image have to be compared. Where the likeliest one does not, the next ones of the
  // same match seldom do, and what they cost is better spent on a longer reach.
  const unsigned int limit = mayReach ? std::min((settings.minimisations + 1) / 2, minimisationsLeft()) : 0;
  const double decisive = mayReach ? explainedResidue() : HUGE_VAL;
  const Proposal near = findPoses(frame, cMo, limit, decisive) ? best(frame) : Proposal{cMo, true};
  return !mayReach || explains(bestResidue()) ? near : reachFarther(frame, cMo, near.cMo);
}

bool vpEdgeEstimator::findPoses(const vpFrameContext &frame, const vpHomogeneousMatrix &cMo, unsigned int limit,
                                double decisive)
{
  const vpStopwatch stage(frame.timings.pose);
  m_hypotheses.find(m_cues.edges(), m_looks.view(), cMo, frame.streams.searches++, limit, decisive);
  m_minimisations += m_hypotheses.minimisations();
  return !found().empty();
}

// The better one of the pose that the search at the usual range led to, and of what a longer one finds.
vpEdgeEstimator::Proposal vpEdgeEstimator::reachFarther(const vpFrameContext &frame, const vpHomogeneousMatrix &start,
                                                        const vpHomogeneousMatrix &near)
{
  const double residue = bestResidue();
  std::swap(m_hypotheses, m_other);
  restrictMotions();
  // Residues are compared at the usual range: with a longer one there is a candidate near to everything.
  if (searchFarther(frame, start)) {
    const bool isMatched = refine(frame, 0, maxRefinements);
    if (bestResidue() < residue) {
      return {found().front().cMo, isMatched};
    }
  }
  std::swap(m_hypotheses, m_other);
  return {near, false};
}

// One pose after the other, each from a match at the one before. \return False where the last match allows none.
bool vpEdgeEstimator::searchFarther(const vpFrameContext &frame, const vpHomogeneousMatrix &start)
{
  const double reach = m_hypotheses.settings().reach;
  vpEdgeCueSettings farther = m_cues.edges().settings();
  farther.range = std::min(reach * farther.range, vpEdgeCueSettings::maxRange);
  // A longer line meets more that is not the edge: only what is most like it.
  farther.candidates = std::max(static_cast<unsigned int>(farther.candidates / reach), 1U);
  const vpOtherEdgeSettings asFar(m_cues.edges(), farther);
  vpHomogeneousMatrix cMo = start;
  bool isFound = false;
  bool hasMoved = true;
  for (unsigned int left = minimisationsLeft(); hasMoved && left > 0; --left) {
    match(frame, cMo);
    isFound = findPoses(frame, cMo, 1, HUGE_VAL);
    const vpHomogeneousMatrix before = cMo;
    cMo = isFound ? found().front().cMo : cMo;
    hasMoved = vpControlPointMotion::between(m_looks.view(), before, cMo, frame.image.camera()) >= rematchMotion;
  }
  return isFound;
}

bool vpEdgeEstimator::refine(const vpFrameContext &frame, std::size_t index, unsigned int most)
{
  const vpHomogeneousMatrix &cMo = found()[index].cMo;
  bool isMatched = false;
  for (unsigned int i = 0; i < most && !isMatched; ++i) {
    matchNear(frame, cMo);
    const vpStopwatch stage(frame.timings.pose);
    m_hypotheses.refine(index, m_cues.edges(), m_looks.model().diameter());
    isMatched = serves(frame, cMo);
  }
  return isMatched;
}

// Poses that are about as likely are compared at a match of their own.
vpEdgeEstimator::Proposal vpEdgeEstimator::best(const vpFrameContext &frame)
{
  std::size_t finalists = 1;
  while (finalists < std::min(found().size(), maxFinalists) && found()[finalists].weight > leastWeight) {
    ++finalists;
  }
  if (finalists == 1) {
    const vpHomogeneousMatrix cMo = found().front().cMo;
    return {cMo, serves(frame, cMo)};
  }
  bool isMatched = false;
  for (std::size_t i = finalists; i > 0; --i) { // The likeliest last: its match can stay.
    isMatched = refine(frame, i - 1, 1);
  }
  const vpHomogeneousMatrix last = found().front().cMo;
  m_hypotheses.rank();
  const vpHomogeneousMatrix &cMo = found().front().cMo;
  return {cMo, isMatched && std::equal(last.data, last.data + 16, cMo.data)};
}

END_VISP_NAMESPACE
