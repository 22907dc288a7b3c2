// SPDX-License-Identifier: GPL-2.0-or-later
#include <visp3/multicue/vpMbMultiCueTracker.h>

#include "tracker/vpTrackerState.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

BEGIN_VISP_NAMESPACE

namespace {
// An edge or a point that is farther away than this does not support a pose, pixels.
const double edgeReach = 2.5;
const double pointReach = 2.;
// Of what the trusted frames before had: from there on a pose is taken, and below this others are looked for all
// around.
const double wellExplained = 0.8;
const double badlyExplained = 0.65;
// One cue alone does not make a pose better than those before.
const double mostOfOne = 1.2;
// A surface of one colour tells no pose from another.
const double leastTexture = 0.15;
const double decisiveSurface = 0.7;
const double contradictingSurface = 0.35;
// Of a pose that is one deviation off the expected one; squared for those farther off.
const double farPenalty = 0.03;
const double mostFar = 10.;
const double toleratedPenalty = 0.05;
const double farDistance = 0.2; // Diameters.
const double farTurn = 0.4;     // Radians.
// Of half a turn, or two diameters.
const double changePenalty = 0.1;
const double followedBonus = 0.05;
const double steadyVariance = 0.15 * 0.15;
// Slower down than up: a wrong pose explains less, and must not become the usual one.
const double usualRiseRate = 0.1;
const double usualFallRate = 0.02;
const double unsteadinessRate = 0.05;
// Turns of the object that are tried, radians.
const double turn = 0.35;

// 1 for a distance of 0, falling to 0 at the reach.
double closeness(double distance, double reach)
{
  const double share = distance / reach;
  return std::max(0., 1. - share * share);
}
} // namespace

double vpMbMultiCueTracker::edgeAgreement() const
{
  const Impl &impl = *m_impl;
  vpResidualBlock &block = m_impl->block;
  impl.edges.residuals(m_cMo, block);
  double sum = 0.;
  for (const vpResidual &row : block.rows) {
    sum += closeness(row.error, edgeReach / impl.frameCamera.get_px());
  }
  return impl.edges.matches().empty() ? 0. : sum / static_cast<double>(impl.edges.matches().size());
}

double vpMbMultiCueTracker::pointAgreement() const
{
  const Impl &impl = *m_impl;
  vpResidualBlock &block = m_impl->block;
  impl.points->residuals(m_cMo, block);
  double sum = 0.;
  for (std::size_t i = 0; i + 1 < block.rows.size(); i += 2) {
    const double distance = std::hypot(block.rows[i].error, block.rows[i + 1].error);
    sum += closeness(distance, pointReach / impl.frameCamera.get_px());
  }
  return impl.points->matches().empty() ? 0. : sum / static_cast<double>(impl.points->matches().size());
}

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
  const double distance = off[0] / farDistance;
  const double angle = off[1] / farTurn;
  return std::min(distance * distance + angle * angle, mostFar);
}

double vpMbMultiCueTracker::Impl::shareOf(double value, double usual)
{
  return value / std::max(usual, leastUsual);
}

// How much a cue counts whose agreement with trusted poses has this variance, in shares of the usual one: 1 for one
// that is steady. Colours that come and go with the light on the object say little.
double vpMbMultiCueTracker::Impl::reliability(double variance)
{
  return steadyVariance / (steadyVariance + variance);
}

// How well the cues agree with the pose, each as a share of what it had in the trusted frames before. Points count only
// where there is nothing else: those of what hides the object agree with a wrong pose.
double vpMbMultiCueTracker::explainedShare()
{
  Impl &impl = *m_impl;
  Agreement &agreement = impl.agreement;
  double sum = 0.;
  double cues = 0.;
  const auto add = [&](double value, double usual, double weight) {
    sum += weight * std::min(impl.shareOf(value, usual), mostOfOne);
    cues += weight;
  };
  if (impl.uses(EDGE_TRACKER)) {
    agreement.edges = edgeAgreement();
    add(agreement.edges, impl.usual.edges, impl.reliability(impl.unsteadiness.edges));
  }
  if (impl.uses(COLOR_TRACKER) && !impl.color.settings().scales.empty()) {
    agreement.color = impl.color.evidenceAt(m_cMo);
    add(agreement.color, impl.usual.color, impl.reliability(impl.unsteadiness.color));
  }
  const vpSurfaceMemory::Agreement surface = impl.surface.agreement(m_cMo);
  agreement.surface = surface.correlation;
  agreement.surfaceKnown = surface.known;
  agreement.surfaceWeight = vpSurfaceTrust(surface.texture) * surface.known;
  if (impl.usual.surface > 0.) {
    add(std::max(surface.correlation, 0.), impl.usual.surface,
        agreement.surfaceWeight * impl.reliability(impl.unsteadiness.surface));
  }
  if (impl.uses(KLT_TRACKER) && !(cues > 0.)) {
    agreement.points = pointAgreement();
    add(agreement.points, impl.usual.points, 1.);
  }
  return cues > 0. ? sum / cues : 0.;
}

