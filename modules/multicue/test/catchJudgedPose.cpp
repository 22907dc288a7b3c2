// SPDX-License-Identifier: GPL-2.0-or-later
#include "judge/vpJudgedPose.h" // The library keeps it to itself.

#include <catchMain.h>

TEST_CASE("More that is explained is better odds, everywhere", "[judged-pose]")
{
  for (double share = -0.5; share < 1.5; share += 0.05) {
    CAPTURE(share);
    CHECK(vpJudgedPose::oddsOf(share + 0.05) > vpJudgedPose::oddsOf(share));
  }
}

TEST_CASE("Odds are even between what right and what wrong poses explain, and bounded", "[judged-pose]")
{
  CHECK(vpJudgedPose::oddsOf(vpJudgedPose::badlyExplained) < 0.);
  CHECK(vpJudgedPose::oddsOf(vpJudgedPose::badlyExplained) > -1.5);
  CHECK(vpJudgedPose::oddsOf(0.8) > 0.5);
  CHECK(vpJudgedPose::oddsOf(0.) > -8.); // One image proves nothing.
  CHECK(vpJudgedPose::oddsOf(1.2) < 5.);
}

TEST_CASE("What explains an image is enough, what may well be wrong is not", "[judged-pose]")
{
  CHECK(vpJudgedPose::oddsOf(0.9) > vpJudgedPose::enoughOdds);
  CHECK(vpJudgedPose::oddsOf(0.7) < vpJudgedPose::enoughOdds);
  CHECK(vpJudgedPose().value < vpJudgedPose::oddsOf(-1.)); // Anything wins over no pose at all.
}
