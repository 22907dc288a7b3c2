// SPDX-License-Identifier: GPL-2.0-or-later
#include <catchMain.h>

#include "generateChecks.h"

#include "dataset/motionFigures.h"

#include <visp3/core/vpException.h>
#include <visp3/core/vpMath.h>
#include <visp3/se3/vpPoseExponential.h>

#include <opencv2/imgproc.hpp>

#include <fstream>

using bench::MotionFigures;
using bench::Scene;
using bench::SceneOptions;

namespace {
SceneOptions options(const meshFiles::TemporaryFolder &folder, const std::string &object, const std::string &motion,
                     double scale)
{
  SceneOptions result = generateChecks::options(folder.path("data"), object, "regular", 300);
  result.width = 640;
  result.height = 480;
  result.motion = motion;
  result.motionScale = scale;
  return result;
}

std::vector<vpHomogeneousMatrix> posesOf(const Scene &scene)
{
  std::vector<vpHomogeneousMatrix> poses;
  for (int frame = 0; frame < scene.options().frames; ++frame) {
    poses.push_back(scene.pose(frame));
  }
  return poses;
}

MotionFigures figuresOf(const Scene &scene)
{
  return bench::measureMotion(posesOf(scene), scene.object().model->vertices(), scene.camera().cam);
}

std::string rowOf(const vpHomogeneousMatrix &cMo)
{
  std::ostringstream row;
  row << std::setprecision(9);
  for (unsigned int i = 0; i < 3; ++i) {
    row << cMo[i][0] << "\t" << cMo[i][1] << "\t" << cMo[i][2] << "\t";
  }
  row << 1000. * cMo[0][3] << "\t" << 1000. * cMo[1][3] << "\t" << 1000. * cMo[2][3] << "\n";
  return row.str();
}

bool staysInside(const Scene &scene)
{
  bool inside = true;
  for (int frame = 0; frame < scene.options().frames; ++frame) {
    for (const Eigen::Vector2d &p :
         generateChecks::project(*scene.object().model, scene.pose(frame), scene.camera().cam)) {
      inside = inside && p.x() > 0. && p.x() < 639. && p.y() > 0. && p.y() < 479.;
    }
  }
  return inside;
}

// Of the object's centre.
Eigen::Vector2d centreOf(const Scene &scene, double time)
{
  const Eigen::Vector3d centre = vpPoseExponential::toEigen(scene.motion().pose(time)) * scene.object().model->centre();
  return scene.camera().cam.get_px() * centre.head<2>() / centre.z();
}
} // namespace

TEST_CASE("A hand's object moves, turns and departs from its prediction as real ones do, within the image")
{
  const meshFiles::TemporaryFolder folder;
  for (const std::string &object : bench::objectNames()) {
    for (const double scale : {0.5, 1., 2.}) {
      const Scene scene(options(folder, object, "handheld", scale));
      const MotionFigures figures = figuresOf(scene);
      INFO(object << " " << scale);
      CHECK(figures.pixels.mean == Approx(10. * scale).epsilon(0.06));
      CHECK(figures.degrees.mean >= (scale > 1. ? 8. : 5.6 * scale));
      CHECK(figures.degrees.mean <= (scale > 1. ? 12. : 6.4 * scale));
      CHECK(figures.prediction.mean == Approx(4. * scale).epsilon(0.06));
      CHECK(figures.prediction.ninth == Approx(9. * scale).epsilon(0.25));
      CHECK(staysInside(scene));
    }
  }
}

TEST_CASE("A shaken camera's prediction is off by 9 pixels, and the object hardly turns")
{
  const meshFiles::TemporaryFolder folder;
  for (const std::string &object : bench::objectNames()) {
    const MotionFigures figures = figuresOf(Scene(options(folder, object, "shaken-camera", 1.)));
    INFO(object);
    CHECK(figures.pixels.mean == Approx(9.).epsilon(0.06));
    CHECK(figures.prediction.mean == Approx(9.).epsilon(0.06));
    CHECK(figures.degrees.mean < 2.);
  }
}

TEST_CASE("Lengths are those of 640 x 480, and a short sequence is the beginning of a long one")
{
  const meshFiles::TemporaryFolder folder;
  const Scene large(options(folder, "box", "handheld", 1.));
  SceneOptions small = options(folder, "box", "handheld", 1.);
  small.width = 160;
  small.height = 120;
  small.frames = 40;
  CHECK((4. * centreOf(Scene(small), 33.5) - centreOf(large, 33.5)).norm() < 1.);
}

