// SPDX-License-Identifier: GPL-2.0-or-later
#include <visp3/multicue/vpMbMultiCueTracker.h>

#include "motion/vpEvenMotion.h"
#include "tracker/vpTrackerState.h"

#include <algorithm>

BEGIN_VISP_NAMESPACE

namespace {
// Frames in vain after which older knowledge is tried, and those that each is tried for, in turn with the newest.
const unsigned int framesWithNewest = 20;
const unsigned int framesWithOther = 10;
// An object that was trusted in fewer frames until it was lost again was something else, perhaps.
const unsigned int fewTrusted = 10;
// Of what is usual: a drift mostly explains less, or moves as the object did not.
const double worthKeeping = 0.8;
// Frames from one that explained so much to a loss that came at once, at a right pose.
const double mostSudden = 5.5;
const double halfWay = 0.5; // An object that went on while it was hidden may have slowed down.
} // namespace

void vpMbMultiCueTracker::Impl::noteLoss()
{
  if (mustConfirm) {
    return;
  }
  mustConfirm = true;
  endTwins();
  farDeviation = mostFarDeviation;
  framesSinceLoss = 0;
  trustedBefore.reset();
  wasSudden = time - lastExplained < mostSudden * frameInterval;
}

void vpMbMultiCueTracker::Impl::noteFound(const vpHomogeneousMatrix &cMo)
{
  mustConfirm = false;
  wasFound = true;
  trustedFrames = 0;
  doubtfulFrames = 0;
  disbelievedFrames = 0;
  searched.clear();
  if (trustedBefore) {
    past.settle();
  }
  startProof();
  startTwins(cMo);
  forgetMotion();
}

// After a trusted frame.
void vpMbMultiCueTracker::Impl::keepLearnt()
{
  if (!searches || best.value < worthKeeping) {
    return;
  }
  lastExplained = time;
  if (past.count()) {
    learnTurnEffect();
    past.keep(std::make_shared<const Learnt>(Learnt{color.reference(), surface.reference(), usual, trusted, period}));
  }
}

// \return Which knowledge to look for the object with from this frame on, see vpPastKnowledge; none: as before.
std::optional<unsigned int> vpMbMultiCueTracker::Impl::levelToRecall() const
{
  if (framesSinceLoss == 1) {
    return 0U;
  }
  const bool isDue = framesSinceLoss > framesWithNewest && (framesSinceLoss - 1) % framesWithOther == 0;
  if (!isDue || confirmations > 0) {
    return std::nullopt;
  }
  const unsigned int change = (framesSinceLoss - 1 - framesWithNewest) / framesWithOther;
  return change % 2 == 0 ? change / 2 + 1 : 0U;
}

// At the start of a frame after a loss: the last one's results are of what was learnt then. How steady the cues are is
// not forgotten: it takes long to be known, and a drift changes it little.
void vpMbMultiCueTracker::Impl::recallLearnt()
{
  ++framesSinceLoss;
  const std::optional<unsigned int> level = levelToRecall();
  const bool isUnproven = framesSinceLoss == 1 && proof.isOpen;
  if (isUnproven) {
    forgetPeriod();
  }
  const std::shared_ptr<const Learnt> *recalled = level ? past.recall(*level) : nullptr;
  if (recalled == nullptr && isUnproven) {
    recalled = &proof.known;
  }
  if (recalled == nullptr) {
    return;
  }
  recall(**recalled);
  trustedBefore = (*recalled)->trusted;
  if (*level > 0 || (wasFound && trustedFrames < fewTrusted)) {
    keyframes.reset();
  }
  searched.clear();
}

// What was learnt since the object was found may be of a wrong pose.
void vpMbMultiCueTracker::Impl::forgetPeriod()
{
  past.dropNewest([this](const std::shared_ptr<const Learnt> &learnt) { return learnt->period == period; });
}

void vpMbMultiCueTracker::Impl::recall(const Learnt &learnt)
{
  color.setReference(learnt.color);
  surface.setReference(learnt.surface);
  usual = learnt.usual;
}

// Where the object is if it went on as it moved when it was trusted. \param share Of the way that it would have gone.
vpHomogeneousMatrix vpMbMultiCueTracker::Impl::movedOn(const Trusted &from, double share) const
{
  const double gone = std::min(time - from.time, kalman.settings().longestGap);
  return vpEvenMotion(from.cMo, from.velocity, model->centre(), share * gone);
}

std::array<vpHomogeneousMatrix, 3> vpMbMultiCueTracker::Impl::whereaboutsOf(const Trusted &from) const
{
  return {{from.cMo, movedOn(from, 1.), movedOn(from, halfWay)}};
}

std::vector<vpHomogeneousMatrix> vpMbMultiCueTracker::Impl::whereabouts() const
{
  std::vector<vpHomogeneousMatrix> poses;
  if (proof.hasFailed) { // The last pose was mistaken for one that looks much alike.
    poses = halfTurns.turned(trusted.cMo);
  } else {
    const std::array<vpHomogeneousMatrix, 3> last = whereaboutsOf(trusted);
    poses.assign(last.begin(), last.end());
  }
  if (trustedBefore) {
    const std::array<vpHomogeneousMatrix, 3> before = whereaboutsOf(*trustedBefore);
    poses.insert(poses.end(), before.begin(), before.end());
  }
  return poses;
}

// Either of them in two searches on end, one by colours and one by edges. Of an object that was lost at once the last
// one is right, most likely.
const vpMbMultiCueTracker::Impl::Trusted &vpMbMultiCueTracker::Impl::searchOrigin() const
{
  const bool isDoubtful = trustedBefore && (!wasSudden || framesSinceLoss > framesWithNewest);
  return isDoubtful && (framesSinceLoss - 1) / 2 % 2 == 1 ? *trustedBefore : trusted;
}

END_VISP_NAMESPACE
