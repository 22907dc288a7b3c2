// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef benchMotionTargets_h
#define benchMotionTargets_h

#include "dataset/motionFigures.h"
#include "generate/motion.h"

#include <functional>

namespace bench {

//! What a motion has to be like in the mean over 300 frames, at 640 x 480.
struct MotionTargets
{
  double pixels = 10.;    //!< Motion from frame to frame.
  double degrees = 0.;    //!< Turn from frame to frame; 0: any.
  double prediction = 4.; //!< How far off a prediction with constant velocity is, pixels.
};

//! How strong oscillations are.
struct MotionGains
{
  double shift = 20.; //!< Pixels at 640 x 480.
  double turn = 0.2;  //!< Radians.
  double tempo = 0.5; //!< Radians per frame.
};

/*!
  \param poseAt The pose with some gains at a time in frames.
  \return The gains with which the targets are met, to a twentieth, for this object and seed.
  \throw vpException naming the motion and its scale where they cannot be met.
*/
MotionGains reachTargets(const SceneCamera &camera, const MotionSettings &settings, const MotionTargets &targets,
                         const std::function<vpHomogeneousMatrix(const MotionGains &, double)> &poseAt);

} // namespace bench
#endif
