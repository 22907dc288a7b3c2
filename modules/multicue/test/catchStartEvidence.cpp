// SPDX-License-Identifier: GPL-2.0-or-later
#include "search/vpStartEvidence.cpp" // The library keeps it to itself.

#include <catchMain.h>

namespace {
// Four images in which all but the model's colours speak for a pose.
vpStartEvidence withColors(double correlation, unsigned int tries, double trust = 1.)
{
  vpStartSearch::Value value;
  value.edges = 0.9;
  value.colors = correlation;
  value.seen = (value.edges + trust * correlation) / (1. + trust);
  vpStartEvidence::Support support;
  support.edges = 0.9;
  support.hasEdges = true;
  support.colors = 1.2;
  support.hasColors = true;
  vpStartEvidence evidence;
  evidence.setTries(tries);
  for (unsigned int i = 0; i < 4; ++i) {
    evidence.add(value, {vpStartSearch::Value(), vpStartSearch::Value()}, support, trust);
  }
  return evidence;
}
} // namespace

TEST_CASE("The model's colours have to agree better the more images were searched", "[start-evidence]")
{
  CHECK_FALSE(withColors(0.3, 1).isEnough(1.)); // What the best pose on something else reaches.
  CHECK(withColors(0.36, 1).isEnough(1.));
  CHECK_FALSE(withColors(0.36, 6).isEnough(1.));
  CHECK(withColors(0.45, 6).isEnough(1.));
  CHECK(withColors(0.45, 1000).isEnough(1.));
  CHECK(withColors(0.36, 6).text(1.).find("0.36 of 0.43") != std::string::npos);
}

TEST_CASE("Colours that a model does not have are not asked for", "[start-evidence]")
{
  CHECK(withColors(0., 6, 0.).isEnough(1.));
  CHECK(withColors(0.36, 1).isEnough(0.8));
  CHECK_FALSE(vpStartEvidence().isEnough(1.));
}
