// SPDX-License-Identifier: GPL-2.0-or-later
#include <visp3/cues/vpColorCue.h>

#include <visp3/core/vpException.h>

#include <catchMain.h>

#include <functional>
#include <limits>
#include <string>
#include <vector>

#ifdef ENABLE_VISP_NAMESPACE
using namespace VISP_NAMESPACE_NAME;
#endif

namespace {
const double notANumber = std::numeric_limits<double>::quiet_NaN();
}

TEST_CASE("a member out of range is named with its value", "[color-settings]")
{
  struct Wrong
  {
    std::string text;
    std::function<void(vpColorCueSettings &)> set;
  };
  const std::vector<Wrong> all = {
      {"spacing is 0.5", [](vpColorCueSettings &s) { s.spacing = 0.5; }},
      {"spacing is nan", [](vpColorCueSettings &s) { s.spacing = notANumber; }},
      {"lines is 9", [](vpColorCueSettings &s) { s.lines = 9; }},
      {"lines is 5001", [](vpColorCueSettings &s) { s.lines = 5001; }},
      {"scales is 0",
       [](vpColorCueSettings &s) {
         s.scales = {4, 0};
       }},
      {"scales is 21", [](vpColorCueSettings &s) { s.scales = {21}; }},
      {"scales is 4",
       [](vpColorCueSettings &s) {
         s.scales = {4, 4};
       }},
      {"scales.size() is 9", [](vpColorCueSettings &s) { s.scales = {9, 8, 7, 6, 5, 4, 3, 2, 1}; }},
      {"bands is 0.4", [](vpColorCueSettings &s) { s.bands = {0.4}; }},
      {"bands is nan", [](vpColorCueSettings &s) { s.bands = {notANumber}; }},
      {"bands is 3",
       [](vpColorCueSettings &s) {
         s.bands = {2., 3.};
       }},
      {"bands.size() is 0", [](vpColorCueSettings &s) { s.bands.clear(); }},
      {"length is 2", [](vpColorCueSettings &s) { s.length = 2.; }},
      {"length is 61", [](vpColorCueSettings &s) { s.length = 61.; }},
      {"alpha is 0", [](vpColorCueSettings &s) { s.alpha = 0.; }},
      {"alpha is 1.5", [](vpColorCueSettings &s) { s.alpha = 1.5; }},
      {"regularisation is 0", [](vpColorCueSettings &s) { s.regularisation = 0.; }},
      {"contourDeviation is 0", [](vpColorCueSettings &s) { s.contourDeviation = 0.; }},
      {"histogramLength is 2", [](vpColorCueSettings &s) { s.histogramLength = 2.; }},
      {"learningRate is 1.5", [](vpColorCueSettings &s) { s.learningRate = 1.5; }},
  };
  vpColorCueSettings good;
  good.length = 12.;
  vpColorCue cue(good);
  for (const Wrong &wrong : all) {
    vpColorCueSettings settings;
    wrong.set(settings);
    CHECK_THROWS_WITH(settings.check(), ContainsSubstring("vpColorCueSettings::" + wrong.text + ","));
    CHECK_THROWS_AS(vpColorCue(settings), vpException);
    CHECK_THROWS_AS(cue.setSettings(settings), vpException);
    CHECK(cue.settings().length == exactly(12.)); // The old ones stay.
  }
  CHECK_NOTHROW(vpColorCueSettings().check());
}

TEST_CASE("levels are the scales and then the bands, the finest one unless another is chosen", "[color-settings]")
{
  vpColorCueSettings settings;
  settings.scales = {5, 2};
  settings.bands = {2., 1., 0.5};
  vpColorCue cue(settings);
  CHECK(cue.levels() == 5);
  CHECK(cue.level() == 4);
  cue.setLevel(1);
  CHECK(cue.level() == 1);
  cue.setLevel(12);
  CHECK(cue.level() == 4);
  settings.scales.clear();
  settings.bands = {1.};
  cue.setSettings(settings);
  CHECK(cue.levels() == 1);
  CHECK(cue.level() == 0);
}
