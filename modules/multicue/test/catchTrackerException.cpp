// SPDX-License-Identifier: GPL-2.0-or-later
#include <catchMain.h>

#include "throwingTracker.h"

#include <visp3/core/vpTrackingException.h>

namespace {
using namespace throwingTracker;

const char *const placeNames[] = {"start", "residues", "weights"};

// For each place, of exceptions that are ever later in the frame.
const std::vector<Outcome> &outcomes()
{
  static const std::vector<Outcome> all = [] {
    std::vector<Outcome> made;
    for (const Kind &kind : kinds) {
      for (const Place place : {Place::INIT, Place::RESIDUES, Place::WEIGHTS}) {
        bool hasThrown = true;
        for (int call = 0; hasThrown; call = 2 * call + 1) {
          Followed followed(kind);
          const Before before(followed.tracker);
          hasThrown = followed.throws(place, call);
          REQUIRE((hasThrown || call > 0));
          if (hasThrown) {
            const std::string where =
                std::string(", ") + placeNames[static_cast<int>(place)] + ", call " + std::to_string(call);
            made.emplace_back(where, followed, before);
          }
        }
      }
    }
    return made;
  }();
  return all;
}
} // namespace

TEST_CASE("An exception in the middle of track() leaves the settings, and the tracker goes on", "[exception]")
{
  for (const Outcome &outcome : outcomes()) {
    CAPTURE(outcome.text);
    CHECK(outcome.keepsSettings);
    CHECK(outcome.goesOn);
  }
}

TEST_CASE("An exception in the middle of track() leaves the motions that are estimated", "[exception]")
{
  for (const Outcome &outcome : outcomes()) {
    CAPTURE(outcome.text);
    CHECK(outcome.keepsMotions);
  }
}

TEST_CASE("An exception in the middle of track() leaves the last pose", "[exception]")
{
  for (const Outcome &outcome : outcomes()) {
    CAPTURE(outcome.text);
    CHECK(outcome.keepsPose);
  }
}

TEST_CASE("The exception of a loss leaves settings and pose, and the tracker goes on", "[exception]")
{
  for (const Kind &kind : kinds) {
    CAPTURE(kind);
    Followed followed(kind);
    ThrowingTracker &tracker = followed.tracker;
    tracker.setThrowOnLoss(true);
    const Before before(tracker);
    CHECK_THROWS_AS(tracker.track(nothing()), vpTrackingException);
    CHECK(tracker.getTrackingState() == vpTrackingState::LOST);
    CHECK(tracker.settings() == before.settings);
    CHECK(tracker.motions() == before.motions);
    if (tracker.getTrackingResult().reason == vpMbTrackingResult::Reason::COASTING) {
      CHECK(isRight(tracker.getPose(), plainScene::poseAt(Followed::last + 1))); // The predicted pose.
    } else {
      CHECK(same(tracker.getPose(), before.cMo));
    }
    for (std::size_t i = Followed::last + 2; i < 12; ++i) {
      CHECK_NOTHROW(tracker.track(imageOf(kind, i)));
      CHECK(isRight(tracker.getPose(), plainScene::poseAt(static_cast<int>(i))));
    }
    CHECK(tracker.getTrackingState() == vpTrackingState::TRACKING);
  }
}
