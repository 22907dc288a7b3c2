// SPDX-License-Identifier: GPL-2.0-or-later
#include "particles/vpRivalPoses.h"

#include "frame/vpStopwatch.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

BEGIN_VISP_NAMESPACE

namespace {
// Draws that are minimised from each pose.
const unsigned int drawsEach = 2;
// Optimised particles need no more than half of the control points: what comes of them is estimated again with all.
const double coarseness = 2.;
// Particles that are optimised while the pose explains the image.
const unsigned int fewOptimised = 2;
// Poses that are followed beside the object's, and new ones that are looked at with all control points in a frame.
const std::size_t mostRivals = 3;
const std::size_t mostNew = 2;
// While the pose explains the image a motion less than this needs no rival ahead, squared, in widths of a mode.
const double calmMotion = 0.25;
// Squared residues are compared in those of a pose that explains the image; one frame tells no more than this, and
// poses that are about as good win nothing.
const double usualResidue = 0.8; // Pixels.
const double mostOfFrame = 1.5;
const double margin = 0.2;
// From here on a rival is taken for the object's pose, and from there on it is forgotten.
const double winning = 3.;
const double losing = -1.;
// Where the pose that goes on leaves more than trusted ones did, one that leaves this share of it is taken at once: of
// an object that turns fast, the right pose is soon out of reach.
const double decisive = 0.96;
// This share is enough wherever it is: what trusted poses left has grown with wrong ones.
const double mostDecisive = 0.88;
// No pose explains the image: all of them leave as many times what trusted ones left.
const double unexplained = 1.5;
// What trusted poses left grows with wrong ones that were trusted; more than this share of the cutoff explains nothing.
const double mostExplained = 0.5;
// The object is looked for in each of as many frames.
const unsigned int searchInterval = 3;
// How far around is looked for it, in the spread near a pose, grows with each frame.
const double spreadPerFrame = 0.1;
const std::size_t searchNumber = 120;
const std::size_t mostFound = 3;

bool leadsMore(const vpRivalPose &a, const vpRivalPose &b)
{
  return a.lead > b.lead;
}
} // namespace

void vpRivalPoses::optimise(const vpFrameContext &frame, const vpHomogeneousMatrix &cMo)
{
  std::swap(frame.streams.searches, m_particles.draws);
  optimiseRivals(frame, optimiseParticles(frame, cMo));
  std::swap(frame.streams.searches, m_particles.draws);
  m_particles.minimisations = m_edges.minimisations();
  m_edges.setMinimisations(0);
}

vpHomogeneousMatrix vpRivalPoses::judged(const vpEstimate &estimate)
{
  m_outcome.judge(estimate.isFound, m_cues, m_minimiser.fusion(), m_settings.goodRatio);
  return estimate.cMo;
}

vpHomogeneousMatrix vpRivalPoses::lookAgain(const vpFrameContext &frame)
{
  const unsigned int minimisations = m_edges.minimisations() + m_particles.minimisations;
  frame.streams.searches = m_particles.before.draws;
  m_edges.setMinimisations(0);
  m_particles.draws = m_particles.before.particleDraws;
  m_particles.rivals = m_particles.before.rivals;
  m_particles.before.isCalm = false;
  const vpHomogeneousMatrix cMo = m_particles.before.cMo;
  optimise(frame, cMo);
  m_particles.minimisations += minimisations;
  return judged(m_edges.estimate(frame, cMo));
}

// What pose hypotheses make of the best particles. \return The last one that was looked at.
vpHomogeneousMatrix vpRivalPoses::optimiseParticles(const vpFrameContext &frame, const vpHomogeneousMatrix &cMo)
{
  const vpHomogeneousMatrix oMb = m_looks.centreFrame();
  const unsigned int all = m_particles.settings().mostOptimised;
  const unsigned int most = m_particles.before.isCalm ? std::min(all, fewOptimised) : all;
  const std::vector<std::size_t> best =
      m_particles.best(m_particles.values, cMo * oMb, m_looks.model().diameter(), most);
  m_particles.proposals.clear();
  m_particles.residues.clear();
  m_edges.restrictMotions();
  vpHomogeneousMatrix pose = cMo;
  for (const std::size_t i : best) {
    pose = m_particles.filter().pose(i) * oMb.inverse();
    m_looks.computeCoarsely(frame, pose, coarseness);
    m_edges.matchView(frame);
    if (m_edges.findPoses(frame, pose, drawsEach, HUGE_VAL)) {
      takeHypotheses();
    }
  }
  return pose;
}

