// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpWeightedPose_h
#define vpWeightedPose_h

#include <visp3/core/vpCameraParameters.h>
#include <visp3/core/vpHomogeneousMatrix.h>
#include <visp3/core/vpImage.h>
#include <visp3/core/vpRGBa.h>
#include <visp3/se3/vpCompatibility.h>

#include <functional>
#include <vector>

BEGIN_VISP_NAMESPACE

//! \ingroup group_multicue
//! A pose that the object may have, by a detector for instance.
struct vpWeightedPose
{
  vpHomogeneousMatrix cMo; //!< Object to camera, metres.
  double weight = 1.;      //!< How likely it is in comparison to the others, > 0, any unit.
};

//! \ingroup group_multicue
//! How far a pose that was given may be off the object's.
struct VISP_EXPORT vpPoseDeviation
{
  //! Of the place of the object's middle, root mean square of the distance, metres; 0, the default: a tenth of the
  //! model's diameter.
  double translation = 0.;
  double rotation =
      0.2618; //!< Of the turn about it, root mean square of the angle, radians, [0, pi]; default 15 degrees.

  //! \throw vpException naming the member out of range.
  void check() const;
};

/*!
  \ingroup group_multicue
  What a program knows of where the object may be in an image, see vpMbMultiCueTracker::setDetector(): poses, none or
  many, in any order. It is given the image without lens distortion, gray levels as equal red, green and blue, and the
  camera that would have taken it.
*/
using vpPoseDetector =
    std::function<std::vector<vpWeightedPose>(const vpImage<vpRGBa> &I, const vpCameraParameters &cam)>;

END_VISP_NAMESPACE
#endif
