// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpViewCamera_h
#define vpViewCamera_h

#include <visp3/core/vpCameraParameters.h>
#include <visp3/core/vpHomogeneousMatrix.h>
#include <visp3/se3/vpCompatibility.h>

#include <Eigen/Core>

BEGIN_VISP_NAMESPACE

//! Pose and camera in the form that projection needs.
struct vpViewCamera
{
  vpViewCamera(const vpHomogeneousMatrix &cMo, const vpCameraParameters &cam, unsigned int imageWidth,
               unsigned int imageHeight)
      : px(cam.get_px()), py(cam.get_py()), u0(cam.get_u0()), v0(cam.get_v0()), width(imageWidth), height(imageHeight)
  {
    for (unsigned int i = 0; i < 3; ++i) {
      for (unsigned int j = 0; j < 3; ++j) {
        cRo(i, j) = cMo[i][j];
      }
      cto(i) = cMo[i][3];
    }
    oC = -cRo.transpose() * cto;
  }

  Eigen::Vector3d toCamera(const Eigen::Vector3d &oX) const { return cRo * oX + cto; }
  Eigen::Vector2d project(const Eigen::Vector3d &cX) const
  {
    return Eigen::Vector2d(px * cX.x() / cX.z() + u0, py * cX.y() / cX.z() + v0);
  }

  Eigen::Matrix3d cRo;
  Eigen::Vector3d cto;
  Eigen::Vector3d oC; //!< The camera's centre, object frame.
  double px, py, u0, v0;
  double width, height;
};

END_VISP_NAMESPACE
#endif
