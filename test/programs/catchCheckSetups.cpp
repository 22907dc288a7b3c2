// SPDX-License-Identifier: GPL-2.0-or-later
// multicue-check on a set-up that is right, and on those that are broken in the ways in which they often are.
#include <catchMain.h>

#include "chiralObject.h"

#include "check/setupCheck.h"
#include "frames/imageFile.h"
#include "frames/videoFile.h"

#include <meshFiles.h>

#include <visp3/core/vpPoseVector.h>

#include <filesystem>
#include <sstream>

namespace {
using meshFiles::TemporaryFolder;
using programs::checkSetup;
using programs::Setup;
using Change = chiralObject::Change;

std::string cameraXml(double px = 600., double u0 = 319.5, double v0 = 239.5, unsigned int width = 640,
                      unsigned int height = 480)
{
  std::ostringstream text;
  text << "<conf><camera><width>" << width << "</width><height>" << height << "</height><px>" << px << "</px><py>" << px
       << "</py><u0>" << u0 << "</u0><v0>" << v0 << "</v0></camera></conf>";
  return text.str();
}

std::string poseText(const vpHomogeneousMatrix &cMo, double perMetre = 1., double perRadian = 1.)
{
  const vpPoseVector pose(cMo);
  std::ostringstream text;
  text.precision(12);
  for (unsigned int i = 0; i < 6; ++i) {
    text << pose[i] * (i < 3 ? perMetre : perRadian) << "\n";
  }
  return text.str();
}

// A set-up with all files, that is right until a part of it is exchanged.
struct Files
{
  TemporaryFolder folder;
  Setup setup;

  Files()
  {
    setMesh(Change());
    setup.config = folder.write("camera.xml", cameraXml());
    setup.image = chiralObject::writeImage(folder.path("image.png"), chiralObject::pose());
    setPose(poseText(chiralObject::pose()));
  }
  void setMesh(const Change &change) { setup.model = chiralObject::write(folder.path("object.obj"), change); }
  void setConfig(const std::string &text) { setup.config = folder.write("camera.xml", text); }
  void setPose(const std::string &text) { setup.pose = folder.write("start.pos", text); }

  // What is wrong with it, in the words of its one line.
  std::string fault() const
  {
    const programs::CheckReport report = checkSetup(setup);
    std::string all;
    for (const std::string &line : report.faults) {
      CHECK(line.find('\n') == std::string::npos);
      all += (all.empty() ? "" : " | ") + line;
    }
    INFO(all);
    CHECK(report.faults.size() == 1);
    return all;
  }
};

Change scaled(double scale)
{
  Change change;
  change.scale = scale;
  return change;
}
} // namespace

TEST_CASE("A set-up that is right has no fault, and a line for each topic", "[check]")
{
  Files files;
  files.setup.overlay = files.folder.path("overlay.png");
  const programs::CheckReport report = checkSetup(files.setup);
  std::string all;
  for (const std::string &line : report.lines) {
    all += line + "\n";
  }
  INFO(all);
  CHECK(report.faults.empty());
  for (const std::string topic : {"model ", "mesh ", "edges ", "camera ", "image ", "start ", "renderer ", "cue edge",
                                  "cue point", "cue color", "overlay "}) {
    CHECK_THAT(all, ContainsSubstring(topic));
  }
  CHECK(std::filesystem::file_size(files.setup.overlay) > 10000);
}

TEST_CASE("Without image and pose the model and the camera are checked", "[check]")
{
  Files files;
  files.setup.image = files.setup.pose = "";
  CHECK(checkSetup(files.setup).faults.empty());
  files.setup.config = "";
  CHECK_THAT(files.fault(), ContainsSubstring("says no camera"));
}

