// SPDX-License-Identifier: GPL-2.0-or-later
#include <catchMain.h>

#include "marbleBox.h"
#include "renderedBox.h"

#include <visp3/core/vpException.h>
#include <visp3/mbt/vpMbGenericTracker.h>
#include <visp3/mbt/vpMbtDistanceLine.h>

#include <algorithm>

namespace {
const int edge = vpMbMultiCueTracker::EDGE_TRACKER;
const int klt = vpMbMultiCueTracker::KLT_TRACKER;

template <typename Tracker> void prepare(Tracker &tracker)
{
  tracker.setCameraParameters(pointScenes::makeCamera());
  tracker.loadModel(marbleBox::writeCao("faces-box.cao"));
}

std::vector<bool> visible(vpMbTracker &tracker)
{
  std::vector<bool> result;
  for (unsigned int i = 0; i < tracker.getNbPolygon(); ++i) {
    result.push_back(tracker.getPolygon(i)->isVisible());
  }
  return result;
}
} // namespace

TEST_CASE("ViSP's faces are visible as vpMbGenericTracker has them", "[tracker]")
{
  marbleBox box;
  vpMbMultiCueTracker tracker(1, edge);
  vpMbGenericTracker visp(1, edge);
  prepare(tracker);
  prepare(visp);
  CHECK(tracker.getPolygonFaces().first.empty());
  const vpImage<unsigned char> I = box.draw(0);
  tracker.initFromPose(I, marbleBox::poseAt(0));
  visp.initFromPose(I, marbleBox::poseAt(0));
  CHECK(tracker.getFaces().getNbVisiblePolygon() == 3);
  CHECK(visible(tracker) == visible(visp));
  const auto mine = tracker.getPolygonFaces();
  const auto theirs = visp.getPolygonFaces();
  REQUIRE(mine.first.size() == 3);
  REQUIRE(theirs.first.size() == 3);
  for (std::size_t i = 0; i < 3; ++i) {
    CHECK(mine.first[i].getArea() == Approx(theirs.first[i].getArea()));
    CHECK(mine.second[i].size() == 4);
  }
  CHECK(tracker.getPolygonFaces(true, false).first.size() == 6);
  CHECK(tracker.getPolygonFaces(true, true, true).first.size() == 3);

  // A reference that is kept goes with the object.
  vpMbHiddenFaces<vpMbtPolygon> &faces = tracker.getFaces();
  const vpHomogeneousMatrix frontal(0., 0., 0.5, 0., 0., 0.);
  pointScenes::Painter painter(pointScenes::makeBox());
  tracker.setPose(painter.draw(frontal), frontal);
  visp.setPose(painter.draw(frontal), frontal);
  CHECK(faces.getNbVisiblePolygon() == 1);
  CHECK(visible(tracker) == visible(visp));
  tracker.track(painter.draw(frontal));
  CHECK(faces.getNbVisiblePolygon() == 1);
}

TEST_CASE("ViSP's primitives are told, and which of them are seen", "[tracker]")
{
  marbleBox box;
  vpMbMultiCueTracker tracker(1, edge);
  prepare(tracker);
  box.follow(tracker, 1);
  std::list<vpMbtDistanceLine *> lines;
  const vpMbMultiCueTracker &constant = tracker;
  constant.getLline(lines);
  REQUIRE(lines.size() == 12);
  CHECK(std::count_if(lines.begin(), lines.end(), [](const vpMbtDistanceLine *line) { return line->isVisible(); }) ==
        9);
  std::list<vpMbtDistanceCylinder *> cylinders;
  tracker.getLcylinder("Camera", cylinders);
  CHECK(cylinders.empty());
  CHECK(tracker.getFeaturesCircle().empty());
  CHECK_THROWS_AS(tracker.getLline(lines, 1), vpException);
  CHECK_THROWS_AS(tracker.getLline("Camera2", lines), vpException);
  CHECK_THROWS_AS(tracker.getFeaturesKlt(), vpException);
  CHECK_THROWS_AS(tracker.getFeaturesKltCylinder(), vpException);

  vpMbMultiCueTracker mesh;
  mesh.loadModel(renderedBox::writeObj(meshFiles::temporaryFile("faces-box.obj")));
  CHECK_THROWS_AS(mesh.getLline(lines), vpException);
}

