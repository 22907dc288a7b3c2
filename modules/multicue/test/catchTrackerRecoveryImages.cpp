// SPDX-License-Identifier: GPL-2.0-or-later
#include "recoveryScene.h"

#include <visp3/se3/vpPoseRandom.h>

#include <algorithm>
#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <vector>

using namespace recoveryScene;

namespace {
vpImage<vpRGBa> noise(std::uint64_t seed)
{
  vpPoseRandom random(seed);
  vpImage<vpRGBa> I = plainImage(black);
  const auto level = [&random] { return static_cast<unsigned char>(255. * random.uniform()); };
  for (unsigned int i = 0; i < I.getSize(); ++i) {
    I.bitmap[i].R = level();
    I.bitmap[i].G = level();
    I.bitmap[i].B = level();
  }
  return I;
}
} // namespace

TEST_CASE("Images that do not show the object are never called TRACKING", "[recovery]")
{
  Scene scene(colorScenes::makeBox());
  colorScenes::Paint glaring;
  glaring.gain = 12.;
  const vpImage<vpRGBa> overExposed = scene.draw(Tracked::swaying(12), glaring);
  const vpImage<vpRGBa> white = plainImage(vpRGBa(255, 255, 255));
  const std::vector<std::pair<std::string, std::function<vpImage<vpRGBa>(int)>>> kinds = {
      {"black", [](int) { return plainImage(black); }},
      {"white", [&](int) { return white; }},
      {"noise", [](int i) { return noise(static_cast<std::uint64_t>(i)); }},
      {"over-exposed", [&](int) { return overExposed; }}};
  for (const auto &kind : kinds) {
    CAPTURE(kind.first);
    Tracked object(true);
    for (int i = 0; i < 11; ++i) {
      CHECK_NOTHROW(object.tracker.track(kind.second(i)));
      CHECK(object.isFinite());
      CHECK((i < 10 || !object.isTracking()));
    }
  }
}

TEST_CASE("A frame that is repeated keeps its pose", "[recovery]")
{
  Tracked object(true);
  const vpImage<vpRGBa> I = object.scene.draw(Tracked::swaying(12));
  for (int i = 0; i < 12; ++i) {
    CHECK_NOTHROW(object.tracker.track(I));
    CHECK(object.isTracking());
    CHECK(object.isRight(Tracked::swaying(12)));
  }
}

TEST_CASE("The same images give the same bits while the object is searched for", "[recovery]")
{
  Tracked first(true);
  Tracked second(true);
  const vpImage<vpRGBa> dark = plainImage(black);
  for (int i = 0; i < 8; ++i) {
    const vpImage<vpRGBa> I = i < 3 ? dark : first.scene.draw(turned(60. - i));
    first.tracker.track(I);
    second.tracker.track(I);
    const vpHomogeneousMatrix a = first.tracker.getPose();
    const vpHomogeneousMatrix b = second.tracker.getPose();
    CHECK(std::equal(a.data, a.data + 16, b.data));
    CHECK(first.tracker.getTrackingState() == second.tracker.getTrackingState());
    CHECK(first.tracker.getTrackingResult().score == exactly(second.tracker.getTrackingResult().score));
  }
}

TEST_CASE("A pose that the edges hold is not lost where light turns the colours", "[recovery]")
{
  Tracked tracked(true);
  for (int i = 13; i <= 22; ++i) {
    const vpHomogeneousMatrix truth = Tracked::swaying(i);
    vpImage<vpRGBa> image = tracked.scene.draw(truth);
    std::for_each(image.bitmap, image.bitmap + image.getSize(), [](vpRGBa &pixel) {
      pixel = vpRGBa(static_cast<unsigned char>(255 - pixel.R), static_cast<unsigned char>(255 - pixel.G),
                     static_cast<unsigned char>(255 - pixel.B));
    });
    tracked.tracker.track(image);
    CHECK(tracked.tracker.getTrackingState() != vpTrackingState::LOST);
    CHECK(tracked.isRight(truth));
  }
}

TEST_CASE("Lines like the edges of an object that was lost are not taken for it", "[recovery]")
{
  const colorScenes::Color board(150., 110., 70.);
  Tracked object(true);
  CHECK(object.darken() == 0);
  object.paint.background = [&](double, double) { return board; };
  object.paint.object = [&](const Eigen::Vector3d &X) {
    const Eigen::Vector3d toSides = 0.5 * boxSize - X.cwiseAbs();
    return (toSides.array() < 0.003).count() > 1 ? colorScenes::Color(10., 10., 10.) : board;
  };
  CHECK(object.comeBack(turned(180.), 40).confirmed == Tracked::never); // From a side that was not seen before.
}
