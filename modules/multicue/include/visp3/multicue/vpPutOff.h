// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpPutOff_h
#define vpPutOff_h

#include <visp3/se3/vpCompatibility.h>

BEGIN_VISP_NAMESPACE

/*!
  \ingroup group_multicue
  What vpMbMultiCueTracker::track() leaves for the frames after, where a frame has a deadline
  (vpMbMultiCueTracker::setFrameDeadline()). Nothing of it is needed to follow an object that is seen where it is
  expected.
*/
enum class vpPutOff
{
  STARTS,    //!< Other poses to start from, where the image does not look as it should at the expected one.
  KEYFRAMES, //!< Views of the object that were trusted are not looked for in the image.
  SEARCH,    //!< A search for the object; it goes on in the next frame from the best poses that it has.
  COMPARISON //!< That of the pose with others that look alike, such as half a turn.
};

//! \ingroup group_multicue
//! \return The name, "SEARCH" for instance.
VISP_EXPORT const char *toString(vpPutOff work);

END_VISP_NAMESPACE
#endif
