// SPDX-License-Identifier: GPL-2.0-or-later
#include <catchMain.h>

#include "generateChecks.h"

#include "generate/light.h"

#include <visp3/core/vpException.h>

#include <opencv2/imgproc.hpp>

#include <algorithm>

using bench::Scene;
using bench::SceneOptions;
using bench::Webcam;
using programs::BopFrame;

namespace {
cv::Mat processed(const std::vector<std::string> &effects, const cv::Mat &image, int frame = 3)
{
  const bench::SceneCamera camera =
      bench::makeSceneCamera(static_cast<unsigned int>(image.cols), static_cast<unsigned int>(image.rows));
  cv::Mat result = image.clone();
  Webcam(effects, camera, 1).process(frame, result);
  return result;
}

cv::Mat flat(const cv::Scalar &color)
{
  return cv::Mat(120, 160, CV_32FC3, color);
}

cv::Mat deviation(const cv::Mat &image)
{
  cv::Mat mean;
  cv::Mat result;
  cv::meanStdDev(image, mean, result);
  return result;
}

cv::Mat render(const Scene &scene, int frame)
{
  bench::ObjectRenderer renderer = scene.makeRenderer();
  BopFrame truth;
  return scene.render(frame, renderer, truth);
}

// Of all that differs from the plain background.
Eigen::Vector2d middleOf(const cv::Mat &image)
{
  cv::Mat difference;
  cv::absdiff(image, cv::Mat(image.size(), CV_8UC3, cv::Scalar(96., 92., 88.)), difference);
  cv::cvtColor(difference, difference, cv::COLOR_BGR2GRAY);
  const cv::Moments moments = cv::moments(difference > 2, true);
  return {moments.m10 / moments.m00, moments.m01 / moments.m00};
}

// The middle of the object's silhouette at a pose.
Eigen::Vector2d middleAt(const Scene &scene, const vpHomogeneousMatrix &cMo)
{
  bench::ImageLayer layer;
  scene.makeRenderer().render(cMo, bench::Light(), 2, layer);
  const cv::Moments moments = cv::moments(layer.coverage);
  return {moments.m10 / moments.m00 + layer.area.x, moments.m01 / moments.m00 + layer.area.y};
}
} // namespace

TEST_CASE("Each row of an image is the mean of its own exposure")
{
  const bench::Shutter shutter{0.5, 0.9};
  const cv::Mat means =
      bench::expose(shutter, [](double time, int) { return cv::Mat(50, 4, CV_32F, cv::Scalar(time)); });
  for (int i = 0; i < means.rows; ++i) {
    CHECK(means.at<float>(i, 1) == Approx(shutter.timeOfRow(i, 50)).margin(0.01));
  }
  CHECK(means.at<float>(0, 0) < -0.42F);
  // Half of the time white: half as bright, and that in all rows of a global shutter.
  const cv::Mat half = bench::expose(
      {0.5, 0.}, [](double time, int) { return cv::Mat(50, 4, CV_32F, cv::Scalar(time < 0. ? 0. : 200.)); });
  CHECK(half.at<float>(0, 0) == Approx(100.));
  CHECK(half.at<float>(49, 3) == Approx(100.));
}

TEST_CASE("The truth of a rolling shutter is the pose when the object's rows were exposed")
{
  // Near the image's upper border, 19.5 pixels to the right a frame.
  const meshFiles::TemporaryFolder folder;
  std::string poses;
  for (int i = 0; i < 12; ++i) {
    poses += "1 0 0 0 1 0 0 0 1 " + std::to_string(30 * i - 150) + " -110 1000\n";
  }
  SceneOptions options = generateChecks::options(folder.path("data"), "bands", "regular", 10);
  options.width = 640;
  options.height = 480;
  options.motion = folder.write("poses.txt", poses);
  options.effects = {"rolling-shutter"};
  const Scene scene(options);
  for (int frame = 3; frame < 9; frame += 2) {
    const Eigen::Vector2d seen = middleOf(render(scene, frame));
    const Eigen::Vector2d truth = middleAt(scene, scene.pose(frame));
    const Eigen::Vector2d middle = middleAt(scene, scene.motion().pose(frame));
    INFO(frame);
    CHECK((seen - truth).norm() < 0.5);
    CHECK(middle.x() - seen.x() == Approx(19.5 * 0.9 * (0.5 - seen.y() / 480.)).margin(0.5));
    CHECK(middle.x() - seen.x() > 2.5);
  }
}

TEST_CASE("An exposure blurs what moves, and leaves the rest as it is")
{
  const meshFiles::TemporaryFolder folder;
  SceneOptions options = generateChecks::options(folder.path("data"), "bands", "regular", 8);
  options.motion = "handheld";
  options.motionScale = 2.;
  const cv::Mat sharp = render(Scene(options), 5);
  options.effects = {"exposure"};
  const cv::Mat blurred = render(Scene(options), 5);
  cv::Mat sharpEdges;
  cv::Mat blurredEdges;
  cv::Laplacian(sharp, sharpEdges, CV_32F);
  cv::Laplacian(blurred, blurredEdges, CV_32F);
  CHECK(cv::norm(blurredEdges) < 0.6 * cv::norm(sharpEdges));
  CHECK(blurred.at<cv::Vec3b>(2, 2) == sharp.at<cv::Vec3b>(2, 2));
  CHECK((middleOf(blurred) - middleOf(sharp)).norm() < 1.);
}

