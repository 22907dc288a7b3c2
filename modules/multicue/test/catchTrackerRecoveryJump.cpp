// SPDX-License-Identifier: GPL-2.0-or-later
#include "recoveryScene.h"

#include <cmath>

using namespace recoveryScene;

TEST_CASE("Without colours, what was seen of the surface tells of jumps that turn the image by 50 degrees",
          "[recovery]")
{
  const vpHomogeneousMatrix before = Tracked::swaying(12);
  int right = 0;
  for (const double sign : {-1., 1.}) {
    for (const double shift : {-0.03, 0., 0.03}) {
      Tracked box(true, Tracked::edgesAndPoints);
      Eigen::Isometry3d pose = vpPoseExponential::toEigen(before);
      pose.linear() = Eigen::AngleAxisd(sign * 50. * M_PI / 180., Eigen::Vector3d::UnitZ()) * pose.linear();
      pose.translation() += Eigen::Vector3d(shift, -shift, 0.);
      const vpHomogeneousMatrix jumped = vpPoseExponential::fromEigen(pose);
      box.show(jumped);
      right += box.isRight(jumped) ? 1 : 0;
    }
  }
  CHECK(right >= 5);
}

TEST_CASE("An object that turns on in the dark is looked for where it turned to", "[recovery]")
{
  int found = 0;
  for (const double rate : {-6., 6.}) {
    for (const Eigen::Vector3d axis : {Eigen::Vector3d::UnitX(), Eigen::Vector3d::UnitY()}) {
      found += Tracked(true).turnInTheDark(axis, rate);
    }
  }
  CHECK(found >= 3);
}

TEST_CASE("An object that jumps away is found, with a part of its likeness left where it was", "[recovery]")
{
  for (const double degrees : {-30., 30.}) {
    for (const double shift : {0.1, 0.12, 0.14}) {
      CAPTURE(degrees, shift);
      Tracked object(true);
      object.leaveLikeness();
      const vpHomogeneousMatrix jumped =
          displaced(Tracked::swaying(12), Eigen::Vector3d::UnitZ(), degrees, {shift, 0., 0.});
      const Tracked::Return found = object.comeBack(jumped, 14);
      CHECK(found.right <= 7);
      CHECK(found.confirmed <= 12);
      CHECK(found.wronglyTracked == 0);
    }
  }
}
