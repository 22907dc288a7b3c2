// SPDX-License-Identifier: GPL-2.0-or-later
#include "judge/vpContourEvidence.cpp" // The library keeps them to itself.
#include "judge/vpJudgedPose.h"
#include "judge/vpPoseBelief.cpp"
#include "judge/vpPoseTracks.cpp"

#include <catchMain.h>

namespace {
const unsigned int manyFrames = 20; // Those before count no longer.

vpHomogeneousMatrix at(double x)
{
  return vpHomogeneousMatrix(x, 0., 1., 0., 0., 0.);
}

bool isSame(const vpHomogeneousMatrix &c1Mo, const vpHomogeneousMatrix &c2Mo)
{
  return std::abs(c1Mo[0][3] - c2Mo[0][3]) < 0.05;
}

//! A pose that explains as much in this frame. \return What it is compared by.
double add(vpPoseTracks &tracks, double x, double explained, double change = 0.)
{
  return tracks.add(at(x), explained, vpJudgedPose::oddsOf(explained), change, isSame);
}

//! A frame in which a search finds poses that explain as much; those that are followed stay where they are.
void frame(vpPoseTracks &tracks, const std::vector<std::pair<double, double>> &found,
           vpPoseTracks::Seen seen = vpPoseTracks::Seen::WELL)
{
  double best = -HUGE_VAL;
  vpHomogeneousMatrix chosen;
  for (const auto &[x, value] : found) {
    const double compared = add(tracks, x, value);
    if (compared > best) {
      best = compared;
      chosen = at(x);
    }
  }
  tracks.noteSearch();
  tracks.choose(chosen, seen, isSame);
}

//! Follows each track to its own pose. \param valueAt What is explained at a place.
template <typename Value> void followed(vpPoseTracks &tracks, Value valueAt)
{
  std::vector<vpHomogeneousMatrix> poses;
  for (const vpPoseTracks::Track &track : tracks.tracks()) {
    poses.push_back(track.cMo);
  }
  double best = -HUGE_VAL;
  vpHomogeneousMatrix chosen;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    tracks.follow(i);
    const double compared = add(tracks, poses[i][0][3], valueAt(poses[i][0][3]));
    tracks.followNone();
    if (compared > best) {
      best = compared;
      chosen = poses[i];
    }
  }
  tracks.noteSearch();
  tracks.choose(chosen, vpPoseTracks::Seen::WELL, isSame);
}

//! Only the first one is looked at.
void followFirst(vpPoseTracks &tracks, const vpHomogeneousMatrix &cMo, double value)
{
  tracks.follow(0);
  add(tracks, cMo[0][3], value);
  tracks.followNone();
}

double chosenAt(vpPoseTracks &tracks)
{
  return tracks.chosen().cMo[0][3];
}

vpPoseTracks followedFor(unsigned int frames)
{
  vpPoseTracks tracks;
  frame(tracks, {{0., 0.85}});
  for (unsigned int i = 1; i < frames; ++i) {
    followed(tracks, [](double) { return 0.85; });
  }
  return tracks;
}
} // namespace

TEST_CASE("A pose that is followed keeps the least penalty for where it is", "[tracks]")
{
  vpPoseTracks tracks;
  add(tracks, 0., 1., 0.1);
  tracks.choose(at(0.), vpPoseTracks::Seen::WELL, isSame);
  tracks.follow(0);
  const double moved = add(tracks, 0.04, 1., 0.4); // With the object.
  tracks.followNone();
  vpPoseTracks other;
  add(other, 0., 1., 0.1);
  other.choose(at(0.), vpPoseTracks::Seen::WELL, isSame);
  CHECK(moved == exactly(add(other, 0., 1., 0.1)));
  tracks.follow(0);
  CHECK(add(tracks, 0.3, 1., 0.4) == Approx(moved - 0.3)); // It jumped.
  tracks.followNone();
  CHECK(add(other, 1., 1., 0.1) == Approx(add(other, 2., 1., 0.4) + 0.3)); // Found just now.
}

