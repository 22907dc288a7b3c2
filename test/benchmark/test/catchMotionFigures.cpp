// SPDX-License-Identifier: GPL-2.0-or-later
#include <catchMain.h>

#include "dataset/motionFigures.h"

#include <visp3/core/vpMath.h>

#include <cmath>

namespace {
const vpCameraParameters cam(600., 600., 320., 240.);
const std::vector<Eigen::Vector3d> flat = {{-0.1, 0., 0.}, {0.1, 0., 0.}, {0., 0.1, 0.}, {0., -0.1, 0.}};
} // namespace

TEST_CASE("A shift by 6 mm a frame at 0.6 m is 6 pixels, and predicted exactly")
{
  std::vector<vpHomogeneousMatrix> poses;
  for (int i = 0; i < 5; ++i) {
    poses.emplace_back(0.006 * i, 0., 0.6, 0., 0., 0.);
  }
  const bench::MotionFigures figures = bench::measureMotion(poses, flat, cam);
  CHECK(figures.pixels.mean == Approx(6.).margin(1e-9));
  CHECK(figures.degrees.mean == Approx(0.).margin(1e-6));
  CHECK(figures.prediction.ninth == Approx(0.).margin(1e-9));
}

TEST_CASE("Turns about the line of sight count as degrees, and are predicted in the object's frame")
{
  std::vector<vpHomogeneousMatrix> poses;
  for (int i = 0; i < 5; ++i) {
    poses.emplace_back(0., 0., 0.6, 0., 0., vpMath::rad(10. * i));
  }
  const bench::MotionFigures figures = bench::measureMotion(poses, flat, cam);
  CHECK(figures.degrees.mean == Approx(10.).margin(1e-6));
  // A chord of 10 degrees on a circle of 100 pixels.
  CHECK(figures.pixels.mean == Approx(200. * std::sin(vpMath::rad(5.))).margin(1e-6));
  CHECK(figures.prediction.mean == Approx(0.).margin(1e-6));
}

TEST_CASE("A prediction is off by what the velocity has changed")
{
  // 6 pixels to the right, then as many back: off by 12 each time.
  std::vector<vpHomogeneousMatrix> poses;
  for (int i = 0; i < 6; ++i) {
    poses.emplace_back(0.006 * (i % 2), 0., 0.6, 0., 0., 0.);
  }
  const bench::MotionFigures figures = bench::measureMotion(poses, flat, cam);
  CHECK(figures.pixels.mean == Approx(6.).margin(1e-9));
  CHECK(figures.prediction.mean == Approx(12.).margin(1e-9));
}

TEST_CASE("Values are told by their mean, and by what a tenth, a half and nine tenths of them do not exceed")
{
  std::vector<double> values;
  for (int i = 100; i >= 0; --i) {
    values.push_back(i);
  }
  const bench::Spread spread = bench::spreadOf(values);
  CHECK(spread.mean == exactly(50.));
  CHECK(spread.tenth == exactly(10.));
  CHECK(spread.median == exactly(50.));
  CHECK(spread.ninth == exactly(90.));
  CHECK(std::isnan(bench::spreadOf({}).mean));
}
