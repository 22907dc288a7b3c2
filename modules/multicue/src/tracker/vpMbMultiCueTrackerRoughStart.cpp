// SPDX-License-Identifier: GPL-2.0-or-later
#include <visp3/multicue/vpMbMultiCueTracker.h>

#include "motion/vpPoseCheck.h"
#include "tracker/vpTrackerState.h"

#include <visp3/core/vpException.h>

#include <algorithm>
#include <cmath>

BEGIN_VISP_NAMESPACE

namespace {
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

const vpHomogeneousMatrix &heaviest(const std::vector<vpWeightedPose> &poses)
{
  return std::max_element(poses.begin(), poses.end(),
                          [](const vpWeightedPose &a, const vpWeightedPose &b) { return a.weight < b.weight; })
      ->cMo;
}

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

void vpPoseDeviation::check() const
{
  if (!(translation >= 0.) || !std::isfinite(translation)) {
    throw vpException(vpException::badValue, "The deviation of the translation is %g m: give 0 or more", translation);
  }
  if (!(rotation >= 0. && rotation <= M_PI)) {
    throw vpException(vpException::badValue, "The deviation of the rotation is %g: give 0 to pi, radians", rotation);
  }
}

bool vpMbMultiCueTracker::initFromRoughPose(const vpImage<unsigned char> &I, const vpHomogeneousMatrix &cMo,
                                            const vpPoseDeviation &deviation)
{
  return startRoughlyOn(I, {{cMo, 1.}}, deviation);
}

bool vpMbMultiCueTracker::initFromRoughPose(const vpImage<vpRGBa> &I_color, const vpHomogeneousMatrix &cMo,
                                            const vpPoseDeviation &deviation)
{
  return startRoughlyOn(I_color, {{cMo, 1.}}, deviation);
}

bool vpMbMultiCueTracker::initFromRoughPoses(const vpImage<unsigned char> &I,
                                             const std::vector<vpWeightedPose> &candidates,
                                             const vpPoseDeviation &deviation)
{
  return startRoughlyOn(I, candidates, deviation);
}

bool vpMbMultiCueTracker::initFromRoughPoses(const vpImage<vpRGBa> &I_color,
                                             const std::vector<vpWeightedPose> &candidates,
                                             const vpPoseDeviation &deviation)
{
  return startRoughlyOn(I_color, candidates, deviation);
}

template <typename Pixel>
bool vpMbMultiCueTracker::startRoughlyOn(const vpImage<Pixel> &I, const std::vector<vpWeightedPose> &candidates,
                                         const vpPoseDeviation &deviation)
{
  Impl &impl = *m_impl;
  requireTrackable(I.getWidth(), I.getHeight());
  deviation.check();
  if (candidates.empty()) {
    throw vpException(vpException::badValue, "No poses to start from: give at least one");
  }
  for (const vpWeightedPose &candidate : candidates) {
    vpPoseCheck::requireRigid(candidate.cMo);
    vpPoseCheck::requireInView(*impl.model, candidate.cMo, m_cam, I.getWidth(), I.getHeight());
    if (!(candidate.weight > 0.) || !std::isfinite(candidate.weight)) {
      throw vpException(vpException::badValue, "A candidate's weight is %g, it must be above 0", candidate.weight);
    }
  }
  m_cMo = heaviest(candidates);
  start(I.getWidth(), I.getHeight());
  impl.rough.candidates = candidates;
  impl.rough.spread = vpRoughStart::spreadOf(deviation, impl.model->diameter());
  const bool isAccepted = searchStart(impl.source.frame(I, m_cam, m_mask));
  followFaces(I.getWidth(), I.getHeight());
  return isAccepted;
}

// How well the image agrees with the pose that was estimated last; edges are seen in any light, colours are not.
double vpMbMultiCueTracker::startValue() const
{
  const vpStartSearch &search = m_impl->rough.search;
  const vpStartSearch::Value seen = search(m_cMo);
  const double found = m_impl->uses(EDGE_TRACKER) ? edgeAgreement() : 0.;
  return seen.edges + foundWeight * found + colorWeight * search.trust() * seen.colors;
}

// Estimates the pose from a start, with the colours that the image has where it is taken to be. \return How well the
// image agrees with it.
double vpMbMultiCueTracker::refineStart(const vpCueFrame &frame, const vpHomogeneousMatrix &cMo)
{
  Impl &impl = *m_impl;
  m_cMo = cMo;
  double best = -HUGE_VAL;
  vpHomogeneousMatrix bestPose = cMo;
  for (unsigned int i = 0; i < refinements; ++i) {
    impl.forgetImages();
    impl.expectedPose = impl.startPose = m_cMo;
    impl.usesPoints = false;
    bool estimated = false;
    if (impl.type == EDGE_TRACKER) {
      estimated = estimateFrom(frame, false);
    } else {
      learnStart(frame);
      if (impl.uses(COLOR_TRACKER)) {
        updateView(frame, m_cMo, 0.);
        estimateByCoarseColors(frame);
      }
      estimated = refineFused(frame);
    }
    const double value = estimated ? startValue() : -HUGE_VAL;
    if (!(value > best + leastGain)) {
      break;
    }
    best = value;
    bestPose = m_cMo;
  }
  m_cMo = bestPose;
  return best > -HUGE_VAL ? best : impl.rough.search(m_cMo).total - 1.; // Any estimated pose is better.
}

// Looks for the object about the poses that were given, and goes on from the best one where the image speaks for it.
bool vpMbMultiCueTracker::searchStart(const vpCueFrame &frame)
{
  Impl &impl = *m_impl;
  vpRoughStart &rough = impl.rough;
  impl.frameCamera = frame.camera();
  std::vector<vpWeightedPose> starts;
  append(rough.candidates, starts);
  append(rough.detected, starts);
  if (rough.tries > 0) {
    starts.push_back({m_cMo, 1.}); // Where the image before had it, or nearly so.
  }
  if (rough.hasHint) {
    starts.push_back({rough.hint, 1.});
    rough.hasHint = false;
  }
  const vpPoseSearch::Spread spread = rough.spread.grown(1. + spreadPerFrame * rough.tries);
  rough.search.setFrame(frame, impl.viewSphere(), impl.preference, impl.viewOptions.textureEdges);
  double best = -HUGE_VAL;
  vpHomogeneousMatrix bestPose = heaviest(starts);
  for (const vpPoseCandidate &candidate : rough.search.find(starts, spread, rough.tries)) {
    const double value = refineStart(frame, candidate.cMo);
    if (value > best) {
      best = value;
      bestPose = m_cMo;
    }
  }
  m_cMo = bestPose;
  ++rough.tries;
  return takeStart(frame);
}

// Learns what the image shows at the pose, and accepts or refuses it.
bool vpMbMultiCueTracker::takeStart(const vpCueFrame &frame)
{
  Impl &impl = *m_impl;
  vpRoughStart &rough = impl.rough;
  impl.forgetImages();
  impl.trust(m_cMo);
  impl.expectedPose = impl.startPose = m_cMo;
  learnStart(frame);
  const vpHomogeneousMatrix cMo = m_cMo;
  if (impl.type == EDGE_TRACKER) {
    match(frame, m_cMo);
  } else {
    refineFused(frame); // So that all cues are matched.
    m_cMo = cMo;
  }
  const vpHomogeneousMatrix cMb = m_cMo * impl.centreFrame();
  if (rough.evidence.isEnough(keptShare) && impl.rivalDistance(cMb, rough.refused) < samePlace) {
    rough.evidence.noteFoundAgain();
  } else {
    rough.evidence.clear();
    rough.evidence.setTries(rough.tries);
  }
  rough.refused = cMb;
  addEvidence(placesAtStart);
  const std::string missing = rough.evidence.text(firstShare);
  rough.phase = missing.empty() ? vpRoughStart::UNCONFIRMED : vpRoughStart::REFUSED;
  impl.state = missing.empty() ? vpTrackingState::UNCERTAIN : vpTrackingState::LOST;
  impl.outcome = missing.empty() ? vpMbTrackingResult::Reason::CONFIRMING : vpMbTrackingResult::Reason::CONTRADICTED;
  impl.reason = missing.empty() ? "a pose was found near to the one that was given, and has to explain more images"
                                : "no pose was accepted: at the best one, " + missing;
  return missing.empty();
}

// What speaks for the pose that was estimated last, in the image that the search has.
void vpMbMultiCueTracker::addEvidence(unsigned int places)
{
  vpRoughStart &rough = m_impl->rough;
  vpStartEvidence::Support support;
  support.hasEdges = m_impl->uses(EDGE_TRACKER);
  support.edges = support.hasEdges ? edgeAgreement() : 0.;
  support.hasColors = m_impl->uses(COLOR_TRACKER) && !m_impl->color.settings().scales.empty();
  support.colors = support.hasColors ? m_impl->color.evidenceAt(m_cMo) : 0.;
  const std::uint64_t seed = rough.tries + (static_cast<std::uint64_t>(rough.evidence.frames()) << 32U);
  const vpPoseSearch::Spread spread = rough.spread.grown(1. + spreadPerFrame * (rough.tries - 1U));
  rough.evidence.add(rough.search(m_cMo), rough.search.clutter(m_cMo, spread, seed, places), support,
                     rough.search.trust());
}

// In the frames after a start at poses that were not exact. \return False where there is no pose to follow.
bool vpMbMultiCueTracker::resumeStart(const vpCueFrame &frame)
{
  Impl &impl = *m_impl;
  vpRoughStart &rough = impl.rough;
  if (rough.phase == vpRoughStart::REFUSED) {
    if (impl.searches || rough.hasHint) {
      searchStart(frame);
    }
    impl.isJudged = true;
    return rough.phase == vpRoughStart::UNCONFIRMED;
  }
  return true;
}

// Whether the pose explains this image as well as a right one does.
void vpMbMultiCueTracker::confirmStart(const vpCueFrame &frame)
{
  Impl &impl = *m_impl;
  vpRoughStart &rough = impl.rough;
  if (rough.phase != vpRoughStart::UNCONFIRMED) {
    return;
  }
  if (impl.state != vpTrackingState::LOST) {
    rough.search.setFrame(frame, impl.viewSphere(), impl.preference, impl.viewOptions.textureEdges);
    addEvidence(placesAfter);
    const std::string missing = rough.evidence.text(1.);
    if (rough.evidence.frames() > framesToConfirm && missing.empty()) {
      rough.clear();
      return;
    }
    if (rough.evidence.frames() <= mostFrames && rough.evidence.isEnough(firstShare)) {
      impl.state = vpTrackingState::UNCERTAIN;
      impl.outcome = vpMbTrackingResult::Reason::CONFIRMING;
      return;
    }
    impl.outcome = vpMbTrackingResult::Reason::CONTRADICTED;
    impl.reason = "the pose that was accepted at the start is not confirmed: " + missing;
  }
  impl.state = vpTrackingState::LOST;
  rough.phase = vpRoughStart::REFUSED;
}

END_VISP_NAMESPACE
