// SPDX-License-Identifier: GPL-2.0-or-later
#include "colorScenes.h"

#include <visp3/core/vpException.h>

#include <catchMain.h>

#include <string>

using namespace colorScenes;

namespace {
const vpHomogeneousMatrix cMo(0.01, -0.02, 0.5, 0.5, 0.6, 0.2);

std::uint32_t pixel(unsigned int red, unsigned int green, unsigned int blue)
{
  return red | green << 8U | blue << 16U;
}

// Plain red before plain blue.
Paint plain()
{
  Paint paint;
  paint.object = [](const Eigen::Vector3d &) { return Color(200., 40., 40.); };
  paint.background = [](double, double) { return Color(40., 40., 200.); };
  return paint;
}

vpResidualBlock rowsOf(const vpColorCue &cue, const vpHomogeneousMatrix &pose = cMo)
{
  vpResidualBlock block;
  cue.residuals(pose, block);
  return block;
}

bool sameRows(const vpResidualBlock &a, const vpResidualBlock &b)
{
  bool same = a.rows.size() == b.rows.size();
  for (std::size_t i = 0; same && i < a.rows.size(); ++i) {
    same = a.rows[i].error == exactly(b.rows[i].error) && a.rows[i].jacobian == b.rows[i].jacobian;
  }
  return same;
}
} // namespace

TEST_CASE("the first match learns from the view's pose, reset forgets", "[color-memory]")
{
  Scene scene(makeBox());
  const vpImage<vpRGBa> I = scene.draw(cMo, plain());
  vpFrameSource source;
  const unsigned int level = GENERATE(0U, 4U);
  vpColorCue cue;
  cue.setLevel(level);
  CHECK_FALSE(cue.histograms().isKnown());
  cue.match(source.frame(I, makeCamera(), nullptr), scene.look(cMo));
  REQUIRE(cue.histograms().isKnown());
  CHECK(cue.histograms().object(pixel(200, 40, 40)) > 0.95F);
  CHECK(cue.histograms().object(pixel(40, 40, 200)) < 0.05F);
  CHECK(cue.histograms().object(pixel(10, 240, 10)) == exactly(0.5F)); // Never seen.
  cue.reset();
  CHECK_FALSE(cue.histograms().isKnown());
  CHECK_FALSE(cue.lines().empty());
  CHECK(cue.level() == level);
}

TEST_CASE("the histograms follow the trusted frames, at the rate that was set", "[color-memory]")
{
  Scene scene(makeBox());
  vpFrameSource source;
  vpColorCueSettings settings;
  settings.learningRate = GENERATE(0., 0.2, 1.);
  vpColorCue cue(settings);
  const vpImage<vpRGBa> first = scene.draw(cMo, plain());
  learn(cue, scene, source.frame(first, makeCamera(), nullptr), cMo);
  Paint green = plain();
  green.object = [](const Eigen::Vector3d &) { return Color(40., 200., 40.); };
  const vpImage<vpRGBa> second = scene.draw(cMo, green);
  cue.match(source.frame(second, makeCamera(), nullptr), scene.look(cMo));
  CHECK(cue.histograms().object(pixel(40, 200, 40)) == exactly(0.5F)); // match() alone learns nothing.

  const std::size_t rows = rowsOf(cue).rows.size();
  SECTION("outliers teach nothing")
  {
    cue.updateReference(cMo, std::vector<double>(rows, 0.));
    CHECK(cue.histograms().object(pixel(40, 200, 40)) == exactly(0.5F));
    CHECK(cue.histograms().object(pixel(200, 40, 40)) > 0.95F);
  }
  SECTION("inliers do")
  {
    cue.updateReference(cMo, std::vector<double>(rows, 1.));
    CHECK((cue.histograms().object(pixel(40, 200, 40)) > 0.9F) == (settings.learningRate > 0.));
    CHECK((cue.histograms().object(pixel(200, 40, 40)) > 0.9F) == (settings.learningRate < 1.));
  }
}

TEST_CASE("what is learnt is taken at the trusted pose, not at the matched one", "[color-memory]")
{
  Scene scene(makeBox());
  vpFrameSource source;
  const vpImage<vpRGBa> I = scene.draw(cMo, plain());
  vpColorCueSettings settings;
  settings.learningRate = 1.;
  vpColorCue cue(settings);
  const vpHomogeneousMatrix off = shifted(cMo, 2.5, 2.);
  cue.match(source.frame(I, makeCamera(), nullptr), scene.look(off));
  const float blurred = cue.histograms().object(pixel(40, 40, 200));
  cue.updateReference(cMo, std::vector<double>(rowsOf(cue).rows.size(), 1.));
  CHECK(cue.histograms().object(pixel(40, 40, 200)) < 0.5F * blurred);
}

