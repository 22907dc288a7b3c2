// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef benchHandMotion_h
#define benchHandMotion_h

#include "generate/motionTargets.h"
#include "generate/oscillations.h"
#include "generate/smoothMotion.h"

namespace bench {

/*!
  An object that a hand swings before a camera at rest. With scale 1 it moves by 10 pixels (at 640 x 480) and turns by 6
  degrees from frame to frame in the mean, and a prediction with constant velocity is off by 4 pixels.
*/
class HandheldMotion : public Motion
{
public:
  //! \throw vpException where the scale is too large for the image.
  HandheldMotion(const SceneCamera &camera, const MotionSettings &settings);

  vpHomogeneousMatrix pose(double time) const override { return poseWith(m_gains, time); }

private:
  vpHomogeneousMatrix poseWith(const MotionGains &gains, double time) const;
  Eigen::Matrix3d rotationAt(const Eigen::Vector3d &swing, double time) const;
  double placeAlong(double size, double extent, double wanted) const;

  SceneCamera m_camera;
  MotionSettings m_settings;
  MotionExtent m_extent;
  Oscillations m_swing; //!< Right, down, size, and three turns.
  Oscillations m_drift; //!< Right, down, pitch: slow.
  MotionGains m_gains;
};

/*!
  A camera in a hand that looks at an object while it slowly moves about it: object and background are shaken together.
  With scale 1 the object moves by 9 pixels from frame to frame, and a prediction with constant velocity is off by 9.
*/
class ShakenCameraMotion : public Motion
{
public:
  //! \throw vpException where the scale is too large for the image.
  ShakenCameraMotion(const SceneCamera &camera, const MotionSettings &settings);

  vpHomogeneousMatrix pose(double time) const override { return poseWith(m_gains, time); }
  Eigen::Matrix3d backgroundTurn(double time) const override { return turnWith(m_gains, time); }

private:
  vpHomogeneousMatrix poseWith(const MotionGains &gains, double time) const;
  Eigen::Matrix3d turnWith(const MotionGains &gains, double time) const;

  SceneCamera m_camera;
  SmoothMotion m_slow;
  Oscillations m_shake; //!< Turns of the camera about its three axes.
  MotionGains m_gains;
};

} // namespace bench
#endif
