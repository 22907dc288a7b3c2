// SPDX-License-Identifier: GPL-2.0-or-later
#include "edgeScenes.h"

#include <catchMain.h>

#include <cmath>

using namespace edgeScenes;

namespace {
const Line edge{Eigen::Vector2d(80., 60.), 0.};

vpEdgeCueSettings settingsOf(unsigned int candidates)
{
  vpEdgeCueSettings settings;
  settings.candidates = candidates;
  return settings;
}

//! Of all rows, pixels: the plane is 1 m away.
double meanError(const vpEdgeCue &cue)
{
  vpResidualBlock block;
  cue.residuals(vpHomogeneousMatrix(), block);
  double sum = 0.;
  for (const vpResidual &row : block.rows) {
    sum += row.error;
  }
  return sum / static_cast<double>(block.rows.size()) * makeCamera().get_px();
}

//! A strong edge and a weak one beside it.
vpImage<unsigned char> drawTwo(double gap)
{
  return draw([&](const Eigen::Vector2d &pixel) {
    return 60. + 100. * blurredStep(edge.distance(pixel), 0.7) +
           30. * blurredStep(edge.moved(gap).distance(pixel), 0.7);
  });
}
} // namespace

TEST_CASE("The farther off the pose may be, the more the strongest edge counts and not the nearest", "[edge-evidence]")
{
  vpEdgeCue cue(settingsOf(3));
  match(cue, drawTwo(6.), viewOf({edge.moved(5.)})); // One pixel from the weak edge, five from the strong one.
  const double nearest = meanError(cue);
  CHECK(std::fabs(std::fabs(nearest) - 1.) < 0.2);
  cue.setUncertainty(8.);
  CHECK(std::fabs(std::fabs(meanError(cue)) - 5.) < 0.2);
  CHECK(nearest * meanError(cue) < 0.); // On the other side.
  cue.setUncertainty(1.);
  CHECK(std::fabs(meanError(cue) - nearest) < 1e-9);
  cue.setUncertainty(0.);
  CHECK(std::fabs(meanError(cue) - nearest) < 1e-9);
}

TEST_CASE("Evidence is that of the formula, and falls with distance, rivals and missing edges", "[edge-evidence]")
{
  const double missed = 0.2;
  const double peak = 2. * vpEdgeCueSettings().range / std::sqrt(2. * M_PI);
  vpEdgeCue cue(settingsOf(3));

  match(cue, drawStep(edge, 100.), viewOf({edge}));
  const double there = cue.evidence(vpHomogeneousMatrix());
  CHECK(std::fabs(there - std::log(missed + (1. - missed) * peak)) < 0.02);

  match(cue, drawStep(edge, 100.), viewOf({edge.moved(2.)}));
  const double beside = cue.evidence(vpHomogeneousMatrix());
  CHECK(std::fabs(beside - std::log(missed + (1. - missed) * peak * std::exp(-2.))) < 0.15);

  match(cue, drawTwo(6.), viewOf({edge.moved(6.)})); // At the weaker one of two.
  const double second = cue.evidence(vpHomogeneousMatrix());
  CHECK(std::fabs(second - std::log(missed + 0.5 * (1. - missed) * peak)) < 0.05);

  match(cue, vpImage<unsigned char>(height, width, 128), viewOf({edge}));
  CHECK(std::fabs(cue.evidence(vpHomogeneousMatrix()) - std::log(missed)) < 1e-9);
  CHECK(vpEdgeCue().evidence(vpHomogeneousMatrix()) == exactly(0.));
}

TEST_CASE("Contrasts follow light that changes all of them by one factor", "[edge-evidence]")
{
  vpEdgeCue cue(settingsOf(3));
  const vpModelView view = viewOf({edge});
  match(cue, drawStep(edge, 100.), view);
  learn(cue);
  const vpImage<unsigned char> darker = drawStep(edge, 30.);
  match(cue, darker, view);
  CHECK(found(cue) == 0);

  vpFrameSource source;
  const double factor = cue.adaptToLight(source.frame(darker, makeCamera(), nullptr), view);
  CHECK(std::fabs(factor - 0.3) < 0.02);
  CHECK(cue.settings().mu1 == exactly(vpEdgeCueSettings().mu1));
  match(cue, darker, view);
  CHECK(found(cue) == cue.matches().size());

  vpEdgeCue without; // Nothing is remembered.
  CHECK(without.adaptToLight(source.frame(darker, makeCamera(), nullptr), view) == exactly(1.));
}