TEST_CASE("Models that are broken are named", "[check]")
{
  Files files;
  SECTION("missing")
  {
    files.setup.model = files.folder.path("none.obj");
    CHECK_THAT(files.fault(), ContainsSubstring("model: ") && ContainsSubstring("none.obj"));
  }
  SECTION("empty")
  {
    files.setup.model = files.folder.write("empty.obj", "# nothing\n");
    CHECK_THAT(files.fault(), ContainsSubstring("empty.obj"));
  }
  SECTION("none given")
  {
    files.setup.model = "";
    CHECK_THAT(files.fault(), ContainsSubstring("give --model"));
  }
  SECTION("a mesh in millimetres that is read in metres")
  {
    files.setMesh(scaled(1000.));
    CHECK_THAT(files.fault(), ContainsSubstring("unit"));
  }
  SECTION("a mesh in centimetres that is read in metres")
  {
    files.setMesh(scaled(100.));
    CHECK_THAT(files.fault(), ContainsSubstring("unit is wrong"));
  }
  SECTION("a mesh in centimetres that is read in millimetres")
  {
    files.setMesh(scaled(100.));
    files.setup.metresPerUnit = 0.001;
    CHECK_THAT(files.fault(), ContainsSubstring("unit is wrong") && ContainsSubstring("10 times as large"));
  }
  SECTION("mirrored")
  {
    Change change;
    change.stretch[1] = -1.;
    change.isMirroredBack = true;
    files.setMesh(change);
    CHECK_THAT(files.fault(), ContainsSubstring("mesh is mirrored"));
  }
  SECTION("with a hole")
  {
    Change change;
    change.leftOut = 2;
    files.setMesh(change);
    CHECK_THAT(files.fault(), ContainsSubstring("1 holes, 4 border edges"));
  }
  SECTION("with an origin far away")
  {
    Change change;
    change.shift = Eigen::Vector3d(3., 0., 0.);
    files.setMesh(change);
    CHECK_THAT(files.fault(), ContainsSubstring("origin: "));
  }
}

TEST_CASE("Cameras and configurations that are broken are named", "[check]")
{
  Files files;
  SECTION("missing")
  {
    files.setup.config = files.folder.path("none.xml");
    CHECK_THAT(files.fault(), ContainsSubstring("none.xml"));
  }
  SECTION("with a misspelt key")
  {
    files.setup.config = files.folder.write("a.json", R"({"camera": {"px": 600, "py": 600, "u0": 320, "vo": 240}})");
    CHECK_THAT(files.fault(), ContainsSubstring("'vo' is not known in 'camera'"));
  }
  SECTION("without a camera")
  {
    files.setup.config = files.folder.write("a.json", R"({"preset": "robust"})");
    CHECK_THAT(files.fault(), ContainsSubstring("says no camera"));
  }
  SECTION("of images of another size")
  {
    files.setConfig(cameraXml(1200., 639.5, 479.5, 1280, 960));
    CHECK_THAT(files.fault(), ContainsSubstring("camera: ") && ContainsSubstring("1280 x 960"));
  }
  SECTION("of images of another size that is not said")
  {
    files.setConfig("<conf><camera><px>1200</px><py>1200</py><u0>639.5</u0><v0>479.5</v0></camera></conf>");
    CHECK_THAT(files.fault(), ContainsSubstring("principal point"));
  }
  SECTION("with focal lengths that are no pixels")
  {
    files.setConfig(cameraXml(4.2));
    CHECK_THAT(files.fault(), ContainsSubstring("degrees across"));
  }
  SECTION("with another focal length")
  {
    files.setConfig(cameraXml(900.));
    CHECK_THAT(files.fault(), ContainsSubstring("times the focal length"));
  }
}

