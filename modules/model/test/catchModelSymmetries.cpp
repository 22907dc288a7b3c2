// SPDX-License-Identifier: GPL-2.0-or-later
// Symmetries that are given: what follows from them, and the nearest of the poses that look alike.
#include <catchMain.h>

#include <visp3/core/vpException.h>
#include <visp3/model/vpModelSymmetries.h>
#include <visp3/se3/vpPoseExponential.h>
#include <visp3/se3/vpPoseRandom.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace {
vpHomogeneousMatrix turn(const Eigen::Vector3d &axis, double degrees, const Eigen::Vector3d &point = {0., 0., 0.})
{
  Eigen::Isometry3d turn = Eigen::Isometry3d::Identity();
  turn.linear() = Eigen::AngleAxisd(degrees * M_PI / 180., axis.normalized()).toRotationMatrix();
  turn.translation() = point - turn.linear() * point;
  return vpPoseExponential::fromEigen(turn);
}

vpHomogeneousMatrix randomPose(vpPoseRandom &random)
{
  return vpHomogeneousMatrix(0., 0., 0.5, 0., 0., 0.) * vpPoseExponential::exp(random.normalTangent());
}

vpModelSymmetries cube()
{
  vpModelSymmetries symmetries;
  symmetries.addDiscrete(turn(Eigen::Vector3d::UnitX(), 90.));
  symmetries.addDiscrete(turn(Eigen::Vector3d::UnitZ(), 90.));
  return symmetries;
}

const Eigen::Vector3d centre(0.01, -0.02, 0.03);
const double radius = 0.1;

// Six points with the mean and the covariance of a sphere.
double measured(const vpHomogeneousMatrix &a, const vpHomogeneousMatrix &b)
{
  const Eigen::Isometry3d first = vpPoseExponential::toEigen(a);
  const Eigen::Isometry3d second = vpPoseExponential::toEigen(b);
  double sum = 0.;
  for (int i = 0; i < 3; ++i) {
    for (const double sign : {-1., 1.}) {
      const Eigen::Vector3d X = centre + sign * radius * Eigen::Vector3d::Unit(i);
      sum += (first * X - second * X).squaredNorm();
    }
  }
  return std::sqrt(sum / 6.);
}

// Looks at all turns, and at steps of a tenth of a degree about an axis.
double leastByTrying(const vpModelSymmetries &symmetries, const vpHomogeneousMatrix &cMo,
                     const vpHomogeneousMatrix &reference)
{
  double least = std::numeric_limits<double>::infinity();
  for (const vpHomogeneousMatrix &oTo : symmetries.discrete()) {
    if (symmetries.axes().empty()) {
      least = std::min(least, measured(cMo * oTo, reference));
    }
    for (int i = 0; i < 3600 && !symmetries.axes().empty(); ++i) {
      const vpSymmetryAxis &axis = symmetries.axes().front();
      least = std::min(least, measured(cMo * oTo * turn(axis.direction, 0.1 * i, axis.point), reference));
    }
  }
  return least;
}

void checkNearest(const vpModelSymmetries &symmetries)
{
  vpPoseRandom random(5);
  for (int i = 0; i < 20; ++i) {
    const vpHomogeneousMatrix cMo = randomPose(random);
    const vpHomogeneousMatrix reference = randomPose(random);
    const vpHomogeneousMatrix found = symmetries.nearest(cMo, reference, centre, radius);
    const double least = leastByTrying(symmetries, cMo, reference);
    CHECK(measured(found, reference) <= least + 1e-9);
    CHECK(measured(found, reference) > least - 1e-5);
    CHECK(symmetries.contains(cMo.inverse() * found));
    CHECK(vpModelSymmetries::distance(found, reference, centre, radius) == Approx(measured(found, reference)));
  }
}
} // namespace

TEST_CASE("Turns that are given are completed to all that follow from them", "[symmetries]")
{
  vpModelSymmetries symmetries;
  CHECK(symmetries.isEmpty());
  symmetries.addDiscrete(vpHomogeneousMatrix());
  CHECK(symmetries.isEmpty());
  symmetries.addDiscrete(turn(Eigen::Vector3d::UnitZ(), 60.));
  CHECK(symmetries.discrete().size() == 6);
  symmetries.addDiscrete(turn(Eigen::Vector3d::UnitX(), 180.));
  CHECK(symmetries.discrete().size() == 12);
  symmetries.addDiscrete(turn(Eigen::Vector3d::UnitX(), 180.));
  CHECK(symmetries.discrete().size() == 12);
  CHECK(symmetries.contains(turn(Eigen::Vector3d::UnitZ(), 120.)));
  CHECK_FALSE(symmetries.contains(turn(Eigen::Vector3d::UnitZ(), 90.)));
  CHECK(cube().discrete().size() == 24);
}

