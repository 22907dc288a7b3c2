// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpRecallPlan_h
#define vpRecallPlan_h

#include <visp3/se3/vpCompatibility.h>

#include <optional>

BEGIN_VISP_NAMESPACE

//! With which knowledge a lost object is looked for, see vpPastKnowledge: the newest first, then older ones in turn
//! with it, since the object may have drifted off for some time before it was lost.
class vpRecallPlan
{
public:
  //! True where the newest knowledge was tried in vain for long. \param frames Since the loss.
  static bool isLong(unsigned int frames) { return frames > framesWithNewest; }
  //! \return Which knowledge to look for the object with from this frame on; none: as before.
  static std::optional<unsigned int> level(unsigned int frames, bool isBeingConfirmed)
  {
    if (frames == 1) {
      return 0U;
    }
    const bool isDue = isLong(frames) && (frames - 1) % framesWithOther == 0;
    if (!isDue || isBeingConfirmed) {
      return std::nullopt;
    }
    const unsigned int change = (frames - 1 - framesWithNewest) / framesWithOther;
    return change % 2 == 0 ? change / 2 + 1 : 0U;
  }

private:
  // Frames in vain after which older knowledge is tried, and those that each is tried for.
  static constexpr unsigned int framesWithNewest = 20;
  static constexpr unsigned int framesWithOther = 10;
};

END_VISP_NAMESPACE
#endif
