// SPDX-License-Identifier: GPL-2.0-or-later
#include <catchMain.h>

#include "recording.h"

#include <visp3/core/vpTrackingException.h>
#include <visp3/mbt/vpMbGenericTracker.h>
#include <visp3/multicue/vpMbMultiCueTracker.h>

namespace {
const std::string folder = "mbt-depth/Castle-simu/";
const int firstFrame = 1;
const int lastFrame = 40;

struct Errors
{
  double translation = 0.; // Largest, metres.
  double rotation = 0.;    // Largest, degrees.
  int tracking = 0;
};

// As ViSP's own regression test places it.
vpHomogeneousMatrix cubePose()
{
  vpHomogeneousMatrix oMcube;
  oMcube[0][0] = -1.;
  oMcube[0][3] = -0.2;
  oMcube[1][1] = 0.;
  oMcube[1][2] = 1.;
  oMcube[1][3] = 0.12;
  oMcube[2][1] = 1.;
  oMcube[2][2] = 0.;
  oMcube[2][3] = -0.15;
  return oMcube;
}

bool isTracking(vpMbMultiCueTracker &tracker)
{
  return tracker.getTrackingState() == vpTrackingState::TRACKING;
}
bool isTracking(vpMbGenericTracker &)
{
  return true;
}

template <typename Tracker> Errors follow(Tracker &tracker, bool withCube)
{
  tracker.loadConfigFile(recording::path(folder + "Config/chateau.xml"), false);
  tracker.loadModel(recording::path(folder + "Models/chateau.cao"));
  if (withCube) {
    tracker.loadModel(recording::path(folder + "Models/cube.cao"), false, cubePose());
  }
  Errors errors;
  bool alive = true;
  for (int frame = firstFrame; frame <= lastFrame; ++frame) {
    const vpImage<unsigned char> I = recording::image(folder + "Images/Image_%04d", frame);
    const vpHomogeneousMatrix truth = recording::pose(folder + "CameraPose/Camera_%03d.txt", frame);
    if (frame == firstFrame) {
      tracker.initFromPose(I, truth);
    }
    try {
      if (alive) {
        tracker.track(I);
        errors.tracking += isTracking(tracker) ? 1 : 0;
      }
    } catch (const vpTrackingException &) {
      alive = false; // ViSP's tracker gives up so: its last pose is what it offers from then on.
    }
    const vpHomogeneousMatrix difference = truth.inverse() * tracker.getPose();
    errors.translation = std::max(
        errors.translation, (tracker.getPose().getTranslationVector() - truth.getTranslationVector()).frobeniusNorm());
    errors.rotation = std::max(errors.rotation, vpMath::deg(difference.getThetaUVector().getTheta()));
  }
  return errors;
}
} // namespace

TEST_CASE("The rendered castle stays within the bounds of ViSP's regression test and closer to the truth than ViSP",
          "[sequence]")
{
  for (const bool withCube : {false, true}) {
    CAPTURE(withCube);
    vpMbMultiCueTracker tracker(vpMbMultiCueTracker::EDGE_TRACKER);
    const Errors ours = follow(tracker, withCube);
    vpMbGenericTracker visp(1, vpMbGenericTracker::EDGE_TRACKER);
    const Errors theirs = follow(visp, withCube);
    CHECK(ours.tracking == lastFrame);
    CHECK(ours.translation <= 0.008);
    CHECK(ours.rotation <= 3.9);
    CHECK(ours.translation < theirs.translation);
    CHECK(ours.rotation < theirs.rotation);
  }
}
