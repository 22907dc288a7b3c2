// SPDX-License-Identifier: GPL-2.0-or-later
#include "edgeScenes.h"

#include <visp3/core/vpException.h>
#include <visp3/core/vpMatrix.h>

#include <catchMain.h>

#include <functional>
#include <limits>
#include <string>

using namespace edgeScenes;

namespace {
const double notANumber = std::numeric_limits<double>::quiet_NaN();

vpMe makeMe(unsigned int maskSize, double threshold)
{
  vpMe me;
  me.setMaskSize(maskSize);
  me.setThreshold(threshold);
  me.setRange(7);
  me.setMu1(0.3);
  me.setMu2(0.4);
  return me;
}

// What ViSP's mask along the pixel rows answers to a step of one gray level that it lies on.
double maskResponse(const vpMe &me)
{
  const vpMatrix &mask = me.getMask()[0];
  double sum = 0.;
  for (unsigned int i = 0; i < mask.getRows(); ++i) {
    for (unsigned int j = 0; j < mask.getCols(); ++j) {
      sum += std::max(mask[i][j], 0.);
    }
  }
  // From 3.6 on ViSP divides its masks by this.
  const double normalised = 100. * mask.getRows() * (mask.getRows() / 2);
  return sum < 2. ? sum * normalised : sum;
}
} // namespace

TEST_CASE("a member out of range is named with its value", "[edge-settings]")
{
  struct Wrong
  {
    std::string member;
    std::function<void(vpEdgeCueSettings &)> set;
    std::string value;
  };
  const std::vector<Wrong> all = {
      {"range", [](vpEdgeCueSettings &s) { s.range = 0.5; }, "0.5"},
      {"range", [](vpEdgeCueSettings &s) { s.range = 100.5; }, "100.5"},
      {"range", [](vpEdgeCueSettings &s) { s.range = notANumber; }, "nan"},
      {"contrast", [](vpEdgeCueSettings &s) { s.contrast = 0.; }, "0"},
      {"contrast", [](vpEdgeCueSettings &s) { s.contrast = 256.; }, "256"},
      {"contrast", [](vpEdgeCueSettings &s) { s.contrast = notANumber; }, "nan"},
      {"mu1", [](vpEdgeCueSettings &s) { s.mu1 = -0.1; }, "-0.1"},
      {"mu1", [](vpEdgeCueSettings &s) { s.mu1 = 1.1; }, "1.1"},
      {"mu2", [](vpEdgeCueSettings &s) { s.mu2 = -1.; }, "-1"},
      {"maskSize", [](vpEdgeCueSettings &s) { s.maskSize = 2; }, "2"},
      {"maskSize", [](vpEdgeCueSettings &s) { s.maskSize = 16; }, "16"},
      {"candidates", [](vpEdgeCueSettings &s) { s.candidates = 0; }, "0"},
      {"candidates", [](vpEdgeCueSettings &s) { s.candidates = 9; }, "9"},
  };
  vpEdgeCueSettings good;
  good.range = 12.;
  vpEdgeCue cue(good);
  for (const Wrong &wrong : all) {
    vpEdgeCueSettings settings;
    wrong.set(settings);
    const std::string text = "vpEdgeCueSettings::" + wrong.member + " is " + wrong.value + ",";
    CHECK_THROWS_WITH(settings.check(), ContainsSubstring(text));
    CHECK_THROWS_AS(vpEdgeCue(settings), vpException);
    CHECK_THROWS_AS(cue.setSettings(settings), vpException);
    CHECK(cue.settings().range == exactly(12.)); // The old ones stay.
  }
  CHECK_NOTHROW(vpEdgeCueSettings().check());
}

TEST_CASE("ViSP's parameters are taken over", "[edge-settings]")
{
  vpEdgeCueSettings settings;
  settings.candidates = 2;
  settings.set(makeMe(7, 30.), vpEdgeCueSettings::CONTRAST);
  CHECK(settings.range == exactly(7.));
  CHECK(settings.contrast == exactly(30.));
  CHECK(settings.mu1 == exactly(0.3));
  CHECK(settings.mu2 == exactly(0.4));
  CHECK(settings.maskSize == 7);
  CHECK(settings.candidates == 2);

  settings.set(makeMe(5, 10000.));
  CHECK(settings.contrast == exactly(5.));
  CHECK(settings.maskSize == 5);
}

TEST_CASE("parameters that make no sense change nothing", "[edge-settings]")
{
  vpEdgeCueSettings settings;
  settings.range = 11.;
  CHECK_THROWS_WITH(settings.set(makeMe(5, 1e9), vpEdgeCueSettings::LIKELIHOOD), ContainsSubstring("contrast"));
  vpMe me = makeMe(5, 30.);
  me.setRange(0);
  CHECK_THROWS_WITH(settings.set(me, vpEdgeCueSettings::CONTRAST), ContainsSubstring("range is 0"));
  CHECK(settings.range == exactly(11.));
  CHECK(settings.contrast == exactly(vpEdgeCueSettings().contrast));
}

TEST_CASE("the old threshold is twice the response of ViSP's mask", "[edge-settings]")
{
  CHECK(vpEdgeCueSettings::toContrast(10000., vpEdgeCueSettings::LIKELIHOOD, 5) == exactly(5.));
  CHECK(vpEdgeCueSettings::toContrast(20., vpEdgeCueSettings::CONTRAST, 5) == exactly(20.));
  for (const unsigned int maskSize : {3U, 5U, 7U, 9U}) {
    const vpMe me = makeMe(maskSize, 0.);
    const double threshold = 2. * 12. * maskResponse(me);
    CHECK(vpEdgeCueSettings::toContrast(threshold, vpEdgeCueSettings::LIKELIHOOD, maskSize) == Approx(12.));
  }
}

TEST_CASE("thresholds of both scales tell the same edges apart", "[edge-settings]")
{
  const unsigned int maskSize = GENERATE(3U, 5U, 7U);
  const double contrast = 25.;
  const Line edge{Eigen::Vector2d(80.5, 60.5), 0.};
  const vpModelView view = viewOf({edge.moved(2.)});
  const double likelihood = 2. * contrast * maskResponse(makeMe(maskSize, 0.));
  for (const bool old : {true, false}) {
    vpEdgeCueSettings settings;
    settings.set(makeMe(maskSize, old ? likelihood : contrast),
                 old ? vpEdgeCueSettings::LIKELIHOOD : vpEdgeCueSettings::CONTRAST);
    vpEdgeCue cue(settings);
    match(cue, drawStep(edge, contrast + 1.5), view);
    CHECK(found(cue) == cue.matches().size());
    match(cue, drawStep(edge, contrast - 1.5), view);
    CHECK(found(cue) == 0);
  }
}