TEST_CASE("A better pose that was found after others is not dropped for its age", "[pose-tracks]")
{
  vpPoseTracks tracks;
  for (unsigned int i = 0; i < manyFrames; ++i) {
    frame(tracks, {{0., 0.85}, {1., 0.84}, {2., 0.83}});
  }
  frame(tracks, {{0., 0.85}, {1., 0.84}, {2., 0.83}, {3., 0.9}});
  CHECK(chosenAt(tracks) == exactly(0.));
  REQUIRE(tracks.tracks().size() == 3);
  CHECK(tracks.tracks()[1].cMo[0][3] == exactly(3.));
  CHECK(tracks.tracks()[2].cMo[0][3] == exactly(1.));
}

TEST_CASE("One better image does not move a pose that was followed, some on end do", "[pose-tracks]")
{
  vpPoseTracks tracks = followedFor(6);
  followFirst(tracks, at(0.), 0.85);
  const double old = add(tracks, 0., 0.85);
  CHECK(add(tracks, 1., 0.9) < old);
  tracks.choose(at(0.), vpPoseTracks::Seen::WELL, isSame);
  CHECK(chosenAt(tracks) == exactly(0.));
  REQUIRE(tracks.tracks().size() == 2);

  unsigned int frames = 0;
  for (; frames < 10 && chosenAt(tracks) == exactly(0.); ++frames) {
    followed(tracks, [](double x) { return x > 0.5 ? 1. : 0.85; });
  }
  CHECK(frames >= 1);
  CHECK(frames <= 4);
}

TEST_CASE("A pose that is found from another one goes on as that one", "[pose-tracks]")
{
  vpPoseTracks tracks = followedFor(6);
  tracks.follow(at(0.01), isSame);
  const double corrected = add(tracks, 0.2, 0.9);
  tracks.followNone();
  CHECK(corrected > add(tracks, 1., 0.9)); // A new one.
  tracks.choose(at(0.2), vpPoseTracks::Seen::WELL, isSame);
  CHECK(chosenAt(tracks) == exactly(0.2));
  CHECK(tracks.tracks().size() == 2);

  tracks.follow(at(3.), isSame); // There is none.
  CHECK(add(tracks, 0.2, 0.9) > add(tracks, 3., 0.9));
}

TEST_CASE("A pose that explains nothing ends, others stay up to three, the same ones become one", "[pose-tracks]")
{
  vpPoseTracks tracks;
  frame(tracks, {{0., 0.8}, {1., 0.7}, {2., 0.6}, {3., 0.5}, {1.01, 0.65}, {4., 0.1}});
  REQUIRE(tracks.tracks().size() == 3);
  CHECK(chosenAt(tracks) == exactly(0.));
  CHECK(tracks.tracks()[1].cMo[0][3] == exactly(1.));
  followed(tracks, [](double x) { return x > 1.5 ? 0.2 : 0.7; });
  CHECK(tracks.tracks().size() == 2);
}

TEST_CASE("A lead over what was looked for counts by the frame", "[pose-tracks]")
{
  vpPoseTracks tracks;
  for (unsigned int i = 1; i <= 4; ++i) {
    frame(tracks, {{0., 0.7}, {1., 0.4}});
    CHECK(tracks.lead() == Approx(vpJudgedPose::oddsOf(0.7) - vpJudgedPose::oddsOf(0.4)));
    CHECK(tracks.ahead() == i);
  }
  SECTION("not in a frame without a search")
  {
    add(tracks, 0., 0.7);
    add(tracks, 1., 0.4);
    tracks.choose(at(0.), vpPoseTracks::Seen::WELL, isSame);
    CHECK(tracks.lead() == exactly(0.));
    CHECK(tracks.ahead() == 0);
  }
  SECTION("not where little of the object is seen")
  {
    frame(tracks, {{0., 0.7}, {1., 0.4}}, vpPoseTracks::Seen::ENOUGH);
    CHECK(tracks.ahead() == 0);
  }
  SECTION("not where another one comes near")
  {
    for (unsigned int i = 0; i < manyFrames; ++i) {
      frame(tracks, {{0., 0.7}, {1., 0.69}});
    }
    CHECK(tracks.ahead() == 0);
    CHECK(tracks.isContested());
  }
  SECTION("not of a pose that explains little")
  {
    for (unsigned int i = 0; i < manyFrames; ++i) {
      frame(tracks, {{0., 0.5}, {1., 0.35}});
    }
    CHECK(tracks.ahead() == 0);
  }
}

