// SPDX-License-Identifier: GPL-2.0-or-later
#include "judge/vpJudgedPose.h" // The library keeps it to itself.

#include <catchMain.h>

namespace {
vpJudgedPose judged(double explained, double value, bool isFar)
{
  vpJudgedPose pose;
  pose.explained = explained;
  pose.value = value;
  pose.isFar = isFar;
  return pose;
}
} // namespace

TEST_CASE("The larger value wins, and anything wins over no pose at all", "[judged-pose]")
{
  CHECK(judged(0.8, 0.7, false).isBetterThan(judged(0.9, 0.6, false), false));
  CHECK_FALSE(judged(0.9, 0.6, false).isBetterThan(judged(0.8, 0.7, false), false));
  CHECK(judged(0.1, -0.2, false).isBetterThan(vpJudgedPose(), false));
  CHECK(judged(0.1, -0.2, true).isBetterThan(vpJudgedPose(), false));
}

TEST_CASE("The object does not jump while a pose where it is expected explains the image", "[judged-pose]")
{
  const vpJudgedPose far = judged(1.1, 0.8, true);
  const vpJudgedPose near = judged(0.45, 0.45, false); // What hides it takes much away.
  CHECK_FALSE(far.isBetterThan(near, false));
  CHECK(near.isBetterThan(far, false)); // Whichever came first.
  SECTION("it may have jumped where that explains little")
  {
    const vpJudgedPose poor = judged(0.35, 0.35, false);
    CHECK(far.isBetterThan(poor, false));
    CHECK_FALSE(poor.isBetterThan(far, false));
  }
  SECTION("it may be anywhere where it is lost")
  {
    CHECK(far.isBetterThan(near, true));
    CHECK_FALSE(near.isBetterThan(far, true));
  }
}
