// SPDX-License-Identifier: GPL-2.0-or-later
#include <catchMain.h>
#include <exceptionMessage.h>

#include "renderedBox.h"

#include <meshFiles.h>

#include <visp3/core/vpException.h>
#include <visp3/core/vpTrackingException.h>
#include <visp3/multicue/vpMbMultiCueTracker.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace {
// A tracker that follows the box, and what it must go on doing after every refused input.
struct Fixture
{
  Fixture()
  {
    tracker.setCameraParameters(renderedBox::camera());
    tracker.loadModel(renderedBox::writeCao(meshFiles::temporaryFile("bad-input-box.cao")));
    I = box.draw(renderedBox::pose());
    tracker.initFromPose(I, renderedBox::pose());
    tracker.track(I);
  }

  void requireUsable()
  {
    REQUIRE_NOTHROW(tracker.track(I));
    REQUIRE(tracker.getTrackingState() == vpTrackingState::TRACKING);
    const vpHomogeneousMatrix difference = renderedBox::pose().inverse() * tracker.getPose();
    REQUIRE(difference.getTranslationVector().frobeniusNorm() < 0.001);
  }

  renderedBox box;
  vpMbMultiCueTracker tracker{vpMbMultiCueTracker::EDGE_TRACKER};
  vpImage<unsigned char> I;
};

} // namespace

TEST_CASE("A model file that is missing, empty or broken is refused by name, and the old model stays", "[tracker]")
{
  Fixture f;
  CHECK_THAT(messageOf([&] { f.tracker.loadModel("no-such-model.cao"); }), ContainsSubstring("no-such-model.cao"));
  CHECK_THAT(messageOf([&] { f.tracker.loadModel("no-such-model.obj"); }), ContainsSubstring("no-such-model.obj"));
  for (const std::string name : {"empty-model.cao", "empty-model.obj", "empty-model.wrl"}) {
    const std::string path = meshFiles::temporaryFile(name);
    std::ofstream file(path);
    file.close();
    CHECK_THAT(messageOf([&] { f.tracker.loadModel(path); }), ContainsSubstring(name));
  }
  for (const std::string text :
       {"V1\n", "V1\n3\n0 0 0\n1 0", "rubbish", "V1\n0\n0\n0\n0\n0\n0\n", "V1\nload(\"nothing.cao\")\n"}) {
    const std::string path = meshFiles::temporaryFile("broken-model.cao");
    std::ofstream file(path);
    file << text;
    file.close();
    CHECK_THAT(messageOf([&] { f.tracker.loadModel(path); }), ContainsSubstring("broken-model.cao"));
  }
  CHECK_THAT(messageOf([&] { f.tracker.loadModel("model.docx"); }), ContainsSubstring("model.docx"));
  f.requireUsable();
}

TEST_CASE("A model in millimetres read as metres is refused with its size", "[tracker]")
{
  Fixture f;
  const std::string name = renderedBox::writeObj(meshFiles::temporaryFile("millimetres.obj"), 1000.);
  const std::string message = messageOf([&] { f.tracker.loadModel(name); });
  CHECK_THAT(message, ContainsSubstring("millimetres.obj"));
  CHECK_THAT(message, ContainsSubstring("246")); // The diagonal of 200 x 120 x 80.
  CHECK_THAT(messageOf([&] {
               f.tracker.loadModel(renderedBox::writeCao(meshFiles::temporaryFile("millimetres.cao"), 1000.));
             }),
             ContainsSubstring("246"));
  f.requireUsable();

  vpMbMultiCueTracker tracker(vpMbMultiCueTracker::EDGE_TRACKER);
  tracker.setModelUnit(0.001);
  tracker.loadModel(name);
  CHECK(tracker.getModelReport().diameter == Approx(renderedBox::size().norm()));
  CHECK_THROWS_AS(tracker.setModelUnit(0.), vpException);
  CHECK_THROWS_AS(tracker.setModelUnit(std::nan("")), vpException);
}