void vpRivalPoses::takeHypotheses()
{
  for (const vpPoseHypothesis &hypothesis : m_edges.found()) {
    m_particles.proposals.push_back(hypothesis.cMo * m_looks.centreFrame());
    m_particles.residues.push_back(hypothesis.residue);
  }
}

// Where the image shows the object in none of the poses: the likeliest ones around where it was seen last.
void vpRivalPoses::search(const vpFrameContext &frame, const vpHomogeneousMatrix &cMo)
{
  m_score.setFrame(frame);
  const vpStopwatch stage(frame.timings.particles);
  const vpHomogeneousMatrix seen = m_particles.explained * m_looks.centreFrame().inverse();
  const double growth = 1. + spreadPerFrame * m_particles.blindFrames;
  const vpPoseSearch::Spread spread = vpPoseSearch::near().grown(growth);
  vpPoseSearch search(m_score.score(), m_looks.model(), frame.streams.searches++);
  search.setSymmetries(m_symmetries.get());
  search.setPrior({seen}, spread, vpPoseSearch::Tail::LIGHT);
  search.scatter({seen, cMo}, spread, searchNumber);
  m_score.settle(search);
  search.keepBest(mostFound, vpPoseSearch::same());
  for (const vpPoseCandidate &candidate : search.candidates()) {
    m_particles.found.push_back(candidate.cMo * m_looks.centreFrame());
  }
}

bool vpRivalPoses::add(const vpHomogeneousMatrix &cMb)
{
  std::vector<vpRivalPose> &rivals = m_particles.rivals;
  const bool isNew = std::none_of(rivals.begin(), rivals.end(),
                                  [&](const vpRivalPose &other) { return m_alike.distance(cMb, other.cMb) < 1.; });
  if (isNew) {
    vpRivalPose rival;
    rival.cMb = cMb;
    rivals.push_back(rival);
  }
  return isNew;
}

