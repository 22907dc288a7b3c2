// SPDX-License-Identifier: GPL-2.0-or-later
#include <catchMain.h>

#include "marbleBox.h"

#include <visp3/core/vpException.h>
#include <visp3/mbt/vpMbGenericTracker.h>

#include <set>

namespace {
const int edge = vpMbMultiCueTracker::EDGE_TRACKER;
const int klt = vpMbMultiCueTracker::KLT_TRACKER;
const int color = vpMbMultiCueTracker::COLOR_TRACKER;

template <typename Tracker> void prepare(Tracker &tracker)
{
  tracker.setCameraParameters(pointScenes::makeCamera());
  tracker.loadModel(marbleBox::writeCao("points-box.cao"));
}
} // namespace

TEST_CASE("A program of vpMbKltTracker tracks with points and its settings", "[tracker]")
{
  if (!vpPointCue::isAvailable()) {
    return;
  }
  marbleBox box;
  vpMbMultiCueTracker tracker(vpMbMultiCueTracker::KLT_TRACKER);
  vpKltOpencv settings;
  settings.setMaxFeatures(60);
  settings.setWindowSize(7);
  settings.setQuality(0.02);
  settings.setMinDistance(6);
  settings.setHarrisFreeParameter(0.01);
  settings.setBlockSize(3);
  settings.setPyramidLevels(2);
  tracker.setKltOpencv(settings);
  tracker.setMaskBorder(4);
  tracker.setThresholdAcceptation(0.2);
  prepare(tracker);
  CHECK(tracker.getTrackerType() == klt);
  CHECK(tracker.getKltMaskBorder() == 4);
  CHECK(tracker.getMaskBorder() == 4);
  CHECK(tracker.getKltThresholdAcceptation() == exactly(0.2));
  CHECK(tracker.getThresholdAcceptation() == exactly(0.2));
  CHECK(tracker.getKltOpencv().getMaxFeatures() == 60);
  box.follow(tracker, 5);
  CHECK(tracker.getTrackingState() == vpTrackingState::TRACKING);
  CHECK(marbleBox::error(tracker.getPose(), 5) < 0.002);
  CHECK(tracker.getNbFeaturesEdge() == 0);
  CHECK(tracker.getKltNbPoints() > 30);
  CHECK(tracker.getKltNbPoints() <= 60);
  CHECK(tracker.getNbPoints() == 0); // They are points of edges.

  CHECK_THROWS_AS(tracker.setKltMaskBorder(101), vpException);
  CHECK_THROWS_AS(tracker.setKltThresholdAcceptation(1.), vpException);
  CHECK(tracker.getKltMaskBorder() == 4);
  CHECK(tracker.getKltThresholdAcceptation() == exactly(0.2));
}

TEST_CASE("Points are told as vpMbGenericTracker tells them", "[tracker]")
{
  if (!vpPointCue::isAvailable()) {
    return;
  }
  marbleBox box;
  vpMbMultiCueTracker tracker(1, edge | klt);
  prepare(tracker);
  box.follow(tracker, 3);
  const std::map<int, vpImagePoint> before = tracker.getKltImagePointsWithId();
  tracker.track(box.draw(4));
  const std::map<int, vpImagePoint> points = tracker.getKltImagePointsWithId();
  REQUIRE(points.size() > 20);
  CHECK(tracker.getKltImagePoints().size() == points.size());
  CHECK(tracker.getKltPoints().size() == points.size());
  CHECK(tracker.getNbKltPoints() == static_cast<int>(points.size()));
  CHECK(static_cast<double>(tracker.getKltPoints()[0].x) == Approx(points.begin()->second.get_u()));
  // A number goes on with its point, which moves by a few pixels.
  unsigned int kept = 0;
  for (const auto &[id, point] : points) {
    const auto old = before.find(id);
    if (old != before.end()) {
      CHECK(vpImagePoint::distance(old->second, point) < 8.);
      ++kept;
    }
  }
  CHECK(10 * kept > 7 * points.size());

  CHECK(tracker.getNbFeaturesKlt() % 2 == 0);
  CHECK(tracker.getNbFeaturesKlt() <= 2 * points.size());
  CHECK(tracker.getNbFeaturesKlt() > points.size());
  CHECK(tracker.getNbPoints() <= tracker.getNbFeaturesEdge());
  CHECK(2 * tracker.getNbPoints() > tracker.getNbFeaturesEdge());
  std::set<int> shown;
  for (const std::vector<double> &feature : tracker.getFeaturesForDisplay()) {
    if (feature[0] == exactly(0.)) {
      CHECK(feature.size() == 4);
      continue;
    }
    REQUIRE(feature.size() == 6);
    CHECK(feature[0] == exactly(1.));
    CHECK(feature[3] == Approx(feature[1] + 7.));
    const int id = static_cast<int>(feature[5]);
    REQUIRE(points.count(id) == 1);
    CHECK(feature[1] == Approx(points.at(id).get_i()));
    CHECK(feature[2] == Approx(points.at(id).get_j()));
    shown.insert(id);
  }
  CHECK(shown.size() == points.size());
}