TEST_CASE("Images without pixels or of another size are refused", "[tracker]")
{
  Fixture f;
  CHECK_THAT(messageOf([&] { f.tracker.track(vpImage<unsigned char>()); }), ContainsSubstring("0 x 0"));
  CHECK_THAT(messageOf([&] { f.tracker.track(vpImage<vpRGBa>()); }), ContainsSubstring("0 x 0"));
  CHECK_THAT(messageOf([&] { f.tracker.initFromPose(vpImage<unsigned char>(), renderedBox::pose()); }),
             ContainsSubstring("0 x 0"));
  const std::string message = messageOf([&] { f.tracker.track(vpImage<unsigned char>(240, 320)); });
  CHECK_THAT(message, ContainsSubstring("320 x 240"));
  CHECK_THAT(message, ContainsSubstring("640 x 480"));
  const vpImage<bool> mask(100, 100, true);
  f.tracker.setMask(mask);
  CHECK_THAT(messageOf([&] { f.tracker.track(f.I); }), ContainsSubstring("100 x 100"));
  const vpImage<bool> everything(480, 640, true);
  f.tracker.setMask(everything);
  f.requireUsable();
}

TEST_CASE("Poses that cannot be are refused, and the last good one stays", "[tracker]")
{
  Fixture f;
  vpHomogeneousMatrix behind = renderedBox::pose();
  behind[2][3] = -0.6;
  CHECK_THAT(messageOf([&] { f.tracker.initFromPose(f.I, behind); }), ContainsSubstring("behind the camera"));
  vpHomogeneousMatrix beside = renderedBox::pose();
  beside[0][3] = 2.;
  CHECK_THAT(messageOf([&] { f.tracker.initFromPose(f.I, beside); }), ContainsSubstring("outside the image"));
  vpHomogeneousMatrix broken = renderedBox::pose();
  broken[0][3] = std::numeric_limits<double>::quiet_NaN();
  CHECK_THAT(messageOf([&] { f.tracker.initFromPose(f.I, broken); }), ContainsSubstring("not finite"));
  broken[0][3] = std::numeric_limits<double>::infinity();
  CHECK_THAT(messageOf([&] { f.tracker.setPose(f.I, broken); }), ContainsSubstring("not finite"));
  broken = renderedBox::pose();
  broken[0][0] = 2.;
  CHECK_THAT(messageOf([&] { f.tracker.setPose(f.I, broken); }), ContainsSubstring("rotation"));
  f.requireUsable();
}

TEST_CASE("A start that is refused leaves the pose before, and what was learnt", "[tracker]")
{
  Fixture f;
  const vpHomogeneousMatrix before = f.tracker.getPose();
  vpHomogeneousMatrix other = renderedBox::pose();
  other[0][3] += 0.05;
  const auto stays = [&] {
    const vpHomogeneousMatrix after = f.tracker.getPose();
    return std::equal(before.data, before.data + 16, after.data);
  };
  CHECK_THROWS_AS(f.tracker.initFromPose(vpImage<unsigned char>(), other), vpException);
  CHECK(stays());
  const vpImage<bool> mask(100, 100, true);
  f.tracker.setMask(mask);
  CHECK_THROWS_AS(f.tracker.initFromPose(f.I, other), vpException);
  CHECK(stays());
  CHECK_THROWS_AS(f.tracker.initFromRoughPose(f.I, other), vpException);
  CHECK(stays());
  const vpImage<bool> everything(480, 640, true);
  f.tracker.setMask(everything);
  f.requireUsable();

  vpMbMultiCueTracker empty;
  other[0][3] = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_AS(empty.initFromPose(f.I, other), vpException); // There is no model.
  CHECK(std::isfinite(empty.getPose()[0][3]));
}

TEST_CASE("A camera that is singular is refused", "[tracker]")
{
  Fixture f;
  CHECK_THROWS_AS(f.tracker.setCameraParameters(vpCameraParameters(0., 600., 320., 240.)), vpException);
  CHECK_THROWS_AS(f.tracker.setCameraParameters(vpCameraParameters(600., -1., 320., 240.)), vpException);
  CHECK_THROWS_AS(f.tracker.setCameraParameters(vpCameraParameters(600., 600., std::nan(""), 240.)), vpException);
  f.requireUsable();
}

