// SPDX-License-Identifier: GPL-2.0-or-later
#include "estimate/vpUnobservedMotions.h"

#include "motion/vpCentreFrame.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstdio>

BEGIN_VISP_NAMESPACE

namespace {
// Share of the information of the motion that is known best. A round contour made of few straight bits seems to tell a
// turn about its axis by about this much.
const double leastInformation = 2e-3;
// A motion among those that are not observed is named where it has this share of its length there.
const double sameMotion = 0.98;
// Parts of a motion that are smaller than this do not change its name.
const double littlePart = 0.03;

vpPoseMatrix6 informationOf(const vpCueFusion &fusion)
{
  vpPoseMatrix6 information = vpPoseMatrix6::Zero();
  for (std::size_t i = 0; i < fusion.size(); ++i) {
    const vpCueFusion::Part &part = fusion[i];
    const std::size_t rows = part.scale > 0. ? std::min(part.weights.size(), part.block.rows.size()) : 0;
    for (std::size_t k = 0; k < rows; ++k) {
      const vpResidual &row = part.block.rows[k];
      const double factor = part.weights[k] * row.weight / part.scale;
      information.noalias() += (factor * factor) * row.jacobian * row.jacobian.transpose();
    }
  }
  return information;
}

std::string vectorText(const Eigen::Vector3d &vector)
{
  char text[80];
  std::snprintf(text, sizeof text, "(%.3g, %.3g, %.3g)", vector.x() + 0., vector.y() + 0., vector.z() + 0.);
  return text;
}

// "z" or a vector.
std::string axisText(const Eigen::Vector3d &direction)
{
  for (int i = 0; i < 3; ++i) {
    if (std::fabs(direction[i]) > 1. - littlePart * littlePart) {
      return std::string("the object's ") + "xyz"[i] + " axis";
    }
  }
  return "the direction " + vectorText(direction) + " of the object";
}
} // namespace

// From motions in which all that may be seen is seen about alike to metres and radians at the object's middle.
vpPoseMatrix6 vpUnobservedMotions::units(const vpHomogeneousMatrix &cMb) const
{
  const double radius = 0.5 * m_model.diameter();
  const Eigen::Isometry3d pose = vpPoseExponential::toEigen(cMb);
  const Eigen::Vector3d sight = pose.linear().transpose() * pose.translation().normalized();
  const double depth = std::max(pose.translation().norm() / radius, 1.);
  vpPoseMatrix6 units = vpPoseMatrix6::Zero();
  units.topLeftCorner<3, 3>() = Eigen::Matrix3d::Identity() + (depth - 1.) * sight * sight.transpose();
  units.bottomRightCorner<3, 3>() = Eigen::Matrix3d::Identity() / radius;
  return units;
}

// Turns about the axes of symmetry, shifts and turns along the object's own axes as far as these motions span them, and
// what is left of them. Eigenvectors alone are any mixture.
vpUnobservedMotions::Motions vpUnobservedMotions::named(const Motions &hidden, const vpPoseMatrix6 &units) const
{
  Motions rest = hidden; // Orthonormal.
  Motions found(6, 0);
  const auto take = [&](const vpPoseTangent &motion) {
    const vpPoseTangent unit = (units.inverse() * motion).normalized();
    const Eigen::VectorXd shares = rest.transpose() * unit;
    if (rest.cols() == 0 || shares.norm() < sameMotion) {
      return;
    }
    found.conservativeResize(6, found.cols() + 1);
    found.rightCols<1>() = motion;
    // An orthonormal basis of what is perpendicular to it.
    const Eigen::VectorXd within = shares.normalized();
    const Eigen::MatrixXd basis = within.householderQr().householderQ();
    rest = Motions(rest * basis.rightCols(rest.cols() - 1));
  };
  const vpPoseMatrix6 bVo = vpPoseExponential::adjoint(vpCentreFrame(m_model).inverse());
  const Eigen::Matrix<double, 6, Eigen::Dynamic> symmetric = bVo * m_symmetries.hiddenMotions();
  for (Eigen::Index i = 0; i < symmetric.cols(); ++i) {
    take(symmetric.col(i));
  }
  for (int i = 0; i < 6; ++i) {
    take(vpPoseTangent::Unit(i));
  }
  const Eigen::Index count = found.cols();
  found.conservativeResize(6, count + rest.cols());
  found.rightCols(rest.cols()) = units * rest;
  return found;
}

// What a motion is, from its parts: a turn about a line, a shift, or both.
std::string vpUnobservedMotions::textOf(const vpPoseTangent &motion, bool turns) const
{
  const Eigen::Vector3d shift = motion.head<3>();
  const Eigen::Vector3d turn = motion.tail<3>();
  if (!turns) {
    return "shift along " + axisText(shift);
  }
  const double little = littlePart * 0.5 * m_model.diameter();
  const double along = shift.dot(turn);
  const Eigen::Vector3d point = turn.cross(shift); // Of the line that stays where it is, from the middle.
  const Eigen::Vector3d fromOrigin = m_model.centre() + point;
  const bool isThroughOrigin = (fromOrigin - fromOrigin.dot(turn) * turn).norm() < little;
  std::string text = "turn about " + axisText(turn);
  if (point.norm() > little && !isThroughOrigin) {
    text += " through " + vectorText(fromOrigin) + " m";
  }
  char pitch[80] = "";
  if (std::fabs(along) > little) {
    std::snprintf(pitch, sizeof pitch, ", with a shift of %.3g m for each radian", along);
  }
  return text + pitch;
}

vpMbTrackingResult::UnobservedMotion vpUnobservedMotions::describe(const vpPoseTangent &motion) const
{
  const double turned = motion.tail<3>().norm() * 0.5 * m_model.diameter();
  const bool turns = turned > littlePart * motion.head<3>().norm();
  vpPoseTangent unit = motion / (turns ? motion.tail<3>().norm() : motion.head<3>().norm());
  if (!turns) {
    unit.tail<3>().setZero();
  }
  vpMbTrackingResult::UnobservedMotion result;
  result.direction.resize(6);
  std::copy(unit.data(), unit.data() + 6, result.direction.data);
  result.text = textOf(unit, turns);
  return result;
}

std::vector<vpMbTrackingResult::UnobservedMotion> vpUnobservedMotions::find(const vpCueFusion &fusion) const
{
  const vpHomogeneousMatrix cMb = fusion.pose() * vpCentreFrame(m_model);
  const vpPoseMatrix6 scaled = units(cMb);
  const vpPoseMatrix6 toCamera = vpPoseExponential::adjoint(cMb) * scaled;
  const Eigen::SelfAdjointEigenSolver<vpPoseMatrix6> solver(toCamera.transpose() * informationOf(fusion) * toCamera);
  const double least = leastInformation * solver.eigenvalues()(5);
  const Eigen::Index count = (solver.eigenvalues().array() <= least).count(); // They come first.
  std::vector<vpMbTrackingResult::UnobservedMotion> result;
  if (count == 0) {
    return result;
  }
  const Motions motions = named(solver.eigenvectors().leftCols(count), scaled);
  for (Eigen::Index i = 0; i < motions.cols(); ++i) {
    result.push_back(describe(motions.col(i)));
  }
  return result;
}

END_VISP_NAMESPACE
