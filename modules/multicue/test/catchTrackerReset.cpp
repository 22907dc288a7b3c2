// SPDX-License-Identifier: GPL-2.0-or-later
#include <catchMain.h>

#include "renderedBox.h"

#include <meshFiles.h>

#include <visp3/core/vpException.h>
#include <visp3/mbt/vpMbGenericTracker.h>
#include <visp3/multicue/vpMbMultiCueTracker.h>

#include <limits>

namespace {
using Tracker = vpMbMultiCueTracker;

double error(const vpHomogeneousMatrix &cMo)
{
  return (cMo.getTranslationVector() - renderedBox::pose().getTranslationVector()).frobeniusNorm();
}

std::string model(const std::string &name)
{
  return renderedBox::writeCao(meshFiles::temporaryFile(name));
}
} // namespace

TEST_CASE("resetTracker keeps camera, moving edges and cues, and the tracker starts again", "[tracker]")
{
  renderedBox box;
  const vpImage<unsigned char> I = box.draw(renderedBox::pose());
  const int points = vpPointCue::isAvailable() ? Tracker::KLT_TRACKER : 0;
  for (const int type : {1, 1 | points, 16 | points, 17 | points}) {
    INFO("type " << type);
    Tracker tracker(1, type);
    tracker.setCameraParameters(renderedBox::camera());
    vpMe me;
    me.setRange(9);
    me.setMaskSize(5);
    me.setThreshold(12000.);
    me.setMu1(0.4);
    me.setMu2(0.6);
    me.setSampleStep(5.);
    tracker.setMovingEdge(me, vpEdgeCueSettings::LIKELIHOOD);
    tracker.setKltMaskBorder(8);
    tracker.setAngleAppear(1.2);
    tracker.setUseEdgeTracking("side", false);
    tracker.setProjectionErrorComputation(true);
    tracker.loadModel(model("reset-box.cao"));
    tracker.initFromPose(I, renderedBox::pose());
    tracker.track(I);

    tracker.resetTracker();
    vpCameraParameters cam;
    tracker.getCameraParameters(cam);
    CHECK(cam.get_px() == exactly(600.));
    CHECK(tracker.getTrackerType() == type);
    CHECK(tracker.getMovingEdge().getRange() == 9);
    CHECK(tracker.getMovingEdge().getThreshold() == exactly(12000.));
    CHECK(tracker.getMovingEdge().getSampleStep() == exactly(5.));
    CHECK(tracker.getKltMaskBorder() == 8);
    CHECK(tracker.getAngleAppear() == Approx(vpMath::rad(89.)));
    CHECK(tracker.getNbPolygon() == 0);
    CHECK(tracker.getError().getRows() == 0);
    CHECK_THROWS_AS(tracker.track(I), vpException);

    tracker.loadModel(model("reset-box.cao"));
    tracker.initFromPose(I, renderedBox::pose());
    for (int i = 0; i < 2; ++i) {
      tracker.track(I);
    }
    CHECK(error(tracker.getPose()) < 0.001);
    CHECK(tracker.getProjectionError() < 20.);
  }
}

TEST_CASE("A model that cannot be started leaves the old one", "[tracker]")
{
  renderedBox box;
  const vpImage<unsigned char> I = box.draw(renderedBox::pose());
  Tracker tracker(1, Tracker::EDGE_TRACKER);
  tracker.setCameraParameters(renderedBox::camera());
  tracker.loadModel(model("kept-box.cao"));
  tracker.initFromPose(I, renderedBox::pose());
  tracker.track(I);
  const vpHomogeneousMatrix before = tracker.getPose();
  const std::string larger = renderedBox::writeCao(meshFiles::temporaryFile("larger-box.cao"), 2.);
  vpHomogeneousMatrix behind = renderedBox::pose();
  behind[2][3] = -0.6;
  vpHomogeneousMatrix broken = renderedBox::pose();
  broken[1][3] = std::numeric_limits<double>::quiet_NaN();
  for (const vpHomogeneousMatrix &cMo : {behind, broken}) {
    CHECK_THROWS_AS(tracker.reInitModel(I, larger, cMo), vpException);
    CHECK(tracker.getModelReport().size.x() == Approx(0.2));
    CHECK(tracker.getNbPolygon() == 6);
    CHECK(tracker.getPose()[0][3] == exactly(before[0][3]));
  }
  CHECK_THROWS_AS(tracker.reInitModel(vpImage<unsigned char>(), larger, renderedBox::pose()), vpException);
  CHECK_THROWS_AS(tracker.reInitModel(I, "no-such-model.cao", renderedBox::pose()), vpException);
  const vpImage<bool> mask(10, 10, true);
  tracker.setMask(mask);
  CHECK_THROWS_AS(tracker.reInitModel(I, larger, renderedBox::pose()), vpException);
  const vpImage<bool> all(480, 640, true);
  tracker.setMask(all);
  tracker.track(I);
  CHECK(tracker.getTrackingState() == vpTrackingState::TRACKING);
  CHECK(error(tracker.getPose()) < 0.001);
  tracker.reInitModel(I, larger, renderedBox::pose());
  CHECK(tracker.getModelReport().size.x() == Approx(0.4));
}

