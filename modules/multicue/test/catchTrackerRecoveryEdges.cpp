// SPDX-License-Identifier: GPL-2.0-or-later
#include "recoveryScene.h"

using namespace recoveryScene;

TEST_CASE("With edges alone it is found as well, with and without particles", "[recovery]")
{
  for (const bool hasParticles : {false, true}) {
    CAPTURE(hasParticles);
    Tracked object(true, vpMbMultiCueTracker::EDGE_TRACKER, hasParticles);
    CHECK(object.darken() == 0);
    const Tracked::Return found = object.comeBack(turned(-40.), 16);
    CHECK(found.right <= 10);
    CHECK(found.confirmed > 1);
    CHECK(found.confirmed <= 15); // Another pose of a plain box has nearly the same outline.
    CHECK(found.wronglyTracked == 0);
    CHECK(object.isTracking());
    CHECK(object.leave() == 0);
  }
}

TEST_CASE("With edges alone it is found at the first look, on the other side of the image", "[recovery]")
{
  int found = 0;
  for (const double degrees : {25., 40., 55., 70.}) {
    CAPTURE(degrees);
    Tracked object(true, vpMbMultiCueTracker::EDGE_TRACKER);
    for (int i = 1; i <= 3; ++i) {
      object.show(displaced(Tracked::swaying(12), Eigen::Vector3d::UnitX(), 0., {0.03 * i, 0., 0.}));
    }
    CHECK(object.darken() == 0);
    const Tracked::Return back = object.comeBack(displaced(start, {1., 0.2, 0.3}, degrees, {-0.15, 0.05, 0.}), 10);
    found += back.right == 1;
    CHECK(back.wronglyTracked == 0);
  }
  CHECK(found >= 3);
}
