// SPDX-License-Identifier: GPL-2.0-or-later
#include "searchScenes.h"

// The library keeps them to itself.
#include "search/vpContourAligner.cpp"
#include "search/vpPointProjection.cpp"

#include <catchMain.h>

#include <limits>

namespace {
using searchScenes::BoxScene;
using searchScenes::differenceOf;

vpContourAligner alignerFor(BoxScene &scene)
{
  vpContourAligner aligner;
  aligner.setSphere(&scene.sphere);
  aligner.setImage(&scene.odds, &scene.edges, scene.camera, scene.width, scene.height);
  return aligner;
}

//! From far to near, as a search does it.
bool alignAll(const vpContourAligner &aligner, Eigen::Isometry3d &pose)
{
  for (const double reach : {0.15, 0.15, 0.08, 0.08, 0.05, 0.05, 0.03, 0.03}) {
    if (!aligner.stepByColors(pose, reach)) {
      return false;
    }
  }
  return true;
}
} // namespace

TEST_CASE("From ten degrees and a twentieth of the diameter off, the silhouette leads to the pose", "[contour-aligner]")
{
  BoxScene scene;
  const vpContourAligner aligner = alignerFor(scene);
  const double shift = 0.05 * scene.model->diameter() / std::sqrt(3.);
  for (const Eigen::Vector3d &axis : searchScenes::axes()) {
    for (const double sign : {-1., 1.}) {
      CAPTURE(axis.transpose(), sign);
      const vpHomogeneousMatrix start = searchScenes::displaced(searchScenes::truePose(), axis, 10. * sign,
                                                                sign * Eigen::Vector3d(shift, -shift, shift));
      Eigen::Isometry3d pose = vpPoseExponential::toEigen(start);
      REQUIRE(alignAll(aligner, pose));
      const searchScenes::Difference left =
          differenceOf(vpPoseExponential::fromEigen(pose), searchScenes::truePose(), *scene.model);
      CHECK(left.degrees < 2.);
      CHECK(left.diameters < 0.01);
      CHECK((pose.linear() * pose.linear().transpose() - Eigen::Matrix3d::Identity()).norm() < 1e-6);
    }
  }
}

TEST_CASE("From five degrees and a fiftieth of the diameter off, edges lead to the pose", "[contour-aligner]")
{
  BoxScene scene;
  const vpContourAligner aligner = alignerFor(scene);
  const double shift = 0.02 * scene.model->diameter() / std::sqrt(2.);
  for (const Eigen::Vector3d &axis : searchScenes::axes()) {
    for (const double sign : {-1., 1.}) {
      CAPTURE(axis.transpose(), sign);
      const vpHomogeneousMatrix start =
          searchScenes::displaced(searchScenes::truePose(), axis, 5. * sign, sign * Eigen::Vector3d(shift, -shift, 0.));
      Eigen::Isometry3d pose = vpPoseExponential::toEigen(start);
      for (int i = 0; i < 8; ++i) {
        REQUIRE(aligner.stepByEdges(pose));
      }
      const searchScenes::Difference left =
          differenceOf(vpPoseExponential::fromEigen(pose), searchScenes::truePose(), *scene.model);
      CHECK(left.degrees < 2.);
      CHECK(left.diameters < 0.02);
    }
  }
  Eigen::Isometry3d behind = vpPoseExponential::toEigen(searchScenes::truePose());
  behind.translation().z() = -0.5;
  const Eigen::Isometry3d before = behind;
  CHECK_FALSE(aligner.stepByEdges(behind));
  CHECK((behind.matrix() - before.matrix()).norm() == exactly(0.));
}

TEST_CASE("The true pose stays where it is", "[contour-aligner]")
{
  BoxScene scene;
  const vpContourAligner aligner = alignerFor(scene);
  Eigen::Isometry3d pose = vpPoseExponential::toEigen(searchScenes::truePose());
  REQUIRE(alignAll(aligner, pose));
  const searchScenes::Difference left =
      differenceOf(vpPoseExponential::fromEigen(pose), searchScenes::truePose(), *scene.model);
  CHECK(left.degrees < 1.5);
  CHECK(left.diameters < 0.015);
}

TEST_CASE("Where no colour says anything, nothing moves", "[contour-aligner]")
{
  colorScenes::Paint paint = searchScenes::plainPaint();
  paint.object = [](const Eigen::Vector3d &) { return colorScenes::Color(10., 10., 250.); };
  paint.background = [](double, double) { return colorScenes::Color(10., 10., 250.); };
  BoxScene scene(paint);
  const vpContourAligner aligner = alignerFor(scene);
  const Eigen::Isometry3d start = vpPoseExponential::toEigen(searchScenes::truePose());
  Eigen::Isometry3d pose = start;
  CHECK(aligner.stepByColors(pose, 0.1));
  CHECK((pose.matrix() - start.matrix()).norm() < 1e-12);
}

TEST_CASE("Poses without the object in view are left as they are", "[contour-aligner]")
{
  BoxScene scene;
  const vpContourAligner aligner = alignerFor(scene);
  std::vector<vpHomogeneousMatrix> poses(4, searchScenes::truePose());
  poses[0][0][3] = 5.;
  poses[1][2][3] = -0.5;
  poses[2][2][3] = 0.;
  poses[3][0][3] = std::numeric_limits<double>::quiet_NaN();
  for (const vpHomogeneousMatrix &cMo : poses) {
    const Eigen::Isometry3d start = vpPoseExponential::toEigen(cMo);
    Eigen::Isometry3d pose = start;
    CHECK_FALSE(aligner.stepByColors(pose, 0.1));
    CHECK((pose.translation() == start.translation() || std::isnan(cMo[0][3])));
    CHECK(pose.linear() == start.linear());
  }
}

TEST_CASE("A pose is finite after every step, wherever it begins", "[contour-aligner]")
{
  BoxScene scene;
  const vpContourAligner aligner = alignerFor(scene);
  for (const double z : {0.05, 0.13, 0.6, 50.}) {
    for (const Eigen::Vector3d &axis : searchScenes::axes()) {
      for (const double reach : {0., 1e-6, 0.1, 3.}) {
        vpHomogeneousMatrix cMo = searchScenes::truePose();
        cMo[2][3] = z;
        Eigen::Isometry3d pose =
            vpPoseExponential::toEigen(searchScenes::displaced(cMo, axis, 70., Eigen::Vector3d(0.03, 0.05, 0.)));
        for (int k = 0; k < 5; ++k) {
          aligner.stepByColors(pose, reach);
          REQUIRE(pose.matrix().allFinite());
          REQUIRE(pose.translation().z() > 0.);
        }
      }
    }
  }
}
