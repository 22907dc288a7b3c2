// SPDX-License-Identifier: GPL-2.0-or-later
#include <visp3/se3/vpPoseMean.h>

#include <visp3/se3/vpPoseExponential.h>

#include <visp3/core/vpException.h>

#include <Eigen/SVD>

#include <cmath>

BEGIN_VISP_NAMESPACE

namespace {
double checkedSum(const double *weights, std::size_t count)
{
  double sum = 0.;
  for (std::size_t i = 0; i < count; i++) {
    if (!(weights[i] >= 0.)) {
      throw vpException(vpException::badValue, "Weight %u of a pose mean is %g, but weights have to be >= 0",
                        static_cast<unsigned int>(i), weights[i]);
    }
    sum += weights[i];
  }
  if (!(sum > 0.) || !std::isfinite(sum)) {
    throw vpException(vpException::badValue,
                      "The weights of a pose mean sum up to %g: at least one has to be > 0, and all finite", sum);
  }
  return sum;
}

// The polar factor of the matrix, with the direction of its least singular value turned round where the factor would be
// a reflection. The determinant of the factor decides, since that of the matrix may be 0.
Eigen::Matrix3d closestRotation(const Eigen::Matrix3d &matrix)
{
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(matrix, Eigen::ComputeFullU | Eigen::ComputeFullV);
  const double handedness = (svd.matrixU() * svd.matrixV().transpose()).determinant();
  const Eigen::Vector3d h(1., 1., handedness < 0. ? -1. : 1.);
  return svd.matrixU() * h.asDiagonal() * svd.matrixV().transpose();
}
} // namespace

vpHomogeneousMatrix vpPoseMean::weighted(const std::vector<vpHomogeneousMatrix> &poses,
                                         const std::vector<double> &weights)
{
  if (poses.empty() || poses.size() != weights.size()) {
    throw vpException(vpException::badValue,
                      "A pose mean needs a weight for each pose, but has %u poses and %u weights",
                      static_cast<unsigned int>(poses.size()), static_cast<unsigned int>(weights.size()));
  }
  return weighted(poses.data(), weights.data(), poses.size());
}

vpHomogeneousMatrix vpPoseMean::weighted(const vpHomogeneousMatrix *poses, const double *weights, std::size_t count)
{
  if (count == 0) {
    throw vpException(vpException::badValue, "A pose mean needs at least one pose");
  }
  const double sum = checkedSum(weights, count);
  Eigen::Matrix4d mean = Eigen::Matrix4d::Zero();
  for (std::size_t i = 0; i < count; i++) {
    mean += weights[i] / sum * vpPoseExponential::toEigen(poses[i]).matrix();
  }
  if (!mean.allFinite()) {
    throw vpException(vpException::badValue, "A pose of a pose mean has a value that is not finite");
  }
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.linear() = closestRotation(mean.topLeftCorner<3, 3>());
  pose.translation() = mean.topRightCorner<3, 1>();
  return vpPoseExponential::fromEigen(pose);
}

END_VISP_NAMESPACE
