// SPDX-License-Identifier: GPL-2.0-or-later
#include <catchMain.h>

#include "renderedBox.h"

#include <meshFiles.h>

#include <visp3/core/vpExponentialMap.h>
#include <visp3/core/vpMeterPixelConversion.h>
#include <visp3/multicue/vpMbMultiCueTracker.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace {
const int edge = vpMbMultiCueTracker::EDGE_TRACKER;
const int klt = vpMbMultiCueTracker::KLT_TRACKER;
const int color = vpMbMultiCueTracker::COLOR_TRACKER;

// Some 12 pixels from frame to frame.
vpHomogeneousMatrix poseAt(int frame)
{
  const double t = 0.4 * frame;
  vpColVector motion(6);
  motion[0] = 0.03 * std::sin(t);
  motion[1] = 0.02 * std::sin(1.3 * t);
  motion[3] = 0.2 * std::sin(0.9 * t);
  motion[5] = 0.2 * std::sin(0.8 * t);
  return renderedBox::pose() * vpExponentialMap::direct(motion);
}

void prepare(vpMbMultiCueTracker &tracker, int type)
{
  tracker.setTrackerType(type);
  tracker.setCameraParameters(renderedBox::camera());
  tracker.loadModel(renderedBox::writeCao(meshFiles::temporaryFile("box.cao")));
}

double error(const vpHomogeneousMatrix &cMo, const vpHomogeneousMatrix &truth)
{
  return (cMo.getTranslationVector() - truth.getTranslationVector()).frobeniusNorm();
}

// Counts the control points that the first search of a frame found.
class FirstSearch : public vpMbMultiCueTracker
{
public:
  unsigned int found(const vpImage<vpRGBa> &I)
  {
    m_found = 0;
    track(I);
    return m_found;
  }

protected:
  void computeVVSInit() override
  {
    vpMbMultiCueTracker::computeVVSInit();
    m_found = m_found == 0 ? getNbFeaturesEdge() : m_found;
  }

private:
  unsigned int m_found = 0;
};

// How many are found of an object that was at rest and is 10 pixels farther. \param wander Of the velocity.
unsigned int foundOfShifted(double range, bool isPredicted, double wander = 1.)
{
  renderedBox box;
  FirstSearch tracker;
  prepare(tracker, edge | klt); // There is no texture: nothing but the edges brings the pose nearer.
  vpPoseKalmanSettings motion;
  motion.translationWander = motion.startTranslation = wander;
  motion.rotationWander = motion.startRotation = wander;
  tracker.setPrediction(true, motion);
  tracker.setPredictedRange(isPredicted);
  vpEdgeCueSettings settings = tracker.getEdgeSettings();
  settings.range = range;
  tracker.setEdgeSettings(settings);
  tracker.initFromPose(box.drawColor(renderedBox::pose()), renderedBox::pose());
  for (int i = 0; i < 4; ++i) {
    tracker.track(box.drawColor(renderedBox::pose()));
  }
  const vpHomogeneousMatrix shifted = vpHomogeneousMatrix(0.01, 0., 0., 0., 0., 0.) * renderedBox::pose();
  const unsigned int found = tracker.found(box.drawColor(shifted));
  CHECK(tracker.getTrackingState() == vpTrackingState::TRACKING);
  CHECK(tracker.getEdgeSettings().range == exactly(range));
  return found;
}

bool isFinite(const vpHomogeneousMatrix &cMo)
{
  return std::all_of(cMo.data, cMo.data + 16, [](double value) { return std::isfinite(value); });
}
} // namespace

TEST_CASE("Cues alone and together follow the object", "[tracker]")
{
  renderedBox box;
  for (const int type : {color, edge | color, edge | klt, edge | klt | color}) {
    for (const bool predicts : {false, true}) {
      vpMbMultiCueTracker tracker;
      prepare(tracker, type);
      tracker.setPrediction(predicts);
      tracker.initFromPose(box.drawColor(poseAt(0)), poseAt(0));
      double worst = 0.;
      for (int i = 1; i < 10; ++i) {
        tracker.track(box.drawColor(poseAt(i)));
        worst = std::max(worst, error(tracker.getPose(), poseAt(i)));
        CHECK(tracker.getTrackingState() == vpTrackingState::TRACKING);
        CHECK((tracker.getNbFeaturesEdge() > 0) == ((type & edge) != 0));
        CHECK((tracker.getNbFeaturesColor() > 0) == ((type & color) != 0));
      }
      INFO("type " << type << (predicts ? ", predicting" : ""));
      CHECK(worst < 0.004);
    }
  }
}

TEST_CASE("A gray image does for all cues, and the type may change between frames", "[tracker]")
{
  renderedBox box;
  vpMbMultiCueTracker tracker;
  prepare(tracker, color);
  tracker.initFromPose(box.draw(poseAt(0)), poseAt(0));
  const int types[] = {color, edge | color, edge, edge | klt | color, color};
  for (int i = 1; i <= 5; ++i) {
    tracker.setTrackerType(types[i - 1]);
    tracker.track(box.draw(poseAt(i)));
    CHECK(tracker.getTrackingState() == vpTrackingState::TRACKING);
    CHECK(error(tracker.getPose(), poseAt(i)) < 0.004);
  }
}

