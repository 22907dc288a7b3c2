// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpTrackingTimings_h
#define vpTrackingTimings_h

#include <visp3/se3/vpCompatibility.h>

BEGIN_VISP_NAMESPACE

/*!
  \ingroup group_multicue
  Where the time of one call of vpMbMultiCueTracker::track() went, milliseconds. A stage that ran several times in the
  frame is summed up.
*/
struct vpTrackingTimings
{
  double frame = 0.;     //!< Gray levels, undistortion.
  double view = 0.;      //!< What of the model is visible.
  double match = 0.;     //!< Search for its features in the image.
  double pose = 0.;      //!< Minimisation.
  double map = 0.;       //!< Distances to image edges, and colours, for the likelihood of many poses.
  double particles = 0.; //!< Particles: their likelihoods, weights and modes.
  double total = 0.;     //!< All of track(), the rest included.
};

END_VISP_NAMESPACE
#endif
