// SPDX-License-Identifier: GPL-2.0-or-later
#include "evaluate/poseError.h"

#include <visp3/core/vpMath.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>

namespace bench {

namespace {
using Pose = Eigen::Matrix4d;

Pose toEigen(const vpHomogeneousMatrix &M)
{
  return Eigen::Map<const Eigen::Matrix<double, 4, 4, Eigen::RowMajor>>(M.data);
}

vpHomogeneousMatrix toVisp(const Pose &M)
{
  vpHomogeneousMatrix result;
  Eigen::Map<Eigen::Matrix<double, 4, 4, Eigen::RowMajor>>(result.data) = M;
  return result;
}

Eigen::Vector3d transform(const Pose &M, const Eigen::Vector3d &X)
{
  return M.topLeftCorner<3, 3>() * X + M.topRightCorner<3, 1>();
}

std::vector<Eigen::Vector3d> transformAll(const Pose &M, const std::vector<Eigen::Vector3d> &points)
{
  std::vector<Eigen::Vector3d> result;
  result.reserve(points.size());
  for (const Eigen::Vector3d &X : points) {
    result.push_back(transform(M, X));
  }
  return result;
}

// The turn about the axis that brings the truth nearest to the estimate: with R the rotation from truth to estimate,
// the trace of R^T exp(angle [a]) is largest where tan(angle) = (sum of the antisymmetric part along a) / (tr R - a^T R
// a).
Pose bestTurn(const Pose &oMe, const SymmetryAxis &axis)
{
  const Eigen::Matrix3d R = oMe.topLeftCorner<3, 3>();
  const Eigen::Vector3d skew(R(2, 1) - R(1, 2), R(0, 2) - R(2, 0), R(1, 0) - R(0, 1));
  const double angle = std::atan2(axis.direction.dot(skew), R.trace() - axis.direction.dot(R * axis.direction));
  Pose turn = Pose::Identity();
  turn.topLeftCorner<3, 3>() = Eigen::AngleAxisd(angle, axis.direction).toRotationMatrix();
  turn.topRightCorner<3, 1>() = axis.point - turn.topLeftCorner<3, 3>() * axis.point;
  return turn;
}

double meanDistance(const Pose &first, const Pose &second, const std::vector<Eigen::Vector3d> &points)
{
  double sum = 0.;
  for (const Eigen::Vector3d &X : points) {
    sum += (transform(first, X) - transform(second, X)).norm();
  }
  return sum / static_cast<double>(points.size());
}

double meanNearestDistance(const std::vector<Eigen::Vector3d> &estimate, const std::vector<Eigen::Vector3d> &truth)
{
  double sum = 0.;
  for (const Eigen::Vector3d &X : truth) {
    double nearest = std::numeric_limits<double>::infinity();
    for (const Eigen::Vector3d &Y : estimate) {
      nearest = std::min(nearest, (X - Y).squaredNorm());
    }
    sum += std::sqrt(nearest);
  }
  return sum / static_cast<double>(truth.size());
}

double meanPixelDistance(const std::vector<Eigen::Vector3d> &estimate, const std::vector<Eigen::Vector3d> &truth,
                         const vpCameraParameters &cam)
{
  const Eigen::Array2d focal(cam.get_px(), cam.get_py());
  double sum = 0.;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    if (estimate[i].z() <= 0. || truth[i].z() <= 0.) {
      return std::numeric_limits<double>::infinity();
    }
    const Eigen::Array2d difference =
        estimate[i].head<2>().array() / estimate[i].z() - truth[i].head<2>().array() / truth[i].z();
    sum += (focal * difference).matrix().norm();
  }
  return sum / static_cast<double>(truth.size());
}
} // namespace

PoseErrorMeasure::PoseErrorMeasure(const SequenceObject &object, const vpTrackedModel &model) : m_axes(object.axis)
{
  const std::size_t most = 500;
  const std::size_t count = model.vertices().size();
  const std::size_t used = std::min(count, most);
  for (std::size_t i = 0; i < used; ++i) {
    m_points.push_back(model.vertices()[i * count / used]);
  }
  m_symmetries.push_back(Pose::Identity());
  for (const vpHomogeneousMatrix &symmetry : object.symmetry) {
    m_symmetries.push_back(toEigen(symmetry));
  }
}

vpHomogeneousMatrix PoseErrorMeasure::nearestTruth(const vpHomogeneousMatrix &cMo,
                                                   const vpHomogeneousMatrix &truth) const
{
  const Pose estimate = toEigen(cMo);
  Pose nearest = toEigen(truth);
  double least = std::numeric_limits<double>::infinity();
  const auto consider = [&](const Pose &candidate) {
    const double distance = meanDistance(estimate, candidate, m_points);
    if (distance < least) {
      least = distance;
      nearest = candidate;
    }
  };
  for (const Pose &symmetry : m_symmetries) {
    const Pose same = toEigen(truth) * symmetry;
    consider(same);
    for (const SymmetryAxis &axis : m_axes) {
      consider(same * bestTurn(same.inverse() * estimate, axis));
    }
  }
  return toVisp(nearest);
}

PoseError PoseErrorMeasure::operator()(const vpHomogeneousMatrix &cMo, const vpHomogeneousMatrix &truth,
                                       const vpCameraParameters &cam) const
{
  if (!std::all_of(cMo.data, cMo.data + 16, [](double value) { return std::isfinite(value); })) {
    const double infinite = std::numeric_limits<double>::infinity();
    return {infinite, 180., infinite, infinite, infinite};
  }
  const Pose target = toEigen(isSymmetric() ? nearestTruth(cMo, truth) : truth);
  const Pose estimate = toEigen(cMo);
  const std::vector<Eigen::Vector3d> seen = transformAll(estimate, m_points);
  const std::vector<Eigen::Vector3d> expected = transformAll(target, m_points);

  PoseError error;
  error.translation = (estimate - target).topRightCorner<3, 1>().norm();
  const Eigen::Matrix3d difference = target.topLeftCorner<3, 3>().transpose() * estimate.topLeftCorner<3, 3>();
  error.rotation = vpMath::deg(std::abs(Eigen::AngleAxisd(difference).angle()));
  error.pixels = meanPixelDistance(seen, expected, cam);
  error.add = meanDistance(estimate, target, m_points);
  error.adds = meanNearestDistance(seen, expected);
  return error;
}

} // namespace bench