TEST_CASE("Colours of a Bayer pattern are right where they are even, and wrong at thin lines")
{
  const cv::Mat image = flat(cv::Scalar(40., 90., 200.));
  CHECK(cv::norm(processed({"bayer"}, image), image, cv::NORM_INF) < 1.);
  cv::Mat line = flat(cv::Scalar::all(20.));
  line.col(80).setTo(cv::Scalar::all(220.));
  std::vector<cv::Mat> channels;
  cv::split(processed({"bayer"}, line), channels);
  CHECK(cv::norm(channels[0], channels[2], cv::NORM_INF) > 50.);
}

TEST_CASE("A lens is darker in the corners and less sharp, a sensor noisier where it is bright")
{
  const cv::Mat image = flat(cv::Scalar::all(200.));
  const cv::Mat shaded = processed({"vignetting"}, image);
  CHECK(shaded.at<cv::Vec3f>(60, 80)[0] == Approx(200.).margin(0.5));
  CHECK(shaded.at<cv::Vec3f>(0, 0)[1] < 165.F);
  const double bright = deviation(processed({"noise"}, image)).at<double>(0);
  const double dark = deviation(processed({"noise"}, flat(cv::Scalar::all(10.)))).at<double>(0);
  CHECK(bright == Approx(std::sqrt(1.5 * 1.5 + 20.)).epsilon(0.05));
  CHECK(dark == Approx(std::sqrt(1.5 * 1.5 + 1.)).epsilon(0.05));
  cv::Mat step = flat(cv::Scalar::all(0.));
  step.colRange(80, 160).setTo(cv::Scalar::all(200.));
  CHECK(processed({"defocus"}, step).at<cv::Vec3f>(60, 79)[0] > 0.);
}

TEST_CASE("Brightness and colours drift slowly, by a few percent")
{
  const cv::Mat image = flat(cv::Scalar::all(100.));
  double least = 1e9;
  double most = 0.;
  float before = 0.F;
  for (int frame = 0; frame < 100; ++frame) {
    const cv::Vec3f color = processed({"drift"}, image, frame).at<cv::Vec3f>(7, 7);
    least = std::min(least, double(color[1]));
    most = std::max(most, double(color[1]));
    CHECK((frame == 0 || std::abs(color[1] - before) < 2.F));
    CHECK(std::abs(color[0] - color[2]) < 12.F);
    before = color[1];
  }
  CHECK(least > 80.);
  CHECK(most < 120.);
  CHECK(most - least > 10.);
}

TEST_CASE("Compression changes what is fine, not what is even")
{
  CHECK(cv::norm(processed({"jpeg"}, flat(cv::Scalar::all(77.))), flat(cv::Scalar::all(77.)), cv::NORM_INF) < 2.);
  cv::Mat fine = flat(cv::Scalar::all(50.));
  for (int i = 0; i < fine.rows; ++i) {
    fine.at<cv::Vec3f>(i, (i * 7) % fine.cols) = cv::Vec3f(250.F, 10.F, 10.F);
  }
  CHECK(cv::norm(processed({"jpeg"}, fine), fine, cv::NORM_INF) > 20.);
}

TEST_CASE("A lamp's points are near the light's direction, and few of them spread over all of it")
{
  const bench::Light light;
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  double farthest = 0.;
  for (int i = 4; i < 9; ++i) {
    const Eigen::Vector3d point = bench::lampPoint(light, i).toLight;
    CHECK(point.dot(light.toLight) > std::cos(0.11));
    farthest = std::max(farthest, std::acos(point.dot(light.toLight)));
    mean += 0.2 * point;
  }
  CHECK(farthest > 0.06);
  CHECK((mean - light.toLight).norm() < 0.04);
}

TEST_CASE("Highlights make spots on the object that are much brighter, and darken nothing")
{
  const meshFiles::TemporaryFolder folder;
  SceneOptions options = generateChecks::options(folder.path("data"), "figurine", "regular", 3);
  const cv::Mat matte = render(Scene(options), 1);
  options.effects = {"highlights"};
  const cv::Mat glossy = render(Scene(options), 1);
  cv::Mat brighter;
  cv::subtract(glossy, matte, brighter, cv::noArray(), CV_16S);
  double least = 0.;
  double most = 0.;
  cv::minMaxLoc(brighter.reshape(1), &least, &most);
  CHECK(most > 60.);
  CHECK(least > -20.); // A smaller spot, where the wide one of the matte surface was.
}

TEST_CASE("Effects are named in the scene's name, unknown ones and two shutters are refused")
{
  const meshFiles::TemporaryFolder folder;
  SceneOptions options = generateChecks::options(folder.path("data"), "box", "occlusion", 3);
  options.effects = {"bayer", "jpeg"};
  options.motion = "handheld";
  CHECK(bench::sceneName(options) == "box_handheld_bayer+jpeg_occlusion");
  options.effects = bench::effectNames();
  CHECK(bench::sceneName(options) == "box_handheld_webcam_occlusion");
  options.effects = {"rain"};
  CHECK_THROWS_WITH(Scene(options), ContainsSubstring("'rain'"));
  options.effects = {"exposure"};
  options.variant = "blur";
  CHECK_THROWS_WITH(Scene(options), ContainsSubstring("shutter of its own"));
}