TEST_CASE("Each pose has its own belief and confirmations", "[pose-tracks]")
{
  vpPoseBelief believed;
  believed.start(0.9);
  vpPoseTracks tracks;
  tracks.begin(at(0.), at(-0.02), believed);
  CHECK(tracks.chosen().before[0][3] == exactly(-0.02));
  followFirst(tracks, at(0.02), 0.8);
  add(tracks, 1., 0.8);
  tracks.choose(at(0.02), vpPoseTracks::Seen::WELL, isSame);
  CHECK(tracks.chosen().belief.probability() == Approx(0.9));
  CHECK(tracks.chosen().before[0][3] == exactly(0.));
  CHECK(tracks.tracks()[1].belief.probability() < 0.5);
  CHECK(tracks.tracks()[1].confirmations == 1);
}

TEST_CASE("A pose that was not among the estimated ones is a track of its own", "[pose-tracks]")
{
  vpPoseTracks tracks = followedFor(3);
  tracks.choose(at(5.), vpPoseTracks::Seen::WELL, isSame);
  CHECK(chosenAt(tracks) == exactly(5.));
  CHECK(tracks.lead() == exactly(0.));
}

TEST_CASE("Others have to be looked for while enough is seen, and to have some frames", "[pose-tracks]")
{
  const auto frameWithout = [](vpPoseTracks &tracks, vpPoseTracks::Seen seen) {
    followFirst(tracks, tracks.chosen().cMo, 0.7);
    tracks.choose(tracks.tracks()[0].cMo, seen, isSame);
  };
  vpPoseTracks tracks;
  CHECK_FALSE(tracks.isCompared());
  frame(tracks, {{0., 0.7}}, vpPoseTracks::Seen::LITTLE);
  CHECK_FALSE(tracks.wasCompared());
  for (unsigned int i = 0; i < manyFrames; ++i) {
    frameWithout(tracks, vpPoseTracks::Seen::WELL);
    CHECK_FALSE(tracks.wasCompared());
  }
  SECTION("once is enough")
  {
    tracks.noteOthers();
    for (unsigned int i = 0; i < 3; ++i) {
      frameWithout(tracks, vpPoseTracks::Seen::ENOUGH);
      CHECK(tracks.wasCompared());
      CHECK_FALSE(tracks.isCompared());
    }
    frameWithout(tracks, vpPoseTracks::Seen::LITTLE);
    CHECK(tracks.isCompared());
  }
  SECTION("one that was just found may be better")
  {
    for (unsigned int i = 0; i < manyFrames; ++i) {
      frame(tracks, {{0., 0.7}});
    }
    CHECK(tracks.isCompared());
    for (unsigned int i = 0; i < 3; ++i) {
      frame(tracks, {{0., 0.7}, {1., 0.68}});
      CHECK_FALSE(tracks.isCompared());
    }
    frame(tracks, {{0., 0.7}, {1., 0.68}});
    CHECK(tracks.isCompared());
  }
  SECTION("one that explains less is none")
  {
    for (unsigned int i = 0; i < manyFrames; ++i) {
      frame(tracks, {{0., 0.7}});
    }
    frame(tracks, {{0., 0.7}, {1., 0.5}});
    CHECK(tracks.isCompared());
  }
}

TEST_CASE("What the followed pose explains is known once it was looked at in a frame", "[pose-tracks]")
{
  vpPoseTracks tracks = followedFor(manyFrames);
  CHECK(tracks.followedValue() == exactly(-HUGE_VAL));
  tracks.follow(0);
  CHECK(tracks.followedValue() == exactly(-HUGE_VAL));
  add(tracks, 0., 0.5);
  add(tracks, 0., 0.4);
  CHECK(tracks.followedValue() == exactly(vpJudgedPose::oddsOf(0.5)));
  tracks.followNone();
  CHECK(tracks.followedValue() == exactly(-HUGE_VAL));
}

TEST_CASE("A pose that was worse before it settled contests the first one", "[pose-tracks]")
{
  vpPoseTracks tracks;
  frame(tracks, {{0., 0.9}, {1., 0.5}});
  frame(tracks, {{0., 0.9}, {1., 0.6}});
  CHECK_FALSE(tracks.isContested());
  frame(tracks, {{0., 0.9}, {1., 0.9}});
  CHECK(tracks.chosen().cMo[0][3] == exactly(0.));
  CHECK(tracks.isContested());
}
