// SPDX-License-Identifier: GPL-2.0-or-later
#include <catchMain.h>

#include "datasetFolder.h"

#include <recording.h>

namespace {
using bench::openRecording;
using bench::Recording;

const std::string cameraXml =
    "<?xml version=\"1.0\"?>\n<conf><camera><px>700</px><py>690</py><u0>320</u0><v0>240</v0></camera></conf>\n";

// Images 10, 12, 14, of which the second has no pose.
Recording putRecording(const DatasetFolder &folder)
{
  for (const char *number : {"10", "12", "14"}) {
    folder.put(std::string("image-00") + number + ".pgm");
  }
  folder.put("pose-10.txt", "1 0 0 0.1\n0 1 0 0.2\n0 0 1 0.9\n0 0 0 1\n");
  folder.put("pose-14.txt", "0 -1 0 0.1\n1 0 0 0.2\n0 0 1 0.8\n0 0 0 1\n");
  Recording recording;
  recording.images = folder.path("image-%04d.pgm");
  recording.poses = folder.path("pose-%d.txt");
  recording.model = folder.put("box.obj", meshFiles::obj(smallBox()));
  recording.unit = 0.001;
  recording.camera = folder.put("camera.xml", cameraXml);
  recording.first = 10;
  recording.step = 2;
  return recording;
}

Recording castle()
{
  const std::string model = recording::path("mbt-depth/Castle-simu/Models/chateau.cao");
  const std::string folder = model.substr(0, model.rfind("Models"));
  const bool png = vpIoTools::checkFilename(folder + "Images/Image_0001.png"); // .pgm up to ViSP 3.5.
  Recording recording;
  recording.name = "castle";
  recording.images = folder + "Images/Image_%04d" + (png ? ".png" : ".pgm");
  recording.poses = folder + "CameraPose/Camera_%03d.txt";
  recording.model = model;
  recording.camera = folder + "Config/chateau.xml";
  recording.first = 1;
  return recording;
}
} // namespace

TEST_CASE("ViSP's recording of the castle is a sequence", "[dataset]")
{
  Recording recording = castle();
  const bench::Sequence sequence = openRecording(recording);
  CHECK(sequence.scene == "castle");
  CHECK(sequence.frames.size() >= 40);
  CHECK(sequence.frames[0].id == 1);
  CHECK(sequence.frames[0].cam.get_px() == exactly(700.));
  CHECK(sequence.frames[39].hasTruth);
  const vpHomogeneousMatrix truth = recording::pose("mbt-depth/Castle-simu/CameraPose/Camera_%03d.txt", 40);
  CHECK((sequence.frames[39].cMo.getTranslationVector() - truth.getTranslationVector()).frobeniusNorm() < 1e-12);
  CHECK(sequence.object.mesh.empty());
  CHECK(sequence.object.cao == recording.model);
  CHECK(sequence.object.diameter > 0.1);
  CHECK(sequence.object.diameter < 1.);
  recording.last = 11;
  recording.step = 5;
  CHECK(openRecording(recording).frames.size() == 3);
}

TEST_CASE("A recording with gaps in its poses", "[dataset]")
{
  const DatasetFolder folder;
  const bench::Sequence sequence = openRecording(putRecording(folder));
  REQUIRE(sequence.frames.size() == 3);
  CHECK(sequence.frames[0].hasTruth);
  CHECK_FALSE(sequence.frames[1].hasTruth);
  CHECK(sequence.frames[2].hasTruth);
  CHECK(sequence.frames[2].id == 14);
  CHECK(sequence.frames[2].cMo[0][1] == Approx(-1.));
  CHECK(sequence.frames[2].cMo[2][3] == Approx(0.8));
  CHECK(sequence.frames[2].cam.get_py() == exactly(690.));
  CHECK(sequence.object.mesh == folder.path("box.obj"));
  CHECK(sequence.object.diameter == Approx(std::sqrt(60. * 60. + 40. * 40. + 20. * 20.) / 1000.));
}

TEST_CASE("A broken recording ends with the file", "[dataset]")
{
  const DatasetFolder folder;
  Recording recording = putRecording(folder);
  const auto message = [&] { return messageOf([&] { openRecording(recording); }); };
  SECTION("patterns")
  {
    for (const char *pattern : {"image.pgm", "image-%s.pgm", "image-%d-%d.pgm", "image-%", "image-%f.pgm"}) {
      recording.images = folder.path(pattern);
      CHECK_THAT(message(), ContainsSubstring(pattern) && ContainsSubstring("%04d"));
    }
  }
  SECTION("numbers")
  {
    recording.step = 0;
    CHECK_THAT(message(), ContainsSubstring("step"));
  }
  SECTION("too short")
  {
    recording.last = 11;
    CHECK_THAT(message(), ContainsSubstring("1 frames"));
  }
  SECTION("an image is missing")
  {
    recording.last = 16;
    CHECK_THAT(message(), ContainsSubstring("image-0016.pgm") && ContainsSubstring("missing"));
    recording.first = 9;
    CHECK_THAT(message(), ContainsSubstring("image-0009.pgm") && ContainsSubstring("missing"));
  }
  SECTION("the first pose is missing")
  {
    folder.remove("pose-10.txt");
    CHECK_THAT(message(), ContainsSubstring("pose-10.txt") && ContainsSubstring("missing"));
  }
  SECTION("poses")
  {
    const std::vector<std::pair<std::string, std::string>> poses = {
        {"1 0 0 0 0 1 0 0 0 0 1 1", "not 12"},           {"1 0 0 0 0 1 0 0 0 0 1 x 0 0 0 1", "'x'"},
        {"1 0 0 0 0 1 0 0 0 0 1 inf 0 0 0 1", "'inf'"},  {"1 0 0 0 0 1 0 0 0 0 2 1 0 0 0 1", "rotation"},
        {"1 0 0 0 0 1 0 0 0 0 1 1 0 0 1 1", "last row"}, {"1 0 0 0 0 1 0 0 0 0 1 -1 0 0 0 1", "front"},
    };
    for (const auto &pose : poses) {
      folder.put("pose-14.txt", pose.first);
      CHECK_THAT(message(), ContainsSubstring("pose-14.txt") && ContainsSubstring(pose.second));
    }
  }
  SECTION("the model is missing")
  {
    folder.remove("box.obj");
    CHECK_THAT(message(), ContainsSubstring("box.obj") && ContainsSubstring("missing"));
  }
  SECTION("the camera is missing")
  {
    folder.put("camera.xml", "<?xml version=\"1.0\"?>\n<conf><ecm><mask><size>5</size></mask></ecm></conf>\n");
    CHECK_THAT(message(), ContainsSubstring("camera.xml") && ContainsSubstring("no camera"));
    folder.remove("camera.xml");
    CHECK_THAT(message(), ContainsSubstring("camera.xml") && ContainsSubstring("missing"));
  }
}
