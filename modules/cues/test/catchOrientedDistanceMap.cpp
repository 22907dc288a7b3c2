// SPDX-License-Identifier: GPL-2.0-or-later
#include "distanceScenes.h"

#include <visp3/core/vpException.h>

#include <countAllocations.h>

#include <limits>
#include <vector>

using namespace distanceScenes;

TEST_CASE("bins are those of atan2, and of either sign", "[distance-map]")
{
  for (int k = 0; k < 7200; ++k) {
    const double angle = (k + 0.5) * M_PI / 3600.;
    const double length = 0.01 + 100. * (k % 7);
    const int expected = static_cast<int>(std::lround(std::atan2(std::sin(angle), std::cos(angle)) / (M_PI / 8.)) + 16);
    INFO(k);
    CHECK(vpOrientedDistanceMap::bin(length * std::cos(angle), length * std::sin(angle)) == expected % 8);
    CHECK(vpOrientedDistanceMap::bin(-length * std::cos(angle), -length * std::sin(angle)) == expected % 8);
  }
  CHECK(vpOrientedDistanceMap::bin(1., 0.) == 0);
  CHECK(vpOrientedDistanceMap::bin(-1., 0.) == 0);
  CHECK(vpOrientedDistanceMap::bin(1., -0.) == 0);
  CHECK(vpOrientedDistanceMap::bin(0., 1.) == 4);
  CHECK(vpOrientedDistanceMap::bin(0., -1.) == 4);
  CHECK(vpOrientedDistanceMap::bin(-0., 1.) == 4);
  const int none = vpOrientedDistanceMap::bin(0., 0.);
  CHECK((none >= 0 && none < 8));
}

TEST_CASE("distances are those to the edges, as exact as the weights", "[distance-map]")
{
  vpOrientedDistanceSettings settings;
  settings.scale = GENERATE(1., 0.5, 1. / 3.);
  settings.maxDistance = 20.;
  const Shot shot(disc(120, 160, 70.3, 61.2, 33.));
  vpOrientedDistanceMap map;
  map.setSettings(settings);
  map.compute(shot.frame, shot.whole);
  const double pixel = 1. / settings.scale;
  struct Edge
  {
    unsigned int x, y;
  };
  std::vector<Edge> edges[vpOrientedDistanceMap::bins];
  const auto centre = [&](unsigned int x) { return (x + 0.5) * pixel - 0.5; };
  for (int bin = 0; bin < vpOrientedDistanceMap::bins; ++bin) {
    for (unsigned int y = 0; y < map.height(); ++y) {
      for (unsigned int x = 0; x < map.width(); ++x) {
        if (map.distance(centre(x), centre(y), bin) == exactly(0.)) {
          edges[bin].push_back({x, y});
        }
      }
    }
    REQUIRE_FALSE(edges[bin].empty());
  }
  double worst = 0.;
  for (int bin = 0; bin < vpOrientedDistanceMap::bins; ++bin) {
    for (unsigned int y = 0; y < map.height(); ++y) {
      for (unsigned int x = 0; x < map.width(); ++x) {
        double exact = settings.maxDistance;
        for (int turn = -1; turn <= 1; ++turn) {
          const double added = turn == 0 ? 0. : 0.5;
          for (const Edge &edge : edges[(bin + turn + 8) % 8]) {
            const double steps = std::hypot(static_cast<double>(x) - edge.x, static_cast<double>(y) - edge.y);
            exact = std::min(exact, pixel * (steps + added));
          }
        }
        const double found = map.distance(centre(x), centre(y), bin);
        worst = std::max(worst, std::fabs(found - exact) - 0.021 * exact);
      }
    }
  }
  CHECK(worst < 1e-6);
  CHECK(leastOf(map, 70.3 + 33., 61.2) <= 1.5 * pixel);
  CHECK(leastOf(map, 70.3 + 24., 61.2) == Approx(9.).margin(1.3 * pixel));
  CHECK(leastOf(map, 70.3, 61.2) == exactly(settings.maxDistance));
}

TEST_CASE("an upright edge is near in its bin and far in the one across", "[distance-map]")
{
  const Shot shot(halves(121, 163, 80));
  vpOrientedDistanceMap map;
  map.compute(shot.frame, shot.whole);
  CHECK(map.width() == 82);
  CHECK(map.height() == 61);
  for (double v = 10.; v < 110.; v += 7.) {
    CHECK(map.distance(79.5, v, 0) <= 2.);
    for (const double distance : {4., 6., 10.}) {
      CHECK(map.distance(79.5 + distance, v, 0) == Approx(distance).margin(2.));
      CHECK(map.distance(79.5 - distance, v, 0) == Approx(distance).margin(2.));
      // Beside the edge's own bin half a map pixel more, farther off nothing.
      const double beside = std::min(map.distance(79.5 + distance, v, 0) + 1., farthest);
      CHECK(map.distance(79.5 + distance, v, 1) == Approx(beside));
      CHECK(map.distance(79.5 + distance, v, 7) == Approx(beside));
    }
    for (int bin = 2; bin < 7; ++bin) {
      CHECK(map.distance(79.5, v, bin) == exactly(farthest));
    }
    CHECK(map.distance(79.5 + 20., v, 0) == exactly(farthest));
  }
}

