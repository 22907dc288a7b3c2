// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpPointCamera_h
#define vpPointCamera_h

#include <visp3/core/vpCameraParameters.h>
#include <visp3/core/vpHomogeneousMatrix.h>
#include <visp3/se3/vpCompatibility.h>

#include <Eigen/Core>

BEGIN_VISP_NAMESPACE

//! Pose and camera in the form that projection of points needs.
struct vpPointCamera
{
  vpPointCamera(const vpHomogeneousMatrix &cMo, const vpCameraParameters &cam)
      : focal(cam.get_px(), cam.get_py()), centre(cam.get_u0(), cam.get_v0())
  {
    for (unsigned int i = 0; i < 3; ++i) {
      for (unsigned int j = 0; j < 3; ++j) {
        cRo(i, j) = cMo[i][j];
      }
      cto(i) = cMo[i][3];
    }
  }

  Eigen::Vector3d toCamera(const Eigen::Vector3d &oX) const { return cRo * oX + cto; }
  Eigen::Vector3d toObject(const Eigen::Vector3d &cX) const { return cRo.transpose() * (cX - cto); }
  //! \pre cX.z() > 0
  Eigen::Vector2d project(const Eigen::Vector3d &cX) const
  {
    return focal.cwiseProduct(cX.head<2>() / cX.z()) + centre;
  }
  Eigen::Vector2d normalized(const Eigen::Vector2d &pixel) const { return (pixel - centre).cwiseQuotient(focal); }
  //! How the projection moves with the point, pixels per metre of the camera frame. \pre cX.z() > 0
  Eigen::Matrix<double, 2, 3> derivative(const Eigen::Vector3d &cX) const
  {
    Eigen::Matrix<double, 2, 3> d;
    d << focal.x(), 0., -focal.x() * cX.x() / cX.z(), 0., focal.y(), -focal.y() * cX.y() / cX.z();
    return d / cX.z();
  }

  Eigen::Matrix3d cRo;
  Eigen::Vector3d cto;
  Eigen::Vector2d focal;
  Eigen::Vector2d centre;
};

END_VISP_NAMESPACE
#endif
