// SPDX-License-Identifier: GPL-2.0-or-later
#include <catchMain.h>

#include "datasetFolder.h"

TEST_CASE("A scene of RBOT is read with its lengths in metres and its pixels at integers", "[dataset]")
{
  const DatasetFolder folder;
  putRbot(folder);
  folder.put("ape/frames/d_occlusion0000.png");
  folder.put("squirrel_small.obj");
  CHECK(bench::listScenes(folder.path()) == std::vector<std::string>{"ape/a_regular", "ape/d_occlusion"});
  for (const char *name : {"ape/a_regular", "a_regular"}) {
    const bench::Sequence sequence = bench::openSequence(folder.path(), name);
    CHECK(sequence.scene == "ape/a_regular");
    CHECK(sequence.object.id == 1);
    CHECK(sequence.object.mesh == folder.path("ape/ape.obj"));
    CHECK(sequence.object.meshUnit == exactly(0.001));
    CHECK(sequence.object.diameter == Approx(std::sqrt(60. * 60. + 40. * 40. + 20. * 20.) / 1000.));
    REQUIRE(sequence.frames.size() == 3);
    const bench::SequenceFrame &frame = sequence.frames[1];
    CHECK(frame.id == 1);
    CHECK(frame.image == folder.path("ape/frames/a_regular0001.png"));
    CHECK(frame.hasTruth);
    CHECK(frame.cMo[0][1] == Approx(-1.));
    CHECK(frame.cMo[1][0] == Approx(1.));
    CHECK(frame.cMo[0][3] == Approx(0.011));
    CHECK(frame.cMo[2][3] == Approx(0.6));
    CHECK(frame.cam.get_px() == Approx(650.048));
    CHECK(frame.cam.get_py() == Approx(647.183));
    CHECK(frame.cam.get_u0() == Approx(324.328 - 0.5));
    CHECK(frame.cam.get_v0() == Approx(257.323 - 0.5));
  }
}

TEST_CASE("A broken RBOT data set ends with the file and the line or frame", "[dataset]")
{
  const DatasetFolder folder;
  putRbot(folder);
  const auto message = [&] { return messageOf([&] { bench::openSequence(folder.path(), "ape/a_regular"); }); };
  SECTION("whole")
  {
    CHECK(message().empty());
    CHECK_THAT(messageOf([&] { bench::openSequence(folder.path(), "ape/a_regular", 2); }),
               ContainsSubstring("object 2") && ContainsSubstring("1"));
    CHECK_THAT(messageOf([&] { bench::openSequence(folder.path(), "cat/a_regular"); }),
               ContainsSubstring("cat/a_regular") && ContainsSubstring("ape/a_regular"));
  }
  SECTION("no model")
  {
    folder.remove("ape/ape.obj");
    CHECK_THAT(message(), ContainsSubstring("ape.obj") && ContainsSubstring("missing"));
  }
  SECTION("no image")
  {
    folder.remove("ape/frames/a_regular0001.png");
    CHECK_THAT(message(), ContainsSubstring("a_regular0001.png") && ContainsSubstring("missing"));
  }
  SECTION("no pose")
  {
    folder.put("ape/frames/a_regular0003.png");
    CHECK_THAT(message(), ContainsSubstring("poses_first.txt") && ContainsSubstring("a_regular0003.png"));
  }
  SECTION("no poses at all")
  {
    folder.put("poses_first.txt", "titles\n");
    CHECK_THAT(message(), ContainsSubstring("poses_first.txt"));
    folder.remove("poses_first.txt");
    CHECK_THAT(message(), ContainsSubstring("poses_first.txt") && ContainsSubstring("missing"));
  }
  SECTION("a short line")
  {
    folder.replace("poses_first.txt", "\t11\t20\t600", "\t11\t20");
    CHECK_THAT(message(), ContainsSubstring("poses_first.txt") && ContainsSubstring("frame 1") &&
                              ContainsSubstring("12 numbers, not 11"));
  }
  SECTION("a word")
  {
    folder.replace("poses_first.txt", "\t11\t20\t600", "\tnan\t20\t600");
    CHECK_THAT(message(),
               ContainsSubstring("poses_first.txt") && ContainsSubstring("line 3") && ContainsSubstring("'nan'"));
  }
  SECTION("no rotation")
  {
    folder.replace("poses_first.txt", "0\t-1\t0", "0\t1\t0");
    CHECK_THAT(message(), ContainsSubstring("frame 1") && ContainsSubstring("rotation"));
  }
  SECTION("behind the camera")
  {
    folder.replace("poses_first.txt", "12\t20\t600", "12\t20\t-600");
    CHECK_THAT(message(), ContainsSubstring("frame 2") && ContainsSubstring("front"));
  }
  SECTION("no camera")
  {
    folder.put("camera_calibration.txt", "titles\n650 650 320\n");
    CHECK_THAT(message(), ContainsSubstring("camera_calibration.txt") && ContainsSubstring("cy"));
    folder.put("camera_calibration.txt", "titles\n0 650 320 240\n");
    CHECK_THAT(message(), ContainsSubstring("camera_calibration.txt") && ContainsSubstring("focal"));
    folder.put("camera_calibration.txt", "fx fy cx cy k1\n650 650 320 240\n");
    CHECK_THAT(message(), ContainsSubstring("camera_calibration.txt") && ContainsSubstring("titles"));
    folder.put("camera_calibration.txt", "fx fy cx cy k1\n650 650 320 240 0.1\n");
    CHECK_THAT(message(), ContainsSubstring("camera_calibration.txt") && ContainsSubstring("distortion"));
    folder.remove("camera_calibration.txt");
    CHECK_THAT(message(), ContainsSubstring("camera_calibration.txt") && ContainsSubstring("missing"));
  }
}
