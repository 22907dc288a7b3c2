// SPDX-License-Identifier: GPL-2.0-or-later
#include <catchMain.h>

#include "renderedBox.h"

#include <meshFiles.h>

#include <visp3/multicue/vpMbMultiCueTracker.h>
#include <visp3/se3/vpPoseRandom.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace {
const int all =
    vpMbMultiCueTracker::EDGE_TRACKER | vpMbMultiCueTracker::KLT_TRACKER | vpMbMultiCueTracker::COLOR_TRACKER;

// A speckled board in front of the object, full of corners.
void hide(vpImage<vpRGBa> &I, int left, int width)
{
  vpPoseRandom random(7);
  for (int v = 140; v < 340; ++v) {
    for (int u = left; u < left + width; ++u) {
      const bool isNewSpot = (v - 140) % 5 == 0 && (u - left) % 5 == 0;
      if (isNewSpot) {
        const auto level = static_cast<unsigned char>(40. + 180. * random.uniform());
        for (int y = v; y < v + 5; ++y) {
          for (int x = u; x < u + 5; ++x) {
            I[static_cast<unsigned int>(y)][static_cast<unsigned int>(x)] = vpRGBa(level, level, level);
          }
        }
      }
    }
  }
}

void prepare(vpMbMultiCueTracker &tracker)
{
  tracker.setTrackerType(all);
  tracker.setCameraParameters(renderedBox::camera());
  tracker.loadModel(renderedBox::writeCao(meshFiles::temporaryFile("box.cao")));
}

double error(const vpHomogeneousMatrix &cMo, const vpHomogeneousMatrix &truth)
{
  return (cMo.getTranslationVector() - truth.getTranslationVector()).frobeniusNorm();
}

double turnOff(const vpHomogeneousMatrix &cMo, const vpHomogeneousMatrix &truth)
{
  return (cMo.inverse() * truth).getThetaUVector().getTheta() * 180. / M_PI;
}
} // namespace

TEST_CASE("Points of what passes before the object do not take the pose along", "[tracker]")
{
  renderedBox box; // Without any texture: all points are the board's.
  for (const int first : {250, 330}) {
    vpMbMultiCueTracker tracker;
    prepare(tracker);
    vpImage<vpRGBa> I = box.drawColor(renderedBox::pose());
    hide(I, first, 60); // At the start already.
    tracker.initFromPose(I, renderedBox::pose());
    double worst = 0.;
    for (int i = 1; i <= 12; ++i) {
      I = box.drawColor(renderedBox::pose());
      hide(I, first + (first < 300 ? 5 : -5) * i, 60);
      tracker.track(I);
      worst = std::max(worst, error(tracker.getPose(), renderedBox::pose()));
    }
    INFO("worst error " << worst << " m");
    CHECK(worst < 0.004);
    CHECK(tracker.getTrackingState() == vpTrackingState::TRACKING);
  }
}

TEST_CASE("Turns between two frames are found by starting elsewhere", "[tracker]")
{
  renderedBox box;
  for (const double angle : {-0.7, -0.6, 0.6, 0.7}) {
    for (int axis = 0; axis < 3; ++axis) {
      vpMbMultiCueTracker tracker;
      prepare(tracker);
      tracker.initFromPose(box.drawColor(renderedBox::pose()), renderedBox::pose());
      for (int i = 0; i < 3; ++i) {
        tracker.track(box.drawColor(renderedBox::pose()));
      }
      const vpHomogeneousMatrix turned =
          renderedBox::pose() *
          vpHomogeneousMatrix(0., 0., 0., axis == 0 ? angle : 0., axis == 1 ? angle : 0., axis == 2 ? angle : 0.);
      tracker.track(box.drawColor(turned));
      tracker.track(box.drawColor(turned));
      INFO("axis " << axis << " by " << angle << ": off by " << turnOff(tracker.getPose(), turned) << " degrees");
      CHECK(turnOff(tracker.getPose(), turned) < 1.);
      CHECK(tracker.getTrackingState() == vpTrackingState::TRACKING);
    }
  }
}

TEST_CASE("A wrong pose is not called TRACKING, nor learnt from", "[tracker]")
{
  renderedBox box;
  vpMbMultiCueTracker tracker;
  prepare(tracker);
  tracker.initFromPose(box.drawColor(renderedBox::pose()), renderedBox::pose());
  for (int i = 0; i < 3; ++i) {
    tracker.track(box.drawColor(renderedBox::pose()));
  }
  const std::vector<vpMbTrackingResult::Cue> before = tracker.getTrackingResult().cues;
  // It has gone, and something else is there.
  vpImage<vpRGBa> I(renderedBox::height, renderedBox::width, vpRGBa(25, 230, 90));
  hide(I, 250, 140);
  for (int i = 0; i < 10; ++i) {
    tracker.track(I);
    CHECK(tracker.getTrackingState() != vpTrackingState::TRACKING);
  }
  // It is back where it was, and looks to the tracker as before: a start would have forgotten what was learnt.
  for (int i = 0; i < 2; ++i) {
    tracker.track(box.drawColor(renderedBox::pose()));
    CHECK(tracker.getTrackingState() == vpTrackingState::TRACKING);
    CHECK(error(tracker.getPose(), renderedBox::pose()) < 0.004);
    const std::vector<vpMbTrackingResult::Cue> now = tracker.getTrackingResult().cues;
    REQUIRE(now.size() == before.size());
    for (std::size_t k = 0; k < now.size(); ++k) {
      if (now[k].type != vpMbMultiCueTracker::KLT_TRACKER) { // Points are not asked beside the others.
        CHECK(now[k].agreement == Approx(before[k].agreement).epsilon(0.02));
      }
    }
  }
}
