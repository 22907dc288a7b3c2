// SPDX-License-Identifier: GPL-2.0-or-later
#include <visp3/multicue/vpMbMultiCueTracker.h>

#include "tracker/vpTrackerState.h"

#include <algorithm>
#include <cmath>

BEGIN_VISP_NAMESPACE

namespace {
// An edge or a point that is farther away than this does not support a pose, pixels.
const double edgeReach = 2.5;
const double pointReach = 2.;
// Points on the surface count this much beside the other cues once this many of them are followed, from this number on;
// and what they have at a right pose.
const double besideOthers = 0.6;
const std::size_t enoughPoints = 24;
const std::size_t fewestPoints = 8;
const double usualOfPoints = 0.9;
// One cue alone does not make a pose better than those before, nor refuse it.
const double mostOfOne = 1.2;
const double leastOfOne = -0.5;
const double shareOfStart = 0.8;
const double usualOfSurface = 0.6; // Of one that was seen once.
const double steadyVariance = 0.15 * 0.15;
const double leastReliability = 0.2; // Of a cue whose agreement comes and goes.
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
// Slower down than up: a wrong pose explains less, and must not become the usual one.
const double usualRiseRate = 0.1;
const double usualFallRate = 0.02;
const unsigned int framesOfProof = 60; // Trusted ones; the light may change in a longer time.
const double usualCountRate = 0.1;
const double nearerRate = 0.1; // Of the distance to the image's edges; the slow one above where it grows.
const double unsteadinessRate = 0.05;

// Of what is usual, less what any pose has of it.
double beyondChance(double share, double byChance)
{
  return std::max(share - byChance, 0.) / (1. - byChance);
}

// 1 for a distance of 0, falling to 0 at the reach.
double closeness(double distance, double reach)
{
  const double share = distance / reach;
  return std::max(0., 1. - share * share);
}
} // namespace

double vpMbMultiCueTracker::edgeAgreement() const
{
  return m_impl->edges.agreement(m_cMo, edgeReach);
}

// How well the distance map agrees with the pose, as a share of what it had in trusted frames. Beside the matches,
// which clutter has for nearly every pose, it tells wrong poses: on rendered sequences with edges alone, right ones had
// 0.8 to 1.1 of it in 96 % of the frames, and wrong ones less than 0.8 in half of theirs.
double vpMbMultiCueTracker::mapShare()
{
  Impl &impl = *m_impl;
  const vpPoseScore::Value value = impl.poseScore(m_cMo);
  impl.agreement.mapDistance = value.isSeen ? value.distance : 1.;
  return beyondChance(Impl::countedShare(1. - impl.agreement.mapDistance, 1. - impl.usual.mapDistance), mapByChance);
}

void vpMbMultiCueTracker::lookAtEdges()
{
  m_impl->agreement.edges = edgeAgreement();
  m_impl->agreement.edgeCount = static_cast<double>(m_impl->edges.matches().size());
}

double vpMbMultiCueTracker::Impl::agreeingPoints(const vpHomogeneousMatrix &cMo, std::size_t &followed)
{
  points->residuals(cMo, block);
  double sum = 0.;
  for (std::size_t i = 0; i + 1 < block.rows.size(); i += 2) {
    const double distance = std::hypot(block.rows[i].error, block.rows[i + 1].error);
    sum += closeness(distance, pointReach / frameCamera.get_px());
  }
  followed = block.rows.size() / 2;
  return sum;
}

double vpMbMultiCueTracker::pointAgreement() const
{
  const std::size_t searched = m_impl->points->matches().size();
  std::size_t followed = 0;
  return searched == 0 ? 0. : m_impl->agreeingPoints(m_cMo, followed) / static_cast<double>(searched);
}

// While the object is followed: points that agreed with trusted poses do not slide along an edge, as other cues may do.
// Their share is that of those which were found again, for what hides the object, or turns away, is not their fault.
vpMbMultiCueTracker::Impl::Share vpMbMultiCueTracker::Impl::shareOfPoints(const vpHomogeneousMatrix &cMo)
{
  std::size_t followed = 0;
  const double agreeing = agreeingPoints(cMo, followed);
  if (followed <= fewestPoints) {
    return {};
  }
  const double share = agreeing / (usualOfPoints * static_cast<double>(followed));
  const double number = static_cast<double>(followed - fewestPoints) / static_cast<double>(enoughPoints - fewestPoints);
  const double weight = besideOthers * std::min(number, 1.);
  return {weight * std::min(share, mostOfOne), weight};
}

double vpMbMultiCueTracker::Impl::countedShare(double value, double usual)
{
  return std::min(std::max(value / std::max(usual, leastUsual), leastOfOne), mostOfOne);
}

// How much a cue counts whose agreement with trusted poses has this variance, in shares of the usual one: 1 for one
// that is steady. Colours that come and go with the light on the object say little.
double vpMbMultiCueTracker::Impl::reliability(double variance)
{
  return std::max(steadyVariance / (steadyVariance + variance), leastReliability);
}

// How much colours or surface count whose agreement has this variance.
double vpMbMultiCueTracker::Impl::weightBesideEdges(double variance) const
{
  if (!mustConfirm) {
    return besideEdges * reliability(variance);
  }
  const double fixed = fixedVariance / (fixedVariance + variance);
  return (leastBesideEdges + (1. - leastBesideEdges) * fixed * fixed) * reliability(variance);
}

// While the object is followed: all other cues were learnt at its poses, and agree with one that slid off unnoticed.
double vpMbMultiCueTracker::Impl::mostBesideEdges() const
{
  const bool tells = uses(EDGE_TRACKER) && usual.edges > leastUsual;
  return tells && !mustConfirm ? agreement.edges / usual.edges + aboveEdges : HUGE_VAL;
}

