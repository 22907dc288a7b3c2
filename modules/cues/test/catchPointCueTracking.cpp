// SPDX-License-Identifier: GPL-2.0-or-later
#include <catchMain.h>

#ifdef CUES_TESTS_HAVE_POINTS

#include "pointScenes.h"

#include <opencv2/core.hpp>

using namespace pointScenes;

namespace {
// To and fro, so that sides of the box turn away and come back: once in 60 frames.
vpHomogeneousMatrix swinging(int k)
{
  const double p = 2. * M_PI * k / 60.;
  return vpHomogeneousMatrix(0.03 * std::sin(p), 0.02 * std::sin(2. * p), 0.5 + 0.05 * std::sin(p),
                             0.5 + 0.25 * std::sin(p), 0.6 + 0.35 * std::sin(p), 0.1 + 0.2 * std::sin(2. * p));
}
} // namespace

TEST_CASE("Points find the pose from 20 pixels away", "[point-cue]")
{
  const Model model = makeBox();
  Painter painter(model);
  for (const double angle : {0., 1., 2., 3., 4., 5., 6.}) {
    Follower follower(model);
    follower.start(painter.draw(startPose()), startPose());
    REQUIRE(follower.cue.pointCount() == 100);
    // 20 pixels in each direction, with a rotation of three degrees.
    const double far = 20. / 400. * 0.5;
    const vpHomogeneousMatrix truth(far * std::cos(angle), far * std::sin(angle), 0.51, 0.52, 0.63, 0.14);
    REQUIRE(imageError(*model, startPose(), truth) > 18.);
    const vpHomogeneousMatrix found = follower.track(painter.draw(truth), startPose());
    CAPTURE(angle, follower.found());
    CHECK(imageError(*model, found, truth) < 0.15);
    CHECK(follower.found() > 35);
  }
}

TEST_CASE("A prediction carries points over a motion of any length", "[point-cue]")
{
  const Model model = makeBox();
  Painter painter(model);
  Follower follower(model);
  follower.start(painter.draw(startPose()), startPose());
  const vpHomogeneousMatrix truth(0.06, 0.04, 0.55, 0.55, 0.7, 0.5);
  const vpHomogeneousMatrix predicted(0.064, 0.042, 0.55, 0.56, 0.68, 0.51);
  REQUIRE(imageError(*model, startPose(), truth) > 50.);
  CHECK(imageError(*model, follower.track(painter.draw(truth), predicted), truth) < 0.3);
  CHECK(follower.found() > 60);
}

TEST_CASE("Errors do not add up over many frames", "[point-cue]")
{
  const Model model = makeBox();
  Painter painter(model);
  Follower follower(model);
  follower.start(painter.draw(swinging(0)), swinging(0));
  vpHomogeneousMatrix cMo = swinging(0);
  double worst = 0.;
  for (int k = 1; k <= 120; ++k) {
    cMo = follower.track(painter.draw(swinging(k)), cMo);
    worst = std::max(worst, imageError(*model, cMo, swinging(k)));
  }
  CHECK(imageError(*model, cMo, swinging(120)) < 0.25);
  CHECK(worst < 0.5);
  // Depth was drawn where points were missing, and not for every frame.
  CHECK(follower.renders > 1);
  CHECK(follower.renders < 25);
}

TEST_CASE("An object that stands still stays where it is", "[point-cue]")
{
  const Model model = makeBox();
  Painter painter(model);
  Follower follower(model);
  const vpImage<unsigned char> clean = painter.draw(startPose());
  follower.start(clean, startPose());
  vpHomogeneousMatrix cMo = startPose();
  double squares = 0.;
  for (int k = 0; k < 100; ++k) {
    vpImage<unsigned char> I = clean;
    for (unsigned int i = 0; i < I.getSize(); ++i) {
      I.bitmap[i] = static_cast<unsigned char>(I.bitmap[i] + 8. * (hashed(static_cast<int>(i), k, 3) - 0.5));
    }
    cMo = follower.track(I, cMo);
    squares += std::pow(imageError(*model, cMo, startPose()), 2);
  }
  CHECK(std::sqrt(squares / 100.) < 0.03);
  CHECK(imageError(*model, cMo, startPose()) < 0.05);
}

TEST_CASE("Brightness and contrast may change", "[point-cue]")
{
  const Model model = makeBox();
  Painter painter(model);
  Follower follower(model);
  follower.start(painter.draw(startPose()), startPose());
  vpHomogeneousMatrix cMo = startPose();
  for (int k = 1; k <= 20; ++k) {
    const vpHomogeneousMatrix truth(0.001 * k, 0., 0.5, 0.5, 0.6 + 0.01 * k, 0.1);
    vpImage<unsigned char> I = painter.draw(truth);
    for (unsigned int i = 0; i < I.getSize(); ++i) {
      I.bitmap[i] = static_cast<unsigned char>(I.bitmap[i] * (1. - 0.02 * k) + k);
    }
    cMo = follower.track(I, cMo);
    CHECK(imageError(*model, cMo, truth) < 0.3);
  }
  CHECK(follower.found() > 50);
}

TEST_CASE("The number of threads changes nothing", "[point-cue]")
{
  const Model model = makeBox();
  Painter painter(model);
  const int before = cv::getNumThreads();
  std::vector<vpPointCue::Match> expected;
  for (const int threads : {1, 2, 3, 4}) {
    cv::setNumThreads(threads);
    Follower follower(model);
    follower.start(painter.draw(swinging(0)), swinging(0));
    for (int k = 1; k <= 12; ++k) {
      follower.track(painter.draw(swinging(k)), swinging(k - 1));
    }
    const std::vector<vpPointCue::Match> &matches = follower.cue.matches();
    REQUIRE(matches.size() > 50);
    if (threads == 1) {
      expected = matches;
    }
    REQUIRE(matches.size() == expected.size());
    for (std::size_t i = 0; i < matches.size(); ++i) {
      CHECK(matches[i].pixel == expected[i].pixel);
      CHECK(matches[i].position == expected[i].position);
      CHECK(matches[i].found == expected[i].found);
    }
  }
  cv::setNumThreads(before);
}

TEST_CASE("A frame is matched again, and an untrusted one is not learnt from", "[point-cue]")
{
  const Model model = makeBox();
  Painter painter(model);
  Follower follower(model);
  follower.start(painter.draw(swinging(0)), swinging(0));
  const vpImage<unsigned char> I = painter.draw(swinging(4));
  follower.match(I, swinging(0));
  const vpHomogeneousMatrix first = follower.estimate(swinging(0));
  // The view moved within the frame.
  follower.view.compute(first, makeCamera(), width, height, vpModelViewOptions(), nullptr);
  follower.cue.match(follower.source.frame(I, makeCamera(), nullptr), follower.view);
  const vpHomogeneousMatrix second = follower.estimate(first);
  CHECK(imageError(*model, second, swinging(4)) < 0.15);
  // Frames of which nothing was learnt do no harm.
  const vpImage<unsigned char> black(height, width, 0);
  for (int k = 0; k < 10; ++k) {
    follower.match(black, swinging(4));
    CHECK(follower.found() == 0);
  }
  CHECK(imageError(*model, follower.track(painter.draw(swinging(6)), second), swinging(6)) < 0.2);
}

#else
#include "pointCueMissing.h"
#endif
