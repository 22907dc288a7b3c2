// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpJudgedPose_h
#define vpJudgedPose_h

#include <visp3/se3/vpCompatibility.h>

BEGIN_VISP_NAMESPACE

//! What an image says of a pose that the cues were brought to.
struct vpJudgedPose
{
  //! Of what the trusted frames before had: what explains less is no explanation of an image.
  static constexpr double badlyExplained = 0.65;
  //! At a pose that explains less the object is lost.
  static constexpr double leastExplained = 0.4;

  double explained = -1.; //!< Less than any pose explains.
  double value = -2.;     //!< What poses are compared by.
  bool isFar = false;     //!< From where the object is expected.

  //! \param isLost Unless it is, the object does not jump to where something explains more while a pose where it is
  //! expected explains the image.
  bool isBetterThan(const vpJudgedPose &other, bool isLost) const
  {
    const vpJudgedPose &near = isFar ? other : *this;
    if (!isLost && isFar != other.isFar && near.explained >= leastExplained) {
      return !isFar;
    }
    return value > other.value;
  }
};

END_VISP_NAMESPACE
#endif
