// SPDX-License-Identifier: GPL-2.0-or-later
#include <visp3/multicue/vpMbMultiCueTracker.h>

#include "tracker/vpTrackerState.h"

BEGIN_VISP_NAMESPACE

namespace {
const std::size_t nearNumber = 80;
const std::size_t scoredNumber = 400; // Where colours do not help, from the near spread and from a wider one each.
const double widerFactor = 1.6;
const std::size_t modeNumber = 10; // Around each mode of the particles.
const std::size_t keptParents = 24;
const std::size_t children = 200;
const unsigned int layers = 3;
const std::size_t mostAttempts = 4;
const double steadyReliability = 0.6; // Of colours, which below it may lead away from the object.

// The best poses after a first alignment, with those that were not to be lost by it.
void keepSettled(vpPoseSearch &search)
{
  search.addCopies();
  search.score();
  search.keepBest(4 * keptParents, {0.04, 0.12, 0.08});
}

// Poses that were aligned are near to what they can become.
void annealSettled(vpPoseSearch &search)
{
  search.score();
  search.anneal({0.05, 0.15, 0.08}, keptParents, children, layers - 1);
}
} // namespace

// One more start. \param byColors Their coarse levels come first, which reach far. \return True where the pose that it
// leads to is enough.
bool vpMbMultiCueTracker::attemptFrom(const vpCueFrame &frame, const vpHomogeneousMatrix &cMo, bool byColors)
{
  Impl &impl = *m_impl;
  m_cMo = impl.nearestAlike(cMo);
  impl.startPose = m_cMo;
  updateView(frame, m_cMo, 0.);
  if (byColors && impl.uses(COLOR_TRACKER)) {
    estimateByCoarseColors(frame);
  }
  return takeAttempt(refineFused(frame));
}

// The likeliest poses around the one that is expected, the best ones estimated with all cues.
void vpMbMultiCueTracker::searchNear(const vpCueFrame &frame)
{
  Impl &impl = *m_impl;
  impl.scoreFrame(frame);
  vpPoseSearch search(impl.poseScore, *impl.model, impl.draws++);
  search.setSymmetries(impl.symmetries.get());
  search.setPrior(impl.expectedPose, vpPoseSearch::near(), vpPoseSearch::usualPrior);
  search.scatter({impl.expectedPose}, vpPoseSearch::near(), nearNumber);
  for (const vpPoseMode &mode : getPoseModes()) { // What the frames before left open.
    search.scatter({mode.cMo}, vpPoseSearch::same(), modeNumber);
  }
  impl.settle(search);
  if (attemptBest(frame, search) || impl.searchBudget.isSpent()) {
    return;
  }
  // Colours led away from the object, or there are none.
  vpPoseSearch again(impl.poseScore, *impl.model, impl.draws++);
  again.setSymmetries(impl.symmetries.get());
  const vpPoseSearch::Spread wider = vpPoseSearch::near().grown(widerFactor);
  again.setPrior(impl.expectedPose, wider, vpPoseSearch::usualPrior);
  again.scatter({impl.expectedPose}, vpPoseSearch::near(), scoredNumber);
  again.scatter({impl.expectedPose}, wider, scoredNumber);
  impl.settleByScore(again);
  attemptBest(frame, again, false);
}

// The best poses of a search, estimated with all cues. \return True where one of them is enough.
bool vpMbMultiCueTracker::attemptBest(const vpCueFrame &frame, vpPoseSearch &search, bool byColors)
{
  search.keepBest(mostAttempts, vpPoseSearch::same());
  bool isEnough = false;
  for (const vpPoseCandidate &candidate : search.candidates()) {
    isEnough = attemptFrom(frame, candidate.cMo, byColors);
    if (isEnough || m_impl->searchBudget.isSpent()) {
      break;
    }
  }
  return isEnough;
}

double vpMbMultiCueTracker::Impl::insideShare(const vpHomogeneousMatrix &cMo)
{
  vpPoseScore outline; // What poseScore looks at stays as it is.
  outline.setSphere(&viewSphere());
  outline.setImage(nullptr, nullptr, nullptr, frameCamera, width, height);
  return outline(cMo).inside;
}

bool vpMbMultiCueTracker::Impl::hasUnsteadyColors() const
{
  return reliability(unsteadiness.color) < steadyReliability;
}

// From poses drawn far and wide to a few that are as good as they can be told from views made beforehand.
void vpMbMultiCueTracker::Impl::settle(vpPoseSearch &search)
{
  if (!uses(COLOR_TRACKER) || !color.histograms().isKnown()) {
    settleByScore(search);
    return;
  }
  if (mustConfirm || hasUnsteadyColors()) {
    search.keepCopies(); // Poses are looked at where they were drawn, too.
  }
  search.alignByColors(aligner, 0.15, 2);
  search.alignByColors(aligner, 0.08, 1);
  keepSettled(search);
  search.alignByColors(aligner, 0.05, 2);
  annealSettled(search);
}

void vpMbMultiCueTracker::Impl::settleByScore(vpPoseSearch &search) const
{
  if (!uses(EDGE_TRACKER)) {
    search.score();
    search.anneal(vpPoseSearch::near(), keptParents, children, layers);
    return;
  }
  search.keepCopies(); // Where edges are many, the nearest ones may lead away from the object's.
  search.alignByEdges(aligner, 3);
  keepSettled(search);
  search.alignByEdges(aligner, 2);
  annealSettled(search);
}

END_VISP_NAMESPACE
