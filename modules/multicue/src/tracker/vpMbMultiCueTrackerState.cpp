// SPDX-License-Identifier: GPL-2.0-or-later
#include <visp3/multicue/vpMbMultiCueTracker.h>

#include "tracker/vpTrackerState.h"

#include <visp3/core/vpTrackingException.h>

#include <algorithm>

BEGIN_VISP_NAMESPACE

namespace {
// Frames on end that have to explain a pose after a loss.
const unsigned int neededConfirmations = 3;
const unsigned int usualConfirmations = 6;
const unsigned int disownedConfirmations = 60; // Where edges alone speak for a pose.
const unsigned int doubtfulConfirmations = 15; // Where the surface looks like that of another pose.
// Frames on end in which no other pose came near, whatever is explained.
const unsigned int neededAhead = 6;
// An object that left the image for so many frames on end may come back anywhere; one that the image does not explain
// is followed for longer, since light and what is in front of it change more often than it jumps. Where a pose far
// off is all that explains it, the object is lost at once.
const unsigned int mostOutside = 3;
const unsigned int mostDoubtful = 30;
const unsigned int mostDoubtfulByEdges = 3; // Edges alone lead from one wrong pose to the next.
const double leastInside = 0.3;             // Share of the outline that is in the image.
// TRACKING is said from the one on, and as long as the other is not fallen short of.
const double trustedBelief = 0.85;
const double keptBelief = 0.7;
// A pose that is believed less than this for so many frames on end is lost: others farther off are looked for while the
// object is still near.
const double leastBelief = 0.6;
const unsigned int mostDisbelieved = 2;
// Logarithm of the factor between distances: one that changed by more needs a surface that agrees.
const double mostDepthChange = 0.5;
const double mostLead = 0.25; // That counts, of what a pose explains more than others.
// Fewer points than this happen to agree anywhere.
const unsigned int fewestGood = 8;
} // namespace

void vpMbMultiCueTracker::judge(bool estimated)
{
  Impl &impl = *m_impl;
  impl.countSupport(estimated);
  const double needed = impl.goodRatio * impl.expected;
  if (impl.good < fewestGood || impl.good < 0.5 * needed) {
    impl.state = vpTrackingState::LOST;
    impl.outcome = impl.good == 0 ? vpMbTrackingResult::Reason::NOTHING_SEEN : vpMbTrackingResult::Reason::FEW_FEATURES;
  } else {
    impl.state = impl.good < needed ? vpTrackingState::UNCERTAIN : vpTrackingState::TRACKING;
    if (impl.comparesAttempts()) {
      impl.state = impl.stateOf(impl.best.explained);
    }
    impl.outcome = impl.outcomeOf(impl.state);
  }
  impl.isJudged = true;
  impl.reason = std::to_string(impl.good) + " of " + std::to_string(impl.expected) + " features support the pose";
}

vpTrackingState vpMbMultiCueTracker::getTrackingState() const
{
  return m_impl->state;
}

double vpMbMultiCueTracker::getSupport() const
{
  return m_impl->support();
}

const vpTrackingTimings &vpMbMultiCueTracker::getTimings() const
{
  return m_impl->timings;
}

void vpMbMultiCueTracker::testTracking()
{
  if (m_impl->state == vpTrackingState::LOST) {
    throw vpTrackingException(vpTrackingException::fatalError, "The object is lost: " + m_impl->reason);
  }
}

void vpMbMultiCueTracker::setThrowOnLoss(bool flag)
{
  m_impl->throwOnLoss = flag;
}

// A pose is not trusted while hardly any of the object is in the image, nor after a loss before the next frames confirm
// it.
void vpMbMultiCueTracker::confirm()
{
  Impl &impl = *m_impl;
  if (!impl.searches) {
    return;
  }
  const vpTrackingState stateBefore = impl.state;
  confirmState();
  if (impl.state != stateBefore) {
    impl.outcome = impl.state == vpTrackingState::LOST ? vpMbTrackingResult::Reason::CONTRADICTED
                                                       : vpMbTrackingResult::Reason::CONFIRMING;
  }
}

