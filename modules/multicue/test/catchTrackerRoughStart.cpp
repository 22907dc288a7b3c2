// SPDX-License-Identifier: GPL-2.0-or-later
#include <catchMain.h>

#include "searchScenes.h"

#include <meshFiles.h>

#include <visp3/core/vpException.h>
#include <visp3/multicue/vpMbMultiCueTracker.h>
#include <visp3/se3/vpPoseRandom.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

namespace {
using colorScenes::Scene;
using searchScenes::displaced;

const Eigen::Vector3d boxSize(0.2, 0.14, 0.1);
const vpHomogeneousMatrix truth = searchScenes::truePose();
const int edge = vpMbMultiCueTracker::EDGE_TRACKER;
const int allCues = edge | vpMbMultiCueTracker::KLT_TRACKER | vpMbMultiCueTracker::COLOR_TRACKER;

//! A box, of which the model knows no colours: for edges alone of one colour, else printed before a cluttered
//! background.
struct Box
{
  explicit Box(int type)
  {
    if (type == edge) {
      paint = searchScenes::plainPaint();
    }
    tracker.setTrackerType(type);
    tracker.setCameraParameters(colorScenes::makeCamera());
    tracker.loadModel(searchScenes::writeBox(boxSize, meshFiles::temporaryFile("rough-box.obj")));
  }

  vpImage<vpRGBa> draw(const vpHomogeneousMatrix &cMo) { return scene.draw(cMo, paint); }
  bool isTracking() const { return tracker.getTrackingState() == vpTrackingState::TRACKING; }
  bool isLost() const { return tracker.getTrackingState() == vpTrackingState::LOST; }
  bool isRight(const vpHomogeneousMatrix &cMo) const
  {
    const searchScenes::Difference d = searchScenes::differenceOf(tracker.getPose(), cMo, *tracker.getModel());
    return d.degrees < 5. && d.diameters < 0.05;
  }
  void show(const vpHomogeneousMatrix &cMo, int frames)
  {
    for (int i = 0; i < frames; ++i) {
      tracker.track(draw(cMo));
    }
  }

  Scene scene{colorScenes::makeBox()};
  colorScenes::Paint paint;
  vpMbMultiCueTracker tracker;
};

vpImage<vpRGBa> plainImage()
{
  return vpImage<vpRGBa>(colorScenes::height, colorScenes::width, vpRGBa(90, 90, 90));
}

vpImage<vpRGBa> noise(std::uint64_t seed)
{
  vpPoseRandom random(seed);
  vpImage<vpRGBa> I = plainImage();
  const auto level = [&random] { return static_cast<unsigned char>(255. * random.uniform()); };
  for (unsigned int i = 0; i < I.getSize(); ++i) {
    I.bitmap[i] = vpRGBa(level(), level(), level());
  }
  return I;
}

//! Turned by an angle and moved by a tenth of the diameter, about as far off as the deviation says.
vpHomogeneousMatrix off(std::size_t axis, double degrees)
{
  const Eigen::Vector3d shift = 0.02 * searchScenes::axes()[(axis + 1) % 6].normalized();
  return displaced(truth, searchScenes::axes()[axis], degrees, shift);
}

vpPoseDeviation deviation(double degrees)
{
  vpPoseDeviation result;
  result.translation = 0.026;
  result.rotation = degrees * M_PI / 180.;
  return result;
}

vpHomogeneousMatrix notANumber()
{
  vpHomogeneousMatrix cMo = truth;
  cMo[0][3] = std::numeric_limits<double>::quiet_NaN();
  return cMo;
}

bool isSame(const vpHomogeneousMatrix &a, const vpHomogeneousMatrix &b)
{
  return std::equal(a.data, a.data + 16, b.data);
}

vpHomogeneousMatrix behind()
{
  return vpHomogeneousMatrix(0., 0., -1., 0., 0., 0.);
}
} // namespace

TEST_CASE("A start that is off by 12 degrees and a tenth of the diameter finds the object", "[rough]")
{
  for (const int type : {edge, allCues}) {
    for (std::size_t i = 0; i < 3; ++i) {
      CAPTURE(type, i);
      Box box(type);
      const vpImage<vpRGBa> I = box.draw(truth);
      CHECK(box.tracker.initFromRoughPose(I, off(i, 12.), deviation(12.)));
      CHECK(box.isRight(truth));
      CHECK(box.tracker.getTrackingState() == vpTrackingState::UNCERTAIN);
      box.show(truth, 4);
      CHECK(box.isTracking());
      CHECK(box.isRight(truth));
    }
  }
}

