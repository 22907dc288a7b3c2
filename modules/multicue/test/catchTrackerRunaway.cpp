// SPDX-License-Identifier: GPL-2.0-or-later
#include "motion/vpPoseCheck.cpp" // The library keeps it to itself.

#include <catchMain.h>

#include "renderedBox.h"

#include <meshFiles.h>
#include <modelShapes.h>

#include <visp3/multicue/vpMbMultiCueTracker.h>

#include <limits>

/*! \file catchTrackerRunaway.cpp A minimisation that diverges leads the tracker nowhere. */

namespace {
// Its equations lead some metres farther in every iteration, where they are told to.
class RunawayTracker : public vpMbMultiCueTracker
{
public:
  using vpMbMultiCueTracker::vpMbMultiCueTracker;
  void computeVVSInteractionMatrixAndResidu() override
  {
    vpMbMultiCueTracker::computeVVSInteractionMatrixAndResidu();
    if (step != exactly(0.)) {
      vpColVector motion(6, 0.);
      motion[2] = step;
      m_error = m_L * motion;
    }
  }
  double step = 0.;
};
} // namespace

TEST_CASE("A camera can have seen an object of two pixels, and none behind it", "[tracker]")
{
  const vpTrackedModel model = modelShapes::build(modelShapes::boxPolygons({0.1, 0.1, 0.1}));
  const vpCameraParameters cam(600., 600., 320., 240.);
  const auto why = [&](double z) {
    return vpPoseCheck::whyUnbelievable(model, vpHomogeneousMatrix(0., 0., z, 0.1, 0.2, 0.3), cam);
  };
  CHECK(why(0.5).empty());
  CHECK(why(40.).empty());
  CHECK_THAT(why(42000.), ContainsSubstring("42000 m away") && ContainsSubstring("pixels wide"));
  CHECK_THAT(why(-3.), ContainsSubstring("behind the camera"));
  CHECK_THAT(why(std::numeric_limits<double>::quiet_NaN()), ContainsSubstring("not finite"));
}

TEST_CASE("A pose that runs away is LOST, and the last one is kept", "[tracker]")
{
  const double step = GENERATE(-1e4, 1e4);
  const bool hasHypotheses = GENERATE(false, true);
  CAPTURE(step, hasHypotheses);
  renderedBox box;
  RunawayTracker tracker(vpMbMultiCueTracker::EDGE_TRACKER);
  vpPoseHypothesisSettings hypotheses;
  hypotheses.enabled = hasHypotheses;
  tracker.setPoseHypothesisSettings(hypotheses);
  tracker.setCameraParameters(renderedBox::camera());
  tracker.loadModel(renderedBox::writeCao(meshFiles::temporaryFile("runaway-box.cao")));
  const vpImage<unsigned char> I = box.draw(renderedBox::pose());
  tracker.initFromPose(I, renderedBox::pose());
  tracker.track(I);
  REQUIRE(tracker.getTrackingState() == vpTrackingState::TRACKING);
  const vpHomogeneousMatrix before = tracker.getPose();

  tracker.step = step;
  tracker.track(I);
  CHECK(tracker.getTrackingState() == vpTrackingState::LOST);
  CHECK(tracker.getTrackingResult().score == exactly(0.));
  CHECK((before.getTranslationVector() - tracker.getPose().getTranslationVector()).frobeniusNorm() < 0.01);

  tracker.step = 0.;
  tracker.track(I);
  CHECK(tracker.getTrackingState() == vpTrackingState::TRACKING);
}
