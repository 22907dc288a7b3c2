// SPDX-License-Identifier: GPL-2.0-or-later
#include "edgeScenes.h"

#include <catchMain.h>

using namespace edgeScenes;

namespace {
const Line middle{Eigen::Vector2d(80.4, 60.3), 0.4};

vpEdgeCueSettings withCandidates(unsigned int candidates)
{
  vpEdgeCueSettings settings;
  settings.candidates = candidates;
  return settings;
}

// Two steps up: 40 gray levels at \e weak and 90 at \e strong, which is further along the normal.
vpImage<unsigned char> drawTwoSteps(const Line &weak, const Line &strong)
{
  return draw([&](const Eigen::Vector2d &pixel) {
    return 60. + 40. * blurredStep(weak.distance(pixel), 0.7) + 90. * blurredStep(strong.distance(pixel), 0.7);
  });
}

// Stripes of 6 pixels across the line: an edge every 6 pixels.
vpImage<unsigned char> drawStripes(const Line &line)
{
  return draw([&](const Eigen::Vector2d &pixel) {
    const double phase = line.distance(pixel) / 12.;
    return phase - std::floor(phase) < 0.5 ? 40. : 200.;
  });
}

const vpEdgeCue::Candidate &candidateOf(const vpEdgeCue &cue, const vpEdgeCue::Match &match, int i)
{
  return cue.candidates()[static_cast<std::size_t>(match.first + i)];
}
} // namespace

TEST_CASE("two parallel edges are two candidates, the stronger first", "[edge-candidates]")
{
  const Line weak = middle.moved(-4.);
  const Line strong = middle.moved(5.);
  vpEdgeCue cue(withCandidates(3));
  match(cue, drawTwoSteps(weak, strong), viewOf({middle}));
  REQUIRE(cue.matches().size() > 15);
  for (const vpEdgeCue::Match &match : cue.matches()) {
    REQUIRE(match.count == 2);
    CHECK(match.state == vpFeatureState::GOOD);
    CHECK(candidateOf(cue, match, 0).offset == Approx(offsetTo(strong, match.point)).margin(0.2));
    CHECK(candidateOf(cue, match, 1).offset == Approx(offsetTo(weak, match.point)).margin(0.2));
    CHECK(std::fabs(candidateOf(cue, match, 0).contrast) == Approx(90.).epsilon(0.15));
    CHECK(std::fabs(candidateOf(cue, match, 1).contrast) == Approx(40.).epsilon(0.15));
  }
}

TEST_CASE("what was seen before comes first, be it the weaker one", "[edge-candidates]")
{
  vpEdgeCueSettings settings = withCandidates(3);
  settings.mu2 = 2.;
  vpEdgeCue cue(settings);
  const Line weak = middle.moved(-4.);
  match(cue, drawStep(middle, 40., 0.7), viewOf({middle}));
  learn(cue);
  match(cue, drawTwoSteps(weak, middle.moved(5.)), viewOf({middle}));
  for (const vpEdgeCue::Match &match : cue.matches()) {
    REQUIRE(match.count == 2);
    CHECK(candidateOf(cue, match, 0).offset == Approx(offsetTo(weak, match.point)).margin(0.2));
  }
}

TEST_CASE("no more candidates are kept than asked for", "[edge-candidates]")
{
  const unsigned int candidates = GENERATE(1U, 2U, 3U, 8U);
  vpEdgeCueSettings settings = withCandidates(candidates);
  settings.range = 15.;
  vpEdgeCue cue(settings);
  match(cue, drawStripes(middle), viewOf({middle}));
  REQUIRE(cue.matches().size() > 15);
  std::size_t total = 0;
  for (const vpEdgeCue::Match &match : cue.matches()) {
    CHECK(match.first == static_cast<int>(total));
    // Five edges or six are within 15 pixels.
    CHECK(match.count >= static_cast<int>(std::min(candidates, 4U)));
    CHECK(match.count <= static_cast<int>(std::min(candidates, 6U)));
    total += static_cast<std::size_t>(match.count);
  }
  CHECK(total == cue.candidates().size());
}

