// SPDX-License-Identifier: GPL-2.0-or-later
#include <visp3/se3/vpPoseExponential.h>

#include <visp3/core/vpExponentialMap.h>
#include <visp3/core/vpVelocityTwistMatrix.h>

#include <cmath>
#include <utility>

BEGIN_VISP_NAMESPACE

namespace {
template <int Rows, int Columns> using RowMajor = Eigen::Matrix<double, Rows, Columns, Eigen::RowMajor>;

// Below this angle (radians) a quotient of 0 / 0 is near, and one term of its series is exact to rounding.
const double smallAngle = 1e-3;

// asin(s) / s of a half angle's sine s, from the squared sine and the cosine c >= 0.
double angleOverSine(double squaredSine, double cosine)
{
  if (squaredSine > 0.01) {
    const double sine = std::sqrt(squaredSine);
    return std::atan2(sine, cosine) / sine;
  }
  // The terms left out are below 1e-15.
  const double u = squaredSine;
  return 1. +
         u * (1. / 6. + u * (3. / 40. + u * (5. / 112. + u * (35. / 1152. + u * (63. / 2816. + u * 231. / 13312.)))));
}

// (1 - cos(theta)) / theta^2 and (theta - sin(theta)) / theta^3.
std::pair<double, double> jacobianFactors(double theta)
{
  const double square = theta * theta;
  if (theta < 0.02) { // The second form loses digits with the third power of the angle.
    return {0.5 - square / 24. * (1. - square / 30.), 1. / 6. - square / 120. * (1. - square / 42.)};
  }
  const double sine = std::sin(0.5 * theta) / theta;
  return {2. * sine * sine, (theta - std::sin(theta)) / (square * theta)};
}
} // namespace

vpHomogeneousMatrix vpPoseExponential::exp(const vpPoseTangent &xi)
{
  vpColVector v(6);
  Eigen::Map<vpPoseTangent>(v.data) = xi;
  return vpExponentialMap::direct(v);
}

Eigen::Isometry3d vpPoseExponential::expEigen(const vpPoseTangent &xi)
{
  const Eigen::Vector3d v = xi.head<3>();
  const Eigen::Vector3d omega = xi.tail<3>();
  const double theta = omega.norm();
  const auto [first, second] = jacobianFactors(theta);
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  if (theta > 0.) {
    pose.linear() = Eigen::AngleAxisd(theta, omega / theta).toRotationMatrix();
  }
  const Eigen::Vector3d turned = omega.cross(v);
  pose.translation() = v + first * turned + second * omega.cross(turned);
  return pose;
}

vpPoseTangent vpPoseExponential::log(const vpHomogeneousMatrix &aMb)
{
  return log(toEigen(aMb));
}

// ViSP's vpThetaUVector recovers the axis near pi from sqrt(R[i][i] - cos(theta)); a quaternion has no such place.
vpPoseTangent vpPoseExponential::log(const Eigen::Isometry3d &aMb)
{
  return log(Eigen::Quaterniond(aMb.linear()).normalized(), aMb.translation());
}

vpPoseTangent vpPoseExponential::log(const Eigen::Quaterniond &aRb, const Eigen::Vector3d &atb)
{
  const double sign = aRb.w() < 0. ? -1. : 1.; // Of the two quaternions of a rotation, that of the shorter way.
  const double cosine = sign * aRb.w();        // Of half the angle.
  const double squaredSine = aRb.vec().squaredNorm();
  const double ratio = angleOverSine(squaredSine, cosine);
  const Eigen::Vector3d omega = 2. * sign * ratio * aRb.vec();
  // (1 - theta / 2 cot(theta / 2)) / theta^2. Its rounding error grows to 1e-16 / theta^2, but meets theta^2 below.
  const double factor = squaredSine < 1e-15 ? 1. / 12. : (1. - ratio * cosine) / (4. * ratio * ratio * squaredSine);
  vpPoseTangent xi;
  xi << atb - 0.5 * omega.cross(atb) + factor * omega.cross(omega.cross(atb)), omega;
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