// How the pose came about, and what it explained in the frames before, count beside this image.
void vpMbMultiCueTracker::believe()
{
  Impl &impl = *m_impl;
  if (impl.state == vpTrackingState::LOST) {
    impl.belief.lose();
    return;
  }
  if (impl.mustConfirm) {
    impl.belief.doubt();
    const double lead = std::min(std::max(impl.tracks.lead(), 0.), mostLead);
    impl.belief.update(impl.surpriseAt(m_cMo), impl.best.explained + lead);
  } else {
    impl.belief.updateFollowed(impl.surpriseAt(m_cMo), impl.best.explained);
  }
  impl.disbelievedFrames = impl.belief.probability() < leastBelief ? impl.disbelievedFrames + 1 : 0;
  if (impl.searches && impl.disbelievedFrames >= mostDisbelieved) {
    impl.noteLoss();
  }
  const double needed = impl.wasTracking ? keptBelief : trustedBelief;
  const bool isBelieved = !impl.searches || impl.believed() >= needed;
  if (impl.state == vpTrackingState::TRACKING && !isBelieved) {
    impl.state = vpTrackingState::UNCERTAIN;
    impl.outcome = vpMbTrackingResult::Reason::CONFIRMING;
  }
}

void vpMbMultiCueTracker::confirmState()
{
  Impl &impl = *m_impl;
  if (impl.state == vpTrackingState::LOST) {
    impl.confirmations = 0;
    impl.noteLoss();
    return;
  }
  if (!impl.mustConfirm && impl.isDisproved(m_cMo)) {
    impl.confirmations = 0;
    impl.noteLoss();
    impl.state = vpTrackingState::LOST;
    return;
  }
  const double inside = impl.insideShare(m_cMo);
  const unsigned int mostDoubt = impl.comparesAttempts() ? mostDoubtful : mostDoubtfulByEdges;
  const bool isExplained = impl.state == vpTrackingState::TRACKING;
  impl.outsideFrames = inside < leastInside ? impl.outsideFrames + 1 : 0;
  impl.doubtfulFrames = isExplained ? 0 : impl.doubtfulFrames + 1;
  if (impl.outsideFrames >= mostOutside || impl.doubtfulFrames >= mostDoubt || impl.best.isFar) {
    impl.noteLoss();
  }
  if (inside < leastInside) {
    impl.state = vpTrackingState::UNCERTAIN;
  }
  if (!impl.mustConfirm) {
    return;
  }
  const bool confirms =
      isExplained && inside >= Impl::insideToConfirm && impl.best.explained >= vpPoseTracks::confirming;
  impl.confirmations = confirms ? impl.confirmations + 1 : 0;
  if (isConfirmed(inside)) {
    impl.noteFound(m_cMo);
  } else {
    impl.state = vpTrackingState::UNCERTAIN;
  }
}

// By frames on end that explain the pose, or by others that were looked for in vain; not before others were looked for.
bool vpMbMultiCueTracker::isConfirmed(double inside) const
{
  const Impl &impl = *m_impl;
  // A small pose far away fits into many a part of what the image shows.
  const bool isElsewhere = impl.depthChange(m_cMo) > mostDepthChange;
  const bool hasTexture = impl.type != EDGE_TRACKER && impl.surface.texture() > Impl::leastTexture;
  if (!impl.tracks.isCompared() || (isElsewhere && !(hasTexture && isDecisive()))) {
    return false;
  }
  // Of two poses that only show sides which were never seen, nothing tells the right one until another side is seen.
  const bool isUnknown = hasTexture && impl.agreement.surfaceWeight < Impl::leastTexture;
  if (impl.isDisowned() || impl.agreement.isRefuted || (isUnknown && impl.tracks.isContested())) {
    return impl.confirmations >= disownedConfirmations;
  }
  if (inside >= Impl::insideToConfirm && impl.tracks.ahead() >= neededAhead) {
    return true;
  }
  const bool isDoubtful = impl.tracks.isContested() || isContradicted();
  return impl.confirmations >=
         (isDoubtful ? doubtfulConfirmations : (isDecisive() ? neededConfirmations : usualConfirmations));
}

END_VISP_NAMESPACE
