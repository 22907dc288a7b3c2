// SPDX-License-Identifier: GPL-2.0-or-later
#include "frame/vpFrameDeadline.cpp" // The library keeps it to itself.
#include "frame/vpSearchSize.h"

#include <catchMain.h>

#include "renderedBox.h"

#include <meshFiles.h>

#include <visp3/multicue/vpMbMultiCueTracker.h>

#include <cmath>
#include <limits>
#include <thread>

namespace {
void wait(double milliseconds)
{
  std::this_thread::sleep_for(std::chrono::duration<double, std::milli>(milliseconds));
}
} // namespace

TEST_CASE("Without a deadline nothing is put off", "[frame-deadline]")
{
  vpFrameDeadline deadline;
  deadline.startFrame();
  deadline.learn(vpPutOff::SEARCH, 1e6);
  deadline.learnEnding(1e6);
  CHECK_FALSE(deadline.putsOff(vpPutOff::SEARCH));
  CHECK(std::isinf(deadline.left()));
  CHECK_FALSE(deadline.after(0.).isOver());
  CHECK(deadline.putOff().empty());

  vpSearchSize size;
  size.begin(deadline, 0.5);
  CHECK(size.of(2000.) == 2000);
  size.end(deadline);
  CHECK(size.of(2000.) == 2000);
}

TEST_CASE("What does not fit in before the end is put off, and told once", "[frame-deadline]")
{
  vpFrameDeadline deadline;
  deadline.set(1000.);
  deadline.startFrame();
  deadline.learn(vpPutOff::STARTS, 400.);
  CHECK_FALSE(deadline.putsOff(vpPutOff::STARTS));
  deadline.learnEnding(700.);
  CHECK(deadline.putsOff(vpPutOff::STARTS));
  CHECK(deadline.putsOff(vpPutOff::STARTS));
  CHECK_FALSE(deadline.putsOff(vpPutOff::SEARCH)); // Nothing is known of its time.
  CHECK(deadline.putOff() == std::vector<vpPutOff>{vpPutOff::STARTS});
  deadline.startFrame();
  CHECK(deadline.putOff().empty());
}

TEST_CASE("A long time is remembered for some frames", "[frame-deadline]")
{
  vpFrameDeadline deadline;
  deadline.set(1000.);
  deadline.startFrame();
  deadline.learn(vpPutOff::STARTS, 2000.);
  unsigned int times = 0;
  for (; deadline.putsOff(vpPutOff::STARTS) && times < 1000; ++times) {
    deadline.learn(vpPutOff::STARTS, 10.);
  }
  CHECK(times > 3);
  CHECK(times < 20);
}

TEST_CASE("Nothing more is begun when the time is spent", "[frame-deadline]")
{
  vpFrameDeadline deadline;
  deadline.set(1.);
  deadline.startFrame();
  wait(2.);
  CHECK(deadline.left() < 0.);
  CHECK(deadline.putsOff(vpPutOff::COMPARISON));
  CHECK(deadline.after(0.5).isOver());
}

TEST_CASE("A search becomes as large as its time allows", "[frame-deadline]")
{
  vpFrameDeadline deadline;
  deadline.set(40.);
  deadline.startFrame();
  vpSearchSize size;
  size.begin(deadline, 0.25);
  const double whole = 20.; // Of all poses, milliseconds.
  for (unsigned int i = 0; i < 12; ++i) {
    size.learn(10., whole * size.share());
  }
  CHECK(size.share() == Approx(0.5));
  for (unsigned int i = 0; i < 12; ++i) {
    size.learn(10., 15.); // Whatever is drawn.
  }
  CHECK(size.share() < 0.1);
  CHECK(size.of(2000.) >= 50);
  for (unsigned int i = 0; i < 12; ++i) {
    size.learn(10., 0.);
  }
  CHECK(size.share() == Approx(1.));
}

TEST_CASE("A search that was put off in several frames has more time in the next", "[frame-deadline]")
{
  vpFrameDeadline deadline;
  deadline.set(1000.);
  std::vector<bool> isSearched;
  for (unsigned int i = 0; i < 8; ++i) {
    deadline.startFrame();
    deadline.learn(vpPutOff::SEARCH, 1500.);
    isSearched.push_back(!deadline.putsOff(vpPutOff::SEARCH));
  }
  CHECK(isSearched == std::vector<bool>{false, false, false, true, false, false, false, true});
}

TEST_CASE("A frame without time follows the object, and tells what it left", "[frame-deadline]")
{
  renderedBox box;
  vpMbMultiCueTracker tracker;
  tracker.setCameraParameters(renderedBox::camera());
  tracker.loadModel(renderedBox::writeCao(meshFiles::temporaryFile("deadline-box.cao")));
  const vpImage<vpRGBa> I = box.drawColor(renderedBox::pose());
  const vpImage<vpRGBa> nothing(I.getHeight(), I.getWidth(), vpRGBa(90, 90, 90));
  const double deadline = GENERATE(0., 0.01);
  tracker.setFrameDeadline(deadline);
  tracker.initFromPose(I, renderedBox::pose());
  for (unsigned int i = 0; i < 5; ++i) {
    tracker.track(I);
    CHECK(tracker.getTrackingState() == vpTrackingState::TRACKING);
    CHECK(tracker.getTrackingResult().putOff.empty()); // There was nothing else to do.
  }
  tracker.track(nothing);
  const vpMbTrackingResult result = tracker.getTrackingResult();
  CHECK(result.state == vpTrackingState::LOST);
  CHECK(result.putOff.empty() == (deadline == exactly(0.)));
  CHECK(vpMbTrackingResult::fromJson(result.toJson()).putOff == result.putOff);
  tracker.initFromPose(I, renderedBox::pose());
  CHECK(tracker.getTrackingResult().putOff.empty());
}

TEST_CASE("A deadline out of range is refused and the last one kept", "[frame-deadline]")
{
  vpMbMultiCueTracker tracker(vpMbMultiCueTracker::EDGE_TRACKER);
  CHECK(tracker.getFrameDeadline() == exactly(0.));
  tracker.setFrameDeadline(40.);
  for (const double value : {-1., 10001., std::numeric_limits<double>::quiet_NaN()}) {
    CHECK_THROWS_AS(tracker.setFrameDeadline(value), vpException);
    CHECK(tracker.getFrameDeadline() == exactly(40.));
  }
}