TEST_CASE("nothing is learnt from masked pixels", "[color-memory]")
{
  Scene scene(makeBox());
  vpImage<bool> mask(height, width, true);
  vpImage<vpRGBa> I = scene.draw(cMo);
  vpImage<vpRGBa> other = I;
  for (unsigned int i = 0; i < height; ++i) {
    for (unsigned int j = 0; j < width; ++j) {
      mask[i][j] = j < 150 || i > 150;
      other[i][j] = mask[i][j] ? I[i][j] : vpRGBa(10, 240, 10);
    }
  }
  vpFrameSource source;
  vpColorCue a;
  vpColorCue b;
  for (int k = 0; k < 3; ++k) {
    for (unsigned int level = 0; level < a.levels(); ++level) {
      a.setLevel(level);
      b.setLevel(level);
      a.match(source.frame(I, makeCamera(), &mask), scene.look(cMo));
      b.match(source.frame(other, makeCamera(), &mask), scene.look(cMo));
      REQUIRE(a.lines().size() > 20);
      CHECK(sameRows(rowsOf(a), rowsOf(b)));
    }
    a.updateReference(cMo, std::vector<double>(rowsOf(a).rows.size(), 1.));
    b.updateReference(cMo, std::vector<double>(rowsOf(b).rows.size(), 1.));
  }
  CHECK(b.histograms().object(pixel(10, 240, 10)) == exactly(0.5F));
}

TEST_CASE("colours of the last trusted frame count with 1 - alpha", "[color-memory]")
{
  Scene scene(makeBox());
  vpFrameSource source;
  const vpImage<vpRGBa> before = scene.draw(cMo, plain());
  Paint changed = plain();
  changed.object = [](const Eigen::Vector3d &) { return Color(192., 46., 38.); };
  const vpImage<vpRGBa> after = scene.draw(cMo, changed);
  vpColorCueSettings settings;
  settings.alpha = GENERATE(1., 0.5);
  vpColorCue cue(settings);
  const auto rowsAfter = [&]() {
    cue.match(source.frame(after, makeCamera(), nullptr), scene.look(cMo));
    return rowsOf(cue, shifted(cMo, 0.5, 0.5));
  };
  const vpResidualBlock alone = rowsAfter();
  learn(cue, scene, source.frame(before, makeCamera(), nullptr), cMo);
  CHECK(sameRows(alone, rowsAfter()) == (settings.alpha == exactly(1.)));
  cue.reset();
  CHECK(sameRows(alone, rowsAfter()));
  learn(cue, scene, source.frame(before, makeCamera(), nullptr), cMo);
  cue.updateReference(cMo, std::vector<double>(rowsOf(cue).rows.size(), 0.)); // Not trusted: nothing is kept.
  CHECK(sameRows(alone, rowsAfter()));
}

TEST_CASE("gray after colour starts afresh", "[color-memory]")
{
  Scene scene(makeBox());
  vpFrameSource source;
  const vpImage<vpRGBa> I = scene.draw(cMo);
  vpImage<unsigned char> gray;
  vpImageConvert::convert(I, gray);
  vpColorCue cue;
  learn(cue, scene, source.frame(I, makeCamera(), nullptr), cMo);
  CHECK(cue.histograms().channels() == 3);
  vpColorCue fresh;
  for (unsigned int level = 0; level < cue.levels(); ++level) {
    cue.setLevel(level);
    fresh.setLevel(level);
    cue.match(source.frame(gray, makeCamera(), nullptr), scene.look(cMo));
    fresh.match(source.frame(gray, makeCamera(), nullptr), scene.look(cMo));
    CHECK(cue.histograms().channels() == 1);
    CHECK(sameRows(rowsOf(cue), rowsOf(fresh)));
  }
}

TEST_CASE("a wrong number of weights is refused", "[color-memory]")
{
  Scene scene(makeBox());
  vpFrameSource source;
  const vpImage<vpRGBa> I = scene.draw(cMo);
  vpColorCue cue;
  cue.match(source.frame(I, makeCamera(), nullptr), scene.look(cMo));
  const std::string rows = std::to_string(rowsOf(cue).rows.size());
  CHECK_THROWS_WITH(cue.updateReference(cMo, std::vector<double>(1, 1.)), ContainsSubstring("1 weights for " + rows));
}

TEST_CASE("the cue goes back to what it knew before", "[color-memory]")
{
  Scene scene(makeBox());
  vpFrameSource source;
  const vpImage<vpRGBa> I = scene.draw(cMo);
  const vpImage<vpRGBa> other = scene.draw(cMo, plain());
  vpColorCue cue;
  learn(cue, scene, source.frame(I, makeCamera(), nullptr), cMo);
  const vpColorCue::Reference before = cue.reference();
  const auto evidence = [&] {
    cue.setLevel(1);
    cue.match(source.frame(I, makeCamera(), nullptr), scene.look(cMo));
    return cue.evidence();
  };
  const double known = evidence();
  cue.reset();
  learn(cue, scene, source.frame(other, makeCamera(), nullptr), cMo);
  REQUIRE(evidence() < 0.5 * known);
  cue.setReference(before);
  CHECK(evidence() == exactly(known));

  // Not to what colours told, once images are gray.
  vpImage<unsigned char> gray;
  vpImageConvert::convert(I, gray);
  learn(cue, scene, source.frame(gray, makeCamera(), nullptr), cMo);
  cue.setReference(before);
  CHECK(cue.histograms().channels() == 1);
}