TEST_CASE("Errors and weights are those of features alone", "[tracker]")
{
  const int type = vpPointCue::isAvailable() ? edge | klt | color : edge | color;
  marbleBox box;
  vpMbMultiCueTracker tracker(1, type);
  prepare(tracker);
  CHECK(tracker.getError().getRows() == 0);
  box.follow(tracker, 3);
  const unsigned int rows = tracker.getNbFeaturesEdge() + tracker.getNbFeaturesKlt() + tracker.getNbFeaturesColor();
  CHECK(rows > 100);
  CHECK(tracker.getError().getRows() == rows);
  const vpColVector weights = tracker.getRobustWeights();
  REQUIRE(weights.getRows() == rows);
  CHECK(weights.getMinValue() >= 0.);
  CHECK(weights.getMaxValue() <= 1.);
  // The edges come first, in metres at 1 m: a pixel is a 400th.
  for (unsigned int i = 0; i < tracker.getNbFeaturesEdge(); ++i) {
    CHECK(std::fabs(tracker.getError()[i]) < 30. / 400.);
  }
}

TEST_CASE("A wide border leaves small faces some points", "[tracker]")
{
  if (!vpPointCue::isAvailable()) {
    return;
  }
  marbleBox box;
  for (const unsigned int border : {5U, 10U, 25U, 60U}) {
    vpMbMultiCueTracker tracker(1, klt);
    tracker.setKltMaskBorder(border);
    prepare(tracker);
    box.follow(tracker, 3);
    INFO("border " << border);
    CHECK(tracker.getTrackingState() == vpTrackingState::TRACKING);
    CHECK(marbleBox::error(tracker.getPose(), 3) < 0.003);
    CHECK(tracker.getKltNbPoints() > 15);
  }
}

TEST_CASE("Feature factors weigh the cues", "[tracker]")
{
  if (!vpPointCue::isAvailable()) {
    return;
  }
  marbleBox box;
  // The points are told a wrong camera motion by an image whose edges are those of another pose: what the cues say
  // differs, and the factors decide.
  const auto poseWith = [&box](double ofEdges, double ofPoints) {
    vpMbMultiCueTracker tracker(1, edge | klt);
    prepare(tracker);
    tracker.setFeatureFactors(
        {{vpMbMultiCueTracker::EDGE_TRACKER, ofEdges}, {vpMbMultiCueTracker::KLT_TRACKER, ofPoints}});
    box.follow(tracker, 3);
    return tracker.getPose();
  };
  const vpHomogeneousMatrix same = poseWith(1., 1.);
  const vpHomogeneousMatrix byEdges = poseWith(1., 1e-3);
  const vpHomogeneousMatrix byPoints = poseWith(1e-3, 1.);
  for (const vpHomogeneousMatrix &cMo : {same, byEdges, byPoints}) {
    CHECK(marbleBox::error(cMo, 3) < 0.003);
  }
  CHECK((byEdges.inverse() * byPoints).getTranslationVector().frobeniusNorm() > 1e-6);
  vpMbMultiCueTracker tracker;
  CHECK_THROWS_AS(tracker.setFeatureFactors({{vpMbMultiCueTracker::EDGE_TRACKER, 0.}}), vpException);
  CHECK_THROWS_AS(
      tracker.setFeatureFactors({{vpMbMultiCueTracker::EDGE_TRACKER | vpMbMultiCueTracker::KLT_TRACKER, 1.}}),
      vpException);
}
