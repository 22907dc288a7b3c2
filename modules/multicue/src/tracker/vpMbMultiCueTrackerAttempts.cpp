// SPDX-License-Identifier: GPL-2.0-or-later
#include <visp3/multicue/vpMbMultiCueTracker.h>

#include "tracker/vpTrackerState.h"
#include "motion/vpTurnBetween.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

BEGIN_VISP_NAMESPACE

namespace {
// Of what the trusted frames before had: from there on a pose is taken.
const double wellExplained = 0.8;
const double decisiveSurface = 0.7;
// Of colours and surface together, how far they were steady, and what they have of the usual.
const double leastSteadiness = 0.6;
const double disowningShare = 0.25;
// Penalty of a pose with so few edges that others are looked for.
const double fewEdges = 0.2;
const double contradictingSurface = 0.35;
const double contradictionPenalty = 0.2; // Of a pose whose surface cannot be what was seen before.
// Of a pose that is one deviation off the expected one; squared for those farther off.
const double farPenalty = 0.03;
const double mostFar = 10.;
const double toleratedPenalty = 0.05;
const double unknownAfterLoss = 0.25; // Weight of a surface that was never seen.
// Of half a turn, or two diameters.
const double changePenalty = 0.1;
// An object that was hidden for some time goes on as it moved: at the end of 197 hidden times of rendered sequences it
// was turned by 20 degrees from the nearest of the expected poses (median), by less than 57 in 95 % of them. So much,
// of that, for a turn farther than that (radians), and the time after which half of it is left (seconds).
const double unlikelyTurn = 2.;
const double likelyTurn = 1.;
const double likelyGap = 3.;
const double mostShift = 1.5;    // Of two diameters; beyond it, shifts are equally unlikely.
const double depthPenalty = 0.3; // Of a distance that is e times what it was.
// Poses that look alike and are nearer than this to one another are the same one, diameters.
const double sameAlike = 0.05;
// Turns of the object that are tried, radians.
const double turn = 0.35;

// Of half a turn. \param unlikely What a turn counts beside that which is far beyond the likely ones.
double changeOfTurn(double angle, double unlikely)
{
  const double share = angle / likelyTurn;
  return angle / M_PI + unlikely * (1. - std::exp(-share * share));
}
} // namespace

std::array<double, 2> vpMbMultiCueTracker::Impl::offExpected(const vpHomogeneousMatrix &cMo) const
{
  const Eigen::Isometry3d moved = vpPoseExponential::toEigen(expectedPose.inverse() * cMo);
  const Eigen::Vector3d centre = model->centre();
  return {(moved * centre - centre).norm() / model->diameter(), Eigen::AngleAxisd(moved.linear()).angle()};
}

// Squared, in deviations of how far the object may be from where it is expected.
double vpMbMultiCueTracker::Impl::surpriseAt(const vpHomogeneousMatrix &cMo) const
{
  const std::array<double, 2> off = offExpected(cMo);
  const double distance = off[0] / farDeviation[0];
  const double angle = off[1] / farDeviation[1];
  return std::min(distance * distance + angle * angle, mostFar);
}

// Of half a turn, and of two diameters; from where the object was, may have moved to, or was detected, whichever is
// nearest.
double vpMbMultiCueTracker::Impl::changeSince(const vpHomogeneousMatrix &cMo) const
{
  const Eigen::Isometry3d now = vpPoseExponential::toEigen(cMo);
  const Eigen::Vector3d centre = model->centre();
  const double gap = (time - trusted.time) / likelyGap;
  const double unlikely = unlikelyTurn / (1. + gap * gap);
  const auto changeFrom = [&](const vpHomogeneousMatrix &pose) {
    const Eigen::Isometry3d before = vpPoseExponential::toEigen(pose);
    const double shift = (now * centre - before * centre).norm() / (2. * model->diameter());
    return changeOfTurn(vpTurnBetween(pose, cMo), unlikely) + std::min(shift, mostShift);
  };
  double least = HUGE_VAL;
  for (const vpHomogeneousMatrix &pose : whereabouts()) {
    least = std::min(least, changeFrom(pose));
  }
  for (const vpWeightedPose &pose : rough.detected) {
    least = std::min(least, changeFrom(pose.cMo));
  }
  return least;
}

// Logarithm of the factor between the distances now and when it was trusted, or where it was told to be, 1 at most: a
// pose far behind what the image shows fits into it, and drifts away.
double vpMbMultiCueTracker::Impl::depthChange(const vpHomogeneousMatrix &cMo) const
{
  const double now = depthOf(cMo);
  const auto changeFrom = [now](double before) {
    return now > 0. && before > 0. ? std::min(std::fabs(std::log(now / before)), 1.) : 1.;
  };
  double least = changeFrom(depthOf(trusted.cMo));
  if (trustedBefore) {
    least = std::min(least, changeFrom(depthOf(trustedBefore->cMo)));
  }
  for (const double depth : rough.depths) {
    least = std::min(least, changeFrom(depth));
  }
  return least;
}