// All control points for the poses that are followed beside the object's, and for the best new ones.
void vpRivalPoses::optimiseRivals(const vpFrameContext &frame, const vpHomogeneousMatrix &cMo)
{
  m_particles.found.clear();
  if (m_particles.blindFrames > 0 && m_particles.blindFrames % searchInterval == 0) {
    search(frame, cMo);
  }
  std::vector<std::size_t> order(m_particles.proposals.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::stable_sort(order.begin(), order.end(),
                   [this](std::size_t a, std::size_t b) { return m_particles.residues[a] < m_particles.residues[b]; });
  const vpHomogeneousMatrix ahead = m_particles.followed * m_particles.followedMotion;
  const double moved = m_particles.distance(ahead, m_particles.followed, m_looks.model().diameter());
  if (moved > (m_particles.before.isCalm ? calmMotion : 0.)) {
    add(ahead);
  }
  for (const vpHomogeneousMatrix &cMb : m_particles.found) {
    add(cMb);
  }
  std::size_t added = 0;
  for (std::size_t i = 0; i < order.size() && added < mostNew; ++i) {
    added += add(m_particles.proposals[order[i]]) ? 1U : 0U;
  }
  for (vpRivalPose &rival : m_particles.rivals) {
    optimiseRival(frame, rival);
  }
}

void vpRivalPoses::optimiseRival(const vpFrameContext &frame, vpRivalPose &rival)
{
  const vpHomogeneousMatrix oMb = m_looks.centreFrame();
  const vpHomogeneousMatrix cMo = rival.cMb * oMb.inverse();
  m_edges.matchNear(frame, cMo);
  if (!m_edges.findPoses(frame, cMo, drawsEach, HUGE_VAL)) {
    rival.residue = HUGE_VAL;
    return;
  }
  if (!m_edges.serves(frame, m_edges.found().front().cMo)) {
    m_edges.refine(frame, 0, 1);
  }
  takeHypotheses();
  rival.cMb = m_edges.found().front().cMo * oMb;
  rival.residue = m_edges.bestResidue();
}

double vpRivalPoses::weigh(const vpHomogeneousMatrix &cMb, double residue)
{
  double least = residue;
  std::vector<vpRivalPose> kept;
  std::stable_sort(m_particles.rivals.begin(), m_particles.rivals.end(), leadsMore);
  for (vpRivalPose &rival : m_particles.rivals) {
    const double other = std::min(rival.residue, vpPoseHypotheses::cutoff);
    const double gain = (residue * residue - other * other) / (usualResidue * usualResidue);
    rival.lead += std::min(std::max(gain, -mostOfFrame), mostOfFrame) - margin;
    const bool isNew =
        m_alike.distance(rival.cMb, cMb) > 1. && std::none_of(kept.begin(), kept.end(), [&](const vpRivalPose &before) {
          return m_alike.distance(rival.cMb, before.cMb) < 1.;
        });
    if (isNew && rival.lead > losing) {
      least = std::min(least, other);
      kept.push_back(rival);
    }
  }
  std::stable_sort(kept.begin(), kept.end(), leadsMore);
  kept.resize(std::min(kept.size(), mostRivals));
  m_particles.rivals = kept;
  return least;
}

vpHomogeneousMatrix vpRivalPoses::compare(const vpFrameContext &frame, const vpHomogeneousMatrix &cMo)
{
  const vpHomogeneousMatrix oMb = m_looks.centreFrame();
  const double cutoff = vpPoseHypotheses::cutoff;
  const double residue = m_outcome.isLost() ? cutoff : std::min(m_edges.bestResidue(), cutoff);
  const double least = weigh(cMo * oMb, residue);
  const std::vector<vpRivalPose> rivals = m_particles.rivals;
  const auto best = std::min_element(rivals.begin(), rivals.end(),
                                     [](const vpRivalPose &a, const vpRivalPose &b) { return a.residue < b.residue; });
  const double explained = std::min(m_edges.explainedResidue(), mostExplained * cutoff);
  vpHomogeneousMatrix followed = cMo;
  if (best != rivals.end() && best->residue < (residue > explained ? decisive : mostDecisive) * residue) {
    followed = take(frame, cMo, best->cMb, false);
  } else if (!rivals.empty() && rivals.front().lead >= winning && rivals.front().residue < residue) {
    followed = take(frame, cMo, rivals.front().cMb, true);
  }
  const bool isBlind = least > unexplained * explained;
  m_particles.isCalm = m_outcome.isTracking() && residue <= explained && least >= residue;
  m_particles.blindFrames = isBlind ? m_particles.blindFrames + 1 : 0;
  noteFollowed(followed * oMb, least < unexplained * explained);
  return followed;
}

void vpRivalPoses::noteFollowed(const vpHomogeneousMatrix &cMb, bool isExplained)
{
  m_particles.followedMotion = m_particles.followed.inverse() * cMb;
  if (m_particles.blindFrames > 0 || m_outcome.isLost()) {
    m_particles.followedMotion.eye();
  } else if (isExplained) {
    m_particles.explained = cMb;
  }
  m_particles.followed = cMb;
}

// Goes on from a rival. isOld: the pose was wrong for several frames, what was learnt belongs to another one.
vpHomogeneousMatrix vpRivalPoses::take(const vpFrameContext &frame, const vpHomogeneousMatrix &cMo,
                                       const vpHomogeneousMatrix &cMb, bool isOld)
{
  const vpHomogeneousMatrix oMb = m_looks.centreFrame();
  vpHomogeneousMatrix taken = m_alike.nearest(cMb * oMb.inverse());
  if (isOld) {
    m_cues.edges().reset();
    m_edges.forgetResidue();
  }
  m_edges.match(frame, taken);
  bool isMatched = false;
  if (m_edges.findPoses(frame, taken, drawsEach, HUGE_VAL)) {
    taken = m_edges.found().front().cMo;
    isMatched = m_edges.serves(frame, taken);
  }
  const vpHomogeneousMatrix followed = judged(m_edges.from(frame, taken, isMatched));
  // The pose before may come back.
  vpRivalPose before;
  before.cMb = cMo * oMb;
  m_particles.rivals = {before};
  return followed;
}

END_VISP_NAMESPACE
