// SPDX-License-Identifier: GPL-2.0-or-later
#include <catchMain.h>
#include <processorTime.h>

#include "datasetFolder.h"

#include "dataset/largestDistance.h"
#include "check/setupCheck.h"
#include "dataset/datasetFiles.h"
#include "evaluate/imageStore.h"
#include "frames/frameReader.h"
#include "frames/videoFile.h"

#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

// Data sets that are odd, but not broken.

namespace {
using bench::openSequence;
using bench::Sequence;

const std::string scene = "test/000001/";

// A scene of twelve images of object 5. \param truth Member of scene_gt.json for an image.
template <typename Truth> void putLongScene(const DatasetFolder &folder, const Truth &truth)
{
  std::string cameras = "{", truths = "{";
  for (int i = 0; i < 12; ++i) {
    const std::string number = "\"" + std::to_string(i) + "\": ";
    const std::string separator = i == 0 ? "" : ", ";
    cameras += separator + number + R"({"cam_K": [570, 0, 320, 0, 570, 240, 0, 0, 1]})";
    truths += separator + number + "[" + truth(i) + "]";
    const std::string name = std::to_string(100000 + i).substr(1);
    folder.put(scene + "rgb/0" + name + ".png");
  }
  folder.put(scene + "scene_camera.json", cameras + "}");
  folder.put(scene + "scene_gt.json", truths + "}");
}

std::string truthAt(const std::string &z, const std::string &rotation = "[1, 0, 0, 0, 1, 0, 0, 0, 1]")
{
  return R"({"cam_R_m2c": )" + rotation + R"(, "cam_t_m2c": [0, 0, )" + z + R"(], "obj_id": 5})";
}

// A JPEG file with an orientation tag after its first two bytes.
std::string withOrientation(const std::string &jpeg, char orientation)
{
  const std::string tiff("MM\0\x2a\0\0\0\x08\0\x01\x01\x12\0\x03\0\0\0\x01\0", 19);
  const std::string exif = std::string("Exif\0\0", 6) + tiff + orientation + std::string("\0\0\0\0\0\0", 6);
  const std::string length = {'\0', static_cast<char>(exif.size() + 2)};
  return jpeg.substr(0, 2) + "\xFF\xE1" + length + exif + jpeg.substr(2);
}

std::string encoded(const std::string &extension, const cv::Mat &image)
{
  std::vector<unsigned char> bytes;
  cv::imencode(extension, image, bytes);
  return std::string(bytes.begin(), bytes.end());
}
} // namespace

TEST_CASE("A frame with the object behind the camera is one without truth", "[files]")
{
  const DatasetFolder folder;
  putBopModels(folder);
  putLongScene(folder, [](int i) { return truthAt(i == 7 ? "-400" : "500"); });
  const Sequence sequence = openSequence(folder.path(), "1", 5);
  REQUIRE(sequence.frames.size() == 12);
  CHECK_FALSE(sequence.frames[7].hasTruth);
  CHECK(sequence.frames[7].visibility == exactly(0.));
  CHECK(sequence.frames[8].hasTruth);
  CHECK(sequence.notes.empty());
}

TEST_CASE("One frame of many that cannot be read is left out with a note, many are refused", "[files]")
{
  const DatasetFolder folder;
  putBopModels(folder);
  putLongScene(folder, [](int i) {
    return truthAt("500", i == 7 ? "[2, 0, 0, 0, 1, 0, 0, 0, 1]" : "[1, 0, 0, 0, 1, 0, 0, 0, 1]");
  });
  const Sequence broken = openSequence(folder.path(), "1", 5);
  REQUIRE(broken.frames.size() == 12);
  CHECK_FALSE(broken.frames[7].hasTruth);
  REQUIRE(broken.notes.size() == 1);
  CHECK_THAT(broken.notes[0], ContainsSubstring("scene_gt.json") && ContainsSubstring("'7'"));

  putLongScene(folder, [](int) { return truthAt("500"); });
  folder.remove(scene + "rgb/000004.png");
  const Sequence lost = openSequence(folder.path(), "1", 5);
  CHECK(lost.frames.size() == 11);
  REQUIRE(lost.notes.size() == 1);
  CHECK_THAT(lost.notes[0], ContainsSubstring("000004.png"));
  folder.remove(scene + "rgb/000005.png");
  CHECK_THAT(messageOf([&] { openSequence(folder.path(), "1", 5); }),
             ContainsSubstring("2 of 12") && ContainsSubstring("000004.png"));
}

