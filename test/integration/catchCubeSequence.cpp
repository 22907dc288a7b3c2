// SPDX-License-Identifier: GPL-2.0-or-later
#include <catchMain.h>

#include "modelFiles.h"
#include "recording.h"

#include <meshFiles.h>

#include <visp3/mbt/vpMbGenericTracker.h>
#include <visp3/multicue/vpMbMultiCueTracker.h>

namespace {
const int frames = 218;

struct Outcome
{
  std::vector<double> errors; // Projection errors by ViSP's own measure, degrees.
  std::vector<vpHomogeneousMatrix> poses;
  int tracking = 0;
};

bool isTracking(vpMbMultiCueTracker &tracker)
{
  return tracker.getTrackingState() == vpTrackingState::TRACKING;
}
bool isTracking(vpMbGenericTracker &)
{
  return true;
} // It throws where it is not.

template <typename Tracker> Outcome follow(Tracker &tracker)
{
  vpMbGenericTracker judge(1, vpMbGenericTracker::EDGE_TRACKER);
  judge.loadConfigFile(recording::path("mbt/cube.xml"), false);
  judge.loadModel(recording::path("mbt/cube.cao"));
  vpCameraParameters cam;
  judge.getCameraParameters(cam);
  Outcome outcome;
  for (int frame = 0; frame < frames; ++frame) {
    const vpImage<unsigned char> I = recording::image("mbt/cube/image%04d", frame);
    if (frame == 0) {
      tracker.initFromPose(I, recording::path("mbt/cube.0.pos"));
    }
    tracker.track(I);
    outcome.tracking += isTracking(tracker) ? 1 : 0;
    outcome.poses.push_back(tracker.getPose());
    outcome.errors.push_back(judge.computeCurrentProjectionError(I, tracker.getPose(), cam));
  }
  return outcome;
}

template <typename Tracker> Outcome followModel(Tracker &tracker, const std::string &model)
{
  tracker.loadConfigFile(recording::path("mbt/cube.xml"), false);
  tracker.loadModel(model);
  return follow(tracker);
}
} // namespace

TEST_CASE("The real cube is held in all frames, with a projection error not above that of ViSP's edge tracker",
          "[sequence]")
{
  vpMbMultiCueTracker tracker(vpMbMultiCueTracker::EDGE_TRACKER);
  const Outcome ours = followModel(tracker, recording::path("mbt/cube.cao"));
  vpMbGenericTracker visp(1, vpMbGenericTracker::EDGE_TRACKER);
  const Outcome theirs = followModel(visp, recording::path("mbt/cube.cao"));
  CHECK(ours.tracking == frames);
  CHECK(recording::median(ours.errors) <= recording::median(theirs.errors));
  CHECK(recording::maximum(ours.errors) <= recording::maximum(theirs.errors));
}

TEST_CASE("The cube as a mesh is tracked as well as the .cao", "[sequence]")
{
  vpMbMultiCueTracker tracker(vpMbMultiCueTracker::EDGE_TRACKER);
  const Outcome polygons = followModel(tracker, recording::path("mbt/cube.cao"));
  vpMbMultiCueTracker meshTracker(vpMbMultiCueTracker::EDGE_TRACKER);
  const Outcome mesh =
      followModel(meshTracker, writeModelAsObj(*tracker.getModel(), meshFiles::temporaryFile("cube-as-mesh.obj")));
  CHECK(mesh.tracking == frames);
  CHECK(meshTracker.getModelReport().edges == 12);
  CHECK(recording::median(mesh.errors) <= 1.02 * recording::median(polygons.errors));
  CHECK(recording::maximum(mesh.errors) <= 1.05 * recording::maximum(polygons.errors));
  for (int frame = 0; frame < frames; ++frame) {
    const vpHomogeneousMatrix difference =
        polygons.poses[static_cast<std::size_t>(frame)].inverse() * mesh.poses[static_cast<std::size_t>(frame)];
    CHECK(difference.getTranslationVector().frobeniusNorm() < 0.003);
  }
}