TEST_CASE("edges beyond the range are not found", "[edge-candidates]")
{
  const double range = GENERATE(1., 4.5, 8., 20.);
  vpEdgeCueSettings settings;
  settings.range = range;
  vpEdgeCue cue(settings);
  const vpImage<unsigned char> I = drawStep(middle, 100., 0.7);
  for (const double side : {-1., 1.}) {
    match(cue, I, viewOf({middle.moved(side * (range - 0.3))}, 25.));
    CHECK(found(cue) == cue.matches().size());
    match(cue, I, viewOf({middle.moved(side * (range + 0.3))}, 25.));
    CHECK(found(cue) == 0);
    CHECK(inState(cue, vpFeatureState::THRESHOLD) == cue.matches().size());
    CHECK(cue.candidates().empty());
  }
}

TEST_CASE("only edges above the threshold are found", "[edge-candidates]")
{
  vpEdgeCueSettings settings;
  settings.contrast = GENERATE(5., 20., 60.);
  settings.maskSize = GENERATE(3U, 5U, 7U);
  vpEdgeCue cue(settings);
  const Line edge{Eigen::Vector2d(80.5, 60.5), 0.};
  const vpModelView view = viewOf({edge.moved(2.)});
  match(cue, drawStep(edge, settings.contrast + 1.5), view);
  CHECK(found(cue) == cue.matches().size());
  match(cue, drawStep(edge, settings.contrast - 1.5), view);
  CHECK(found(cue) == 0);
  CHECK(inState(cue, vpFeatureState::THRESHOLD) == cue.matches().size());
}

TEST_CASE("nothing is read outside the image", "[edge-candidates]")
{
  vpEdgeCueSettings settings;
  settings.maskSize = GENERATE(3U, 5U, 15U);
  settings.range = 30.;
  vpEdgeCue cue(settings);
  vpModelViewOptions options;
  options.border = 0.;
  options.sampleStep = 1.;
  for (const double angle : {0., 0.3, M_PI / 4., M_PI / 2., 2.}) {
    for (const double across : {-70., -59.9, -58.2, 0.1, 58.8, 59., 70.}) {
      const Line line = Line{Eigen::Vector2d(80., 60.), angle}.moved(across);
      // Lines along the border and across it, seen by the view and partly cut off from the image.
      match(cue, drawStep(line, 100.), viewOf({line}, 120., options));
      vpImage<unsigned char> I = drawStep(line, 100.);
      for (const unsigned int size : {40U, 5U, 2U, 1U}) {
        vpImage<unsigned char> part(size, size + 1);
        for (unsigned int i = 0; i < size; ++i) {
          std::copy_n(I[i], size + 1, part[i]);
        }
        match(cue, part, viewOf({line}, 120., options));
        for (const vpEdgeCue::Match &match : cue.matches()) {
          const bool inside = match.point.pixel.x() <= size && match.point.pixel.y() <= size - 1;
          CHECK((inside || match.count == 0));
        }
      }
    }
  }
}

TEST_CASE("edges are found close to the border", "[edge-candidates]")
{
  vpEdgeCue cue(withCandidates(1));
  // All that a mask of 5 covers is inside, and a pixel more to tell where the gradient is largest.
  for (const Line &edge : {Line{Eigen::Vector2d(80., 3.3), 0.}, Line{Eigen::Vector2d(80., 115.7), 0.},
                           Line{Eigen::Vector2d(3.3, 60.), M_PI / 2.}, Line{Eigen::Vector2d(155.7, 60.), M_PI / 2.}}) {
    match(cue, drawStep(edge, 100.), viewOf({edge}));
    REQUIRE(found(cue) == cue.matches().size());
    for (const vpEdgeCue::Match &match : cue.matches()) {
      CHECK(std::fabs(candidateOf(cue, match, 0).offset) < 0.1);
    }
  }
}
