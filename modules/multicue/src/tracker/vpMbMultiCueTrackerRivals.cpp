// SPDX-License-Identifier: GPL-2.0-or-later
#include <visp3/multicue/vpMbMultiCueTracker.h>

#include "hypotheses/vpControlPointMotion.h"
#include "frame/vpStopwatch.h"
#include "tracker/vpTrackerState.h"

#include <algorithm>
#include <cmath>
#include <numeric>

BEGIN_VISP_NAMESPACE

namespace {
// Poses that are followed beside the object's, and new ones that are looked at with all control points in a frame.
const std::size_t mostRivals = 3;
const std::size_t mostNew = 2;
// While the pose explains the image a motion less than this needs no rival ahead, squared, in widths of a mode.
const double calmMotion = 0.25;
// Draws that are minimised from each.
const unsigned int drawsEach = 2;
// A match serves poses that move its control points by less than this, pixels.
const double nearMotion = 1.5;
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
} // namespace

// Where the image shows the object in none of the poses: the likeliest ones around where it was seen last.
void vpMbMultiCueTracker::searchRivals(const vpCueFrame &frame)
{
  Impl &impl = *m_impl;
  vpTrackerParticles &particles = impl.particles;
  impl.scoreFrame(frame);
  const vpStopwatch stage(impl.timings.particles);
  const vpHomogeneousMatrix bMo = impl.centreFrame().inverse();
  const double growth = 1. + spreadPerFrame * particles.blindFrames;
  const vpPoseSearch::Spread spread = vpPoseSearch::near().grown(growth);
  vpPoseSearch search(impl.poseScore, *impl.model, impl.draws++);
  search.setSymmetries(impl.symmetries.get());
  search.setPrior(particles.explained * bMo, spread, vpPoseSearch::usualPrior);
  search.scatter({particles.explained * bMo, m_cMo}, spread, searchNumber);
  impl.settle(search);
  search.keepBest(mostFound, vpPoseSearch::same());
  for (const vpPoseCandidate &candidate : search.candidates()) {
    particles.found.push_back(candidate.cMo * impl.centreFrame());
  }
}