TEST_CASE("Each sensor of a scene is a scene", "[files]")
{
  const DatasetFolder folder;
  putBop(folder);
  for (const std::string name : {"scene_gt", "scene_camera", "scene_gt_info"}) {
    std::filesystem::copy(folder.path(scene + name + ".json"), folder.path(scene + name + "_left.json"));
    std::filesystem::rename(folder.path(scene + name + ".json"), folder.path(scene + name + "_right.json"));
  }
  std::filesystem::copy(folder.path(scene + "rgb"), folder.path(scene + "gray_left"));
  std::filesystem::rename(folder.path(scene + "rgb"), folder.path(scene + "rgb_right"));
  CHECK(bench::listScenes(folder.path()) == std::vector<std::string>{"test/000001@left", "test/000001@right"});
  const Sequence left = openSequence(folder.path(), "000001@left", 5);
  CHECK(left.frames.size() == 3);
  CHECK_THAT(left.frames[0].image, ContainsSubstring("gray_left"));
  CHECK_THAT(messageOf([&] { openSequence(folder.path(), "1", 5); }), ContainsSubstring("several scenes"));
}

TEST_CASE("An .obj in millimetres is told by the diameter in models_info.json", "[files]")
{
  const DatasetFolder folder;
  putBop(folder);
  folder.put("models/obj_000005.obj", meshFiles::obj(smallBox()));
  bench::SequenceObject object = openSequence(folder.path(), "1", 5).object;
  CHECK(object.mesh == folder.path("models/obj_000005.obj"));
  CHECK(object.meshUnit == exactly(0.001));
  CHECK(object.diameter == Approx(0.075));
  folder.put("models/obj_000005.obj", meshFiles::obj(smallBox(0.0254)));
  object = openSequence(folder.path(), "1", 5).object;
  CHECK(object.mesh == folder.path("models/obj_000005.ply"));
  folder.remove("models/obj_000005.ply");
  CHECK_THAT(messageOf([&] { openSequence(folder.path(), "1", 5); }),
             ContainsSubstring("obj_000005.obj") && ContainsSubstring("models_info.json"));
}

TEST_CASE("An orientation tag does not turn the pixels of an image", "[files]")
{
  const DatasetFolder folder;
  cv::Mat image(48, 64, CV_8UC3, cv::Scalar(0, 0, 0));
  image(cv::Rect(0, 0, 16, 16)).setTo(cv::Scalar(255, 255, 255));
  const std::string jpeg = encoded(".jpg", image);
  for (const char orientation : {'\1', '\3', '\6'}) {
    CAPTURE(static_cast<int>(orientation));
    const std::string file = folder.put("turned.jpg", withOrientation(jpeg, orientation));
    if (orientation != '\1') { // The tag is one that OpenCV follows where it is left to.
      const cv::Mat turned = cv::imread(file);
      CHECK((turned.cols != 64 || turned.at<cv::Vec3b>(4, 4)[0] < 128));
    }
    const cv::Mat read = programs::readColorImage(file);
    REQUIRE(read.cols == 64);
    CHECK(read.at<cv::Vec3b>(4, 4)[0] > 200);
    CHECK(read.at<cv::Vec3b>(40, 60)[0] < 50);
  }
}

TEST_CASE("Every program sees the pixels of an image as they are stored, with the brightness that they have", "[files]")
{
  const DatasetFolder folder;
  cv::Mat image(48, 64, CV_8UC3, cv::Scalar(0, 0, 0));
  image(cv::Rect(0, 0, 16, 16)).setTo(cv::Scalar(255, 255, 255));
  folder.put("turned0.jpg", withOrientation(encoded(".jpg", image), '\6'));
  cv::Mat deep(48, 64, CV_16UC1, cv::Scalar(0));
  deep(cv::Rect(0, 0, 16, 16)).setTo(cv::Scalar(4095));
  folder.put("deep0.png", encoded(".png", deep));
  for (const char *pattern : {"turned%d.jpg", "deep%d.png"}) {
    CAPTURE(pattern);
    programs::FrameSource source;
    source.images = folder.path(pattern);
    vpImage<vpRGBa> I;
    REQUIRE(programs::openFrames(source)->next(I));
    REQUIRE(I.getWidth() == 64);
    CHECK(I[4][4].R > 200);
    CHECK(I[40][60].R < 50);
    programs::Setup setup;
    setup.image = bench::numberedPath(folder.path(pattern), 0);
    const std::vector<std::string> lines = programs::checkSetup(setup).lines;
    CHECK(std::any_of(lines.begin(), lines.end(), [](const std::string &line) {
      return line.find("64 x 48") != std::string::npos && line.find("brightness 21") != std::string::npos;
    }));
  }
}

