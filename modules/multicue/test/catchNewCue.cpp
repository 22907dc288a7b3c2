// SPDX-License-Identifier: GPL-2.0-or-later
#include "centroidCue.h"
#include "renderedBox.h"

#include <catchMain.h>
#include <meshFiles.h>

#include <visp3/core/vpException.h>
#include <visp3/core/vpExponentialMap.h>
#include <visp3/multicue/vpMbMultiCueTracker.h>

#include <cmath>
#include <fstream>

// A cue that the library does not know is in its trackers by one line.

namespace {
const int edge = vpMbMultiCueTracker::EDGE_TRACKER;
const int centroid = vpTrackedCentroid::type;

void addCentroid()
{
  if (vpCueKinds::find(centroid) == nullptr) {
    vpCueKinds::add(vpTrackedCentroid::kind());
  }
}

vpHomogeneousMatrix poseAt(int frame)
{
  vpColVector motion(6);
  motion[0] = 0.01 * frame;
  motion[3] = 0.02 * frame;
  return renderedBox::pose() * vpExponentialMap::direct(motion);
}

void prepare(vpMbMultiCueTracker &tracker, int type)
{
  tracker.setTrackerType(type);
  tracker.setCameraParameters(renderedBox::camera());
  tracker.loadModel(renderedBox::writeCao(meshFiles::temporaryFile("box.cao")));
}

const vpMbTrackingResult::Cue &last(const vpMbTrackingResult &result)
{
  return result.cues.back();
}
} // namespace

TEST_CASE("A new cue takes part in the pose, its support, covariance and results", "[tracker]")
{
  addCentroid();
  renderedBox box;
  vpMbMultiCueTracker tracker;
  prepare(tracker, edge | centroid);
  tracker.setCovarianceComputation(true);
  tracker.initFromPose(box.drawColor(poseAt(0)), poseAt(0));
  for (int frame = 1; frame <= 6; ++frame) {
    tracker.track(box.drawColor(poseAt(frame)));
  }
  vpHomogeneousMatrix cMo;
  tracker.getPose(cMo);
  CHECK((cMo.getTranslationVector() - poseAt(6).getTranslationVector()).frobeniusNorm() < 0.002);
  CHECK(tracker.getTrackingState() == vpTrackingState::TRACKING);
  const vpMbTrackingResult result = tracker.getTrackingResult();
  REQUIRE(result.cues.size() == 2);
  CHECK(last(result).type == centroid);
  CHECK(last(result).name == "centroid");
  CHECK(last(result).expected == 2);
  CHECK(last(result).good > 0); // Of two rows the robust estimation may doubt one.
  CHECK(last(result).agreement > 0.5);
  CHECK(last(result).reason.empty());
  CHECK(tracker.getCovarianceMatrix(centroid).getRows() == 6);
  CHECK(tracker.getError().getRows() == tracker.getNbFeaturesEdge() + 2);
}

TEST_CASE("A new cue moves the pose", "[tracker]")
{
  addCentroid();
  renderedBox box;
  const auto poseWith = [&box](int type, double factor) {
    vpMbMultiCueTracker tracker;
    prepare(tracker, type);
    tracker.setFeatureFactors({{vpMbMultiCueTracker::EDGE_TRACKER, factor}});
    tracker.initFromPose(box.drawColor(poseAt(0)), poseAt(0));
    tracker.track(box.drawColor(poseAt(1)));
    vpHomogeneousMatrix cMo;
    tracker.getPose(cMo);
    return cMo;
  };
  const vpHomogeneousMatrix little = poseWith(edge | centroid, 1e3); // The edges count so much.
  const vpHomogeneousMatrix much = poseWith(edge | centroid, 1e-3);
  CHECK((little.getTranslationVector() - much.getTranslationVector()).frobeniusNorm() > 1e-6);
}

TEST_CASE("A new cue without data says so and leaves the pose to the others", "[tracker]")
{
  addCentroid();
  renderedBox box;
  vpMbMultiCueTracker tracker;
  prepare(tracker, edge | centroid);
  tracker.initFromPose(box.draw(poseAt(0)), poseAt(0)); // Gray images have no reddish pixels.
  for (int frame = 1; frame <= 3; ++frame) {
    tracker.track(box.draw(poseAt(frame)));
  }
  CHECK(tracker.getTrackingState() == vpTrackingState::TRACKING);
  CHECK(tracker.getCueReason(centroid) == "no reddish pixel is in the image");
  CHECK(last(tracker.getTrackingResult()).good == 0);
}

TEST_CASE("A new cue alone gives too few equations, which is no error", "[tracker]")
{
  addCentroid();
  renderedBox box;
  vpMbMultiCueTracker tracker;
  prepare(tracker, centroid);
  tracker.initFromPose(box.drawColor(poseAt(0)), poseAt(0));
  tracker.track(box.drawColor(poseAt(1)));
  CHECK(tracker.getTrackingState() == vpTrackingState::LOST);
}

TEST_CASE("Configurations know a new cue by its name", "[tracker]")
{
  addCentroid();
  const std::string path = meshFiles::temporaryFile("new-cue.json");
  std::ofstream(path) << R"({"cues": ["edge", "centroid"]})";
  vpMbMultiCueTracker tracker;
  tracker.loadConfigFile(path, false);
  CHECK(tracker.getTrackerType() == (edge | centroid));
  CHECK_THROWS_AS(tracker.setTrackerType(1 << 6), vpException);
}
