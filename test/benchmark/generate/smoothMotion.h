// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef benchSmoothMotion_h
#define benchSmoothMotion_h

#include "generate/motion.h"

namespace bench {

/*!
  A smooth random motion of all six degrees of freedom, whose points move by 4 to 8 pixels (at 640 x 480) between frames
  on average.

  The path is a sum of sinusoids of a parameter; the parameter is then chosen frame by frame so that the points move as
  far as they shall.
*/
class SmoothMotion : public Motion
{
public:
  SmoothMotion(const SceneCamera &camera, const MotionSettings &settings);

  vpHomogeneousMatrix pose(double time) const override;

private:
  struct Wave
  {
    double frequency = 1.;
    double phase = 0.;
    double at(double parameter) const;
  };

  vpHomogeneousMatrix poseAt(double parameter) const;
  Eigen::Matrix3d rotationAt(double parameter) const;
  Eigen::Vector2d placeAt(double parameter, double distance) const;
  double distanceAt(double parameter) const;
  double reachOf(int crossing) const;
  void project(const vpHomogeneousMatrix &cMo, std::vector<Eigen::Vector2d> &pixels) const;
  double nextParameter(double parameter, double pixels) const;
  void chooseParameters();

  SceneCamera m_camera;
  MotionSettings m_settings;
  MotionExtent m_extent;
  Wave m_yaw, m_pitch, m_roll, m_column, m_row, m_size, m_speed, m_speed2;
  double m_firstYaw = 0.;
  std::vector<double> m_parameters; //!< Of the times -3, -2, ..., frames + 2.
};

} // namespace bench
#endif
