// SPDX-License-Identifier: GPL-2.0-or-later
#include <catchMain.h>

#include "stripedBox.h"

#include <meshFiles.h>

#include <visp3/core/vpExponentialMap.h>
#include <visp3/multicue/vpMbMultiCueTracker.h>

#include <cmath>

namespace {
const int edge = vpMbMultiCueTracker::EDGE_TRACKER;
const int point = vpMbMultiCueTracker::KLT_TRACKER;
const int color = vpMbMultiCueTracker::COLOR_TRACKER;

//! A box with a stripe beside its border that is stronger than the border, on which contours of a pose that is off end.
class Start
{
public:
  explicit Start(int type) : tracker(1U, type)
  {
    tracker.setCameraParameters(renderedBox::camera());
    tracker.loadModel(renderedBox::writeCao(meshFiles::temporaryFile("capture-box.cao")));
  }

  static vpHomogeneousMatrix truth() { return vpHomogeneousMatrix(0.02, -0.01, 0.6, 0.5, 0.35, -0.2); }

  // In a direction of its own for each number: the corners move by about 5 pixels.
  static vpHomogeneousMatrix off(int number)
  {
    vpColVector motion(6);
    for (unsigned int i = 0; i < 6; ++i) {
      motion[i] = (i < 3 ? 0.0035 : 0.03) * std::sin(1. + 2.3 * number + 1.7 * i);
    }
    return truth() * vpExponentialMap::direct(motion);
  }

  bool isRight() const
  {
    const vpHomogeneousMatrix difference = truth().inverse() * tracker.getPose();
    return difference.getTranslationVector().frobeniusNorm() < 0.003 &&
           vpMath::deg(difference.getThetaUVector().getTheta()) < 1.5;
  }

  stripedBox box;
  vpMbMultiCueTracker tracker;
};

vpImage<unsigned char> shifted(const vpImage<unsigned char> &I, unsigned int pixels)
{
  vpImage<unsigned char> moved(I.getHeight(), I.getWidth(), renderedBox::background);
  for (unsigned int i = 0; i < I.getHeight(); ++i) {
    for (unsigned int j = pixels; j < I.getWidth(); ++j) {
      moved[i][j] = I[i][j - pixels];
    }
  }
  return moved;
}
} // namespace

TEST_CASE("A start that is some pixels off is captured in the first image, with any cues", "[capture]")
{
  for (const int type : {edge, point, color, edge | point, edge | color | point}) {
    CAPTURE(type);
    Start start(type);
    const vpImage<unsigned char> I = start.box.draw(Start::truth());
    for (int number = 0; number < 6; ++number) {
      CAPTURE(number);
      start.tracker.initFromPose(I, Start::off(number));
      start.tracker.track(I);
      CHECK(start.isRight());
    }
  }
}

TEST_CASE("A start keeps the pose that was given until an image is tracked", "[capture]")
{
  Start start(edge);
  const vpImage<unsigned char> I = start.box.draw(Start::truth());
  const vpHomogeneousMatrix given = Start::off(1);
  start.tracker.initFromPose(I, given);
  const vpHomogeneousMatrix kept = start.tracker.getPose();
  CHECK(std::equal(kept.data, kept.data + 16, given.data));
  start.tracker.track(I);
  CHECK(start.isRight());
  start.tracker.setPose(I, given);
  const vpHomogeneousMatrix set = start.tracker.getPose();
  CHECK(std::equal(set.data, set.data + 16, given.data));
  start.tracker.track(I);
  CHECK(start.isRight());
}

TEST_CASE("A start where the image shows nothing stays where it is and is not believed", "[capture]")
{
  Start start(edge);
  const vpImage<unsigned char> blank(renderedBox::height, renderedBox::width, 128);
  start.tracker.initFromPose(blank, Start::truth());
  start.tracker.track(blank);
  CHECK(start.tracker.getTrackingState() == vpTrackingState::LOST);
  CHECK(start.isRight());
}

TEST_CASE("With edges alone an object that jumped is not tracked without notice", "[capture]")
{
  for (const unsigned int pixels : {30U, 45U, 70U}) {
    CAPTURE(pixels);
    Start start(edge);
    const vpImage<unsigned char> I = start.box.draw(Start::truth());
    start.tracker.initFromPose(I, Start::truth());
    for (int i = 0; i < 5; ++i) {
      start.tracker.track(I);
      REQUIRE(start.tracker.getTrackingState() == vpTrackingState::TRACKING);
    }
    const vpImage<unsigned char> jumped = shifted(I, pixels);
    for (int i = 0; i < 5; ++i) {
      start.tracker.track(jumped);
      const double x = start.tracker.getPose()[0][3] - Start::truth()[0][3];
      const bool isFound = std::fabs(x - pixels * 0.6 / 600.) < 0.006;
      CHECK((isFound || start.tracker.getTrackingState() != vpTrackingState::TRACKING));
    }
    start.tracker.track(I);
    CHECK(start.tracker.getTrackingState() == vpTrackingState::TRACKING);
    CHECK(start.isRight());
  }
}
