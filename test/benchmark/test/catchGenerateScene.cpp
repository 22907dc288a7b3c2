// SPDX-License-Identifier: GPL-2.0-or-later
#include <catchMain.h>

#include "generate/variants.h"
#include "generateChecks.h"

#include <visp3/core/vpException.h>
#include <visp3/se3/vpExactNumber.h>

#include <algorithm>

using bench::Scene;
using bench::SceneOptions;
using generateChecks::bytesOf;
using programs::BopFrame;

namespace {
std::vector<std::string> filesOf(const SceneOptions &options)
{
  const std::string scene = options.dataset + "/" + bench::sceneName(options);
  std::vector<std::string> bytes;
  for (const char *name :
       {"/scene_gt.json", "/scene_gt_info.json", "/scene_camera.json", "/rgb/000000.png", "/rgb/000003.png"}) {
    bytes.push_back(bytesOf(scene + name));
    CHECK(bytes.back().size() > 10);
  }
  return bytes;
}

double visibility(const BopFrame &frame)
{
  return double(frame.pixelsVisible) / frame.pixelsAll;
}

//! Lengths of the runs of frames in which the object is not seen.
std::vector<int> hiddenRuns(const std::vector<BopFrame> &frames, double limit)
{
  std::vector<int> runs;
  int length = 0;
  for (const BopFrame &frame : frames) {
    if (visibility(frame) <= limit) {
      ++length;
    } else if (length > 0) {
      runs.push_back(length);
      length = 0;
    }
  }
  return runs;
}

bool isOutside(const Scene &scene, int frame)
{
  const std::vector<Eigen::Vector2d> pixels =
      generateChecks::project(*scene.object().model, scene.pose(frame), scene.camera().cam);
  const double bottom = scene.options().height - 0.5;
  const auto all = [&](auto condition) { return std::all_of(pixels.begin(), pixels.end(), condition); };
  return all([](const Eigen::Vector2d &p) { return p.y() < -0.5; }) ||
         all([bottom](const Eigen::Vector2d &p) { return p.y() > bottom; });
}

struct MotionRange
{
  double least = 1e9;
  double most = 0.;
  double largestChange = 0.;
  Eigen::Vector2d low = Eigen::Vector2d::Constant(1e9);
  Eigen::Vector2d high = Eigen::Vector2d::Constant(-1e9);
};

MotionRange rangeOf(const Scene &scene)
{
  MotionRange range;
  std::vector<Eigen::Vector2d> before;
  double lastMotion = 0.;
  for (int frame = 0; frame < scene.options().frames; ++frame) {
    const std::vector<Eigen::Vector2d> pixels =
        generateChecks::project(*scene.object().model, scene.pose(frame), scene.camera().cam);
    double motion = 0.;
    for (std::size_t i = 0; i < pixels.size(); ++i) {
      range.low = range.low.cwiseMin(pixels[i]);
      range.high = range.high.cwiseMax(pixels[i]);
      motion += before.empty() ? 0. : (pixels[i] - before[i]).norm() / static_cast<double>(pixels.size());
    }
    if (frame > 0) {
      range.least = std::min(range.least, motion);
      range.most = std::max(range.most, motion);
    }
    if (frame > 1) {
      range.largestChange = std::max(range.largestChange, std::abs(motion - lastMotion));
    }
    lastMotion = motion;
    before = pixels;
  }
  return range;
}
} // namespace

TEST_CASE("The same seed gives the same bytes with any number of threads, another seed gives others")
{
  const meshFiles::TemporaryFolder folder;
  for (const std::string variant : {"noise", "occlusion", "webcam"}) {
    SceneOptions options = generateChecks::options(folder.path("first"), "box", variant, 6);
    bench::generateScene(options);
    const std::vector<std::string> first = filesOf(options);
    options.dataset = folder.path("second");
    options.jobs = 3;
    bench::generateScene(options);
    CHECK(filesOf(options) == first);
    CHECK(bytesOf(folder.path("first/models/obj_000001_0.png")) ==
          bytesOf(folder.path("second/models/obj_000001_0.png")));
    options.seed = 2;
    bench::generateScene(options);
    const std::vector<std::string> other = filesOf(options);
    CHECK(other[0] != first[0]);
    CHECK(other[3] != first[3]);
  }
}

TEST_CASE("All objects move by 4 to 8 pixels between frames, smoothly, and stay in the image")
{
  const meshFiles::TemporaryFolder folder;
  for (const std::string &object : bench::objectNames()) {
    SceneOptions options = generateChecks::options(folder.path("data"), object, "regular", 300);
    options.width = 640;
    options.height = 480;
    const MotionRange range = rangeOf(Scene(options));
    INFO(object << ": " << range.least << " to " << range.most << ", changes of " << range.largestChange);
    CHECK(range.least >= 4.);
    CHECK(range.most <= 8.);
    CHECK(range.largestChange < 0.5);
    CHECK(range.low.minCoeff() > 0.);
    CHECK(range.high.x() < 639.);
    CHECK(range.high.y() < 479.);
  }
}

