// SPDX-License-Identifier: GPL-2.0-or-later
#include <catchMain.h>
#include <exceptionMessage.h>

#include "searchScenes.h"

#include <meshFiles.h>

#include <visp3/core/vpException.h>
#include <visp3/core/vpImageConvert.h>
#include <visp3/multicue/vpMbMultiCueTracker.h>
#include <visp3/se3/vpPoseRandom.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>

// Starts without a pose.

namespace {
using colorScenes::Scene;

const Eigen::Vector3d boxSize(0.2, 0.14, 0.1);
const vpHomogeneousMatrix truth = searchScenes::truePose();
const int edge = vpMbMultiCueTracker::EDGE_TRACKER;
const int allCues = edge | vpMbMultiCueTracker::KLT_TRACKER | vpMbMultiCueTracker::COLOR_TRACKER;

const std::size_t across = 4; // Patches of a side, each way.

//! Of the patch that a place on the surface is in.
colorScenes::Color colorOf(const Eigen::Vector3d &oX)
{
  const Eigen::Vector3d share = oX.cwiseQuotient(boxSize); // -0.5 to 0.5.
  Eigen::Index axis = 0;
  share.cwiseAbs().maxCoeff(&axis);
  const auto patch = [&](Eigen::Index i) {
    return std::min(static_cast<int>(std::floor((share[i] + 0.5) * across)), static_cast<int>(across) - 1);
  };
  const int side = 2 * static_cast<int>(axis) + (share[axis] > 0. ? 1 : 0);
  const int place = 7 * side + patch((axis + 1) % 3) + 50 * patch((axis + 2) % 3);
  return {50. + 200. * colorScenes::hashed(place, 1), 50. + 200. * colorScenes::hashed(place, 2),
          50. + 200. * colorScenes::hashed(place, 3)};
}

//! A mesh of patches, whose vertices have the patch's colour.
std::string writeColoredBox(const std::string &name)
{
  std::ofstream file(name);
  const auto polygons = modelShapes::boxPolygons(boxSize);
  const std::size_t patches = across * across * polygons.size();
  file << "ply\nformat ascii 1.0\nelement vertex " << 4 * patches
       << "\nproperty float x\nproperty float y\nproperty float z\nproperty uchar red\nproperty uchar green\n"
          "property uchar blue\nelement face "
       << 2 * patches << "\nproperty list uchar int vertex_indices\nend_header\n";
  for (const auto &side : polygons) {
    const Eigen::Vector3d right = (side[1] - side[0]) / across;
    const Eigen::Vector3d down = (side[3] - side[0]) / across;
    for (std::size_t i = 0; i < across * across; ++i) {
      const Eigen::Vector3d first =
          side[0] + static_cast<double>(i % across) * right + static_cast<double>(i / across) * down;
      const colorScenes::Color color = colorOf(first + 0.5 * right + 0.5 * down);
      for (const Eigen::Vector3d &corner : {first, Eigen::Vector3d(first + right),
                                            Eigen::Vector3d(first + right + down), Eigen::Vector3d(first + down)}) {
        file << corner.transpose();
        for (int k = 0; k < 3; ++k) {
          file << " " << std::lround(color[k]);
        }
        file << "\n";
      }
    }
  }
  for (std::size_t i = 0; i < 4 * patches; i += 4) {
    file << "3 " << i << " " << i + 1 << " " << i + 2 << "\n3 " << i << " " << i + 2 << " " << i + 3 << "\n";
  }
  return name;
}

//! A box of the colours that its mesh has, before a background without edges.
struct ColoredBox
{
  explicit ColoredBox(int type = allCues)
  {
    paint.object = colorOf;
    paint.background = [](double u, double v) { return colorScenes::Color(60. + 0.1 * u, 110. + 0.05 * v, 90.); };
    tracker.setTrackerType(type);
    tracker.setCameraParameters(colorScenes::makeCamera());
    tracker.loadModel(writeColoredBox(meshFiles::temporaryFile("image-start-box.ply")));
  }

  vpImage<vpRGBa> draw(const vpHomogeneousMatrix &cMo) { return scene.draw(cMo, paint); }
  bool isRight(const vpHomogeneousMatrix &cMo) const
  {
    const searchScenes::Difference d = searchScenes::differenceOf(tracker.getPose(), cMo, *tracker.getModel());
    return d.degrees < 3. && d.diameters < 0.05;
  }
  bool isLost() const { return tracker.getTrackingState() == vpTrackingState::LOST; }

  Scene scene{colorScenes::makeBox()};
  colorScenes::Paint paint;
  vpMbMultiCueTracker tracker;
};

vpImage<vpRGBa> noise(std::uint64_t seed)
{
  vpPoseRandom random(seed);
  vpImage<vpRGBa> I(colorScenes::height, colorScenes::width);
  const auto level = [&random] { return static_cast<unsigned char>(255. * random.uniform()); };
  for (unsigned int i = 0; i < I.getSize(); ++i) {
    I.bitmap[i] = vpRGBa(level(), level(), level());
  }
  return I;
}

vpDistanceRange range(double nearest, double farthest)
{
  vpDistanceRange distances;
  distances.nearest = nearest;
  distances.farthest = farthest;
  return distances;
}
} // namespace

