// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpTrackingState_h
#define vpTrackingState_h

#include <visp3/se3/vpCompatibility.h>

BEGIN_VISP_NAMESPACE

//! \ingroup group_multicue
//! What a tracker says of its pose after a frame.
enum class vpTrackingState
{
  TRACKING,  //!< The image supports the pose.
  UNCERTAIN, //!< The image supports it in part.
  LOST       //!< It does not: the pose is the one before, or for half a second the one that is predicted.
};

//! \ingroup group_multicue
//! \return The state's name, "TRACKING" for instance.
VISP_EXPORT const char *toString(vpTrackingState state);

END_VISP_NAMESPACE
#endif
