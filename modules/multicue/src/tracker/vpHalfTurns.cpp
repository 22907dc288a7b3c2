// SPDX-License-Identifier: GPL-2.0-or-later
#include "tracker/vpHalfTurns.h"

#include "tracker/vpTurnBetween.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>

BEGIN_VISP_NAMESPACE

namespace {
const double muchNearer = 0.5; // Radians.

Eigen::Matrix3d halfTurn(const Eigen::Vector3d &axis)
{
  return 2. * axis * axis.transpose() - Eigen::Matrix3d::Identity();
}

double leastAngle(const vpHomogeneousMatrix &cMo, const std::vector<vpHomogeneousMatrix> &expected)
{
  double least = HUGE_VAL;
  for (const vpHomogeneousMatrix &pose : expected) {
    least = std::min(least, vpTurnBetween(pose, cMo));
  }
  return least;
}
} // namespace

void vpHalfTurns::setModel(const vpTrackedModel &model, const std::vector<vpSurfaceSample> &samples)
{
  m_centre = model.centre();
  m_turns.clear();
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();
  for (const vpSurfaceSample &sample : samples) {
    const Eigen::Vector3d place = sample.position.cast<double>() - m_centre;
    mean += place;
    squares += place * place.transpose();
  }
  for (int i = 0; i < 3; ++i) {
    m_turns.push_back(halfTurn(Eigen::Vector3d::Unit(i)));
  }
  if (samples.empty()) {
    return;
  }
  const auto count = static_cast<double>(samples.size());
  const Eigen::Matrix3d covariance = squares / count - mean * mean.transpose() / (count * count);
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(covariance);
  for (int i = 0; i < 3; ++i) {
    m_turns.push_back(halfTurn(solver.eigenvectors().col(i)));
  }
}

std::vector<vpHomogeneousMatrix> vpHalfTurns::turned(const vpHomogeneousMatrix &cMo) const
{
  const Eigen::Isometry3d pose = vpPoseExponential::toEigen(cMo);
  const Eigen::Vector3d at = pose * m_centre;
  std::vector<vpHomogeneousMatrix> poses;
  for (const Eigen::Matrix3d &turn : m_turns) {
    Eigen::Isometry3d turned = pose;
    turned.linear() = pose.linear() * turn;
    turned.translation() = at - turned.linear() * m_centre;
    poses.push_back(vpPoseExponential::fromEigen(turned));
  }
  return poses;
}

std::optional<vpHomogeneousMatrix> vpHalfTurns::nearer(const vpHomogeneousMatrix &cMo,
                                                       const std::vector<vpHomogeneousMatrix> &expected) const
{
  std::optional<vpHomogeneousMatrix> found;
  double least = leastAngle(cMo, expected) - muchNearer;
  for (const vpHomogeneousMatrix &pose : turned(cMo)) {
    const double angle = leastAngle(pose, expected);
    if (angle < least) {
      least = angle;
      found = pose;
    }
  }
  return found;
}

END_VISP_NAMESPACE
