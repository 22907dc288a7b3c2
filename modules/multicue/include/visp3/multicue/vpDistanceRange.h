// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpDistanceRange_h
#define vpDistanceRange_h

#include <visp3/se3/vpCompatibility.h>

BEGIN_VISP_NAMESPACE

/*!
  \ingroup group_multicue
  How far from the camera an object may be that is looked for in a whole image, see
  vpMbMultiCueTracker::initFromImage(): the distance along the optical axis of the middle of its box.
*/
struct VISP_EXPORT vpDistanceRange
{
  //! Metres. 0 (default): where the diagonal of the object's box spans 0.9 of the image's height.
  double nearest = 0.;
  //! Metres, at least nearest. 0 (default): where that diagonal spans 0.05 of the image's height, or 24 pixels if more.
  double farthest = 0.;

  //! \throw vpException naming the member that is negative or not finite, and where farthest is below nearest.
  void check() const;
};

END_VISP_NAMESPACE
#endif
