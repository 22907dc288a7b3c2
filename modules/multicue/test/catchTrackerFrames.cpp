// SPDX-License-Identifier: GPL-2.0-or-later
#include <catchMain.h>
#include <exceptionMessage.h>

#include "plainScene.h"

#include <visp3/core/vpException.h>

#include <algorithm>
#include <vector>

namespace {
//! A tracker with all cues and a search, and a camera whose driver makes mistakes.
struct Followed
{
  Followed()
  {
    const std::string file = meshFiles::temporaryFile("frames.stl");
    std::ofstream(file) << meshFiles::asciiStl(box());
    tracker.setFrameDeadline(0.);
    tracker.setCameraParameters(plainScene::camera());
    tracker.loadModel(file);
    tracker.initFromPose(scene.draw(plainScene::poseAt(0)), plainScene::poseAt(0));
    show({1, 2, 3});
  }

  static meshFiles::Triangles box() { return modelShapes::boxTriangles(modelShapes::Point(0.12, 0.07, 0.05)); }

  void show(const std::vector<int> &frames)
  {
    for (const int i : frames) {
      CAPTURE(i);
      CHECK_NOTHROW(tracker.track(scene.draw(plainScene::poseAt(i))));
      CHECK(tracker.getTrackingState() == vpTrackingState::TRACKING);
      const vpHomogeneousMatrix cMo = tracker.getPose();
      const vpHomogeneousMatrix truth = plainScene::poseAt(i);
      CHECK((cMo.getTranslationVector() - truth.getTranslationVector()).frobeniusNorm() < 0.005);
      CHECK(plainScene::tilt(cMo, truth) < 3.);
    }
  }

  plainScene scene{box()};
  vpMbMultiCueTracker tracker;
};
} // namespace

TEST_CASE("Frames that are dropped, doubled or out of order are followed", "[tracker]")
{
  SECTION("dropped")
  {
    Followed().show({5, 6, 9, 10, 12, 15});
  }
  SECTION("doubled")
  {
    Followed().show({4, 4, 5, 5, 5, 6, 6});
  }
  SECTION("out of order")
  {
    Followed().show({5, 4, 6, 8, 7, 9, 8, 10});
  }
}

TEST_CASE("Frames that are empty or of another size are refused by name, and the next one is followed", "[tracker]")
{
  Followed followed;
  const vpHomogeneousMatrix before = followed.tracker.getPose();
  // ViSP's copy of an empty image hands a null pointer to memcpy(), which is undefined: none is copied.
  const vpImage<vpRGBa> empty;
  const vpImage<vpRGBa> column(plainScene::height, 1);
  const vpImage<vpRGBa> row(1, plainScene::width);
  const vpImage<vpRGBa> upright(plainScene::width, plainScene::height);
  for (const vpImage<vpRGBa> *broken : {&empty, &column, &row, &upright}) {
    const vpImage<vpRGBa> &I = *broken;
    CHECK_THAT(messageOf([&] { followed.tracker.track(I); }),
               ContainsSubstring(std::to_string(I.getWidth()) + " x " + std::to_string(I.getHeight())));
    const vpHomogeneousMatrix after = followed.tracker.getPose();
    CHECK(std::equal(before.data, before.data + 16, after.data));
  }
  followed.show({4, 5, 6});
}
