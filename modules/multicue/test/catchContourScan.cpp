// SPDX-License-Identifier: GPL-2.0-or-later
#include "searchScenes.h"

// The library keeps them to itself.
#include "search/vpContourScan.cpp"
#include "search/vpPointProjection.cpp"
#include "search/vpSameSide.cpp"

#include <catchMain.h>

#include <cmath>
#include <limits>

namespace {
using searchScenes::BoxScene;
using searchScenes::differenceOf;

const vpHomogeneousMatrix truth = searchScenes::truePose();

//! Of the box, pixels.
double radiusIn(const BoxScene &scene)
{
  return 0.5 * scene.camera.get_px() * scene.model->diameter() / truth[2][3];
}

//! Each side of another colour, so that all edges show.
colorScenes::Paint sidesPaint()
{
  colorScenes::Paint paint = searchScenes::plainPaint();
  paint.object = [](const Eigen::Vector3d &oX) {
    Eigen::Index axis = 0;
    oX.cwiseQuotient(Eigen::Vector3d(0.2, 0.14, 0.1)).cwiseAbs().maxCoeff(&axis);
    return colorScenes::Color(200. - 60. * static_cast<double>(axis), 56., 40.);
  };
  return paint;
}

struct Scanned : BoxScene
{
  explicit Scanned(const vpHomogeneousMatrix &cMo) : BoxScene(sidesPaint(), cMo)
  {
    scan.setSphere(&sphere);
    scan.setImage(edges, camera, width, height, radiusIn(*this));
  }

  vpContourScan scan;
};

//! The true orientation, as it is seen in the middle of the image.
Eigen::Isometry3d inTheMiddle()
{
  Eigen::Isometry3d cMo = vpPoseExponential::toEigen(truth);
  cMo.translation() = Eigen::Vector3d(0., 0., truth[2][3]);
  return cMo;
}
} // namespace

TEST_CASE("Contours are found wherever they are, also where a part of them is outside the image", "[contour-scan]")
{
  for (const Eigen::Vector3d &at : {Eigen::Vector3d(0., 0., 0.6), Eigen::Vector3d(0.14, 0.08, 0.6),
                                    Eigen::Vector3d(-0.15, -0.1, 0.6), Eigen::Vector3d(-0.2, 0.05, 0.6)}) {
    CAPTURE(at.transpose());
    // The same side, seen there.
    Eigen::Isometry3d there = inTheMiddle();
    there.linear() = Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), at) * there.linear();
    there.translation() = at;
    const vpHomogeneousMatrix cMo = vpPoseExponential::fromEigen(there);
    Scanned scene(cMo);
    const vpContourScan::Find find = scene.scan.find(inTheMiddle());
    const auto off =
        differenceOf(vpPoseExponential::fromEigen(scene.scan.movedTo(find, inTheMiddle())), cMo, *scene.model);
    CHECK(off.diameters < 0.05);
    CHECK(off.degrees < 4.);
    CHECK(find.share > 0.5);
  }
}

TEST_CASE("Another side, or another size, fits worse anywhere", "[contour-scan]")
{
  Scanned scene(truth);
  const double best = scene.scan.find(inTheMiddle()).share;
  for (const Eigen::Vector3d &axis : searchScenes::axes()) {
    CAPTURE(axis.transpose());
    const vpHomogeneousMatrix turned =
        searchScenes::displaced(vpPoseExponential::fromEigen(inTheMiddle()), axis, 30., Eigen::Vector3d::Zero());
    CHECK(scene.scan.find(vpPoseExponential::toEigen(turned)).share < best - 0.05);
  }
  for (const double factor : {0.6, 1.6}) {
    CAPTURE(factor);
    Eigen::Isometry3d resized = inTheMiddle();
    resized.translation().z() *= factor;
    CHECK(scene.scan.find(resized).share < best - 0.05);
  }
}

