// SPDX-License-Identifier: GPL-2.0-or-later
#include <visp3/multicue/vpMbMultiCueTracker.h>

#include "motion/vpEvenMotion.h"
#include "tracker/vpTrackerState.h"

#include <algorithm>
#include <cmath>

BEGIN_VISP_NAMESPACE

namespace {
// Share of the outline: what is seen of less looks like many poses.
const double insideToCompare = 0.7;
// Of a pose with exp(-1) times the usual number of edges, and the most of them that counts.
const double fewPenalty = 0.2;
const double mostFewPenalty = 0.4;
// Of the object in one frame, its shift in diameters plus its turn in radians: what moves less is found where it was,
// and a pose that jumped farther was corrected, which tells nothing of the next frame.
const double leastMoved = 0.01;
const double mostMoved = 0.4;
// Of a pose that explains more where it was, a pose ahead may as well be its drift.
const double valueToStay = 0.65;
} // namespace

vpPoseTracks::Same vpMbMultiCueTracker::Impl::sameTrack() const
{
  return [this, oMb = centreFrame()](const vpHomogeneousMatrix &c1Mo, const vpHomogeneousMatrix &c2Mo) {
    return rivalDistance(c1Mo * oMb, c2Mo * oMb) < 1.;
  };
}

// The first attempts of a frame go on from where the last one left.
void vpMbMultiCueTracker::Impl::beginTracks(const vpHomogeneousMatrix &cMo)
{
  if (state == vpTrackingState::LOST) {
    tracks.clear();
    return;
  }
  if (tracks.empty()) {
    const vpHomogeneousMatrix before =
        mayCoast() ? vpEvenMotion(cMo, kalman.velocity(), model->centre(), -frameInterval) : cMo;
    tracks.begin(cMo, before, best.explained, belief);
  }
  tracks.follow(0);
}

bool vpMbMultiCueTracker::Impl::mustCompare(const vpHomogeneousMatrix &cMo)
{
  return confirmations > 0 && !tracks.wasCompared() && insideShare(cMo) >= insideToConfirm;
}

// Seen from its edge, an object lies on many a line of the image.
double vpMbMultiCueTracker::Impl::fewEdgesPenalty() const
{
  if (!(usual.edgeCount > 0.)) {
    return 0.;
  }
  const double few = std::log(usual.edgeCount / (agreement.edgeCount + 1.));
  return std::min(std::max(fewPenalty * few, 0.), mostFewPenalty);
}

// What was believed of the best pose of this frame, which may not be the one that was followed.
void vpMbMultiCueTracker::Impl::chooseTrack()
{
  if (!mustConfirm || best.explained < 0.) {
    tracks.clear();
    return;
  }
  const double inside = insideShare(best.cMo);
  const auto seen = inside >= insideToCompare   ? vpPoseTracks::Seen::WELL
                    : inside >= insideToConfirm ? vpPoseTracks::Seen::ENOUGH
                                                : vpPoseTracks::Seen::LITTLE;
  tracks.choose(best.cMo, seen, sameTrack());
  const vpPoseTracks::Track &chosen = tracks.chosen();
  belief = chosen.belief;
  confirmations = chosen.confirmations;
  expectedPose = chosen.before;
}

// The next frame goes on from the pose that this one ended with.
void vpMbMultiCueTracker::Impl::endTracks(const vpHomogeneousMatrix &cMo)
{
  if (!mustConfirm || state == vpTrackingState::LOST) {
    tracks.clear();
    return;
  }
  if (!tracks.empty()) {
    tracks.chosen().cMo = cMo;
    tracks.chosen().belief = belief;
    tracks.chosen().confirmations = confirmations;
  }
}

// After a loss nothing is known of the object's velocity but what the last two frames show. \return True where the pose
// that goes on as it moved from before to cMo leads to one that is enough.
bool vpMbMultiCueTracker::attemptAhead(const vpCueFrame &frame, const vpHomogeneousMatrix &before,
                                       const vpHomogeneousMatrix &cMo)
{
  Impl &impl = *m_impl;
  if (impl.tracks.followedValue() >= valueToStay) {
    return false;
  }
  const vpPoseTangent motion = vpPoseExponential::log(before.inverse() * cMo);
  const Eigen::Vector3d centre = impl.model->centre();
  const Eigen::Vector3d shift = motion.head<3>() + motion.tail<3>().cross(centre);
  const double moved = shift.norm() / impl.model->diameter() + motion.tail<3>().norm();
  if (moved < leastMoved || moved > mostMoved) {
    return false;
  }
  impl.usesPoints = false;
  return attemptFrom(frame, vpEvenMotion(cMo, motion, centre, 1.), false);
}

// After a loss the best pose of the frame may have settled on edges beside its own. Other cues have to tell which of
// those that the edges around allow is right. \return True where one is enough.
bool vpMbMultiCueTracker::attemptProposed(const vpCueFrame &frame)
{
  Impl &impl = *m_impl;
  const bool isTold = impl.uses(EDGE_TRACKER) && impl.type != EDGE_TRACKER;
  if (!isTold || impl.best.explained < 0. || impl.searchBudget.isSpent()) {
    return false;
  }
  m_cMo = impl.startPose = impl.best.cMo;
  proposePose(frame);
  impl.tracks.follow(impl.best.cMo, impl.sameTrack());
  const bool isEnough = takeAttempt(refineFused(frame));
  impl.tracks.followNone();
  return isEnough;
}

// After a loss: the other poses that may be right. \return True where one of them is better, and enough.
bool vpMbMultiCueTracker::followOthers(const vpCueFrame &frame)
{
  Impl &impl = *m_impl;
  const std::size_t number = impl.tracks.tracks().size(); // Before this frame.
  bool isEnough = false;
  for (std::size_t i = 1; i < number && !impl.searchBudget.isSpent(); ++i) {
    impl.usesPoints = false;
    const vpPoseTracks::Track track = impl.tracks.tracks()[i]; // As it was before the attempts.
    impl.tracks.follow(i);
    isEnough = attemptFrom(frame, track.cMo) || isEnough;
    isEnough = attemptFrom(frame, track.cMo, false) || isEnough;
    isEnough = attemptAhead(frame, track.before, track.cMo) || isEnough;
  }
  impl.tracks.followNone();
  return isEnough;
}

END_VISP_NAMESPACE
