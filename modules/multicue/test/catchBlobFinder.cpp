// SPDX-License-Identifier: GPL-2.0-or-later
#include "searchScenes.h"

#include "search/vpBlobFinder.cpp" // The library keeps it to itself.

#include <catchMain.h>

namespace {
const vpRGBa object(200, 56, 40);
const vpRGBa ground(72, 120, 88);

//! A square of the object's colour; parts of it may be outside the image.
vpImage<vpRGBa> square(int left, int top, int side)
{
  vpImage<vpRGBa> I(240, 320, ground);
  for (int i = std::max(top, 0); i < std::min(top + side, 240); ++i) {
    for (int j = std::max(left, 0); j < std::min(left + side, 320); ++j) {
      I[static_cast<unsigned int>(i)][j] = object;
    }
  }
  return I;
}

//! The object's colour to the left of a column and above a row.
vpImage<vpRGBa> upperLeft(unsigned int height, unsigned int width, unsigned int row, unsigned int column)
{
  vpImage<vpRGBa> I(height, width, ground);
  for (unsigned int i = 0; i < row; ++i) {
    for (unsigned int j = 0; j < column; ++j) {
      I[i][j] = object;
    }
  }
  return I;
}

std::vector<vpBlob> found(const vpImage<vpRGBa> &I, double size, std::size_t most = 4)
{
  vpFrameSource source;
  vpColorOddsMap map;
  map.compute(source.frame(I, colorScenes::makeCamera(), nullptr), searchScenes::learnt(searchScenes::plainPaint()),
              vpImageRegion(0, 0, static_cast<int>(I.getWidth()), static_cast<int>(I.getHeight())));
  return vpBlobFinder().find(map, I.getWidth(), I.getHeight(), size, most);
}
} // namespace

TEST_CASE("A square is found at its place, with its size", "[blob-finder]")
{
  const int side = GENERATE(48, 64, 90);
  const int left = GENERATE(40, 143, 200);
  CAPTURE(side, left);
  const std::vector<vpBlob> blobs = found(square(left, 70, side), 64.);
  REQUIRE_FALSE(blobs.empty());
  CHECK(std::fabs(blobs[0].u - (left + 0.5 * side)) < 12.);
  CHECK(std::fabs(blobs[0].v - (70 + 0.5 * side)) < 12.);
  CHECK(std::fabs(blobs[0].size - side) <= 18.);
  CHECK(blobs[0].contrast > 0.6);
  for (std::size_t k = 1; k < blobs.size(); ++k) {
    CHECK(blobs[k].contrast <= blobs[k - 1].contrast);
  }
}

TEST_CASE("Two squares are two places", "[blob-finder]")
{
  vpImage<vpRGBa> I = square(30, 30, 64);
  const vpImage<vpRGBa> second = square(210, 140, 64);
  for (unsigned int k = 0; k < I.getSize(); ++k) {
    I.bitmap[k] = second.bitmap[k].R == object.R ? object : I.bitmap[k];
  }
  const std::vector<vpBlob> blobs = found(I, 64.);
  REQUIRE(blobs.size() >= 2);
  CHECK(std::fabs(std::fabs(blobs[0].u - blobs[1].u) - 180.) < 20.);
  CHECK(std::fabs(std::fabs(blobs[0].v - blobs[1].v) - 110.) < 20.);
  CHECK(found(I, 64., 1).size() == 1);
}

TEST_CASE("An image of one colour has no place that stands out", "[blob-finder]")
{
  CHECK(found(vpImage<vpRGBa>(240, 320, ground), 64.).empty());
  CHECK(found(vpImage<vpRGBa>(240, 320, vpRGBa(0, 0, 255)), 64.).empty());
}

TEST_CASE("Half of a square at the image's border is found", "[blob-finder]")
{
  const std::vector<vpBlob> blobs = found(square(-32, 90, 64), 64.);
  REQUIRE_FALSE(blobs.empty());
  CHECK(blobs[0].u < 32.);
  CHECK(std::fabs(blobs[0].v - 122.) < 16.);
}

TEST_CASE("Images smaller than a cell, and windows larger than the image", "[blob-finder]")
{
  CHECK(found(vpImage<vpRGBa>(5, 5, object), 64.).empty());
  CHECK(found(upperLeft(240, 7, 120, 7), 64.).empty());
  CHECK(found(upperLeft(7, 320, 7, 160), 64.).empty());
  // Nothing is around a window that holds all of the image, and hardly anything inside one that is much larger.
  const vpImage<vpRGBa> half = upperLeft(240, 320, 240, 152);
  for (const double size : {640., 900., 1300., 2000., 1e5}) {
    CAPTURE(size);
    CHECK(found(vpImage<vpRGBa>(240, 320, object), size).empty());
    CHECK(found(half, size).empty() == (size > 1000.));
  }
}

TEST_CASE("The smallest windows are two cells wide", "[blob-finder]")
{
  const std::vector<vpBlob> blobs = found(square(96, 96, 40), 1.);
  REQUIRE(blobs.size() == 4);
  for (const vpBlob &blob : blobs) {
    CHECK(blob.size == exactly(16.));
    CHECK(blob.contrast > 0.);
    CHECK(std::fabs(blob.u - 116.) <= 28.);
    CHECK(std::fabs(blob.v - 116.) <= 28.);
  }
}
