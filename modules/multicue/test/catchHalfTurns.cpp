// SPDX-License-Identifier: GPL-2.0-or-later
#include "symmetry/vpHalfTurns.cpp" // The library keeps it to itself.

#include <modelShapes.h>

#include <visp3/se3/vpPoseExponential.h>

#include <Eigen/Geometry>

#include <vector>

#include <catchMain.h>

namespace {
const vpHomogeneousMatrix expected(0.1, -0.2, 0.8, 0.4, -0.3, 0.7);
const Eigen::Vector3d centre(0.05, 0.3, -0.1);
const vpHomogeneousMatrix other(0., 0., 1., 2.2, 1.9, 0.);
const std::vector<vpHomogeneousMatrix> expectedPoses = {other, expected, other};

//! A box of three sizes whose sides are turned by this in its frame.
vpTrackedModel turnedBox(const Eigen::Matrix3d &turn)
{
  std::vector<modelShapes::Triangle> triangles = modelShapes::boxTriangles({0.1, 0.2, 0.35});
  for (modelShapes::Triangle &triangle : triangles) {
    for (Eigen::Vector3d &corner : triangle) {
      corner = turn * corner + centre;
    }
  }
  return modelShapes::build(triangles);
}

vpHalfTurns halfTurnsOf(const vpTrackedModel &model)
{
  vpHalfTurns turns;
  turns.setModel(model, vpSampleSurface(model, 500));
  return turns;
}

//! Turned about an axis through the middle.
Eigen::Isometry3d turned(const vpHomogeneousMatrix &cMo, double angle, const Eigen::Vector3d &axis)
{
  Eigen::Isometry3d pose = vpPoseExponential::toEigen(cMo);
  const Eigen::Vector3d at = pose * centre;
  pose.linear() = pose.linear() * Eigen::AngleAxisd(angle, axis).toRotationMatrix();
  pose.translation() = at - pose.linear() * centre;
  return pose;
}
} // namespace

TEST_CASE("What was found turned by half is turned back, at its place", "[half-turns]")
{
  const double angle = GENERATE(0., 0.7); // Of the box in its frame.
  const int axis = GENERATE(0, 1, 2);
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(angle, Eigen::Vector3d(1., -2., 0.5).normalized()).toRotationMatrix();
  const Eigen::Isometry3d found = turned(expected, M_PI, turn.col(axis));
  const auto nearer = halfTurnsOf(turnedBox(turn)).nearer(vpPoseExponential::fromEigen(found), expectedPoses);
  REQUIRE(nearer);
  const Eigen::Isometry3d back = vpPoseExponential::toEigen(*nearer);
  const Eigen::Isometry3d truth = vpPoseExponential::toEigen(expected);
  CHECK(Eigen::AngleAxisd(back.linear().transpose() * truth.linear()).angle() < 0.06);
  CHECK((back * centre - truth * centre).norm() < 1e-12);
}

TEST_CASE("What is near to an expected pose has no half turn that is nearer", "[half-turns]")
{
  const double angle = GENERATE(0., 0.5, 1.3);
  const Eigen::Isometry3d found = turned(expected, angle, Eigen::Vector3d::UnitY());
  CHECK_FALSE(
      halfTurnsOf(turnedBox(Eigen::Matrix3d::Identity())).nearer(vpPoseExponential::fromEigen(found), expectedPoses));
}

TEST_CASE("A model without a surface has the half turns about its frame's axes", "[half-turns]")
{
  vpHalfTurns turns;
  turns.setModel(turnedBox(Eigen::Matrix3d::Identity()), {});
  const Eigen::Isometry3d found = turned(expected, M_PI, Eigen::Vector3d::UnitZ());
  const auto nearer = turns.nearer(vpPoseExponential::fromEigen(found), expectedPoses);
  REQUIRE(nearer);
  CHECK((vpPoseExponential::toEigen(*nearer).matrix() - vpPoseExponential::toEigen(expected).matrix()).norm() < 1e-9);
}

TEST_CASE("What sticks out on one side does not move the axis that the rest turns about", "[half-turns]")
{
  std::vector<modelShapes::Triangle> triangles = modelShapes::boxTriangles({0.1, 0.2, 0.35});
  for (modelShapes::Triangle triangle : modelShapes::boxTriangles({0.03, 0.03, 0.12})) {
    for (Eigen::Vector3d &corner : triangle) {
      corner.x() += 0.065; // An antenna: the middle of the box of all is moved by 0.015.
    }
    triangles.push_back(triangle);
  }
  const vpTrackedModel model = modelShapes::build(triangles);
  REQUIRE(model.centre().x() > 0.01);
  const Eigen::Isometry3d pose = vpPoseExponential::toEigen(expected);
  double least = HUGE_VAL;
  for (const vpHomogeneousMatrix &cMo : halfTurnsOf(model).turned(expected)) {
    const Eigen::Isometry3d turn = pose.inverse() * vpPoseExponential::toEigen(cMo);
    const Eigen::Isometry3d right(Eigen::AngleAxisd(M_PI, Eigen::Vector3d::UnitY()));
    const double angle = Eigen::AngleAxisd(right.linear().transpose() * turn.linear()).angle();
    least = std::min(least, angle + turn.translation().norm() / model.diameter());
  }
  CHECK(least < 0.02);
}

TEST_CASE("All half turns of a pose are about its middle", "[half-turns]")
{
  const Eigen::Isometry3d pose = vpPoseExponential::toEigen(expected);
  const std::vector<vpHomogeneousMatrix> all = halfTurnsOf(turnedBox(Eigen::Matrix3d::Identity())).turned(expected);
  REQUIRE(all.size() >= 3);
  for (const vpHomogeneousMatrix &cMo : all) {
    const Eigen::Isometry3d turned = vpPoseExponential::toEigen(cMo);
    CHECK(Eigen::AngleAxisd(pose.linear().transpose() * turned.linear()).angle() == Approx(M_PI));
    CHECK((turned * centre - pose * centre).norm() < 1e-9);
  }
}
