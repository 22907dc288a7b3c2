// SPDX-License-Identifier: GPL-2.0-or-later
#include "recoveryScene.h"

using namespace recoveryScene;

TEST_CASE("An object that left the image is found where it comes back, turned by 40 degrees", "[recovery]")
{
  Tracked object(true);
  CHECK(object.leave() == 0);
  checkReturn(object.comeBack(elsewhere(40.), 14));
  CHECK(object.isTracking());
}

TEST_CASE("An object that turned by 60 degrees in the dark is found", "[recovery]")
{
  Tracked object(true);
  CHECK(object.darken() == 0);
  checkReturn(object.comeBack(turned(-60.), 14));
  CHECK(object.isTracking());
}

TEST_CASE("An object that comes back from another distance is found there", "[recovery]")
{
  for (const double depth : {-0.15, 0.25}) { // Of 0.6 metres.
    CAPTURE(depth);
    Tracked object(true);
    CHECK(object.leave() == 0);
    vpHomogeneousMatrix back = elsewhere(25.);
    back[2][3] += depth;
    checkReturn(object.comeBack(back, 14));
    CHECK(object.isTracking());
  }
}

TEST_CASE("A hint brings back an object at half and at twice its distance", "[recovery]")
{
  for (const double depth : {-0.3, 0.6}) {
    CAPTURE(depth);
    Tracked object(true);
    CHECK(object.leave() == 0);
    vpHomogeneousMatrix back = elsewhere(25.);
    back[2][3] += depth;
    object.tracker.setPoseHint(displaced(back, {1., 0., 0.}, 5., {0.005, 0., 0.}));
    checkReturn(object.comeBack(back, 14));
    CHECK(object.isTracking());
  }
}

TEST_CASE("Without a search it is not", "[recovery]")
{
  Tracked gone(false);
  gone.leave();
  CHECK(gone.comeBack(elsewhere(40.), 14).right == Tracked::never);
  Tracked dark(false);
  dark.darken();
  CHECK(dark.comeBack(turned(-60.), 14).right == Tracked::never);
}