TEST_CASE("Images that show nothing leave a finite pose, and tracking goes on afterwards", "[tracker]")
{
  renderedBox box;
  vpMbMultiCueTracker tracker;
  prepare(tracker, edge | klt | color);
  tracker.setPrediction(true);
  tracker.initFromPose(box.drawColor(poseAt(0)), poseAt(0));
  tracker.track(box.drawColor(poseAt(0)));
  for (const int level : {0, 255, 90}) {
    const auto gray = static_cast<unsigned char>(level);
    const vpImage<vpRGBa> plain(renderedBox::height, renderedBox::width, vpRGBa(gray, gray, gray));
    for (int i = 0; i < 3; ++i) {
      CHECK_NOTHROW(tracker.track(plain));
      CHECK(isFinite(tracker.getPose()));
      CHECK(tracker.getTrackingState() != vpTrackingState::TRACKING);
    }
  }
  tracker.track(box.drawColor(poseAt(0)));
  CHECK(tracker.getTrackingState() == vpTrackingState::TRACKING);
  CHECK(error(tracker.getPose(), poseAt(0)) < 0.004);
}

TEST_CASE("The search range of the prediction leaves the user's range as it is", "[tracker]")
{
  renderedBox box;
  vpMbMultiCueTracker tracker;
  prepare(tracker, edge | color);
  tracker.setPrediction(true);
  tracker.setPredictedRange(true);
  const double range = tracker.getEdgeSettings().range;
  tracker.initFromPose(box.drawColor(poseAt(0)), poseAt(0));
  for (int i = 1; i < 6; ++i) {
    tracker.track(box.drawColor(poseAt(i)));
    CHECK(tracker.getTrackingState() == vpTrackingState::TRACKING);
    CHECK(error(tracker.getPose(), poseAt(i)) < 0.004);
    CHECK(tracker.getEdgeSettings().range == exactly(range));
  }
}

TEST_CASE("The search range of the prediction follows what is known of the motion, within its limits", "[tracker]")
{
  const double usual = vpEdgeCueSettings().range;
  const double quiet = 0.001;
  const double lively = 1.;
  // The longer the range, the more is found of this motion.
  const unsigned int byShortest = foundOfShifted(6., false);
  const unsigned int byUsual = foundOfShifted(usual, false);
  const unsigned int byTwice = foundOfShifted(2. * usual, false);
  REQUIRE(byShortest < byUsual);
  REQUIRE(byUsual < byTwice);
  CHECK(foundOfShifted(usual, true, quiet) == byShortest);
  CHECK(foundOfShifted(2. * usual, true, quiet) == byShortest);
  const unsigned int between = foundOfShifted(2. * usual, true, 0.3);
  CHECK(between > byShortest);
  CHECK(between < byTwice);
  CHECK(foundOfShifted(usual, true, lively) == byTwice); // As the user set none.
  const double set = usual - 1.;
  CHECK(foundOfShifted(set, true, lively) == foundOfShifted(set, false));
}

TEST_CASE("Wrong types and times are named and change nothing", "[tracker]")
{
  vpMbMultiCueTracker tracker(vpMbMultiCueTracker::EDGE_TRACKER);
  for (const int type : {0, -1, 4, 8, 32}) {
    CHECK_THROWS_AS(tracker.setTrackerType(type), vpException);
  }
  CHECK(tracker.getTrackerType() == edge);
  for (const double seconds : {0., -1., std::nan(""), std::numeric_limits<double>::infinity()}) {
    CHECK_THROWS_AS(tracker.setFrameInterval(seconds), vpException);
  }
  vpColorCueSettings settings = tracker.getColorSettings();
  settings.alpha = -1.;
  CHECK_THROWS_AS(tracker.setColorSettings(settings), vpException);
  CHECK(tracker.getColorSettings().alpha > 0.);
}

TEST_CASE("A start from points or a file on a colour image learns its colours, as a start from a pose does",
          "[tracker]")
{
  renderedBox box;
  const vpImage<vpRGBa> first = box.drawColor(poseAt(0));
  const vpImage<vpRGBa> second = box.drawColor(poseAt(1));
  std::vector<vpPoint> points;
  std::vector<vpImagePoint> pixels;
  for (int i = 0; i < 8; ++i) {
    const Eigen::Vector3d half = 0.5 * renderedBox::size();
    vpPoint point((i & 1) ? half.x() : -half.x(), (i & 2) ? half.y() : -half.y(), (i & 4) ? half.z() : -half.z());
    point.track(poseAt(0));
    double u = 0., v = 0.;
    vpMeterPixelConversion::convertPoint(renderedBox::camera(), point.get_x(), point.get_y(), u, v);
    points.push_back(point);
    pixels.emplace_back(v, u);
  }
  vpMbMultiCueTracker tracker, other;
  prepare(tracker, edge | color);
  prepare(other, edge | color);
  const auto checkStart = [&] {
    other.initFromPose(first, vpHomogeneousMatrix(tracker.getPose()));
    tracker.track(second);
    other.track(second);
    CHECK(error(tracker.getPose(), poseAt(1)) < 0.004);
    const vpHomogeneousMatrix a = tracker.getPose();
    const vpHomogeneousMatrix b = other.getPose();
    CHECK(std::equal(a.data, a.data + 16, b.data));
  };
  tracker.initFromPoints(first, pixels, points);
  CHECK(error(tracker.getPose(), poseAt(0)) < 1e-4);
  checkStart();
  tracker.initFromPose(first, vpPoseVector(poseAt(0)));
  checkStart();
}
