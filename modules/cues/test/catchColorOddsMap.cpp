// SPDX-License-Identifier: GPL-2.0-or-later
#include <visp3/core/vpException.h>
#include <visp3/cues/vpColorOddsMap.h>
#include <visp3/cues/vpFrameSource.h>
#include <visp3/se3/vpPoseRandom.h>

#include <catchMain.h>
#include <countAllocations.h>

#include <cmath>
#include <limits>

namespace {
const vpCameraParameters camera(300., 300., 80., 60.);

std::uint32_t numberOf(const vpRGBa &pixel)
{
  return pixel.R | static_cast<std::uint32_t>(pixel.G) << 8U | static_cast<std::uint32_t>(pixel.B) << 16U |
         static_cast<std::uint32_t>(pixel.A) << 24U;
}

std::uint32_t numberOf(unsigned char pixel)
{
  return pixel;
}

unsigned char level(vpPoseRandom &random)
{
  return static_cast<unsigned char>(255.9 * random.uniform());
}

void draw(vpPoseRandom &random, vpRGBa &pixel)
{
  pixel = vpRGBa(level(random), level(random), level(random), level(random));
}

void draw(vpPoseRandom &random, unsigned char &pixel)
{
  pixel = level(random);
}

template <typename Pixel> vpImage<Pixel> randomImage(unsigned int rows, unsigned int columns)
{
  vpPoseRandom random(3);
  vpImage<Pixel> I(rows, columns);
  for (unsigned int k = 0; k < I.getSize(); ++k) {
    draw(random, I.bitmap[k]);
  }
  return I;
}

// Of what an image shows, bright is more often the object.
template <typename Pixel> vpColorHistograms learnt(const vpImage<Pixel> &I, unsigned int channels)
{
  vpColorHistograms histograms;
  histograms.reset(channels);
  for (unsigned int k = 0; k < I.getSize(); ++k) {
    const std::uint32_t number = numberOf(I.bitmap[k]) & 0xFFFFFFU;
    const bool isObject = (number & 0xFFU) > 128U || k % 5 == 0;
    histograms.count(number, isObject ? vpColorHistograms::OBJECT : vpColorHistograms::BACKGROUND);
  }
  histograms.learn(1.);
  return histograms;
}

double oddsOf(const vpColorHistograms &histograms, std::uint32_t pixel)
{
  const double object = histograms.object(pixel);
  return std::min(std::max(std::log(object / (1. - object)), -4.), 4.);
}

template <typename Pixel> void checkAgainstDirect(unsigned int rows, unsigned int columns, unsigned int channels)
{
  const vpImage<Pixel> I = randomImage<Pixel>(rows, columns);
  const vpColorHistograms histograms = learnt(I, channels);
  vpFrameSource source;
  vpColorOddsMap map;
  map.compute(source.frame(I, camera, nullptr), histograms,
              vpImageRegion(0, 0, static_cast<int>(columns), static_cast<int>(rows)));
  REQUIRE(map.width() == (columns + 1) / 2);
  REQUIRE(map.height() == (rows + 1) / 2);
  double worst = 0.;
  for (unsigned int i = 0; i < rows; ++i) {
    for (unsigned int j = 0; j < columns; ++j) {
      double sum = 0.;
      int count = 0;
      for (unsigned int v = i / 2 * 2; v < std::min(i / 2 * 2 + 2, rows); ++v) {
        for (unsigned int u = j / 2 * 2; u < std::min(j / 2 * 2 + 2, columns); ++u, ++count) {
          sum += oddsOf(histograms, numberOf(I[v][u]));
        }
      }
      worst = std::max(worst, std::fabs(map.logOdds(j, i) - sum / count));
    }
  }
  // Half a step of each pixel and of the mean.
  CHECK(worst <= 1. / 16. + 1e-6);
}
} // namespace

TEST_CASE("log-odds are those of the histograms", "[odds-map]")
{
  for (const unsigned int rows : {1U, 2U, 61U}) {
    for (const unsigned int columns : {1U, 2U, 3U, 87U}) {
      checkAgainstDirect<vpRGBa>(rows, columns, 3);
      checkAgainstDirect<unsigned char>(rows, columns, 1);
    }
  }
}