TEST_CASE("each orientation falls into its bin", "[distance-map]")
{
  for (int k = 0; k < 8; ++k) {
    const double nx = std::cos(k * M_PI / 8.);
    const double ny = std::sin(k * M_PI / 8.);
    vpImage<unsigned char> I(120, 160);
    for (unsigned int i = 0; i < I.getHeight(); ++i) {
      for (unsigned int j = 0; j < I.getWidth(); ++j) {
        const double beyond = nx * (j - 80.) + ny * (i - 60.);
        I[i][j] = static_cast<unsigned char>(50. + 100. * std::min(std::max(beyond + 0.5, 0.), 1.));
      }
    }
    const Shot shot(I);
    vpOrientedDistanceMap map;
    map.compute(shot.frame, shot.whole);
    for (double along = -40.; along <= 40.; along += 5.) {
      INFO(k << " at " << along);
      CHECK(map.distance(80. - along * ny, 60. + along * nx, vpOrientedDistanceMap::bin(nx, ny)) <= 3.);
      CHECK(map.distance(80. - along * ny, 60. + along * nx, vpOrientedDistanceMap::bin(-ny, nx)) == exactly(farthest));
    }
  }
}

TEST_CASE("outside the region there are no edges, inside they are as in the whole image", "[distance-map]")
{
  const Shot shot(disc(121, 163, 70., 61., 33.));
  vpOrientedDistanceMap whole, part;
  whole.compute(shot.frame, shot.whole);

  part.compute(shot.frame, vpImageRegion(21, 31, 100, 60));
  CHECK(part.width() == 51);
  CHECK(part.height() == 31);
  for (double u = 55.; u < 90.; u += 1.) {
    // The disc is cut off above and below: its sides are far from the region's border.
    for (int bin = 0; bin < 8; bin += 4) {
      CHECK(part.distance(u, 61., bin) == exactly(whole.distance(u, 61., bin)));
    }
  }
  CHECK(part.distance(37., 61., 0) < 3.);
  CHECK(part.distance(18., 61., 0) == exactly(farthest));
  CHECK(part.distance(70., 28., 4) == exactly(farthest));

  part.compute(shot.frame, vpImageRegion(-2147483647, -50, 2147483647, 2147483647));
  CHECK(part.width() == 0);
  part.compute(shot.frame, vpImageRegion(-50, -50, 2147483647, 2147483647));
  CHECK(part.width() == whole.width());
  CHECK(part.height() == whole.height());
  CHECK(part.edgeCount() == whole.edgeCount());
  for (const vpImageRegion &nothing : {vpImageRegion(), vpImageRegion(10, 10, 0, 5), vpImageRegion(10, 10, -3, 5),
                                       vpImageRegion(163, 0, 10, 10), vpImageRegion(0, -10, 10, 10)}) {
    part.compute(shot.frame, nothing);
    CHECK(part.width() == 0);
    CHECK(part.height() == 0);
    CHECK(part.edgeCount() == 0);
    CHECK(part.distance(37., 61., 0) == exactly(farthest));
    vpImage<unsigned char> drawn;
    part.draw(-1, drawn);
    CHECK(drawn.getSize() == 0);
  }
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  for (const double u : {nan, infinity, -infinity, 1e300, -1e300, -0.6, 163.6}) {
    CHECK(whole.distance(u, 61., 0) == exactly(farthest));
    CHECK(whole.distance(61., u, 0) == exactly(farthest));
  }
  CHECK(vpOrientedDistanceMap().distance(5., 5., 3) == exactly(farthest));
}

TEST_CASE("a second map allocates nothing", "[distance-map]")
{
  const Shot first(disc(120, 160, 70., 61., 33.));
  const Shot second(noise(120, 160, 128., 30.));
  vpOrientedDistanceMap map;
  map.compute(first.frame, first.whole);
  const std::size_t before = countAllocations::allocations;
  map.compute(second.frame, second.whole);
  map.compute(first.frame, vpImageRegion(30, 20, 60, 70));
  CHECK(countAllocations::allocations == before);
}

TEST_CASE("settings out of range are refused by name", "[distance-map]")
{
  vpOrientedDistanceMap map;
  const auto refused = [&](double vpOrientedDistanceSettings::*member, double value, const char *name) {
    vpOrientedDistanceSettings settings;
    settings.*member = value;
    CHECK_THROWS_WITH(map.setSettings(settings), ContainsSubstring(name));
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double value : {0., -1., 0.4, 0.7, 1.5, nan}) {
    refused(&vpOrientedDistanceSettings::scale, value, "scale");
  }
  for (const double value : {0., 46.1, nan}) {
    refused(&vpOrientedDistanceSettings::maxDistance, value, "maxDistance");
  }
  refused(&vpOrientedDistanceSettings::contrast, 0., "contrast");
  refused(&vpOrientedDistanceSettings::noiseFactor, -1., "noiseFactor");
  refused(&vpOrientedDistanceSettings::clutterFactor, nan, "clutterFactor");
  vpImage<unsigned char> I;
  CHECK_THROWS_WITH(map.draw(8, I), ContainsSubstring("bin 8"));
}

TEST_CASE("the drawing shows distances", "[distance-map]")
{
  const Shot shot(halves(120, 160, 80));
  vpOrientedDistanceMap map;
  map.compute(shot.frame, shot.whole);
  vpImage<unsigned char> all, one;
  map.draw(-1, all);
  map.draw(4, one);
  CHECK(all.getWidth() == 80);
  CHECK(all.getHeight() == 60);
  CHECK(all[30][10] == 255);
  CHECK(std::min(all[30][39], all[30][40]) == 0);
  CHECK(one[30][40] == 255);
}
