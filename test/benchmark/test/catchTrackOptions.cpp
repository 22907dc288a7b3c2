// SPDX-License-Identifier: GPL-2.0-or-later
#include <catchMain.h>

#include "track/startFiles.h"
#include "track/tagFinder.h"
#include "track/trackKeys.h"
#include "track/trackOptions.h"

#include <visp3/core/vpException.h>
#include <visp3/core/vpIoTools.h>
#include <visp3/io/vpImageIo.h>

#include <meshFiles.h>

#include <cmath>
#include <fstream>

namespace {
programs::TrackOptions read(std::vector<const char *> arguments)
{
  arguments.insert(arguments.begin(), {"multicue-track", "--model", "box.cao", "--config", "box.xml"});
  programs::TrackOptions options;
  options.read(static_cast<int>(arguments.size()), arguments.data());
  return options;
}
} // namespace

TEST_CASE("Options of a run are read")
{
  const programs::TrackOptions options = read(
      {"--video", "a.mp4", "--init-rough", "a.pos", "--rough-angle", "30", "--unit", "mm", "--cues", "edge,color"});
  CHECK(options.source.video == "a.mp4");
  CHECK(options.start.rough == "a.pos");
  CHECK(options.start.roughAngle == exactly(30.));
  CHECK(options.metresPerUnit == exactly(0.001));
  CHECK(options.cues == std::vector<std::string>({"edge", "color"}));
}

TEST_CASE("Options that are missing, twofold or wrong are named")
{
  CHECK_THROWS_WITH(read({"--init-pose", "a.pos"}), ContainsSubstring("--images, --video and --camera"));
  CHECK_THROWS_WITH(read({"--video", "a.mp4", "--camera", "0", "--init-pose", "a.pos"}),
                    ContainsSubstring("--images, --video and --camera"));
  CHECK_THROWS_WITH(read({"--video", "a.mp4"}), ContainsSubstring("--init-rough, --init-anywhere and --init-tag"));
  CHECK_THROWS_WITH(read({"--video", "a.mp4", "--init-tag", "3"}), ContainsSubstring("--tag-size"));
  CHECK_THROWS_WITH(read({"--video", "a.mp4", "--init-pose", "a.pos", "--unit", "mile"}), ContainsSubstring("mile"));
  CHECK_THROWS_WITH(read({"--video", "a.mp4", "--init-pose", "a.pos", "--first", "9", "--last", "3"}),
                    ContainsSubstring("--last is before --first"));
}

TEST_CASE("Keys change what is tracked and shown, and the last cue stays")
{
  vpMbMultiCueTracker tracker(vpMbMultiCueTracker::EDGE_TRACKER);
  programs::ViewState view;
  programs::applyKey("e", tracker, view);
  CHECK(tracker.getTrackerType() == vpMbMultiCueTracker::EDGE_TRACKER);
  programs::applyKey("c", tracker, view);
  CHECK(tracker.getTrackerType() == (vpMbMultiCueTracker::EDGE_TRACKER | vpMbMultiCueTracker::COLOR_TRACKER));
  CHECK(view.message == "color on");
  programs::applyKey("h", tracker, view);
  CHECK(tracker.getPoseHypothesisSettings().enabled);
  programs::applyKey("1", tracker, view);
  REQUIRE(tracker.getPreset().has_value());
  CHECK(*tracker.getPreset() == vpMultiCuePreset::ROBUST);
  CHECK(view.hypotheses == tracker.getPoseHypothesisSettings().enabled);
  programs::applyKey("n", tracker, view);
  CHECK((view.paused && view.step));
  programs::applyKey(" ", tracker, view);
  CHECK(!view.paused);
  programs::applyKey("?", tracker, view);
  CHECK(!view.quit);
  programs::applyKey("q", tracker, view);
  CHECK(view.quit);
}

TEST_CASE("Files of starts are read, or named with what is wrong")
{
  const meshFiles::TemporaryFolder folder;
  CHECK(programs::readClickPoints(folder.write("a.init", "4 # corners\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n")).size() == 4);
  CHECK_THROWS_WITH(programs::readClickPoints(folder.write("b.init", "5\n0 0 0\n")), ContainsSubstring("b.init"));
  CHECK_THROWS_WITH(programs::readPose(folder.write("c.pos", "1 2 three 4 5 6")), ContainsSubstring("\"three\""));
  CHECK_THROWS_WITH(programs::readPose(folder.write("d.pos", "1 2 3")), ContainsSubstring("d.pos"));
  CHECK(programs::readPose(folder.write("e.pos", "0.1 0.2 0.5 0 0 0"))[2][3] == exactly(0.5));
}

#if defined(VISP_HAVE_APRILTAG) && defined(MULTICUE_HAVE_DETECTION)
TEST_CASE("A tag tells the pose of the object that it is fixed to")
{
  const std::string folder = vpIoTools::createFilePath(vpIoTools::getViSPImagesDataPath(), "AprilTag");
  vpImage<vpRGBa> I;
  vpImageIo::read(I, folder + (vpIoTools::checkFilename(folder + "/AprilTag.png") ? "/AprilTag.png" : "/AprilTag.pgm"));
  const vpCameraParameters cam(600., 600., 320., 240.);
  const double half = 0.02;
  const vpHomogeneousMatrix oMt(0.3, -0.1, 0.2, 0.4, 0.2, -0.3);
  programs::TagFinder finder(8, 2. * half, oMt);
  const std::vector<vpWeightedPose> found = finder.find(I, cam);
  REQUIRE(found.size() == 1);
  // Corners of tag 8 in this image as ViSP's data set has them.
  const double row[] = {51.611, 74.2265, 56.0209, 35.3045};
  const double column[] = {245.347, 283.875, 327.512, 289.137};
  const vpHomogeneousMatrix cMt = found.front().cMo * oMt;
  double mostMissed = 0.;
  for (int i = 0; i < 4; ++i) {
    double missed = 1e9;
    for (const double sx : {-half, half}) {
      for (const double sy : {-half, half}) {
        double p[3];
        for (unsigned int r = 0; r < 3; ++r) {
          p[r] = cMt[r][0] * sx + cMt[r][1] * sy + cMt[r][3];
        }
        missed =
            std::min(missed, std::hypot(320. + 600. * p[0] / p[2] - column[i], 240. + 600. * p[1] / p[2] - row[i]));
      }
    }
    mostMissed = std::max(mostMissed, missed);
  }
  CHECK(mostMissed < 3.);
  CHECK(programs::TagFinder(99, 2. * half, oMt).find(I, cam).empty());
}
#endif