TEST_CASE("Turns that differ by one about the axis count once", "[symmetries]")
{
  vpModelSymmetries symmetries;
  symmetries.addDiscrete(turn(Eigen::Vector3d::UnitX(), 180.));
  symmetries.addDiscrete(turn(Eigen::Vector3d::UnitZ(), 90.));
  CHECK(symmetries.discrete().size() == 8);
  symmetries.addAxis({{0., 0., 3.}, {0., 0., 1.}});
  CHECK(symmetries.discrete().size() == 2); // The can, and the can upside down.
  REQUIRE(symmetries.axes().size() == 1);
  CHECK(symmetries.axes()[0].direction.norm() == Approx(1.));
  CHECK(symmetries.contains(turn({1., 1., 0.}, 180.)));
  CHECK_FALSE(symmetries.contains(turn({1., 1., 0.}, 90.)));
}

TEST_CASE("Of the poses that look alike the nearest one is found", "[symmetries]")
{
  checkNearest(cube());
  vpModelSymmetries can;
  can.addAxis({{0., 0., 1.}, {0.02, 0.01, 0.}});
  checkNearest(can);
  can.addDiscrete(turn(Eigen::Vector3d::UnitX(), 180., {0.02, 0.01, 0.05}));
  checkNearest(can);
}

TEST_CASE("A sphere looks the same after all turns about its middle", "[symmetries]")
{
  vpModelSymmetries sphere;
  const Eigen::Vector3d middle(0.02, 0.01, 0.05);
  sphere.addDiscrete(turn(Eigen::Vector3d::UnitX(), 90., middle));
  sphere.addDiscrete(turn(Eigen::Vector3d::UnitX(), 180., middle));
  CHECK_THROWS_AS(sphere.addAxis({{1., 1., 0.}, middle}), vpException); // Turned to another direction.
  CHECK(sphere.axes().empty());
  vpModelSymmetries ball;
  ball.addAxis({{1., 0., 0.}, middle + Eigen::Vector3d(3., 0., 0.)});
  ball.addAxis({{1., 1., 0.}, middle});
  REQUIRE(ball.axes().size() == 3);
  CHECK((ball.axes()[0].point - middle).norm() < 1e-9);
  vpPoseRandom random(7);
  for (int i = 0; i < 20; ++i) {
    const vpHomogeneousMatrix cMo = randomPose(random);
    const vpHomogeneousMatrix reference = randomPose(random);
    const vpHomogeneousMatrix found = ball.nearest(cMo, reference, centre, radius);
    const Eigen::Isometry3d before = vpPoseExponential::toEigen(cMo);
    CHECK((vpPoseExponential::toEigen(found) * middle - before * middle).norm() < 1e-9);
    const double least = measured(found, reference);
    for (int j = 0; j < 30; ++j) {
      const Eigen::Vector3d axis = random.normalTangent().head<3>();
      const double degrees = j < 15 ? 1. : 12. * j; // No turn, small or large, comes nearer.
      CHECK(measured(found * turn(axis, degrees, middle), reference) >= least - 1e-12);
    }
  }
}

TEST_CASE("What is no symmetry is refused and changes nothing", "[symmetries]")
{
  vpModelSymmetries symmetries = cube();
  vpHomogeneousMatrix bad = turn(Eigen::Vector3d::UnitX(), 90.);
  bad[0][0] = -1.;
  CHECK_THROWS_WITH(symmetries.addDiscrete(bad), ContainsSubstring("rotation"));
  CHECK_THROWS_WITH(symmetries.addDiscrete(vpHomogeneousMatrix(0.1, 0., 0., 0., 0., 0.)), ContainsSubstring("0.1 m"));
  CHECK_THROWS_WITH(symmetries.addDiscrete(turn(Eigen::Vector3d::UnitX(), 1.)), ContainsSubstring("axis"));
  CHECK_THROWS_WITH(symmetries.addDiscrete(turn({1., 2., 3.}, 70.)), ContainsSubstring("120"));
  CHECK_THROWS_WITH(symmetries.addAxis({{0., 0., 0.}, {0., 0., 0.}}), ContainsSubstring("direction"));
  CHECK_THROWS_WITH(symmetries.addAxis({{0., 0., 1.}, {0., 0., 0.}}), ContainsSubstring("sphere"));
  CHECK(symmetries.discrete().size() == 24);
  CHECK(symmetries.axes().empty());
}