double vpMbMultiCueTracker::Impl::depthOf(const vpHomogeneousMatrix &cMo) const
{
  const Eigen::Vector3d centre = model->centre();
  return cMo[2][0] * centre.x() + cMo[2][1] * centre.y() + cMo[2][2] * centre.z() + cMo[2][3];
}

// Keeps the pose where it explains more than the best one before. \return True where that is enough.
bool vpMbMultiCueTracker::takeAttempt(bool estimated)
{
  Impl &impl = *m_impl;
  const double share = estimated ? explainedShare() : -1.;
  if (estimated) {
    impl.attempted.push_back(m_cMo);
  }
  const double surprise = impl.surpriseAt(m_cMo);
  double value = share - std::max(farPenalty * surprise, impl.inertia.penalty(m_cMo));
  if (impl.mustConfirm) {
    // What was never seen is no evidence for a pose. Half a turn of a symmetric object explains as much: the one nearer
    // to the last trusted pose is likelier.
    const double unknown =
        unknownAfterLoss * vpSurfaceTrust(impl.surface.texture()) * (1. - impl.agreement.surfaceKnown);
    const double change = changePenalty * impl.changeSince(m_cMo);
    value = (2. * share + unknown * vpUnknownCorrelation) / (2. + unknown) - impl.fewEdgesPenalty() -
            depthPenalty * impl.depthChange(m_cMo) - (impl.agreement.isRefuted ? contradictionPenalty : 0.);
    vpContourEvidence contours;
    if (estimated && impl.uses(EDGE_TRACKER)) {
      contours.set(impl.edges, m_cMo);
    }
    value = estimated ? impl.tracks.add(m_cMo, value, change, impl.sameTrack(), contours) : value - change;
  }
  const Impl::Attempt attempt = {{share, value, surprise >= mostFar}, m_cMo, impl.share, impl.usesPoints};
  impl.bestIsLast = estimated && attempt.isBetterThan(impl.best, impl.mustConfirm);
  if (impl.bestIsLast) {
    impl.best = attempt;
  }
  if (impl.mustConfirm) {
    return impl.best.explained >= wellExplained && impl.bestIsLast && isDecisive() && !impl.mustCompare(m_cMo);
  }
  return std::min(impl.best.explained, impl.best.value + toleratedPenalty) >= wellExplained;
}

// The image shows something else than what is remembered of the surface.
bool vpMbMultiCueTracker::isContradicted() const
{
  const Impl &impl = *m_impl;
  return impl.agreement.surfaceWeight > Impl::leastTexture &&
         impl.agreement.surface < contradictingSurface * impl.usual.surface;
}

// Colours and surface, where they were steady, have hardly anything at the pose of what they had: edges alone speak for
// it.
bool vpMbMultiCueTracker::Impl::isDisowned() const
{
  double seen = 0.;
  double steadiness = 0.;
  const auto add = [&](double value, double usualValue, double variance, double share) {
    if (usualValue > 0.) {
      const double weight = reliability(variance);
      steadiness += weight;
      seen += weight * share * std::max(countedShare(value, usualValue), 0.);
    }
  };
  add(agreement.color, usual.color, unsteadiness.color, 1.);
  add(agreement.surface, usual.surface, unsteadiness.surface, agreement.surfaceWeight);
  return steadiness > leastSteadiness && seen < disowningShare * steadiness;
}

// After a loss: no other pose looks like this one.
bool vpMbMultiCueTracker::isDecisive() const
{
  const Impl &impl = *m_impl;
  if (impl.type == EDGE_TRACKER) { // There are many edges that no object of this shape has.
    return false;
  }
  if (impl.surface.texture() < Impl::leastTexture) {
    return impl.confirmations > 0;
  }
  return impl.fewEdgesPenalty() < fewEdges && impl.agreement.surfaceWeight > Impl::leastTexture &&
         impl.agreement.surface > decisiveSurface * impl.usual.surface;
}

// Starts elsewhere, where the image does not look as it should at the pose that was found.
void vpMbMultiCueTracker::tryOthers(const vpCueFrame &frame)
{
  Impl &impl = *m_impl;
  impl.usesPoints = false;
  impl.edges.reset(); // A jump of the light changes all contrasts at once.
  if (tryKeyframes(frame, true)) {
    return;
  }
  // Colours mislead where much of the object looks like what is behind it.
  m_cMo = impl.startPose = impl.expectedPose;
  if (takeAttempt(refineFused(frame))) {
    return;
  }
  if (impl.uses(EDGE_TRACKER)) {
    m_cMo = impl.expectedPose;
    proposePose(frame);
    if (takeAttempt(refineFused(frame))) {
      return;
    }
  }
  if (impl.searches) {
    searchNear(frame);
  } else if (impl.best.explained < vpJudgedPose::badlyExplained) {
    tryTurns(frame);
  }
}

