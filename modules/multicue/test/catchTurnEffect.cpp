// SPDX-License-Identifier: GPL-2.0-or-later
#include "knowledge/vpTurnEffect.h"

#include <catchMain.h>

#include <cmath>

namespace {
const double quarter = 0.5 * M_PI;

//! After turns by all angles up to half a turn. \param limit Variance after far turns.
vpTurnEffect observed(double limit)
{
  vpTurnEffect effect;
  for (int i = 1; i <= 200; ++i) {
    const double angle = M_PI * (i % 20 + 1) / 20.;
    effect.observe(angle, limit * angle * angle / (angle * angle + 0.35 * 0.35));
  }
  return effect;
}
} // namespace

TEST_CASE("An object that was not turned yet may look different after a turn", "[turn-effect]")
{
  const vpTurnEffect effect;
  CHECK(effect.variance(0.) == exactly(0.));
  CHECK(effect.variance(quarter) > 0.3);
  CHECK(effect.variance(0.1) < 0.1 * effect.variance(quarter));
}

TEST_CASE("Print looks the same from all sides, foil does not", "[turn-effect]")
{
  CHECK(observed(0.05).variance(quarter) == exactly(0.));
  CHECK(observed(0.6).variance(M_PI) == Approx(0.6 - 0.12).epsilon(0.1));
  CHECK(observed(0.6).variance(0.35) == Approx(0.5 * (0.6 - 0.12)).epsilon(0.1));
}

TEST_CASE("What an object looks like lately counts most", "[turn-effect]")
{
  vpTurnEffect effect = observed(0.6);
  for (int i = 0; i < 300; ++i) {
    effect.observe(quarter, 0.);
  }
  CHECK(effect.variance(quarter) < 0.03);
  effect.reset();
  CHECK(effect.variance(quarter) == exactly(vpTurnEffect().variance(quarter)));
}

TEST_CASE("One frame counts no more than a variance of 1, and none less than 0", "[turn-effect]")
{
  vpTurnEffect one;
  vpTurnEffect most;
  one.observe(quarter, 1.);
  most.observe(quarter, 100.);
  CHECK(most.variance(quarter) == exactly(one.variance(quarter)));
  vpTurnEffect none;
  vpTurnEffect negative;
  none.observe(quarter, 0.);
  negative.observe(quarter, -1.);
  CHECK(negative.variance(quarter) == exactly(none.variance(quarter)));
}
