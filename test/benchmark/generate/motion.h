// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef benchMotion_h
#define benchMotion_h

#include <visp3/core/vpCameraParameters.h>
#include <visp3/core/vpHomogeneousMatrix.h>

#include <Eigen/Core>

#include <cstdint>
#include <memory>
#include <string>
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
  std::string kind = "smooth";         //!< One of motionNames(), or the path of a file with poses in RBOT's format.
  double scale = 1.;                   //!< Multiplies the motion from frame to frame, > 0.
  std::vector<Eigen::Vector3d> points; //!< Vertices, object frame, metres.
  double pixelDiameter = 225.;         //!< Mean size of the diameter in the image, pixels at 640 x 480.
  bool frontOnly = false;              //!< The z axis stays within 60 degrees of the line of sight.
  bool exits = false;                  //!< Leaves the image about every 100 frames.
  int frames = 300;
  std::uint64_t seed = 1;   //!< Of this object's motion.
  double margin = 6.;       //!< Of the image, into which the object does not come; pixels at 640 x 480.
  bool fitsDistance = true; //!< Poses of a file are moved away or nearer, so that the object has pixelDiameter.
};

//! Where the object is, and how the camera is turned, at any time.
class Motion
{
public:
  virtual ~Motion() = default;

  //! Pose at a time in frames, in [-1, frames]; a frame's image is taken at the time that is its number.
  virtual vpHomogeneousMatrix pose(double time) const = 0;

  //! Turn of the camera against a background that is far away: it is seen in direction R d in place of d. Contained in
  //! pose().
  virtual Eigen::Matrix3d backgroundTurn(double time) const;
};

//! "smooth", "handheld" and "shaken-camera".
std::vector<std::string> motionNames();

/*!
  \return The motion of settings.kind.
  \throw vpException where there is no such motion, its file cannot be read or has too few poses, or it cannot be as
  strong as settings.scale wants it.
*/
std::unique_ptr<Motion> makeMotion(const SceneCamera &camera, const MotionSettings &settings);

//! An object's extent, and a part of its points that stands for all.
struct MotionExtent
{
  explicit MotionExtent(const std::vector<Eigen::Vector3d> &points);

  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  double radius = 0.;   //!< Of the sphere about the centre that holds all points, metres.
  double diameter = 0.; //!< Metres.
  std::vector<Eigen::Vector3d> points;
};

//! The pose with this rotation that has the object's \e centre at a \e place in the camera's frame, metres.
vpHomogeneousMatrix poseAround(const Eigen::Vector3d &centre, const Eigen::Matrix3d &rotation,
                               const Eigen::Vector3d &place);

} // namespace bench
#endif