// All control points for the poses that are followed beside the object's, and for the best new ones.
void vpMbMultiCueTracker::optimiseRivals(const vpCueFrame &frame)
{
  Impl &impl = *m_impl;
  vpTrackerParticles &particles = impl.particles;
  const double diameter = impl.model->diameter();
  const vpHomogeneousMatrix oMb = impl.centreFrame();
  std::vector<vpRivalPose> &rivals = particles.rivals;
  particles.found.clear();
  if (particles.blindFrames > 0 && particles.blindFrames % searchInterval == 0) {
    searchRivals(frame);
  }
  std::vector<std::size_t> order(particles.proposals.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::stable_sort(order.begin(), order.end(), [&particles](std::size_t a, std::size_t b) {
    return particles.residues[a] < particles.residues[b];
  });
  const auto add = [&](const vpHomogeneousMatrix &cMb) {
    const bool isNew = std::none_of(rivals.begin(), rivals.end(),
                                    [&](const vpRivalPose &other) { return impl.rivalDistance(cMb, other.cMb) < 1.; });
    if (isNew) {
      vpRivalPose rival;
      rival.cMb = cMb;
      rivals.push_back(rival);
    }
    return isNew;
  };
  const vpHomogeneousMatrix ahead = particles.followed * particles.followedMotion;
  if (particles.distance(ahead, particles.followed, diameter) > (particles.before.isCalm ? calmMotion : 0.)) {
    add(ahead);
  }
  for (const vpHomogeneousMatrix &cMb : particles.found) {
    add(cMb);
  }
  std::size_t added = 0;
  for (std::size_t i = 0; i < order.size() && added < mostNew; ++i) {
    added += add(particles.proposals[order[i]]) ? 1 : 0;
  }
  for (vpRivalPose &rival : rivals) {
    m_cMo = rival.cMb * oMb.inverse();
    matchNear(frame, m_cMo);
    if (!findPoses(drawsEach, HUGE_VAL)) {
      rival.residue = HUGE_VAL;
      continue;
    }
    if (vpControlPointMotion::mean(*impl.view, impl.hypotheses.hypotheses().front().cMo, frame.camera()) >=
        nearMotion) {
      refineHypothesis(frame, 0, 1);
    }
    takeHypotheses();
    rival.cMb = impl.hypotheses.hypotheses().front().cMo * oMb;
    rival.residue = impl.bestResidue();
  }
}

// Which pose explained the frames up to now best.
void vpMbMultiCueTracker::compareRivals(const vpCueFrame &frame)
{
  Impl &impl = *m_impl;
  vpTrackerParticles &particles = impl.particles;
  const vpHomogeneousMatrix cMb = m_cMo * impl.centreFrame();
  const double cutoff = vpPoseHypotheses::cutoff;
  const double residue = impl.state == vpTrackingState::LOST ? cutoff : std::min(impl.bestResidue(), cutoff);
  std::vector<vpRivalPose> kept;
  double least = residue;
  std::stable_sort(particles.rivals.begin(), particles.rivals.end(),
                   [](const vpRivalPose &a, const vpRivalPose &b) { return a.lead > b.lead; });
  for (vpRivalPose &rival : particles.rivals) {
    const double other = std::min(rival.residue, cutoff);
    const double gain = (residue * residue - other * other) / (usualResidue * usualResidue);
    rival.lead += std::min(std::max(gain, -mostOfFrame), mostOfFrame) - margin;
    const bool isNew = impl.rivalDistance(rival.cMb, cMb) > 1. &&
                       std::none_of(kept.begin(), kept.end(), [&](const vpRivalPose &before) {
                         return impl.rivalDistance(rival.cMb, before.cMb) < 1.;
                       });
    if (isNew && rival.lead > losing) {
      least = std::min(least, other);
      kept.push_back(rival);
    }
  }
  std::stable_sort(kept.begin(), kept.end(),
                   [](const vpRivalPose &a, const vpRivalPose &b) { return a.lead > b.lead; });
  kept.resize(std::min(kept.size(), mostRivals));
  particles.rivals = kept;
  const auto best = std::min_element(kept.begin(), kept.end(),
                                     [](const vpRivalPose &a, const vpRivalPose &b) { return a.residue < b.residue; });
  const double explained = std::min(impl.explainedResidue(), mostExplained * cutoff);
  if (best != kept.end() && best->residue < (residue > explained ? decisive : mostDecisive) * residue) {
    takeRival(frame, best->cMb, false);
  } else if (!kept.empty() && kept.front().lead >= winning && kept.front().residue < residue) {
    takeRival(frame, kept.front().cMb, true);
  }
  const bool isBlind = least > unexplained * explained;
  particles.isCalm = impl.state == vpTrackingState::TRACKING && residue <= explained && least >= residue;
  particles.blindFrames = isBlind ? particles.blindFrames + 1 : 0;
  const vpHomogeneousMatrix now = m_cMo * impl.centreFrame();
  particles.followedMotion = particles.followed.inverse() * now;
  if (particles.blindFrames > 0 || impl.state == vpTrackingState::LOST) {
    particles.followedMotion.eye();
  } else if (least < unexplained * explained) {
    particles.explained = now;
  }
  particles.followed = now;
}

// Goes on from a rival. isOld: the pose was wrong for several frames, what was learnt belongs to another one.
void vpMbMultiCueTracker::takeRival(const vpCueFrame &frame, const vpHomogeneousMatrix &cMb, bool isOld)
{
  Impl &impl = *m_impl;
  const vpHomogeneousMatrix cMo = m_cMo;
  m_cMo = impl.nearestAlike(cMb * impl.centreFrame().inverse());
  if (isOld) {
    impl.edges.reset();
    impl.usualResidue = 0.;
  }
  match(frame, m_cMo);
  bool matched = false;
  if (findPoses(drawsEach, HUGE_VAL)) {
    m_cMo = impl.hypotheses.hypotheses().front().cMo;
    matched = vpControlPointMotion::mean(*impl.view, m_cMo, frame.camera()) < nearMotion;
  }
  judge(estimateFrom(frame, matched));
  // The pose before may come back.
  vpRivalPose before;
  before.cMb = cMo * impl.centreFrame();
  impl.particles.rivals = {before};
}

END_VISP_NAMESPACE
