// SPDX-License-Identifier: GPL-2.0-or-later
#include "judge/vpContourEvidence.cpp" // The library keeps it to itself.

#include <edgeScenes.h>

#include <catchMain.h>

using namespace edgeScenes;

namespace {
// Edges across the image; the first is the only one that poses have in common.
const Line shared{Eigen::Vector2d(30., 60.), M_PI / 2.};
const Line own{Eigen::Vector2d(80., 60.), M_PI / 2.};
const Line other{Eigen::Vector2d(130., 60.), M_PI / 2.};

//! An image that is brighter from each of these on.
vpImage<unsigned char> drawEdges(const std::vector<Line> &lines)
{
  return draw([lines](const Eigen::Vector2d &pixel) {
    double level = 20.;
    for (const Line &line : lines) {
      level += pixel.x() > line.through.x() ? 60. : 0.;
    }
    return level;
  });
}

//! What an image shows of a pose with these contours.
vpContourEvidence evidence(const vpImage<unsigned char> &I, const std::vector<Line> &contours)
{
  vpEdgeCue cue;
  match(cue, I, viewOf(contours));
  vpContourEvidence result;
  result.set(cue, vpHomogeneousMatrix());
  return result;
}
} // namespace

TEST_CASE("What only one of two poses has speaks for it where it is there, and else against it", "[contour-evidence]")
{
  const auto first = [](const vpImage<unsigned char> &I) { return evidence(I, {shared, own}); };
  const auto second = [](const vpImage<unsigned char> &I) { return evidence(I, {shared, other}); };
  const vpImage<unsigned char> isFirst = drawEdges({shared, own});
  const double advantage = first(isFirst).advantageOver(second(isFirst));
  CHECK(advantage > 10.); // Of two lines of 80 pixels.
  CHECK(second(isFirst).advantageOver(first(isFirst)) == Approx(-advantage));
  const vpImage<unsigned char> isBoth = drawEdges({shared, own, other});
  CHECK(std::fabs(first(isBoth).advantageOver(second(isBoth))) < 0.1 * advantage);
}

TEST_CASE("A pose that has all contours of another one and more is right where they are there", "[contour-evidence]")
{
  const vpImage<unsigned char> I = drawEdges({shared, own});
  CHECK(evidence(I, {shared, own}).advantageOver(evidence(I, {shared})) > 5.);
  CHECK(evidence(I, {shared}).advantageOver(evidence(I, {shared, own})) < -5.);
  const vpImage<unsigned char> less = drawEdges({shared});
  CHECK(evidence(less, {shared}).advantageOver(evidence(less, {shared, own})) > 5.);
}

TEST_CASE("A hidden contour is no evidence for a pose that does not show, either", "[contour-evidence]")
{
  const vpImage<unsigned char> I = drawEdges({shared}); // Something else is in front of both.
  CHECK(evidence(I, {shared, own}).advantageOver(evidence(I, {shared})) == exactly(0.));
  CHECK(evidence(I, {shared, own}).advantageOver(evidence(I, {shared, other})) >= 0.);
  CHECK(evidence(I, {shared, other}).advantageOver(evidence(I, {shared, own})) >= 0.);
}

TEST_CASE("Poses with the same contours, or none, have no advantage", "[contour-evidence]")
{
  const vpImage<unsigned char> I = drawEdges({shared, own});
  const vpContourEvidence same = evidence(I, {shared, own});
  CHECK(same.advantageOver(same) == exactly(0.));
  CHECK(same.advantageOver(evidence(I, {own.moved(2.), shared.moved(-2.)})) ==
        exactly(0.)); // Where the same edges are found.
  CHECK(vpContourEvidence().advantageOver(vpContourEvidence()) == exactly(0.));
}

TEST_CASE("One image says no more than a limit, and some are needed to decide", "[contour-evidence]")
{
  CHECK(vpContourEvidence::oddsOf(0.) == exactly(0.));
  CHECK(vpContourEvidence::oddsOf(5.) == Approx(-vpContourEvidence::oddsOf(-5.)));
  CHECK(vpContourEvidence::oddsOf(1e6) < vpContourEvidence::decisiveOdds);
  CHECK(vpContourEvidence::oddsOf(-1e6) == exactly(-vpContourEvidence::oddsOf(1e6)));
}
