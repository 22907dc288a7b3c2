// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef benchStartPoses_h
#define benchStartPoses_h

#include "evaluate/poseError.h"

#include <visp3/se3/vpPoseRandom.h>

namespace bench {

/*!
  \param measure Of the same object as \e model.
  \return \e cMo moved in a random direction of all six motions about the object's centre, as far as moves the model's
  points by so many pixels in the mean.
*/
vpHomogeneousMatrix offBy(double pixels, const vpHomogeneousMatrix &cMo, const vpTrackedModel &model,
                          const PoseErrorMeasure &measure, const vpCameraParameters &cam, vpPoseRandom &random);

//! Poses that runs are started at: the truth, or some pixels off.
struct StartPoses
{
  double pixels = 0.; //!< 0: the truth itself.
  int seed = 1;       //!< Of the directions, which depend on it, the scene and the frame alone.

  //! \param scene Name of the scene that has the frame.
  vpHomogeneousMatrix at(const std::string &scene, const SequenceFrame &frame, const vpTrackedModel &model,
                         const PoseErrorMeasure &measure) const;
};

} // namespace bench
#endif
