// SPDX-License-Identifier: GPL-2.0-or-later
#include "edgeScenes.h"

#include <catchMain.h>

using namespace edgeScenes;

namespace {
const Line left{Eigen::Vector2d(40., 60.), M_PI / 2.};
const Line right{Eigen::Vector2d(120., 60.), M_PI / 2.};
const double reach = 2.5; // Pixels.

// A panel between both lines; only what is left of a column has light.
vpImage<unsigned char> drawPanel(double lit, double level = 100.)
{
  return draw([=](const Eigen::Vector2d &pixel) {
    const bool isPanel = pixel.x() > left.through.x() && pixel.x() < right.through.x();
    return isPanel && pixel.x() < lit ? level : 2.;
  });
}

double lightAt(const vpEdgeCue &cue, double u)
{
  return meanAt(cue, u, [](const vpEdgeCue::Match &match) { return match.light; });
}
} // namespace

TEST_CASE("An edge without light speaks neither for a pose nor against it", "[edge-light]")
{
  vpEdgeCue cue;
  const vpModelView view = viewOf({left, right});
  const vpHomogeneousMatrix cMo;

  match(cue, drawPanel(160.), view); // All of it.
  CHECK(lightAt(cue, 40.) == exactly(1.));
  CHECK(lightAt(cue, 120.) == exactly(1.));
  CHECK(cue.agreement(cMo, reach) > 0.9);

  match(cue, drawPanel(80.), view);
  CHECK(lightAt(cue, 40.) == exactly(1.));
  CHECK(lightAt(cue, 120.) == exactly(0.));
  CHECK(cue.agreement(cMo, reach) > 0.9);

  match(cue, drawPanel(160., 7.5), view); // Twilight: half as much above the contrast as it takes.
  CHECK(std::fabs(lightAt(cue, 40.) - 0.5) < 0.1);
}

TEST_CASE("An edge that light would show speaks against a pose", "[edge-light]")
{
  vpEdgeCue cue;
  const vpModelView view = viewOf({left, right});
  // The panel ends before the right line, behind which it is as bright.
  match(cue, draw([](const Eigen::Vector2d &pixel) { return pixel.x() < left.through.x() ? 2. : 100.; }), view);
  CHECK(lightAt(cue, 120.) == exactly(1.));
  CHECK(cue.agreement(vpHomogeneousMatrix(), reach) < 0.6);
}

TEST_CASE("Without any light nothing agrees", "[edge-light]")
{
  vpEdgeCue cue;
  const vpModelView view = viewOf({left, right});
  CHECK(cue.agreement(vpHomogeneousMatrix(), reach) == exactly(0.)); // Nothing was matched.
  match(cue, draw([](const Eigen::Vector2d &) { return 0.; }), view);
  CHECK(cue.agreement(vpHomogeneousMatrix(), reach) == exactly(0.));
}

TEST_CASE("Points in the dark hardly pull", "[edge-light]")
{
  vpEdgeCue cue;
  // The right line is 8 pixels beside the lit end of the panel.
  const vpModelView view = viewOf({left, right});
  match(cue, drawPanel(112.), view);
  vpResidualBlock block;
  cue.residuals(vpHomogeneousMatrix(), block);
  std::size_t row = 0;
  std::size_t dark = 0;
  for (const vpEdgeCue::Match &match : cue.matches()) {
    if (match.count == 0) {
      continue;
    }
    const bool isDark = match.point.pixel.x() > 80.;
    dark += isDark ? 1 : 0;
    CHECK(block.rows[row].weight == exactly((isDark ? 0.05 : 1.)));
    ++row;
  }
  CHECK(dark > 5);
}