TEST_CASE("A circle is added to the model", "[tracker]")
{
  vpMbMultiCueTracker tracker;
  CHECK_THROWS_AS(tracker.addCircle(vpPoint(0, 0, -0.05), vpPoint(0, 0.01, -0.05), vpPoint(0.01, 0, -0.05), 0.02),
                  vpException);
  prepare(tracker);
  tracker.addCircle(vpPoint(0, 0, -0.05), vpPoint(0, 0.01, -0.05), vpPoint(0.01, 0, -0.05), 0.02, "print");
  CHECK(tracker.getModelReport().circles == 1);
  CHECK(tracker.getModelReport().edges == 12);
}

TEST_CASE("Edges of faces that are not used take no part", "[tracker]")
{
  marbleBox box;
  const auto shown = [&box](const std::vector<std::string> &unused) {
    vpMbMultiCueTracker tracker(1, edge);
    prepare(tracker);
    for (const std::string &name : unused) {
      tracker.setUseEdgeTracking(name, false);
    }
    tracker.initFromPose(box.draw(0), marbleBox::poseAt(0));
    tracker.track(box.draw(0));
    return std::make_pair(tracker.getFeaturesForDisplay().size(),
                          tracker
                              .getModelForDisplay(pointScenes::width, pointScenes::height, marbleBox::poseAt(0),
                                                  pointScenes::makeCamera())
                              .size());
  };
  const auto all = shown({});
  const auto some = shown({"side0", "side1"});
  const auto fewer = shown({"side0", "side1", "side2", "side3"});
  CHECK(some.first < all.first);
  CHECK(fewer.first < some.first);
  CHECK(fewer.first > 0);
  CHECK(shown({"side0", "side1", "side2", "side3", "side4", "side5"}).first == 0);
  CHECK(shown({"no such side"}).first == all.first);
  CHECK(some.second == all.second); // They are displayed, as in ViSP.

  vpMbMultiCueTracker tracker(1, edge);
  prepare(tracker);
  tracker.setUseEdgeTracking("side0", false);
  tracker.setUseEdgeTracking("side0", true);
  tracker.initFromPose(box.draw(0), marbleBox::poseAt(0));
  tracker.track(box.draw(0));
  CHECK(tracker.getFeaturesForDisplay().size() == all.first);
}

TEST_CASE("No points lie on faces that are not used for points", "[tracker]")
{
  if (!vpPointCue::isAvailable()) {
    return;
  }
  marbleBox box;
  vpMbMultiCueTracker tracker(vpMbMultiCueTracker::EDGE_TRACKER | vpMbMultiCueTracker::KLT_TRACKER);
  prepare(tracker);
  box.follow(tracker, 4);
  const auto count = [&tracker](int frame) {
    std::map<std::string, int> perFace;
    for (unsigned int i = 0; i < tracker.getNbPolygon(); ++i) {
      vpMbtPolygon &face = *tracker.getPolygon(i);
      if (!face.isVisible()) {
        continue;
      }
      const std::vector<vpImagePoint> roi = face.getRoi(pointScenes::makeCamera(), marbleBox::poseAt(frame));
      for (const vpImagePoint &point : tracker.getKltImagePoints()) {
        perFace[face.getName()] += vpPolygon(roi).isInside(point) ? 1 : 0;
      }
    }
    return perFace;
  };
  const std::map<std::string, int> before = count(4);
  REQUIRE(before.size() == 3);
  const std::string name = before.begin()->first;
  CHECK(before.begin()->second > 5);
  tracker.setUseKltTracking(name, false);
  for (int frame = 5; frame < 10; ++frame) {
    tracker.track(box.draw(frame));
  }
  std::map<std::string, int> after = count(9);
  CHECK(after[name] <= 1); // One on the border may be taken for another face's.
  CHECK(tracker.getKltNbPoints() > 10);
  // As it does where the cues are chosen anew.
  tracker.setTrackerType(klt);
  tracker.setTrackerType(edge);
  tracker.setTrackerType(edge | klt);
  for (int frame = 10; frame < 14; ++frame) {
    tracker.track(box.draw(frame));
  }
  after = count(13);
  CHECK(after[name] <= 1);
  CHECK(tracker.getKltNbPoints() > 10);
}
