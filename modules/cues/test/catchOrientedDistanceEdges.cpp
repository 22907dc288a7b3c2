// SPDX-License-Identifier: GPL-2.0-or-later
#include "distanceScenes.h"

using namespace distanceScenes;

TEST_CASE("masked pixels have no edges", "[distance-map]")
{
  vpImage<bool> mask(120, 160, true);
  for (unsigned int i = 0; i < 60; ++i) {
    for (unsigned int j = 0; j < 160; ++j) {
      mask[i][j] = false;
    }
  }
  const Shot shot(halves(120, 160, 80), &mask);
  vpOrientedDistanceMap map;
  map.compute(shot.frame, shot.whole);
  CHECK(map.distance(79.5, 100., 0) <= 2.);
  CHECK(map.distance(79.5, 30., 0) == exactly(farthest));
}

TEST_CASE("images of all sizes", "[distance-map]")
{
  for (unsigned int rows = 1; rows < 36; rows += rows < 6 ? 1 : 11) {
    for (unsigned int columns = 1; columns < 36; columns += columns < 6 ? 1 : 11) {
      for (const double scale : {1., 0.5, 1. / 3., 0.125}) {
        vpOrientedDistanceSettings settings;
        settings.scale = scale;
        const Shot shot(noise(rows, columns, 120., 60.));
        vpOrientedDistanceMap map;
        map.setSettings(settings);
        map.compute(shot.frame, shot.whole);
        CHECK(map.width() == static_cast<unsigned int>(std::ceil(columns * scale - 1e-9)));
        for (int bin = 0; bin < 8; ++bin) {
          const double corner = map.distance(columns - 1., rows - 1., bin);
          CHECK((corner >= 0. && corner <= farthest));
        }
      }
    }
  }
}

TEST_CASE("uniform images and noise", "[distance-map]")
{
  vpOrientedDistanceMap map;
  const Shot uniform(vpImage<unsigned char>(120, 160, 90));
  map.compute(uniform.frame, uniform.whole);
  CHECK(map.edgeCount() == 0);
  CHECK(map.threshold() == exactly(vpOrientedDistanceSettings().contrast));
  CHECK(leastOf(map, 80., 60.) == exactly(farthest));

  for (const double deviation : {2., 8., 16., 30.}) {
    const Shot shot(noise(240, 320, 128., deviation));
    map.compute(shot.frame, shot.whole);
    INFO(deviation);
    // Noise of deviation 1 is 0.5 of the reduced image's gray levels and, with the gain of the gradient, 0.28 of
    // contrast.
    CHECK(map.threshold() == Approx(std::max(5., 4. * 0.276 * deviation)).epsilon(0.15));
    CHECK(static_cast<double>(map.edgeCount()) < 0.001 * map.width() * map.height());
    for (int bin = 0; bin < 8; ++bin) {
      for (double u = 0.; u < 320.; u += 3.) {
        const double distance = map.distance(u, 0.7 * u, bin);
        CHECK((distance >= 0. && distance <= farthest));
      }
    }
  }
  // An edge that stands out of the noise is found.
  vpImage<unsigned char> I = noise(240, 320, 90., 10.);
  for (unsigned int i = 0; i < 240; ++i) {
    for (unsigned int j = 160; j < 320; ++j) {
      I[i][j] = static_cast<unsigned char>(std::min(I[i][j] + 50, 255));
    }
  }
  const Shot shot(I);
  map.compute(shot.frame, shot.whole);
  for (double v = 10.; v < 230.; v += 4.) {
    CHECK(map.distance(159.5, v, 0) < 5.);
  }
}

TEST_CASE("a faint edge before black is found beside a bright one", "[distance-map]")
{
  vpImage<unsigned char> I(240, 320, 0);
  for (unsigned int i = 60; i < 180; ++i) {
    for (unsigned int j = 100; j < 220; ++j) {
      I[i][j] = j < 200 ? 12 : 140;
    }
  }
  const Shot shot(I);
  vpOrientedDistanceMap map;
  map.compute(shot.frame, shot.whole);
  CHECK(map.distance(99.5, 120., 0) <= 2.);
  CHECK(map.distance(199.5, 120., 0) <= 2.);
  CHECK(map.distance(150., 59.5, 4) <= 2.);
}
