// SPDX-License-Identifier: GPL-2.0-or-later
#include "judge/vpConfirmation.h"

BEGIN_VISP_NAMESPACE

namespace {
// Frames on end that have to explain a pose after a loss.
const unsigned int neededConfirmations = 6;
const unsigned int disownedConfirmations = 60; // Where edges alone speak for a pose.
const unsigned int doubtfulConfirmations = 15; // Where the surface looks like that of another pose.
// Frames on end in which no other pose came near, whatever is explained.
const unsigned int neededAhead = 6;
// Logarithm of the factor between distances: one that changed by more needs a surface that agrees.
const double mostDepthChange = 0.5;
} // namespace

bool vpConfirmation::isDue(const vpHomogeneousMatrix &cMo, const vpAgreement &agreement, double inside) const
{
  const vpPoseTracks &tracks = m_situation.tracks;
  // A small pose far away fits into many a part of what the image shows.
  const bool isElsewhere = m_whereabouts.depthChange(cMo) > mostDepthChange;
  const bool hasTexture = !m_cues.isEdgesAlone() && m_knowledge.hasTexture();
  if (!tracks.isCompared() || (isElsewhere && !(hasTexture && m_judge.isDecisive(agreement)))) {
    return false;
  }
  // Of two poses that only show sides which were never seen, nothing tells the right one until another side is seen.
  const bool isUnknown = hasTexture && agreement.surfaceWeight < vpObjectKnowledge::leastTexture;
  if (m_judge.isDisowned(agreement) || agreement.isRefuted || (isUnknown && tracks.isContested())) {
    return m_situation.confirmations >= disownedConfirmations;
  }
  if (inside >= vpImageScore::insideToConfirm && tracks.ahead() >= neededAhead) {
    return true;
  }
  const bool isDoubtful = tracks.isContested() || m_judge.isContradicted(agreement);
  return m_situation.confirmations >= (isDoubtful ? doubtfulConfirmations : neededConfirmations);
}

END_VISP_NAMESPACE