void vpMbMultiCueTracker::learnUsual()
{
  Impl &impl = *m_impl;
  const auto learn = [&impl](double value, double &usual, double &unsteadiness) {
    if (usual > 0.) {
      const double off = std::min(impl.shareOf(value, usual), mostOfOne) - 1.;
      unsteadiness += unsteadinessRate * (off * off - unsteadiness);
    }
    const double rate = usual > 0. ? (value > usual ? usualRiseRate : usualFallRate) : 1.;
    usual += rate * (value - usual);
  };
  learn(impl.agreement.edges, impl.usual.edges, impl.unsteadiness.edges);
  learn(impl.agreement.color, impl.usual.color, impl.unsteadiness.color);
  learn(impl.agreement.points, impl.usual.points, impl.unsteadiness.points);
  if (impl.agreement.surfaceWeight > leastTexture) {
    learn(impl.agreement.surface, impl.usual.surface, impl.unsteadiness.surface);
  }
}

// Keeps the pose where it explains more than the best one before. \return True where that is enough.
bool vpMbMultiCueTracker::takeAttempt(bool estimated)
{
  Impl &impl = *m_impl;
  const double share = estimated ? explainedShare() : -1.;
  if (estimated) {
    impl.attempted.push_back(m_cMo);
  }
  double value = share - farPenalty * impl.surpriseAt(m_cMo);
  if (impl.mustConfirm) {
    // What was never seen is no evidence for a pose. Half a turn of a symmetric object explains as much: the one nearer
    // to the last trusted pose is likelier.
    const double unknown = vpSurfaceTrust(impl.surface.texture()) * (1. - impl.agreement.surfaceKnown);
    value = (2. * share + unknown * vpUnknownCorrelation) / (2. + unknown) - changePenalty * impl.changeSince(m_cMo);
    // The pose of the frame before, followed to this one, has explained two images.
    value += impl.attempted.size() == 1 && impl.state != vpTrackingState::LOST ? followedBonus : 0.;
  }
  impl.bestIsLast = estimated && value > impl.bestValue;
  if (impl.bestIsLast) {
    impl.bestValue = value;
    impl.bestExplained = share;
    impl.bestPose = m_cMo;
    impl.bestUsesPoints = impl.usesPoints;
  }
  if (impl.mustConfirm) {
    return impl.bestExplained >= wellExplained && impl.bestIsLast && isDecisive();
  }
  return std::min(impl.bestExplained, impl.bestValue + toleratedPenalty) >= wellExplained;
}

// The image shows something else than what is remembered of the surface.
bool vpMbMultiCueTracker::isContradicted() const
{
  const Impl &impl = *m_impl;
  return impl.agreement.surfaceWeight > leastTexture &&
         impl.agreement.surface < contradictingSurface * impl.usual.surface;
}

// After a loss: no other pose looks like this one.
bool vpMbMultiCueTracker::isDecisive() const
{
  const Impl &impl = *m_impl;
  if (impl.surface.texture() < leastTexture) {
    return impl.confirmations > 0;
  }
  return impl.agreement.surfaceWeight > leastTexture && impl.agreement.surface > decisiveSurface * impl.usual.surface;
}

// Starts elsewhere, where the image does not look as it should at the pose that was found.
void vpMbMultiCueTracker::tryOthers(const vpCueFrame &frame)
{
  Impl &impl = *m_impl;
  impl.usesPoints = false;
  impl.edges.reset(); // A jump of the light changes all contrasts at once.
  // Colours mislead where much of the object looks like what is behind it.
  m_cMo = impl.expectedPose;
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
  } else if (impl.bestExplained < badlyExplained) {
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
    updateView(frame, m_cMo, 0.);
    if (impl.uses(COLOR_TRACKER)) {
      estimateByCoarseColors(frame);
    }
    if (takeAttempt(refineFused(frame))) {
      return;
    }
  }
}

bool vpMbMultiCueTracker::estimateFused(const vpCueFrame &frame)
{
  Impl &impl = *m_impl;
  impl.attempted.clear();
  impl.bestExplained = -1.;
  impl.bestValue = -2.;
  impl.surface.setFrame(frame);
  estimateCoarse(frame);
  bool isEnough = takeAttempt(refineFused(frame));
  if (impl.rough.hasHint) {
    isEnough = tryHint(frame) || isEnough;
  }
  if (!isEnough && impl.mustConfirm) {
    impl.usesPoints = false;
    searchEverywhere(frame);
  } else if (!isEnough) {
    tryOthers(frame);
  }
  if (impl.bestExplained < 0.) {
    return false;
  }
  if (!impl.bestIsLast) {
    m_cMo = impl.bestPose;
    impl.usesPoints = impl.bestUsesPoints;
    if (!refineFused(frame)) {
      return false;
    }
    explainedShare();
  }
  return true;
}

END_VISP_NAMESPACE
