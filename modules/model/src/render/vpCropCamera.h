// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpCropCamera_h
#define vpCropCamera_h

#include <visp3/model/vpModelRenderer.h>

#include <Eigen/Core>

BEGIN_VISP_NAMESPACE

/*!
  The camera whose image is the crop: point (X, Y, Z) of the camera frame is seen at (fx X / Z + cx, fy Y / Z + cy),
  crop pixels, pixel centres at integers.
*/
struct vpCropCamera
{
  double fx;
  double fy;
  double cx;
  double cy;

  vpCropCamera(const vpCameraParameters &cam, const vpRenderedView &view)
      : fx(view.scale * cam.get_px()), fy(view.scale * cam.get_py()),
        cx(view.scale * (cam.get_u0() + 0.5) - 0.5 - view.left), cy(view.scale * (cam.get_v0() + 0.5) - 0.5 - view.top)
  {
  }

  //! Line of sight of crop pixel (x, y), with Z = 1.
  Eigen::Vector3d ray(double x, double y) const { return Eigen::Vector3d((x - cx) / fx, (y - cy) / fy, 1.); }
};

//! Rotation and translation side by side.
using vpPoseMatrix = Eigen::Matrix<double, 3, 4>;

inline vpPoseMatrix vpToPoseMatrix(const vpHomogeneousMatrix &cMo)
{
  vpPoseMatrix pose;
  for (unsigned int i = 0; i < 3; ++i) {
    for (unsigned int j = 0; j < 4; ++j) {
      pose(i, j) = cMo[i][j];
    }
  }
  return pose;
}

inline Eigen::Vector3d vpTransform(const vpPoseMatrix &pose, const Eigen::Vector3d &point)
{
  return pose.leftCols<3>() * point + pose.col(3);
}

END_VISP_NAMESPACE
#endif
