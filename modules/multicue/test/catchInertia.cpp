// SPDX-License-Identifier: GPL-2.0-or-later
#include "motion/vpInertia.cpp" // The library keeps it to itself.
#include "motion/vpTurnBetween.h"

#include <catchMain.h>

#include <cmath>

namespace {
const Eigen::Vector3d centre(0.05, 0.3, -0.1);
const double diameter = 0.8;
const double turn = 0.05; // Of the object in each frame, radians.
const std::array<double, 2> deviation = {0.01, 0.01};

//! The object after so many frames of an even turn about its middle, and \e stopped of them at rest.
vpInertia::State stateAt(int frames, int stopped = 0)
{
  vpPoseTangent velocity = vpPoseTangent::Zero();
  velocity.tail<3>() = turn * Eigen::Vector3d(0., 1., 0.);
  velocity.head<3>() = -velocity.tail<3>().cross(centre);
  const vpHomogeneousMatrix start(0.1, -0.2, 2., 0.4, -0.3, 0.7);
  return {vpEvenMotion(start, velocity, centre, frames - stopped), velocity, static_cast<double>(frames), deviation};
}

void predict(vpInertia &inertia, int frame)
{
  inertia.predict(frame, centre, diameter);
}
} // namespace

TEST_CASE("Nothing is known before a first frame, and after a reset", "[inertia]")
{
  vpInertia inertia;
  const auto isUnknown = [&inertia] { return !inertia.isPredicted() && !inertia.isLeftBy(stateAt(20).cMo); };
  predict(inertia, 1);
  CHECK(isUnknown());
  inertia.update(stateAt(1));
  predict(inertia, 2);
  CHECK_FALSE(isUnknown());
  inertia.skip();
  CHECK(isUnknown());
  inertia.reset();
  predict(inertia, 3);
  CHECK(isUnknown());
}

TEST_CASE("What goes on as it moved is where it is expected", "[inertia]")
{
  vpInertia inertia;
  for (int frame = 0; frame < 20; ++frame) {
    predict(inertia, frame);
    const vpInertia::State state = stateAt(frame);
    CHECK_FALSE(inertia.isLeftBy(state.cMo));
    CHECK((frame == 0 || vpTurnBetween(inertia.cMo(), state.cMo) < 1e-6));
    inertia.update(state);
  }
}

TEST_CASE("An object that stops is expected to go on for some frames, and not for ever", "[inertia]")
{
  vpInertia inertia;
  inertia.update(stateAt(0));
  int doubted = 0;
  for (int frame = 1; frame < 20; ++frame) {
    predict(inertia, frame);
    vpInertia::State stopped = stateAt(frame, frame);
    // The velocity that a filter tells has followed it at once.
    stopped.velocity.setZero();
    if (inertia.isLeftBy(stopped.cMo)) {
      ++doubted;
      CHECK_FALSE(inertia.isLeftBy(stateAt(frame).cMo)); // Where it would be.
    }
    inertia.update(stopped);
  }
  CHECK(doubted == 8);
}

TEST_CASE("The less even the motion was, the less is expected of it", "[inertia]")
{
  vpInertia::State shaken = stateAt(0);
  shaken.deviation = {0.05, 0.05};
  vpInertia inertia;
  inertia.update(shaken);
  predict(inertia, 1);
  CHECK_FALSE(inertia.isLeftBy(stateAt(1, 1).cMo));
}