TEST_CASE("A start in an image without the object is refused", "[rough]")
{
  for (const int type : {edge, allCues}) {
    Box box(type);
    for (const vpImage<vpRGBa> &I : {plainImage(), noise(1), noise(2)}) {
      CAPTURE(type);
      CHECK_FALSE(box.tracker.initFromRoughPose(I, truth));
      CHECK(box.isLost());
      CHECK_FALSE(box.tracker.getTrackingResult().text.empty());
    }
    box.show(truth, 2); // Without a search it stays so.
    CHECK(box.isLost());
    box.tracker.initFromPose(box.draw(truth), truth);
    box.show(truth, 2);
    CHECK(box.isTracking());
    CHECK(box.isRight(truth));
  }
}

TEST_CASE("With a search, a start that was refused is tried again", "[rough]")
{
  Box box(allCues);
  box.tracker.setSearch(true);
  CHECK_FALSE(box.tracker.initFromRoughPose(plainImage(), off(0, 10.), deviation(12.)));
  box.show(truth, 6);
  CHECK(box.isTracking());
  CHECK(box.isRight(truth));
}

TEST_CASE("Of several poses the right one is taken", "[rough]")
{
  const std::vector<vpWeightedPose> candidates = {{displaced(truth, {1., 0., 0.}, 60., {0.1, 0., 0.}), 1.},
                                                  {displaced(truth, {0., 1., 0.}, -70., {-0.12, 0.05, 0.}), 3.},
                                                  {off(2, 10.), 1.},
                                                  {displaced(truth, {1., 1., 1.}, 100., {0., 0.1, 0.1}), 2.}};
  for (const int type : {edge, allCues}) {
    CAPTURE(type);
    Box box(type);
    CHECK(box.tracker.initFromRoughPoses(box.draw(truth), candidates, deviation(10.)));
    CHECK(box.isRight(truth));
  }
}

TEST_CASE("A detector brings back an object that was lost", "[rough]")
{
  const vpHomogeneousMatrix back = displaced(truth, {0.3, 1., 0.2}, 80., {-0.1, 0.05, 0.1});
  for (const bool hasDetector : {false, true}) {
    CAPTURE(hasDetector);
    Box box(edge);
    box.tracker.setSearch(true);
    int calls = 0;
    if (hasDetector) {
      box.tracker.setDetector([&](const vpImage<vpRGBa> &I, const vpCameraParameters &) {
        calls += I.getWidth() == colorScenes::width;
        return std::vector<vpWeightedPose>{{notANumber(), 1.}, {displaced(back, {1., 0., 0.}, 8., {0.01, 0., 0.}), 1.}};
      });
    }
    box.tracker.initFromPose(box.draw(truth), truth);
    box.show(truth, 3);
    CHECK(calls == 0);
    for (int i = 0; i < 3; ++i) {
      box.tracker.track(plainImage());
    }
    CHECK(box.isLost());
    CHECK((calls > 0) == hasDetector);
    const std::string text = box.tracker.getTrackingResult().text;
    CHECK((text.find("pose 0 of the detector is passed over") != std::string::npos) == hasDetector);
    box.show(back, 8); // Six of them have to confirm the pose.
    CHECK(box.isRight(back) == hasDetector);
    CHECK((box.isTracking() && box.isRight(back)) == hasDetector);
  }
}

TEST_CASE("What a detector throws stays inside", "[rough]")
{
  Box box(allCues);
  box.tracker.setSearch(true);
  box.tracker.setDetector([](const vpImage<vpRGBa> &, const vpCameraParameters &) -> std::vector<vpWeightedPose> {
    throw std::runtime_error("no network file");
  });
  box.tracker.initFromPose(box.draw(truth), truth);
  box.show(truth, 2);
  for (int i = 0; i < 3; ++i) {
    CHECK_NOTHROW(box.tracker.track(plainImage()));
  }
  CHECK(box.tracker.getTrackingResult().text.find("no network file") != std::string::npos);
  box.tracker.setDetector(nullptr);
  CHECK_NOTHROW(box.tracker.track(plainImage()));
  CHECK(box.tracker.getTrackingResult().text.find("detector") == std::string::npos);
}

TEST_CASE("A hint is taken where it explains the image better", "[rough]")
{
  const vpHomogeneousMatrix jumped = displaced(truth, {0.3, 1., 0.2}, 70., {-0.08, 0.04, 0.05});
  for (const int type : {edge, allCues}) {
    for (const bool hasHint : {false, true}) {
      CAPTURE(type, hasHint);
      Box box(type);
      box.tracker.initFromPose(box.draw(truth), truth);
      box.show(truth, 3);
      if (hasHint) {
        box.tracker.setPoseHint(displaced(jumped, {0., 0., 1.}, 4., {0.005, 0., 0.}));
      }
      box.show(jumped, 1);
      CHECK(box.isRight(jumped) == hasHint);
    }
  }
}

