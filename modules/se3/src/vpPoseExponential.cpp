// SPDX-License-Identifier: GPL-2.0-or-later
#include <visp3/se3/vpPoseExponential.h>

#include <visp3/core/vpExponentialMap.h>
#include <visp3/core/vpVelocityTwistMatrix.h>

#include <cmath>

BEGIN_VISP_NAMESPACE

namespace {
template <int Rows, int Columns> using RowMajor = Eigen::Matrix<double, Rows, Columns, Eigen::RowMajor>;

// Below this angle (radians) the closed forms cancel, and two terms of their series are exact to rounding.
const double smallAngle = 1e-3;

// ViSP's vpThetaUVector recovers the axis near pi from sqrt(R[i][i] - cos(theta)); a quaternion has no such place.
Eigen::Vector3d rotationVector(const Eigen::Matrix3d &aRb)
{
  const Eigen::AngleAxisd angleAxis{Eigen::Quaterniond(aRb)};
  return angleAxis.angle() * angleAxis.axis();
}

// (1 - theta / 2 cot(theta / 2)) / theta^2, the factor of [omega]^2 in the inverse of the left Jacobian of SO(3).
double inverseJacobianFactor(double theta)
{
  if (theta < smallAngle) {
    return 1. / 12. + theta * theta / 720.;
  }
  const double half = 0.5 * theta;
  return (1. - half * std::cos(half) / std::sin(half)) / (theta * theta);
}
} // namespace

vpHomogeneousMatrix vpPoseExponential::exp(const vpPoseTangent &xi)
{
  vpColVector v(6);
  Eigen::Map<vpPoseTangent>(v.data) = xi;
  return vpExponentialMap::direct(v);
}

vpPoseTangent vpPoseExponential::log(const vpHomogeneousMatrix &aMb)
{
  return log(toEigen(aMb));
}

vpPoseTangent vpPoseExponential::log(const Eigen::Isometry3d &aMb)
{
  const Eigen::Vector3d t = aMb.translation();
  const Eigen::Vector3d omega = rotationVector(aMb.linear());
  vpPoseTangent xi;
  xi << t - 0.5 * omega.cross(t) + inverseJacobianFactor(omega.norm()) * omega.cross(omega.cross(t)), omega;
  return xi;
}

vpPoseMatrix6 vpPoseExponential::adjoint(const vpHomogeneousMatrix &aMb)
{
  const vpVelocityTwistMatrix twist(aMb);
  return Eigen::Map<const RowMajor<6, 6>>(twist.data);
}

double vpPoseExponential::logVolume(const vpPoseTangent &xi)
{
  // 2 (1 - cos(theta)) / theta^2 is the square of sin(theta / 2) / (theta / 2), which does not cancel.
  const double half = 0.5 * xi.tail<3>().norm();
  return half < smallAngle ? -2. / 3. * half * half : 4. * std::log(std::sin(half) / half);
}

Eigen::Isometry3d vpPoseExponential::toEigen(const vpHomogeneousMatrix &aMb)
{
  Eigen::Isometry3d pose;
  pose.matrix() = Eigen::Map<const RowMajor<4, 4>>(aMb.data);
  return pose;
}

vpHomogeneousMatrix vpPoseExponential::fromEigen(const Eigen::Isometry3d &aMb)
{
  vpRotationMatrix aRb;
  Eigen::Map<RowMajor<3, 3>>(aRb.data) = aMb.linear();
  if (!aRb.isARotationMatrix()) {
    throw vpException(vpException::badValue, "The linear part of an Eigen pose is not a rotation: orthonormalise it");
  }
  vpHomogeneousMatrix pose;
  pose.insert(aRb);
  pose.insert(vpTranslationVector(aMb.translation().x(), aMb.translation().y(), aMb.translation().z()));
  return pose;
}

END_VISP_NAMESPACE