TEST_CASE("setPose with a detector's wrong pose does not throw, and the tracker goes on", "[tracker]")
{
  renderedBox box;
  const vpImage<unsigned char> I = box.draw(renderedBox::pose());
  vpHomogeneousMatrix behind = renderedBox::pose();
  behind[2][3] = -0.6;
  vpHomogeneousMatrix beside = renderedBox::pose();
  beside[0][3] = 3.;
  Tracker tracker(1, Tracker::EDGE_TRACKER);
  tracker.setCameraParameters(renderedBox::camera());
  tracker.loadModel(model("detected-box.cao"));
  REQUIRE_NOTHROW(tracker.setPose(I, behind)); // Before the first start, too.
  CHECK(tracker.getTrackingState() == vpTrackingState::LOST);
  tracker.setPose(I, renderedBox::pose());
  tracker.track(I);
  CHECK(tracker.getTrackingState() == vpTrackingState::TRACKING);
  for (const vpHomogeneousMatrix &cMo : {behind, beside}) {
    REQUIRE_NOTHROW(tracker.setPose(I, cMo));
    CHECK(tracker.getTrackingState() == vpTrackingState::LOST);
    const vpMbTrackingResult result = tracker.getTrackingResult();
    CHECK(result.score == exactly(0.));
    CHECK_THAT(result.text, ContainsSubstring(cMo[2][3] < 0. ? "behind the camera" : "outside the image"));
    CHECK(error(tracker.getPose()) < 0.001);
    tracker.track(I);
    CHECK(tracker.getTrackingState() == vpTrackingState::TRACKING);
  }
  CHECK_THROWS_AS(tracker.initFromPose(I, behind), vpException);
  CHECK_THROWS_AS(tracker.initFromPose(box.drawColor(renderedBox::pose()), behind), vpException);
}

TEST_CASE("The projection error is that of vpMbGenericTracker", "[tracker]")
{
  renderedBox box;
  vpMe me;
  me.setRange(8);
  me.setMaskSize(5);
  me.setMaskNumber(180);
  me.setThreshold(10000.);
  me.setMu1(0.5);
  me.setMu2(0.5);
  me.setSampleStep(4.);
  Tracker tracker(1, Tracker::EDGE_TRACKER);
  vpMbGenericTracker visp(1, vpMbGenericTracker::EDGE_TRACKER);
  tracker.setMovingEdge(me, vpEdgeCueSettings::LIKELIHOOD);
  visp.setMovingEdge(me);
  const auto prepare = [](auto &any) {
    any.setCameraParameters(renderedBox::camera());
    any.loadModel(model("projection-error-box.cao"));
    any.setProjectionErrorComputation(true);
  };
  prepare(tracker);
  prepare(visp);
  CHECK(tracker.getProjectionError() == exactly(90.));
  // Noise of some gray levels: without it the measure is next to 0.
  vpImage<unsigned char> I = box.draw(renderedBox::pose());
  unsigned int state = 1;
  for (unsigned int i = 0; i < I.getSize(); ++i) {
    state = state * 1664525U + 1013904223U;
    I.bitmap[i] = static_cast<unsigned char>(I.bitmap[i] + (state >> 24) % 24U - (I.bitmap[i] > 220 ? 24U : 0U));
  }
  tracker.initFromPose(I, renderedBox::pose());
  visp.initFromPose(I, renderedBox::pose());
  for (int i = 0; i < 3; ++i) {
    tracker.track(I);
    visp.track(I);
  }
  INFO("ViSP " << visp.getProjectionError() << ", this one " << tracker.getProjectionError());
  CHECK(std::fabs(tracker.getProjectionError() - visp.getProjectionError()) < 2.);
  tracker.track(vpImage<unsigned char>(480, 640, 0));
  CHECK(tracker.getProjectionError() == exactly(90.));
}
