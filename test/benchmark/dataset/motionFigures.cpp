// SPDX-License-Identifier: GPL-2.0-or-later
#include "dataset/motionFigures.h"

#include <visp3/core/vpMath.h>
#include <visp3/se3/vpPoseExponential.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace bench {
namespace {
const std::size_t mostPoints = 500;

using Pixels = Eigen::Matrix2Xd;

Eigen::Matrix3Xd spreadPoints(const std::vector<Eigen::Vector3d> &points)
{
  const std::size_t used = std::min(points.size(), mostPoints);
  Eigen::Matrix3Xd result(3, static_cast<Eigen::Index>(used));
  for (std::size_t i = 0; i < used; ++i) {
    result.col(static_cast<Eigen::Index>(i)) = points[i * points.size() / used];
  }
  return result;
}

Pixels project(const Eigen::Isometry3d &cMo, const Eigen::Matrix3Xd &points, const vpCameraParameters &cam)
{
  const Eigen::Matrix3Xd c = (cMo.linear() * points).colwise() + cMo.translation();
  Pixels pixels(2, c.cols());
  pixels.row(0) = cam.get_px() * c.row(0).cwiseQuotient(c.row(2));
  pixels.row(1) = cam.get_py() * c.row(1).cwiseQuotient(c.row(2));
  return pixels;
}

double meanDistance(const Pixels &a, const Pixels &b)
{
  return (a - b).colwise().norm().mean();
}
} // namespace

Spread spreadOf(std::vector<double> values)
{
  if (values.empty()) {
    return {std::nan(""), std::nan(""), std::nan(""), std::nan("")};
  }
  std::sort(values.begin(), values.end());
  const auto at = [&values](double share) {
    return values[static_cast<std::size_t>(std::lround(share * static_cast<double>(values.size() - 1)))];
  };
  const double sum = std::accumulate(values.begin(), values.end(), 0.);
  return {sum / static_cast<double>(values.size()), at(0.1), at(0.5), at(0.9)};
}

MotionFigures measureMotion(const std::vector<vpHomogeneousMatrix> &poses, const std::vector<Eigen::Vector3d> &points,
                            const vpCameraParameters &cam)
{
  const Eigen::Matrix3Xd some = spreadPoints(points);
  std::vector<double> pixels;
  std::vector<double> degrees;
  std::vector<double> prediction;
  Eigen::Isometry3d cpMo = Eigen::Isometry3d::Identity();
  Eigen::Isometry3d expected = Eigen::Isometry3d::Identity();
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const Eigen::Isometry3d cMo = vpPoseExponential::toEigen(poses[i]);
    const Pixels now = project(cMo, some, cam);
    if (i > 0) {
      pixels.push_back(meanDistance(now, project(cpMo, some, cam)));
      degrees.push_back(vpMath::deg(Eigen::AngleAxisd(cpMo.linear().transpose() * cMo.linear()).angle()));
    }
    if (i > 1) {
      prediction.push_back(meanDistance(now, project(expected, some, cam)));
    }
    expected = cMo * (cpMo.inverse() * cMo);
    cpMo = cMo;
  }
  return {spreadOf(pixels), spreadOf(degrees), spreadOf(prediction)};
}

} // namespace bench
