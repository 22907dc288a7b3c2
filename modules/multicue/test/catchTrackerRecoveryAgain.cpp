// SPDX-License-Identifier: GPL-2.0-or-later
#include "recoveryScene.h"

using namespace recoveryScene;

TEST_CASE("An object that is soon lost again is looked for where it was seen last", "[recovery]")
{
  Tracked object(true, Tracked::edgesAndPoints); // Colours would tell where it is.
  object.darken();
  checkReturn(object.comeBack(turned(-40.), 14));
  vpHomogeneousMatrix last;
  for (int i = 1; i <= 30; ++i) { // On from the last pose of comeBack(), out of reach of where it was before.
    last = displaced(turned(-40.), Eigen::Vector3d::UnitZ(), 7., {0.014 - 0.008 * i, 0.003 * i, 0.});
    object.show(last);
    CHECK(object.isTracking());
  }
  object.darken();
  checkReturn(object.comeBack(last, 14));
}

TEST_CASE("An object that is lost again at once is looked for where it was seen for some frames", "[recovery]")
{
  for (const double degrees : {-55., 55.}) {
    CAPTURE(degrees);
    Tracked object(true, Tracked::edgesAndPoints); // Colours would tell where it is.
    object.darken();
    const auto at = [&](int i) { // Away from where it was before, and on.
      return displaced(turned(degrees * (1. + 0.04 * i)), Eigen::Vector3d::UnitZ(), i, {0.003 * i, 0.003 * i, 0.});
    };
    int tracking = 0;
    int i = 0;
    for (; i < 30 && tracking < 6; ++i) {
      object.show(at(i));
      tracking += object.isTracking();
    }
    REQUIRE(tracking == 6);
    object.darken();
    checkReturn(object.comeBack(at(i + 12), 14));
  }
}