TEST_CASE("A configuration file with an unknown node is refused by name, and nothing changes", "[tracker]")
{
  Fixture f;
  const std::string path = meshFiles::temporaryFile("unknown-node.xml");
  std::ofstream file(path);
  file << "<?xml version=\"1.0\"?>\n<conf>\n  <camera><px>1</px><py>1</py></camera>\n  <emc><range/></emc>\n</conf>\n";
  file.close();
  const std::string message = messageOf([&] { f.tracker.loadConfigFile(path, false); });
  CHECK_THAT(message, ContainsSubstring("unknown-node.xml"));
  CHECK_THAT(message, ContainsSubstring("emc"));
  CHECK_THAT(messageOf([&] { f.tracker.loadConfigFile("no-such-file.xml", false); }),
             ContainsSubstring("no-such-file.xml"));
  f.requireUsable();
}

TEST_CASE("Settings out of range are refused and the old ones stay", "[tracker]")
{
  Fixture f;
  CHECK_THROWS_AS(f.tracker.setTrackerType(0), vpException);
  CHECK_THROWS_AS(f.tracker.setTrackerType(4), vpException);
  CHECK_THROWS_AS(f.tracker.setGoodMovingEdgesRatioThreshold(1.5), vpException);
  CHECK_THROWS_AS(f.tracker.getNbPoints(1), vpException);
  vpMe me;
  me.setRange(0);
  CHECK_THROWS_AS(f.tracker.setMovingEdge(me), vpException);
  me.setRange(8);
  me.setSampleStep(0.);
  CHECK_THROWS_AS(f.tracker.setMovingEdge(me), vpException);
  f.requireUsable();
}

TEST_CASE("A tracker that lacks model or pose says so", "[tracker]")
{
  const vpImage<unsigned char> I(480, 640, 0);
  vpMbMultiCueTracker tracker(vpMbMultiCueTracker::EDGE_TRACKER);
  tracker.setCameraParameters(renderedBox::camera());
  CHECK_THAT(messageOf([&] { tracker.track(I); }), ContainsSubstring("loadModel"));
  CHECK_THAT(messageOf([&] { tracker.initFromPose(I, renderedBox::pose()); }), ContainsSubstring("loadModel"));
  CHECK_THAT(messageOf([&] { tracker.getModelForDisplay(640, 480, renderedBox::pose(), renderedBox::camera()); }),
             ContainsSubstring("loadModel"));
  tracker.loadModel(renderedBox::writeCao(meshFiles::temporaryFile("no-pose-box.cao")));
  CHECK_THAT(messageOf([&] { tracker.track(I); }), ContainsSubstring("initFromPose"));
}

TEST_CASE("What an image shows never throws", "[tracker]")
{
  Fixture f;
  for (const int level : {0, 255}) {
    const vpImage<unsigned char> flat(480, 640, static_cast<unsigned char>(level));
    for (int i = 0; i < 12; ++i) {
      REQUIRE_NOTHROW(f.tracker.track(flat));
      CHECK(f.tracker.getTrackingState() == vpTrackingState::LOST);
    }
    CHECK_THROWS_AS(f.tracker.testTracking(), vpTrackingException);
    f.requireUsable();
  }
  vpImage<unsigned char> noise(480, 640);
  unsigned int state = 1;
  for (unsigned int i = 0; i < noise.getSize(); ++i) {
    state = state * 1664525U + 1013904223U;
    noise.bitmap[i] = static_cast<unsigned char>(state >> 24);
  }
  for (int i = 0; i < 20; ++i) {
    REQUIRE_NOTHROW(f.tracker.track(noise));
    for (unsigned int k = 0; k < 16; ++k) {
      REQUIRE(std::isfinite(f.tracker.getPose().data[k]));
    }
  }
  f.tracker.setThrowOnLoss(true);
  CHECK_THROWS_AS(f.tracker.track(vpImage<unsigned char>(480, 640, 0)), vpTrackingException);
}
