// SPDX-License-Identifier: GPL-2.0-or-later
#include <catchMain.h>

#include "evaluate/poseError.h"

#include <modelShapes.h>

#include <visp3/core/vpMath.h>
#include <visp3/model/vpTrackedModelBuilder.h>

#include <cmath>
#include <limits>

namespace {
using bench::PoseError;
using bench::PoseErrorMeasure;

const vpCameraParameters camera(600., 600., 320., 240.);
const vpHomogeneousMatrix truth(0.02, -0.03, 0.6, 0.3, -0.5, 0.8);

vpTrackedModel box()
{
  vpTrackedModelBuilder builder;
  for (const double z : {-0.05, 0.05}) {
    builder.addFace({{-0.1, -0.1, z}, {0.1, -0.1, z}, {0.1, 0.1, z}, {-0.1, 0.1, z}});
  }
  return builder.build("box");
}

vpHomogeneousMatrix turn(double degrees, double x = 0.)
{
  return vpHomogeneousMatrix(x, 0., 0., 0., 0., vpMath::rad(degrees));
}
} // namespace

TEST_CASE("A pose's errors are those of its difference to the truth", "[evaluate]")
{
  const PoseErrorMeasure measure(bench::SequenceObject(), box());
  const PoseError none = measure(truth, truth, camera);
  CHECK(none.translation == Approx(0.).margin(1e-12));
  CHECK(none.rotation == Approx(0.).margin(1e-5));
  CHECK(none.add == Approx(0.).margin(1e-12));

  const PoseError moved = measure(vpHomogeneousMatrix(0.003, 0.004, 0., 0., 0., 0.) * truth, truth, camera);
  CHECK(moved.translation == Approx(0.005));
  CHECK(moved.rotation == Approx(0.).margin(1e-5));
  CHECK(moved.add == Approx(0.005));
  CHECK(moved.adds <= moved.add);
  CHECK(moved.pixels > 600. * 0.005 / 0.8);
  CHECK(moved.pixels < 600. * 0.005 / 0.4);

  CHECK(measure(truth * turn(12.), truth, camera).rotation == Approx(12.));
  CHECK(measure(truth * turn(-179.), truth, camera).rotation == Approx(179.));
}

TEST_CASE("A pose that is not finite is infinitely wrong", "[evaluate]")
{
  const PoseErrorMeasure measure(bench::SequenceObject(), box());
  vpHomogeneousMatrix cMo = truth;
  cMo[0][3] = std::numeric_limits<double>::quiet_NaN();
  CHECK(std::isinf(measure(cMo, truth, camera).translation));
  CHECK(std::isinf(measure(cMo, truth, camera).add));
  CHECK(std::isinf(measure(vpHomogeneousMatrix(0., 0., -1., 0., 0., 0.), truth, camera).pixels));
}

TEST_CASE("Poses that look the same by a declared symmetry are equally right", "[evaluate]")
{
  bench::SequenceObject object;
  object.symmetry.push_back(turn(90.));
  object.symmetry.push_back(turn(180.));
  const PoseErrorMeasure measure(object, box());
  CHECK(measure.isSymmetric());
  CHECK(measure(truth * turn(90.), truth, camera).rotation == Approx(0.).margin(1e-5));
  CHECK(measure(truth * turn(183.), truth, camera).rotation == Approx(3.));
  CHECK(measure(truth * turn(270.), truth, camera).rotation == Approx(90.)); // Was not declared.
}

TEST_CASE("Turns about an axis of symmetry do not count", "[evaluate]")
{
  bench::SequenceObject object;
  bench::SymmetryAxis axis;
  axis.point = Eigen::Vector3d(0.02, 0., 0.);
  object.axis.push_back(axis);
  const PoseErrorMeasure measure(object, box());
  const vpHomogeneousMatrix aboutAxis = turn(0., 0.02) * turn(77.) * turn(0., -0.02);
  CHECK(measure(truth * aboutAxis, truth, camera).rotation == Approx(0.).margin(1e-5));
  CHECK(measure(truth * aboutAxis, truth, camera).translation == Approx(0.).margin(1e-12));

  const vpHomogeneousMatrix tilted = aboutAxis * vpHomogeneousMatrix(0., 0., 0., vpMath::rad(4.), 0., 0.);
  CHECK(measure(truth * tilted, truth, camera).rotation == Approx(4.).margin(0.01));
}