TEST_CASE("Background and object are shaken together")
{
  const meshFiles::TemporaryFolder folder;
  SceneOptions settings = options(folder, "box", "shaken-camera", 1.);
  settings.frames = 40;
  const Scene scene(settings);
  const bench::Background background("photo", scene.camera(), 1);
  double shaken = 0.;
  for (int frame = 10; frame < 13; ++frame) {
    cv::Mat before;
    cv::Mat after;
    cv::cvtColor(background.at(10., scene.motion().backgroundTurn(frame)), before, cv::COLOR_BGR2GRAY);
    cv::cvtColor(background.at(10., scene.motion().backgroundTurn(frame + 1)), after, cv::COLOR_BGR2GRAY);
    cv::Mat window;
    cv::createHanningWindow(window, before.size(), CV_32F);
    const cv::Point2d seen = cv::phaseCorrelate(before, after, window);
    const Eigen::Vector2d object = centreOf(scene, frame + 1) - centreOf(scene, frame);
    INFO(frame << ": " << seen.x << " " << seen.y << ", object " << object.transpose());
    // What is left is the object's own motion, and the camera's turn about its line of sight.
    CHECK((object - Eigen::Vector2d(seen.x, seen.y)).norm() < 2.5);
    shaken += object.norm();
  }
  CHECK(shaken > 10.);
}

TEST_CASE("Poses of a file are taken with or without its line of titles, as many a frame as the scale says")
{
  const meshFiles::TemporaryFolder folder;
  std::string text;
  for (int i = 0; i < 9; ++i) {
    text += rowOf(vpHomogeneousMatrix(0.01 * i, 0., 2., 0., 0., vpMath::rad(4. * i)));
  }
  const std::string mesh = folder.path("data/models/obj_000001.ply");
  SceneOptions settings = options(folder, "box", "smooth", 1.);
  settings.frames = 4;
  Scene{settings}; // Writes the mesh.
  settings.unit = 0.001;
  settings.object = mesh;
  settings.motionScale = 2.;
  for (const std::string title : {"", "r11 r12 r13\n"}) {
    settings.motion = folder.write("poses.txt", title + text);
    const Scene scene(settings);
    CHECK(bench::sceneName(settings) == "obj_000001_poses2_regular");
    CHECK(scene.pose(3)[0][3] == Approx(0.06).margin(1e-6));
    CHECK(scene.motion().pose(1.25)[0][3] == Approx(0.025).margin(1e-5));
    CHECK(figuresOf(scene).degrees.mean == Approx(8.).margin(1e-3));
  }
  settings.frames = 6;
  CHECK_THROWS_WITH(Scene(settings), ContainsSubstring("9 poses") && ContainsSubstring("11"));
}

TEST_CASE("Poses of a file are moved away until an object of the generator has its usual size")
{
  const meshFiles::TemporaryFolder folder;
  std::string text;
  for (int i = 0; i < 3; ++i) {
    text += rowOf(vpHomogeneousMatrix(0., 0., 0.1, 0., 0., 0.1 * i));
  }
  SceneOptions settings = options(folder, "bands", folder.write("poses.txt", text), 1.);
  settings.frames = 3;
  const Scene scene(settings);
  const Eigen::Vector3d centre = vpPoseExponential::toEigen(scene.pose(1)) * scene.object().model->centre();
  CHECK(650. * scene.object().model->diameter() / centre.z() == Approx(225.).epsilon(0.02));
}

TEST_CASE("A motion that cannot be made is refused by name")
{
  const meshFiles::TemporaryFolder folder;
  CHECK_THROWS_WITH(Scene(options(folder, "box", "wild", 1.)),
                    ContainsSubstring("wild") && ContainsSubstring("smooth"));
  CHECK_THROWS_WITH(Scene(options(folder, "box", "handheld", 0.)), ContainsSubstring("--motion-scale: 0"));
  CHECK_THROWS_WITH(Scene(options(folder, "box", "handheld", 9.)), ContainsSubstring("--motion-scale nearer to 1"));
  SceneOptions exit = options(folder, "box", "handheld", 1.);
  exit.variant = "exit";
  CHECK_THROWS_WITH(Scene(exit), ContainsSubstring("exit"));
  const std::string poses = folder.write("poses.txt", rowOf(vpHomogeneousMatrix(0., 0., 0.5, 0., 0., 0.)));
  CHECK_THROWS_WITH(Scene(options(folder, "box", poses, 1.)), ContainsSubstring("fewer than two poses"));
  CHECK_THROWS_WITH(Scene(options(folder, "window", poses, 1.)), ContainsSubstring("only a front"));
}
