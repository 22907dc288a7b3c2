// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpFrameContext_h
#define vpFrameContext_h

#include "frame/vpFrameDeadline.h"

#include <visp3/cues/vpCueFrame.h>
#include <visp3/multicue/vpTrackingTimings.h>

#include <cstdint>

BEGIN_VISP_NAMESPACE

//! How many streams of random numbers were taken since the start. The same images then give the same poses; whoever
//! takes a stream in another order changes them.
struct vpRandomStreams
{
  std::uint64_t searches = 0;
  std::uint64_t captures = 0;
};

//! One image and what all parts share while they look at it. Settings stay as they are until it ends.
struct vpFrameContext
{
  const vpCueFrame &image;
  vpTrackingTimings &timings;
  vpFrameDeadline &deadline;
  vpRandomStreams &streams;
};

END_VISP_NAMESPACE
#endif
