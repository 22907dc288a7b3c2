// SPDX-License-Identifier: GPL-2.0-or-later
#include <visp3/multicue/vpMbMultiCueTracker.h>

#include "tracker/vpTrackerState.h"
#include "motion/vpTurnBetween.h"

#include <algorithm>
#include <utility>
#include <vector>

BEGIN_VISP_NAMESPACE

namespace {
const double leastTurn = 0.25; // Radians, to tell its effect by.
// Share of the surface that has to be known to contradict a pose; and one that is followed: a single side that was seen
// at a slant before may look different at the right one.
const double leastKnown = 0.3;
const double knownToDisprove = 0.5;
// Of the usual agreement: above the first a frame proves a pose, below the second it may contradict it.
const double proving = 0.7;
const double contradicting = 0.35;
const double contradictingDistance = 6.; // Squared, in deviations.
const unsigned int neededProofs = 3;
const unsigned int neededDisproofs = 5;
} // namespace

double vpMbMultiCueTracker::Impl::turnSince(const vpHomogeneousMatrix &cMo) const
{
  double least = vpTurnBetween(trustedBefore ? trustedBefore->cMo : trusted.cMo, cMo);
  past.forEachOld([&](const std::shared_ptr<const Learnt> &learnt) {
    least = std::min(least, vpTurnBetween(learnt->trusted.cMo, cMo));
  });
  return least;
}

bool vpMbMultiCueTracker::Impl::isRefutedBy(const vpSurfaceMemory::Agreement &seen, double variance) const
{
  const double share = countedShare(seen.correlation, usual.surface);
  return weightOf(seen) > leastKnown && share < contradicting &&
         (1. - share) * (1. - share) > contradictingDistance * variance;
}

// In a frame whose pose is trusted, from what was learnt at another orientation; one at a time, to save time.
void vpMbMultiCueTracker::Impl::learnTurnEffect()
{
  if (surface.texture() < leastTexture) {
    return;
  }
  std::vector<std::pair<double, const Learnt *>> turned;
  past.forEachOld([&](const std::shared_ptr<const Learnt> &learnt) {
    const double angle = vpTurnBetween(learnt->trusted.cMo, trusted.cMo);
    if (learnt->period == period && angle > leastTurn) { // Else one of the two poses may be wrong.
      turned.emplace_back(angle, learnt.get());
    }
  });
  if (turned.empty()) {
    return;
  }
  const auto &[angle, learnt] = turned[turns++ % turned.size()];
  const vpSurfaceMemory::Agreement seen = surface.agreement(trusted.cMo, learnt->surface);
  if (weightOf(seen) > leastTexture) {
    const double off = std::min(countedShare(seen.correlation, usual.surface) - 1., 0.);
    turnEffect.observe(angle, off * off - unsteadiness.surface);
  }
}

// After the object was found again.
void vpMbMultiCueTracker::Impl::startProof()
{
  const Trusted &from = trustedBefore ? *trustedBefore : trusted;
  startProof(std::make_shared<const Learnt>(Learnt{color.reference(), surface.reference(), usual, from, period}));
}

void vpMbMultiCueTracker::Impl::startProof(const std::shared_ptr<const Learnt> &known)
{
  proof = {known, surface.texture() > leastTexture};
  ++period;
}

bool vpMbMultiCueTracker::Impl::isDisproved(const vpHomogeneousMatrix &cMo)
{
  if (!proof.isOpen) {
    return false;
  }
  const vpSurfaceMemory::Agreement seen = surface.agreement(cMo, proof.known->surface);
  const double variance = surfaceVariance(vpTurnBetween(proof.known->trusted.cMo, cMo));
  const bool contradicts = isRefutedBy(seen, variance) && weightOf(seen) > knownToDisprove;
  proof.contradictions = contradicts ? proof.contradictions + 1 : 0;
  if (proof.contradictions >= neededDisproofs) {
    proof.hasFailed = true;
    return true;
  }
  if (weightOf(seen) > leastTexture) {
    const bool tellsNothing = (1. - contradicting) * (1. - contradicting) < contradictingDistance * variance;
    const bool proves = countedShare(seen.correlation, usual.surface) > proving;
    proof.agreeing += proves ? 1 : 0;
    proof.undecided += tellsNothing ? 1 : 0;
  }
  if (std::max(proof.agreeing, proof.undecided) >= neededProofs) {
    proof.isOpen = false;
  }
  return false;
}

END_VISP_NAMESPACE