// How well the cues agree with the pose, each as a share of what it had in the trusted frames before. After a loss
// points count only where there is nothing else: those of what hid the object agree with a wrong pose.
double vpMbMultiCueTracker::explainedShare()
{
  Impl &impl = *m_impl;
  Agreement &agreement = impl.agreement;
  double sum = 0.;
  double cues = 0.;
  const auto add = [&](double share, double weight) {
    sum += weight * share;
    cues += weight;
  };
  if (impl.uses(EDGE_TRACKER)) {
    lookAtEdges();
    const double share = impl.countedShare(agreement.edges, impl.usual.edges);
    const double matched = beyondChance(share, edgesByChance);
    const bool isAlone = impl.type == EDGE_TRACKER;
    add(isAlone ? 0.5 * (matched + mapShare()) : matched, impl.reliability(impl.unsteadiness.edges));
  }
  if (impl.uses(COLOR_TRACKER) && !impl.color.settings().scales.empty()) {
    agreement.color = impl.color.evidenceAt(m_cMo);
    add(impl.countedShare(std::max(agreement.color, 0.), impl.usual.color),
        impl.weightBesideEdges(impl.unsteadiness.color));
  }
  const vpSurfaceMemory::Agreement surface = impl.surface.agreement(m_cMo);
  agreement.surface = surface.correlation;
  agreement.surfaceKnown = surface.known;
  agreement.surfaceWeight = impl.weightOf(surface);
  agreement.isRefuted = impl.mustConfirm && impl.usual.surface > 0. &&
                        impl.isRefutedBy(surface, impl.surfaceVariance(impl.turnSince(m_cMo)));
  if (impl.usual.surface > 0.) {
    add(impl.countedShare(std::max(surface.correlation, 0.), impl.usual.surface),
        agreement.surfaceWeight * impl.weightBesideEdges(impl.unsteadiness.surface));
  }
  if (impl.uses(KLT_TRACKER) && !(cues > 0.)) {
    agreement.points = pointAgreement();
    add(impl.countedShare(agreement.points, impl.usual.points), 1.);
  } else if (impl.uses(KLT_TRACKER) && !impl.mustConfirm) {
    const Impl::Share points = impl.shareOfPoints(m_cMo);
    sum += points.sum;
    cues += points.cues;
  }
  impl.share = {sum, cues, impl.mostBesideEdges()};
  return impl.explainedBy(impl.share, m_cMo);
}

// What the start shows of itself is more than other images show of the object.
void vpMbMultiCueTracker::learnUsualOfStart(const vpCueFrame &frame)
{
  Impl &impl = *m_impl;
  if (impl.uses(EDGE_TRACKER)) {
    impl.edges.match(frame, *impl.view);
    impl.usual.edges = shareOfStart * edgeAgreement();
    impl.usual.evidence = shareOfStart * (impl.edges.evidence(m_cMo) - Impl::evidenceByChance) + Impl::evidenceByChance;
    impl.usual.edgeCount = static_cast<double>(impl.edges.matches().size());
  }
  if (impl.type == EDGE_TRACKER && impl.searches) {
    impl.scoreFrame(frame);
    mapShare();
    impl.usual.mapDistance = impl.agreement.mapDistance;
  }
  if (impl.uses(COLOR_TRACKER) && !impl.color.settings().scales.empty()) {
    impl.usual.color = shareOfStart * impl.color.evidenceAt(m_cMo);
  }
  if (impl.surface.texture() > Impl::leastTexture) {
    impl.usual.surface = usualOfSurface;
    impl.unsteadiness.surface = steadyVariance; // It may look different in the next image.
  }
}

// How fast less agreement becomes the usual one. Not at all after a loss until the found pose is proved, or was
// followed for long: a wrong one that explains less would lower what it is measured by, and be believed for that.
double vpMbMultiCueTracker::Impl::fallRateOfUsual() const
{
  return proof.isOpen && trustedFrames < framesOfProof ? 0. : usualFallRate;
}

void vpMbMultiCueTracker::learnUsual()
{
  Impl &impl = *m_impl;
  const double fallRate = impl.fallRateOfUsual();
  const auto learn = [&impl, fallRate](double value, double &usual, double &unsteadiness) {
    if (usual > 0.) {
      const double off = impl.countedShare(value, usual) - 1.;
      unsteadiness += unsteadinessRate * (off * off - unsteadiness);
    }
    const double rate = usual > 0. ? (value > usual ? usualRiseRate : fallRate) : 1.;
    usual += rate * (value - usual);
  };
  impl.usual.edgeCount += usualCountRate * (impl.agreement.edgeCount - impl.usual.edgeCount);
  // The first frame that is followed tells more than the start, where nothing was remembered of the edges yet.
  const double clearer = impl.agreement.evidence - impl.usual.evidence;
  impl.usual.evidence += (impl.trustedFrames == 1 ? 1. : (clearer > 0. ? usualRiseRate : fallRate)) * clearer;
  const double farther = impl.agreement.mapDistance - impl.usual.mapDistance;
  impl.usual.mapDistance += (farther > 0. ? fallRate : nearerRate) * farther;
  learn(impl.agreement.edges, impl.usual.edges, impl.unsteadiness.edges);
  learn(impl.agreement.color, impl.usual.color, impl.unsteadiness.color);
  learn(impl.agreement.points, impl.usual.points, impl.unsteadiness.points);
  if (impl.agreement.surfaceWeight > Impl::leastTexture) {
    learn(impl.agreement.surface, impl.usual.surface, impl.unsteadiness.surface);
  }
}

END_VISP_NAMESPACE
