// SPDX-License-Identifier: GPL-2.0-or-later
#include <visp3/multicue/vpMbMultiCueTracker.h>

#include "tracker/vpTrackerState.h"

#include <algorithm>
#include <cmath>

BEGIN_VISP_NAMESPACE

namespace {
// Share of the outline: what is seen of less looks like many poses.
const double insideToCompare = 0.7;
// Of a pose with exp(-1) times the usual number of edges, and the most of them that counts.
const double fewPenalty = 0.1;
const double mostFewPenalty = 0.3;
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
    tracks.begin(cMo, best.explained, belief);
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

// After a loss: the other poses that may be right. \return True where one of them is better, and enough.
bool vpMbMultiCueTracker::followOthers(const vpCueFrame &frame)
{
  Impl &impl = *m_impl;
  const std::size_t number = impl.tracks.tracks().size(); // Before this frame.
  bool isEnough = false;
  for (std::size_t i = 1; i < number && !impl.searchBudget.isSpent(); ++i) {
    impl.usesPoints = false;
    const vpHomogeneousMatrix cMo = impl.tracks.tracks()[i].cMo;
    impl.tracks.follow(i);
    isEnough = attemptFrom(frame, cMo) || isEnough;
    isEnough = attemptFrom(frame, cMo, false) || isEnough;
  }
  impl.tracks.followNone();
  return isEnough;
}

END_VISP_NAMESPACE
