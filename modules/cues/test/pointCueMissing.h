// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef pointCueMissing_h
#define pointCueMissing_h

#include <visp3/core/vpException.h>
#include <visp3/cues/vpPointCue.h>

/*!
  \file pointCueMissing.h
  What is left to test of the point cue in a build without OpenCV's video, features2d or calib3d module.
*/

TEST_CASE("Without OpenCV the point cue says so", "[point-cue]")
{
  CHECK_FALSE(vpPointCue::isAvailable());
  CHECK_THROWS_WITH(vpPointCue(), ContainsSubstring("OpenCV"));
}

#endif
