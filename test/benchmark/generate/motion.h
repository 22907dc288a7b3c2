// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef benchMotion_h
#define benchMotion_h

#include <visp3/core/vpCameraParameters.h>
#include <visp3/core/vpHomogeneousMatrix.h>

#include <Eigen/Core>

#include <cstdint>
#include <vector>

#ifdef ENABLE_VISP_NAMESPACE
using namespace VISP_NAMESPACE_NAME;
#endif

namespace bench {

//! The image that a sequence is made for.
struct SceneCamera
{
  vpCameraParameters cam;
  unsigned int width = 640;
  unsigned int height = 480;
  //! All lengths in pixels are given for 640 x 480 and multiplied by this.
  double scale() const;
};

//! \return A camera whose focal length is 650 pixels at 640 x 480.
SceneCamera makeSceneCamera(unsigned int width, unsigned int height);

//! What a motion has to keep to.
struct MotionSettings
{
  std::vector<Eigen::Vector3d> points; //!< Vertices, object frame, metres.
  double pixelDiameter = 225.;         //!< Mean size of the diameter in the image, pixels at 640 x 480.
  bool frontOnly = false;              //!< The z axis stays within 60 degrees of the line of sight.
  bool exits = false;                  //!< Leaves the image about every 100 frames.
  int frames = 300;
  std::uint64_t seed = 1; //!< Of this object's motion.
};

/*!
  A smooth random motion of all six degrees of freedom, whose points move by 4 to 8 pixels (at 640 x 480) between frames
  on average.

  The path is a sum of sinusoids of a parameter; the parameter is then chosen frame by frame so that the points move as
  far as they shall.
*/
class Motion
{
public:
  Motion(const SceneCamera &camera, const MotionSettings &settings);

  //! Pose at a time in frames, in [-1, frames]; a frame's image is taken at the time that is its number.
  vpHomogeneousMatrix pose(double time) const;

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
  std::vector<Eigen::Vector3d> m_points; //!< A part of the points that stands for all.
  Eigen::Vector3d m_centre = Eigen::Vector3d::Zero();
  double m_radius = 0.;   //!< Of the sphere about the centre that holds all points, metres.
  double m_diameter = 0.; //!< Metres.
  Wave m_yaw, m_pitch, m_roll, m_column, m_row, m_size, m_speed, m_speed2;
  double m_firstYaw = 0.;
  std::vector<double> m_parameters; //!< Of the times -3, -2, ..., frames + 2.
};

} // namespace bench
#endif