TEST_CASE("gray histograms serve frames in colour, not the other way round", "[odds-map]")
{
  const vpImage<vpRGBa> colors = randomImage<vpRGBa>(40, 60);
  const vpImage<unsigned char> grays = randomImage<unsigned char>(40, 60);
  vpFrameSource source;
  vpColorOddsMap map;
  const vpColorHistograms gray = learnt(grays, 1);
  const vpCueFrame frame = source.frame(colors, camera, nullptr);
  map.compute(frame, gray, vpImageRegion(0, 0, 60, 40));
  double sum = 0.;
  for (unsigned int k = 0; k < 4; ++k) {
    sum += oddsOf(gray, frame.gray()[10 + k / 2][20 + k % 2]);
  }
  CHECK(map.logOdds(20., 10.) == Approx(sum / 4.).margin(1. / 16.));
  CHECK_THROWS_WITH(map.compute(source.frame(grays, camera, nullptr), vpColorHistograms(), vpImageRegion(0, 0, 9, 9)),
                    ContainsSubstring("frame is gray"));
}

TEST_CASE("nothing is known outside, under a mask, and before learning", "[odds-map]")
{
  vpImage<unsigned char> I(40, 61, 200);
  vpColorHistograms histograms;
  histograms.reset(1);
  vpFrameSource source;
  vpColorOddsMap map;
  map.compute(source.frame(I, camera, nullptr), histograms, vpImageRegion(0, 0, 61, 40));
  CHECK(map.logOdds(30., 20.) == exactly(0.F));

  histograms.count(200, vpColorHistograms::OBJECT);
  histograms.count(10, vpColorHistograms::BACKGROUND);
  histograms.learn(1.);
  map.compute(source.frame(I, camera, nullptr), histograms, vpImageRegion(11, -5, 21, 20));
  CHECK(map.width() == 11);
  CHECK(map.height() == 8);
  CHECK(map.logOdds(10., 0.) == exactly(4.F));
  CHECK(map.logOdds(31., 15.) == exactly(4.F));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double outside : {9., 32., -1e300, 1e300, nan}) {
    CHECK(map.logOdds(outside, 5.) == exactly(0.F));
  }
  CHECK(map.logOdds(20., 16.) == exactly(0.F));
  CHECK(map.logOdds(20., -1.) == exactly(0.F));
  map.compute(source.frame(I, camera, nullptr), histograms, vpImageRegion(61, 0, 5, 5));
  CHECK(map.width() == 0);
  CHECK(map.logOdds(60., 2.) == exactly(0.F));
  CHECK(vpColorOddsMap().logOdds(0., 0.) == exactly(0.F));

  vpImage<bool> mask(40, 61, true);
  mask[20][30] = mask[20][31] = mask[21][30] = mask[21][31] = false;
  map.compute(source.frame(I, camera, &mask), histograms, vpImageRegion(0, 0, 61, 40));
  CHECK(map.logOdds(30., 20.) == exactly(0.F));
  CHECK(map.logOdds(28., 20.) == exactly(4.F));
  CHECK(map.logOdds(32., 20.) == exactly(4.F));
  CHECK(map.logOdds(60., 39.) == exactly(4.F));
  vpImage<unsigned char> drawn;
  map.draw(drawn);
  CHECK(drawn[10][15] == 128);
  CHECK(drawn[10][14] == 255);
}

TEST_CASE("where the lens saw nothing the odds are even", "[odds-map]")
{
  vpImage<unsigned char> I(120, 160, 200);
  vpColorHistograms histograms;
  histograms.reset(1);
  histograms.count(200, vpColorHistograms::OBJECT);
  histograms.count(10, vpColorHistograms::BACKGROUND);
  histograms.learn(1.);
  vpCameraParameters cam;
  cam.initPersProjWithDistortion(150., 150., 80., 60., 0.5, -0.5);
  vpFrameSource source;
  const vpCueFrame frame = source.frame(I, cam, nullptr);
  vpColorOddsMap map;
  map.compute(frame, histograms, vpImageRegion(0, 0, 160, 120));
  int hidden = 0;
  for (int y = 0; y < 120; y += 2) {
    for (int x = 0; x < 160; x += 2) {
      const bool isMasked = frame.isMasked(x + 0.5, y + 0.5);
      hidden += isMasked ? 1 : 0;
      CHECK(map.logOdds(x, y) == exactly((isMasked ? 0.F : 4.F)));
    }
  }
  CHECK(hidden > 50);
}

TEST_CASE("a second odds map allocates nothing", "[odds-map]")
{
  const vpImage<vpRGBa> I = randomImage<vpRGBa>(61, 87);
  const vpColorHistograms histograms = learnt(I, 3);
  vpFrameSource source;
  vpColorOddsMap map;
  const vpCueFrame frame = source.frame(I, camera, nullptr);
  map.compute(frame, histograms, vpImageRegion(0, 0, 87, 61));
  const std::size_t before = countAllocations::allocations;
  map.compute(frame, histograms, vpImageRegion(5, 5, 80, 50));
  CHECK(countAllocations::allocations == before);
}