TEST_CASE("Images of more than eight bits keep their brightness, the same in a sequence", "[files]")
{
  const DatasetFolder folder;
  const auto write = [&](const std::string &name, int value) {
    cv::Mat image(8, 8, CV_16UC1, cv::Scalar(0));
    image.at<unsigned short>(2, 3) = static_cast<unsigned short>(value);
    return folder.put(name, encoded(".png", image));
  };
  for (const auto &[largest, bits] : {std::pair<int, int>{1000, 10}, {4095, 12}, {16000, 14}, {65535, 16}}) {
    programs::ImageDepth depth;
    const cv::Mat image = programs::readColorImage(write("deep.png", largest), depth);
    CHECK(depth.bits == bits);
    CHECK(static_cast<int>(image.at<cv::Vec3b>(2, 3)[1]) == cvRound(255. * largest / ((1 << bits) - 1)));
  }
  programs::ImageDepth depth;
  programs::readColorImage(write("first.png", 4000), depth);
  const cv::Mat darker = programs::readColorImage(write("darker.png", 500), depth);
  CHECK(static_cast<int>(darker.at<cv::Vec3b>(2, 3)[0]) == 31);
  CHECK_THAT(messageOf([&] { programs::readColorImage(write("brighter.png", 5000), depth); }),
             ContainsSubstring("brighter.png") && ContainsSubstring("12 bits"));
}

TEST_CASE("A video of pictures of odd sizes keeps their last row and column", "[files]")
{
  const DatasetFolder folder;
  cv::Mat picture(49, 63, CV_8UC3, cv::Scalar(0, 0, 0));
  picture.row(48).setTo(cv::Scalar(255, 255, 255));
  picture.col(62).setTo(cv::Scalar(255, 255, 255));
  std::string file;
  {
    programs::VideoFile video("--save", folder.path("odd.avi"), 25.); // Whole when it is closed.
    video.write(picture, 0);
    video.write(picture, 1);
    file = video.file();
  }
  programs::FrameSource source;
  source.video = file;
  vpImage<vpRGBa> I;
  REQUIRE(programs::openFrames(source)->next(I));
  REQUIRE((I.getWidth() == 64 && I.getHeight() == 50)); // Encoders take even sizes.
  CHECK(I[48][30].G > 150);
  CHECK(I[20][62].G > 150);
  CHECK(I[20][30].G < 100);
}

TEST_CASE("A gap in the numbers of a recording is no end", "[files]")
{
  const DatasetFolder folder;
  bench::Recording recording;
  for (const char *number : {"0", "1", "3"}) {
    folder.put(std::string("image") + number + ".png");
    folder.put(std::string("pose") + number + ".txt", "1 0 0 0  0 1 0 0  0 0 1 0.5  0 0 0 1");
  }
  recording.images = folder.path("image%d.png");
  recording.poses = folder.path("pose%d.txt");
  recording.model = folder.put("box.obj", meshFiles::obj(smallBox(0.001)));
  recording.camera =
      folder.put("camera.xml", "<conf><camera><px>1000</px><py>1000</py><u0>320</u0><v0>240</v0></camera></conf>");
  CHECK_THAT(messageOf([&] { bench::openRecording(recording); }),
             ContainsSubstring("image2.png") && ContainsSubstring("image3.png"));
  // What tracks and what evaluates see the same frames, or the same gap.
  programs::FrameSource source;
  source.images = recording.images;
  CHECK_THAT(messageOf([&] { programs::openFrames(source); }),
             ContainsSubstring("image2.png") && ContainsSubstring("image3.png"));
  recording.last = source.last = 1;
  CHECK(bench::openRecording(recording).frames.size() == 2);
  CHECK(programs::openFrames(source)->last() == 1);
  recording.first = source.first = 1;
  recording.last = source.last = 3;
  recording.step = source.step = 2;
  CHECK(bench::openRecording(recording).frames.back().id == 3);
  CHECK(programs::openFrames(source)->last() == 3);
}

TEST_CASE("The largest distance of 200,000 points of a ball takes seconds", "[files]")
{
  std::vector<Eigen::Vector3d> points;
  unsigned int state = 1;
  const auto next = [&state] {
    return static_cast<double>(state = state * 1664525U + 1013904223U) / 4294967296. - 0.5;
  };
  while (points.size() < 200000) {
    const Eigen::Vector3d point(next(), next(), next());
    if (point.norm() > 1e-3) {
      points.push_back(point.normalized());
    }
  }
  const double start = processorTime();
  CHECK(programs::largestDistance(points) == Approx(2.).margin(1e-4));
  CHECK(processorTime() - start < 20.);
  points.resize(300);
  double largest = 0.;
  for (const Eigen::Vector3d &a : points) {
    for (const Eigen::Vector3d &b : points) {
      largest = std::max(largest, (a - b).norm());
    }
  }
  CHECK(programs::largestDistance(points) == Approx(largest).epsilon(1e-12));
}