TEST_CASE("Variants have the motion of the regular sequence")
{
  const meshFiles::TemporaryFolder folder;
  const Scene regular(generateChecks::options(folder.path("data"), "box", "regular", 20));
  for (const std::string &variant : bench::variantNames()) {
    const Scene scene(generateChecks::options(folder.path("data"), "box", variant, 20));
    const bool same = vpIsSame(scene.motion().pose(11.).data[3], regular.motion().pose(11.).data[3]);
    CHECK(same == (variant != "exit"));
  }
}

TEST_CASE("All faces of the box are seen within 300 frames")
{
  const meshFiles::TemporaryFolder folder;
  const Scene scene(generateChecks::options(folder.path("data"), "box", "regular", 300));
  std::vector<int> seen(scene.object().model->faces().size(), 0);
  REQUIRE(seen.size() == 6);
  for (int frame = 0; frame < 300; ++frame) {
    const vpHomogeneousMatrix oMc = scene.pose(frame).inverse();
    const Eigen::Vector3d eye(oMc[0][3], oMc[1][3], oMc[2][3]);
    for (std::size_t i = 0; i < seen.size(); ++i) {
      const vpModelFace &face = scene.object().model->faces()[i];
      const Eigen::Vector3d sight = (eye - face.centre).normalized();
      seen[i] += sight.dot(face.normal) > 0.5 ? 1 : 0;
    }
  }
  CHECK(*std::min_element(seen.begin(), seen.end()) > 5);
}

TEST_CASE("An occluder hides some, but never more than 0.4 of the object")
{
  const meshFiles::TemporaryFolder folder;
  const std::vector<BopFrame> frames =
      bench::generateScene(generateChecks::options(folder.path("data"), "box", "occlusion", 150));
  int strongly = 0;
  for (const BopFrame &frame : frames) {
    CHECK(visibility(frame) >= 0.6);
    strongly += visibility(frame) <= 0.8 ? 1 : 0;
  }
  CHECK(strongly > 37);
  CHECK(visibility(frames.front()) > 0.95);
}

TEST_CASE("A board hides the whole object for 10 to 15 frames about every 100 frames")
{
  const meshFiles::TemporaryFolder folder;
  const std::vector<BopFrame> frames =
      bench::generateScene(generateChecks::options(folder.path("data"), "box", "blackout", 180));
  const std::vector<int> runs = hiddenRuns(frames, 0.05);
  REQUIRE(runs.size() == 2);
  for (const int run : runs) {
    CHECK(run >= 10);
    CHECK(run <= 15);
  }
  CHECK(visibility(frames.front()) == exactly(1.));
}

TEST_CASE("Every object leaves the image wholly for 10 to 20 frames about every 100 frames")
{
  const meshFiles::TemporaryFolder folder;
  for (const std::string &object : bench::objectNames()) {
    for (const std::uint64_t seed : {1U, 2U}) {
      SceneOptions options = generateChecks::options(folder.path("data"), object, "exit", 330);
      options.seed = seed;
      const Scene scene(options);
      std::vector<int> runs;
      int length = 0;
      int middle = 0;
      for (int frame = 0; frame < options.frames; ++frame) {
        if (isOutside(scene, frame)) {
          ++length;
        } else if (length > 0) {
          middle = frame - 1 - length / 2;
          runs.push_back(length);
          length = 0;
        }
      }
      INFO(object << " " << seed);
      REQUIRE(runs.size() == 3);
      CHECK(*std::min_element(runs.begin(), runs.end()) >= 10);
      CHECK(*std::max_element(runs.begin(), runs.end()) <= 20);
      bench::ObjectRenderer renderer = scene.makeRenderer();
      BopFrame truth;
      scene.render(middle, renderer, truth);
      CHECK(truth.pixelsVisible == 0);
      CHECK(truth.pixelsAll > 0);
      scene.render(0, renderer, truth);
      CHECK(truth.pixelsVisible == truth.pixelsAll);
    }
  }
}

TEST_CASE("What cannot be made is refused by name")
{
  const meshFiles::TemporaryFolder folder;
  SceneOptions options = generateChecks::options(folder.path("data"), "teapot", "regular", 3);
  CHECK_THROWS_WITH(Scene(options), ContainsSubstring("teapot") && ContainsSubstring("figurine"));
  options = generateChecks::options(folder.path("data"), "box", "fog", 3);
  CHECK_THROWS_WITH(Scene(options), ContainsSubstring("fog") && ContainsSubstring("blackout"));
  options = generateChecks::options(folder.path("data"), "box", "regular", 3);
  options.background = "beach";
  CHECK_THROWS_WITH(Scene(options), ContainsSubstring("beach"));
}