TEST_CASE("The object is found wherever, however turned and however far away it is", "[image-start]")
{
  ColoredBox box;
  for (const vpHomogeneousMatrix &cMo : {truth, vpHomogeneousMatrix(0.1, 0.06, 0.7, -1.2, 2.0, 0.4),
                                         vpHomogeneousMatrix(-0.2, -0.1, 1.1, 2.4, 0.3, -0.9)}) {
    CAPTURE(cMo);
    CHECK(box.tracker.initFromImage(box.draw(cMo)));
    INFO(box.tracker.getTrackingResult().text << box.tracker.getPose());
    CHECK(box.isRight(cMo));
    CHECK(box.tracker.getTrackingState() == vpTrackingState::UNCERTAIN);
    for (int i = 0; i < 4; ++i) {
      box.tracker.track(box.draw(cMo));
    }
    CHECK(box.isRight(cMo));
    CHECK(box.tracker.getTrackingState() == vpTrackingState::TRACKING);
  }
}

TEST_CASE("It is found before clutter of as many colours", "[image-start]")
{
  ColoredBox box;
  box.paint.background = colorScenes::clutter;
  CHECK(box.tracker.initFromImage(box.draw(truth), range(0.4, 0.9)));
  CHECK(box.isRight(truth));
}

TEST_CASE("Edges alone and gray images find it, too", "[image-start]")
{
  ColoredBox box(edge);
  vpImage<unsigned char> I;
  vpImageConvert::convert(box.draw(truth), I);
  CHECK(box.tracker.initFromImage(I));
  CHECK(box.isRight(truth));
}

TEST_CASE("The same image gives the same pose to the last bit", "[image-start]")
{
  ColoredBox first;
  ColoredBox second;
  const vpImage<vpRGBa> I = first.draw(truth);
  second.tracker.initFromImage(second.draw(vpHomogeneousMatrix(0.1, 0.06, 0.7, -1.2, 2.0, 0.4)));
  first.tracker.initFromImage(I);
  second.tracker.initFromImage(I);
  const vpHomogeneousMatrix a = first.tracker.getPose();
  const vpHomogeneousMatrix b = second.tracker.getPose();
  CHECK(std::equal(a.data, a.data + 16, b.data));
}

TEST_CASE("Without the object it is refused with what is missing, and the next image may be tried", "[image-start]")
{
  ColoredBox box;
  CHECK_FALSE(box.tracker.initFromImage(noise(1)));
  CHECK(box.isLost());
  CHECK_THAT(box.tracker.getTrackingResult().text, ContainsSubstring("no pose was accepted"));
  box.tracker.track(box.draw(truth)); // Without a search it stays so.
  CHECK(box.isLost());
  CHECK(box.tracker.initFromImage(box.draw(truth)));
  CHECK(box.isRight(truth));
}

TEST_CASE("With a search, tracking looks at all of the next images after a refusal", "[image-start]")
{
  ColoredBox box;
  box.tracker.setSearch(true);
  REQUIRE_FALSE(box.tracker.initFromImage(noise(1)));
  for (int i = 0; i < 6; ++i) {
    box.tracker.track(box.draw(truth));
  }
  CHECK(box.isRight(truth));
  CHECK(box.tracker.getTrackingState() == vpTrackingState::TRACKING);
}

TEST_CASE("Distances that are told are kept to", "[image-start]")
{
  ColoredBox box;
  const vpImage<vpRGBa> I = box.draw(truth);
  CHECK(box.tracker.initFromImage(I, range(0.5, 0.7)));
  CHECK(box.isRight(truth));
  box.tracker.initFromImage(I, range(2., 3.)); // It is nearer than that.
  CHECK(box.tracker.getPose()[2][3] > 1.5);
}

TEST_CASE("A start without a pose refuses bad input, and the tracker goes on", "[image-start]")
{
  ColoredBox box;
  const vpImage<vpRGBa> I = box.draw(truth);
  box.tracker.initFromPose(I, truth);
  box.tracker.track(I);
  REQUIRE(box.tracker.getTrackingState() == vpTrackingState::TRACKING);
  const double infinity = std::numeric_limits<double>::infinity();
  const auto start = [&](const vpDistanceRange &distances) {
    return messageOf([&] { box.tracker.initFromImage(I, distances); });
  };
  CHECK_THAT(start(range(-1., 0.)), ContainsSubstring("nearest is -1"));
  CHECK_THAT(start(range(0., infinity)), ContainsSubstring("farthest is inf"));
  CHECK_THAT(start(range(std::nan(""), 1.)), ContainsSubstring("nearest is nan"));
  CHECK_THAT(start(range(2., 1.)), ContainsSubstring("less than nearest"));
  CHECK_THAT(start(range(1000., 2000.)), ContainsSubstring("At 1000 m"));
  CHECK_THROWS_AS(box.tracker.initFromImage(vpImage<vpRGBa>()), vpException);
  box.tracker.track(I);
  CHECK(box.tracker.getTrackingState() == vpTrackingState::TRACKING);
  CHECK(box.isRight(truth));

  vpMbMultiCueTracker empty;
  CHECK_THROWS_AS(empty.initFromImage(I), vpException);
}
