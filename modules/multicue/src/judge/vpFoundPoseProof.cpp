// SPDX-License-Identifier: GPL-2.0-or-later
#include "judge/vpFoundPoseProof.h"

#include "motion/vpTurnBetween.h"

#include <algorithm>
#include <utility>

BEGIN_VISP_NAMESPACE

namespace {
// Share of the surface that has to be known to contradict a pose that is followed: a single side that was seen at a
// slant before may look different at the right one.
const double knownToDisprove = 0.5;
// Of the usual agreement, above which a frame proves a pose.
const double proving = 0.7;
const unsigned int neededProofs = 3;
const unsigned int neededDisproofs = 5;
const unsigned int framesOfProof = 60; // Trusted ones; the light may change in a longer time.
// Logarithm of the odds for one share of the surface's usual agreement, about this one.
const double gainOfSurface = 4.;
const double neutralSurface = 0.5;
} // namespace

void vpFoundPoseProof::start(std::shared_ptr<const vpObjectKnowledge::Learnt> known, bool hasTexture)
{
  *this = vpFoundPoseProof();
  m_known = std::move(known);
  m_isOpen = hasTexture;
}

bool vpFoundPoseProof::disproves(const vpHomogeneousMatrix &cMo, const vpObjectKnowledge &knowledge)
{
  if (!m_isOpen) {
    return false;
  }
  const vpSurfaceMemory::Agreement seen = knowledge.surface.agreement(cMo, m_known->surface);
  const double weight = vpObjectKnowledge::weightOf(seen);
  const double variance = knowledge.surfaceVariance(vpTurnBetween(m_known->trusted.cMo, cMo));
  const bool contradicts = knowledge.isRefutedBy(seen, variance) && weight > knownToDisprove;
  m_contradictions = contradicts ? m_contradictions + 1 : 0;
  if (m_contradictions >= neededDisproofs) {
    m_hasFailed = true;
    return true;
  }
  if (weight > vpObjectKnowledge::leastTexture) {
    const bool proves = vpObjectKnowledge::countedShare(seen.correlation, knowledge.usual.surface) > proving;
    m_agreeing += proves ? 1 : 0;
    m_undecided += vpObjectKnowledge::tellsNothing(variance) ? 1U : 0U;
  }
  if (std::max(m_agreeing, m_undecided) >= neededProofs) {
    m_isOpen = false;
  }
  return false;
}

double vpFoundPoseProof::surfaceEvidence(const vpHomogeneousMatrix &cMo, const vpObjectKnowledge &knowledge) const
{
  if (!(knowledge.usual.surface > 0.)) {
    return 0.;
  }
  const vpSurfaceMemory::Agreement seen = knowledge.surface.agreement(cMo, m_known->surface);
  const double variance = knowledge.surfaceVariance(vpTurnBetween(m_known->trusted.cMo, cMo));
  const double share = std::min(vpObjectKnowledge::countedShare(seen.correlation, m_known->usual.surface), 1.);
  return gainOfSurface * vpObjectKnowledge::weightOf(seen) * vpObjectKnowledge::reliability(variance) *
         (share - neutralSurface);
}

double vpFoundPoseProof::fallRateOfUsual(unsigned int trustedFrames) const
{
  return m_isOpen && trustedFrames < framesOfProof ? 0. : vpObjectKnowledge::fallRate;
}

END_VISP_NAMESPACE