TEST_CASE("A wrong hint is not taken", "[rough]")
{
  for (const int type : {edge, allCues}) {
    CAPTURE(type);
    Box box(type);
    box.tracker.initFromPose(box.draw(truth), truth);
    box.show(truth, 3);
    box.tracker.setPoseHint(displaced(truth, {0.3, 1., 0.2}, 60., {-0.1, 0.04, 0.05}));
    box.show(truth, 2);
    CHECK(box.isTracking());
    CHECK(box.isRight(truth));
  }
}

TEST_CASE("The same rough start gives the same bits", "[rough]")
{
  Box first(allCues);
  Box second(allCues);
  const vpImage<vpRGBa> I = first.draw(truth);
  first.tracker.initFromRoughPose(I, off(1, 12.));
  second.tracker.initFromRoughPose(I, off(1, 12.));
  CHECK(isSame(first.tracker.getPose(), second.tracker.getPose()));
}

TEST_CASE("Starts that cannot be are refused with an exception that says why", "[rough]")
{
  const vpImage<vpRGBa> I = plainImage();
  const auto check = [&I](vpMbMultiCueTracker &tracker) {
    const double infinite = std::numeric_limits<double>::infinity();
    const auto checkPoses = [&](const std::vector<vpWeightedPose> &poses, const std::string &text) {
      CHECK_THROWS_WITH(tracker.initFromRoughPoses(I, poses), ContainsSubstring(text));
    };
    CHECK_THROWS_WITH(tracker.initFromRoughPose(I, notANumber()), ContainsSubstring("finite"));
    CHECK_THROWS_WITH(tracker.initFromRoughPose(I, behind()), ContainsSubstring("behind the camera"));
    CHECK_THROWS_WITH(tracker.initFromRoughPose(vpImage<vpRGBa>(), truth), ContainsSubstring("image is empty"));
    CHECK_THROWS_WITH(tracker.initFromRoughPose(I, truth, deviation(-1.)),
                      ContainsSubstring("deviation of the rotation"));
    CHECK_THROWS_WITH(tracker.initFromRoughPose(I, truth, deviation(200.)),
                      ContainsSubstring("deviation of the rotation"));
    vpPoseDeviation negative;
    negative.translation = -0.01;
    CHECK_THROWS_WITH(tracker.initFromRoughPose(I, truth, negative), ContainsSubstring("deviation of the translation"));
    checkPoses({}, "No poses");
    // The heaviest one, which is where the search would begin, is right.
    checkPoses({{truth, 2.}, {notANumber(), 1.}}, "finite");
    checkPoses({{truth, 2.}, {behind(), 1.}}, "behind the camera");
    for (const double weight : {0., -1., infinite, std::nan("")}) {
      checkPoses({{truth, 1.}, {truth, weight}}, "weight");
    }
  };
  Box fresh(edge);
  check(fresh.tracker);
  CHECK_THROWS_WITH(fresh.tracker.track(I), ContainsSubstring("No initial pose")); // None of them was a start.
  Box box(edge);
  box.tracker.initFromPose(box.draw(truth), truth);
  box.show(truth, 3);
  const vpHomogeneousMatrix cMo = box.tracker.getPose();
  check(box.tracker);
  CHECK(isSame(box.tracker.getPose(), cMo));
  CHECK(box.isTracking());
  const vpHomogeneousMatrix next = displaced(truth, {0., 0., 1.}, 1., {0.002, 0., 0.});
  box.show(next, 1);
  CHECK(box.isTracking());
  CHECK(box.isRight(next));
}

TEST_CASE("Hints that cannot be are refused with an exception that says why, and the hint before stays", "[rough]")
{
  const vpHomogeneousMatrix jumped = displaced(truth, {0.3, 1., 0.2}, 70., {-0.08, 0.04, 0.05});
  const vpHomogeneousMatrix hint = displaced(jumped, {0., 0., 1.}, 4., {0.005, 0., 0.});
  Box box(edge);
  box.tracker.initFromPose(box.draw(truth), truth);
  box.show(truth, 3);
  box.tracker.setPoseHint(hint);
  CHECK_THROWS_WITH(box.tracker.setPoseHint(notANumber()), ContainsSubstring("finite"));
  CHECK_THROWS_WITH(box.tracker.setPoseHint(behind()), ContainsSubstring("behind the camera"));
  CHECK_THROWS_WITH(box.tracker.setPoseHint(truth, deviation(-1.)), ContainsSubstring("deviation of the rotation"));
  CHECK_THROWS_WITH(vpMbMultiCueTracker().setPoseHint(truth), ContainsSubstring("loadModel"));
  box.show(jumped, 1);
  CHECK(box.isRight(jumped)); // As without a hint it is not.
}