TEST_CASE("Several places are the best ones that are apart, best first", "[contour-scan]")
{
  Scanned scene(truth);
  const vpContourScan::Find best = scene.scan.find(inTheMiddle());
  std::vector<vpContourScan::Find> finds;
  scene.scan.find(inTheMiddle(), 3, finds);
  REQUIRE(finds.size() == 3);
  CHECK(finds[0].share == exactly(best.share));
  CHECK(finds[0].u == exactly(best.u));
  CHECK(finds[0].v == exactly(best.v));
  for (std::size_t i = 1; i < finds.size(); ++i) {
    CHECK(finds[i].share <= finds[i - 1].share);
    for (std::size_t k = 0; k < i; ++k) {
      const float off = std::max(std::fabs(finds[i].u - finds[k].u), std::fabs(finds[i].v - finds[k].v));
      CHECK(off > 0.4F * static_cast<float>(radiusIn(scene)));
    }
  }
}

TEST_CASE("Against clutter, edges of all orientations at one place are worth none", "[contour-scan]")
{
  Scanned scene(truth);
  vpImage<vpRGBa> hatched(scene.height, scene.width);
  for (unsigned int i = 0; i < hatched.getHeight(); ++i) {
    for (unsigned int j = 0; j < hatched.getWidth(); ++j) { // Dots.
      const unsigned char level = (i / 6 + j / 6) % 2 == 0 && i % 12 < 8 && j % 12 < 7 ? 220 : 40;
      hatched[i][j] = vpRGBa(level, level, level);
    }
  }
  vpOrientedDistanceMap dots;
  vpFrameSource source;
  dots.compute(source.frame(hatched, scene.camera, nullptr),
               {0, 0, static_cast<int>(scene.width), static_cast<int>(scene.height)});
  const auto shareOf = [&](const vpOrientedDistanceMap &edges, double clutter) {
    scene.scan.setImage(edges, scene.camera, scene.width, scene.height, radiusIn(scene), 6., clutter);
    return scene.scan.find(inTheMiddle()).share;
  };
  const double plainLead = shareOf(scene.edges, 0.) - shareOf(dots, 0.);
  CHECK(shareOf(scene.edges, 1.) - shareOf(dots, 1.) > plainLead + 0.05);
}

TEST_CASE("What is behind the camera or too large to see is not found, without harm", "[contour-scan]")
{
  Scanned scene(truth);
  CHECK(scene.scan.find(inTheMiddle()).share > 0.5);
  Eigen::Isometry3d pose = inTheMiddle();
  pose.translation().z() = -0.6;
  CHECK(scene.scan.find(pose).share == exactly(0.));
  pose.translation().z() = 1e-6;
  CHECK(scene.scan.find(pose).share < 0.1);
  pose.translation().z() = std::numeric_limits<double>::quiet_NaN();
  CHECK(scene.scan.find(pose).share == exactly(0.));
}

TEST_CASE("Of an object that is taken for smaller hardly any point counts, and of none are there too many cells",
          "[contour-scan]")
{
  Scanned scene(truth);
  const vpContourScan::Find before = scene.scan.find(inTheMiddle());
  for (const double radius : {0., 1e-3, 1.}) { // Far away.
    CAPTURE(radius);
    scene.scan.setImage(scene.edges, scene.camera, scene.width, scene.height, radius);
    CHECK(scene.scan.find(inTheMiddle()).share < 0.1);
  }
  for (const double radius : {500., 1e9}) { // About the camera.
    CAPTURE(radius);
    scene.scan.setImage(scene.edges, scene.camera, scene.width, scene.height, radius);
    const vpContourScan::Find find = scene.scan.find(inTheMiddle());
    CHECK(find.share > 0.5);
    CHECK(std::fabs(find.u - before.u) < 8.F);
    CHECK(std::fabs(find.v - before.v) < 8.F);
  }
  scene.scan.setImage(scene.edges, scene.camera, scene.width, scene.height, radiusIn(scene));
  const vpContourScan::Find after = scene.scan.find(inTheMiddle());
  CHECK(after.share == exactly(before.share));
  CHECK(after.u == exactly(before.u));
  CHECK(after.v == exactly(before.v));
}
