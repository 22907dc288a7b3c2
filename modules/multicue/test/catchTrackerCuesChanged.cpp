// SPDX-License-Identifier: GPL-2.0-or-later
#include <catchMain.h>

#include "plainScene.h"

#include <visp3/core/vpException.h>

#include <fstream>

// What is asked between a change of the cues and the next frame is asked of the last frame's features.
TEST_CASE("After a change of the cues, nothing is told of cues that ended", "[tracker]")
{
  const meshFiles::Triangles box = modelShapes::boxTriangles(modelShapes::Point(0.12, 0.07, 0.05));
  const std::string file = meshFiles::temporaryFile("changed-cues.stl");
  std::ofstream(file) << meshFiles::asciiStl(box);
  plainScene scene(box);
  vpMbMultiCueTracker tracker;
  tracker.setFrameDeadline(0.);
  tracker.setCameraParameters(plainScene::camera());
  tracker.loadModel(file);
  tracker.setCovarianceComputation(true);
  tracker.initFromPose(scene.draw(plainScene::poseAt(0)), plainScene::poseAt(0));
  const auto follow = [&](int first) {
    for (int i = first; i < first + 3; ++i) {
      tracker.track(scene.draw(plainScene::poseAt(i)));
      CHECK(tracker.getTrackingState() == vpTrackingState::TRACKING);
    }
  };
  follow(1);
  tracker.setTrackerType(vpMbMultiCueTracker::EDGE_TRACKER);
  CHECK(tracker.getFeaturesForDisplay().empty());
  CHECK(tracker.getError().size() == 0);
  CHECK(tracker.getNbFeaturesKlt() == 0);
  CHECK_THROWS_AS(tracker.getCovarianceMatrix(vpMbMultiCueTracker::EDGE_TRACKER), vpException);
  follow(4);
  CHECK(!tracker.getFeaturesForDisplay().empty());
  tracker.setPreset(vpMultiCuePreset::PETIT2014); // Cues come in: those of the last frame are still there.
  CHECK(!tracker.getFeaturesForDisplay().empty());
  tracker.setFrameDeadline(0.);
  follow(7);
}