TEST_CASE("Images that are broken are named", "[check]")
{
  Files files;
  SECTION("missing")
  {
    files.setup.image = files.folder.path("none.png");
    CHECK_THAT(files.fault(), ContainsSubstring("image: ") && ContainsSubstring("none.png"));
  }
  SECTION("black")
  {
    vpImageIo::write(vpImage<unsigned char>(480, 640, 0), files.setup.image);
    CHECK_THAT(files.fault(), ContainsSubstring("shows nothing"));
  }
  SECTION("a video that is none")
  {
    files.setup.image.clear();
    files.setup.video = files.folder.write("none.mp4", "no video");
    CHECK_THAT(files.fault(), ContainsSubstring("video: ") && ContainsSubstring("none.mp4"));
  }
}

TEST_CASE("A start is checked in the first image of a video, too", "[check]")
{
  Files files;
  files.setup.video = files.folder.path("object.avi");
  programs::VideoFile("--save", files.setup.video, 25.).write(programs::readColorImage(files.setup.image), 0);
  files.setup.image.clear();
  CHECK(checkSetup(files.setup).faults.empty());
}

TEST_CASE("Without a pose the overlay is the image, to read places of points from", "[check]")
{
  Files files;
  files.setup.pose.clear();
  files.setup.overlay = files.folder.path("seen.png");
  CHECK(checkSetup(files.setup).faults.empty());
  const cv::Mat image = programs::readColorImage(files.setup.image);
  CHECK(cv::norm(programs::readColorImage(files.setup.overlay), image, cv::NORM_INF) < 0.5);
  files.setup.pose = files.folder.path("none.pos");
  files.setup.overlay = files.folder.path("again.png");
  CHECK(checkSetup(files.setup).faults.size() == 1);
  CHECK(cv::norm(programs::readColorImage(files.setup.overlay), image, cv::NORM_INF) < 0.5);
}

TEST_CASE("Starts that are broken are named", "[check]")
{
  Files files;
  const vpHomogeneousMatrix good = chiralObject::pose();
  SECTION("missing")
  {
    files.setup.pose = files.folder.path("none.pos");
    CHECK_THAT(files.fault(), ContainsSubstring("start: ") && ContainsSubstring("none.pos"));
  }
  SECTION("behind the camera")
  {
    files.setPose(poseText(vpHomogeneousMatrix(0., 0., -1.2, 0., 0., 0.) * good));
    CHECK_THAT(files.fault(), ContainsSubstring("behind the camera"));
  }
  SECTION("with OpenGL's axes")
  {
    files.setPose(poseText(vpHomogeneousMatrix(0., 0., 0., M_PI, 0., 0.) * good));
    CHECK_THAT(files.fault(), ContainsSubstring("behind the camera") && ContainsSubstring("OpenGL's axes"));
  }
  SECTION("beside the image")
  {
    files.setPose(poseText(vpHomogeneousMatrix(0.5, 0., 0., 0., 0., 0.) * good));
    CHECK_THAT(files.fault(), ContainsSubstring("0 % of the object's box is in the image"));
  }
  SECTION("in millimetres")
  {
    files.setPose(poseText(good, 1000.));
    CHECK_THAT(files.fault(), ContainsSubstring("too small") && ContainsSubstring("translation is divided"));
  }
  SECTION("in degrees")
  {
    files.setPose(poseText(good, 1., 180. / M_PI));
    CHECK_THAT(files.fault(), ContainsSubstring("not in degrees"));
  }
  SECTION("inverted")
  {
    files.setPose(poseText(good.inverse()));
    CHECK_THAT(files.fault(), ContainsSubstring("pose is inverted"));
  }
  SECTION("for a model with other axes")
  {
    files.setPose(poseText(good * vpHomogeneousMatrix(0., 0., 0., M_PI / 2., 0., 0.)));
    CHECK_THAT(files.fault(), ContainsSubstring("axes are others") && ContainsSubstring("-90 degrees about its x"));
  }
  SECTION("of another image")
  {
    files.setPose(poseText(good * vpHomogeneousMatrix(0.02, 0., 0., 0.5, 0.6, -0.7)));
    CHECK_THAT(files.fault(), ContainsSubstring("does not show the object"));
  }
}
