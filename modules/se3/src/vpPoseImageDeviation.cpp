// SPDX-License-Identifier: GPL-2.0-or-later
#include <visp3/se3/vpPoseImageDeviation.h>

#include <algorithm>
#include <cmath>

BEGIN_VISP_NAMESPACE

namespace {
double largestEigenvalue(const Eigen::Matrix2d &m)
{
  return 0.5 * (m(0, 0) + m(1, 1)) + std::hypot(0.5 * (m(0, 0) - m(1, 1)), m(0, 1));
}
} // namespace

Eigen::Matrix2d vpPoseImageDeviation::covariance(const vpCameraParameters &cam, const vpHomogeneousMatrix &cMo,
                                                 const vpPoseMatrix6 &covariance, const Eigen::Vector3d &oX)
{
  const Eigen::Vector3d cX = vpPoseExponential::toEigen(cMo) * oX;
  if (!(cX.z() > 0.)) {
    return Eigen::Matrix2d::Zero();
  }
  // exp(alpha) moves the point by v + omega x cX.
  const double x = cX.x() / cX.z();
  const double y = cX.y() / cX.z();
  Eigen::Matrix<double, 2, 6> jacobian;
  jacobian << 1. / cX.z(), 0., -x / cX.z(), -x * y, 1. + x * x, -y, //
      0., 1. / cX.z(), -y / cX.z(), -(1. + y * y), x * y, x;
  jacobian.row(0) *= cam.get_px();
  jacobian.row(1) *= cam.get_py();
  return jacobian * covariance * jacobian.transpose();
}

double vpPoseImageDeviation::largest(const vpCameraParameters &cam, const vpHomogeneousMatrix &cMo,
                                     const vpPoseMatrix6 &covariance, const std::vector<Eigen::Vector3d> &oX)
{
  double most = 0.;
  for (const Eigen::Vector3d &point : oX) {
    most = std::max(most, largestEigenvalue(vpPoseImageDeviation::covariance(cam, cMo, covariance, point)));
  }
  return std::sqrt(most);
}

double vpPoseImageDeviation::along(const vpCameraParameters &cam, const vpHomogeneousMatrix &cMo,
                                   const vpPoseMatrix6 &covariance, const Eigen::Vector3d &oX,
                                   const Eigen::Vector2d &normal)
{
  const Eigen::Matrix2d spread = vpPoseImageDeviation::covariance(cam, cMo, covariance, oX);
  return std::sqrt(std::max(normal.dot(spread * normal), 0.));
}

END_VISP_NAMESPACE