void vpMbMultiCueTracker::tryTurns(const vpCueFrame &frame)
{
  Impl &impl = *m_impl;
  const vpHomogeneousMatrix oMb = impl.centreFrame();
  const vpHomogeneousMatrix cMb = impl.expectedPose * oMb;
  for (unsigned int i = 0; i < 6; ++i) {
    const double angle = i % 2 == 0 ? turn : -turn;
    const unsigned int axis = i / 2;
    const vpHomogeneousMatrix turned(
        vpTranslationVector(cMb[0][3], cMb[1][3], cMb[2][3]),
        vpRotationMatrix(vpThetaUVector(axis == 0 ? angle : 0., axis == 1 ? angle : 0., axis == 2 ? angle : 0.)) *
            cMb.getRotationMatrix());
    m_cMo = turned * oMb.inverse();
    if (impl.symmetries.hides(m_cMo, impl.expectedPose, *impl.model)) {
      continue;
    }
    m_cMo = impl.nearestAlike(m_cMo);
    updateView(frame, m_cMo, 0.);
    if (impl.uses(COLOR_TRACKER)) {
      estimateByCoarseColors(frame);
    }
    if (takeAttempt(refineFused(frame))) {
      return;
    }
  }
}

// After a loss the estimation may lead to another one of the poses that look alike than the nearest to the last.
bool vpMbMultiCueTracker::takeNearestAlike(const vpCueFrame &frame)
{
  Impl &impl = *m_impl;
  if (!impl.mustConfirm || impl.symmetries.get() == nullptr) {
    return true;
  }
  const vpHomogeneousMatrix alike = impl.nearestAlike(m_cMo);
  const double diameter = impl.model->diameter();
  if (vpModelSymmetries::distance(alike, m_cMo, impl.model->centre(), 0.5 * diameter) < sameAlike * diameter) {
    return true;
  }
  m_cMo = alike;
  impl.startPose = alike;
  const bool isFound = refineFused(frame);
  explainedShare();
  return isFound;
}

// After a loss, where the pose of the frame before does not explain the image.
void vpMbMultiCueTracker::findAgain(const vpCueFrame &frame)
{
  Impl &impl = *m_impl;
  impl.usesPoints = false;
  if (impl.state != vpTrackingState::LOST) { // What hides the object misleads colours and points.
    m_cMo = impl.startPose = impl.expectedPose;
    impl.tracks.follow(0);
    const bool isEnough = takeAttempt(refineFused(frame));
    impl.tracks.followNone();
    if (isEnough || attemptProposed(frame)) {
      return;
    }
  }
  if (attemptFrom(frame, impl.movedOn(impl.trusted, 1.), false) ||
      (impl.trustedBefore && attemptFrom(frame, impl.movedOn(*impl.trustedBefore, 1.), false))) {
    return;
  }
  if (impl.proof.hasFailed && impl.framesSinceLoss == 1) {
    for (const vpHomogeneousMatrix &cMo : impl.halfTurns.turned(impl.trusted.cMo)) {
      attemptFrom(frame, cMo, false);
    }
  }
  if (!tryKeyframes(frame, false)) {
    searchEverywhere(frame);
    attemptHalfTurned(frame);
    impl.tracks.noteOthers();
  }
}

// Where the object is if it moves as it did some frames ago. \return True where that leads to a pose that is enough.
bool vpMbMultiCueTracker::attemptInert(const vpCueFrame &frame)
{
  Impl &impl = *m_impl;
  if (impl.best.explained < 0. || !impl.inertia.isLeftBy(impl.best.cMo)) {
    return false;
  }
  impl.usesPoints = false;
  return attemptFrom(frame, impl.inertia.cMo(), false);
}

bool vpMbMultiCueTracker::estimateFused(const vpCueFrame &frame)
{
  Impl &impl = *m_impl;
  impl.attempted.clear();
  if (impl.type == EDGE_TRACKER) {
    impl.scoreFrame(frame);
    impl.hypotheses.clear();
  }
  if (impl.mustConfirm) {
    impl.recallLearnt();
    impl.beginTracks(m_cMo);
  }
  const vpPoseTracks::Track first = impl.tracks.empty() ? vpPoseTracks::Track() : impl.tracks.tracks().front();
  impl.best = Impl::Attempt();
  impl.mostAgreeing = 0;
  impl.surface.setFrame(frame);
  estimateCoarse(frame);
  bool isEnough = takeAttempt(refineFused(frame));
  isEnough = attemptInert(frame) || isEnough;
  impl.holdsPrediction = false; // The attempts to come look elsewhere.
  if (!isEnough && impl.mustConfirm) {
    isEnough = attemptAhead(frame, first.before, first.cMo);
  }
  impl.tracks.followNone();
  if (impl.mustConfirm && followOthers(frame)) {
    isEnough = true;
  }
  if (impl.rough.hasHint) {
    isEnough = tryHint(frame) || isEnough;
  }
  if (!isEnough && impl.mustConfirm) {
    findAgain(frame);
  } else if (!isEnough) {
    tryOthers(frame);
  }
  if (impl.best.explained < 0.) {
    return false;
  }
  compareTwins(frame);
  if (!impl.bestIsLast) {
    m_cMo = impl.startPose = impl.best.cMo;
    impl.usesPoints = impl.best.usesPoints;
    if (!refineFused(frame)) {
      return false;
    }
    explainedShare();
  }
  return takeNearestAlike(frame);
}

END_VISP_NAMESPACE
