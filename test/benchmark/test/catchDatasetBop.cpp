// SPDX-License-Identifier: GPL-2.0-or-later
#include <catchMain.h>

#include "datasetFolder.h"

namespace {
using bench::openSequence;
using bench::Sequence;
using bench::SequenceFrame;

void checkObjectFive(const Sequence &sequence)
{
  CHECK(sequence.object.id == 5);
  REQUIRE(sequence.frames.size() == 3);
  const SequenceFrame &first = sequence.frames[0];
  CHECK(first.id == 3);
  CHECK(first.cam.get_px() == exactly(570.));
  CHECK(first.cam.get_py() == exactly(580.));
  CHECK(first.cam.get_u0() == exactly(320.5));
  CHECK(first.cam.get_v0() == exactly(240.25));
  CHECK(first.cam.get_projModel() == vpCameraParameters::perspectiveProjWithoutDistortion);
  REQUIRE(first.hasTruth);
  CHECK(first.cMo[0][3] == Approx(0.01)); // The first of the two instances.
  CHECK(first.cMo[1][3] == Approx(-0.005));
  CHECK(first.cMo[2][3] == Approx(0.5));
  CHECK(first.visibility == exactly(0.75));
  const SequenceFrame &second = sequence.frames[1];
  CHECK(second.id == 4);
  CHECK(second.cam.get_px() == exactly(571.));
  CHECK(second.cMo[0][1] == Approx(-1.)); // Row by row.
  CHECK(second.cMo[1][0] == Approx(1.));
  CHECK(second.visibility == exactly(1.)); // Not computed.
  CHECK_FALSE(sequence.frames[2].hasTruth);
  CHECK(sequence.frames[2].id == 7);
}
} // namespace

TEST_CASE("A scene of BOP is read with its lengths in metres", "[dataset]")
{
  const DatasetFolder folder;
  putBop(folder);
  CHECK(bench::listScenes(folder.path()) == std::vector<std::string>{"test/000001"});
  const Sequence sequence = openSequence(folder.path(), "test/000001", 5);
  CHECK(sequence.scene == "test/000001");
  checkObjectFive(sequence);
  CHECK(std::filesystem::exists(sequence.frames[2].image));
  CHECK(sequence.object.mesh == folder.path("models/obj_000005.ply"));
  CHECK(sequence.object.meshUnit == exactly(0.001));
  CHECK(sequence.object.cao.empty());
  CHECK(sequence.object.diameter == Approx(0.075));
  CHECK(sequence.object.axis.empty());
  REQUIRE(sequence.object.symmetry.size() == 1);
  CHECK(sequence.object.symmetry[0][0][0] == Approx(-1.));
  CHECK(sequence.object.symmetry[0][0][3] == Approx(0.01));
}

TEST_CASE("The other object of a scene, and the first one where none is named", "[dataset]")
{
  const DatasetFolder folder;
  putBop(folder);
  CHECK(openSequence(folder.path(), "test/000001").object.id == 5);
  const Sequence sequence = openSequence(folder.path(), "test/000001", 2);
  REQUIRE(sequence.frames.size() == 3);
  CHECK(sequence.frames[0].cMo[0][3] == Approx(0.09));
  CHECK(sequence.frames[0].visibility == exactly(0.5));
  CHECK_FALSE(sequence.frames[1].hasTruth);
  CHECK(sequence.frames[2].cMo[0][3] == Approx(0.08));
  CHECK(sequence.frames[2].visibility == exactly(1.)); // The file does not have the image.
  REQUIRE(sequence.object.axis.size() == 1);
  CHECK((sequence.object.axis[0].direction - Eigen::Vector3d::UnitZ()).norm() < 1e-12);
  CHECK((sequence.object.axis[0].point - Eigen::Vector3d(0., 0.03, 0.)).norm() < 1e-12);
}

TEST_CASE("Scenes stand in the data set, in a split of it, or are the data set, and have short names", "[dataset]")
{
  const DatasetFolder folder;
  putBopModels(folder);
  putBopScene(folder, "test/000001");
  putBopScene(folder, "test/000002");
  putBopScene(folder, "val/000002");
  putBopScene(folder, "clip");
  CHECK(bench::listScenes(folder.path()) ==
        std::vector<std::string>{"clip", "test/000001", "test/000002", "val/000002"});
  for (const char *name : {"1", "000001", "test/000001"}) {
    CHECK(openSequence(folder.path(), name).scene == "test/000001");
  }
  checkObjectFive(openSequence(folder.path(), "clip"));
  CHECK_THAT(messageOf([&] { openSequence(folder.path(), "2"); }),
             ContainsSubstring("'2'") && ContainsSubstring("test/000002, val/000002"));

  const DatasetFolder alone;
  putBopScene(alone, ".");
  putBopModels(alone);
  CHECK(bench::listScenes(alone.path()) == std::vector<std::string>{"."});
  checkObjectFive(openSequence(alone.path(), "."));
}

TEST_CASE("Of an object's models the one in metres is preferred, and its .cao is found", "[dataset]")
{
  const DatasetFolder folder;
  putBop(folder);
  folder.put("models/obj_000005.obj", meshFiles::obj(smallBox(0.001)));
  folder.put("models/obj_000005.cao", "V1");
  const bench::SequenceObject object = openSequence(folder.path(), "1", 5).object;
  CHECK(object.mesh == folder.path("models/obj_000005.obj"));
  CHECK(object.meshUnit == exactly(1.));
  CHECK(object.cao == folder.path("models/obj_000005.cao"));
}

TEST_CASE("The diameter is measured where no file tells it", "[dataset]")
{
  const std::string models = GENERATE("models", "models_eval", "test/000001/models");
  const DatasetFolder folder;
  putBopScene(folder, "test/000001");
  putBopModels(folder, models);
  const double diagonal = std::sqrt(60. * 60. + 40. * 40. + 20. * 20.) / 1000.;
  folder.put(models + "/models_info.json", R"({"2": {"diameter": 80.5}, "5": {}})");
  CHECK(openSequence(folder.path(), "1", 5).object.diameter == Approx(diagonal));
  folder.put(models + "/models_info.json", R"({"2": {"diameter": 80.5}})");
  CHECK(openSequence(folder.path(), "1", 5).object.diameter == Approx(diagonal));
  folder.remove(models + "/models_info.json");
  CHECK(openSequence(folder.path(), "1", 5).object.diameter == Approx(diagonal));
  folder.put(models + "/obj_000005.obj", meshFiles::obj(smallBox(0.001)));
  CHECK(openSequence(folder.path(), "1", 5).object.diameter == Approx(diagonal));
}

TEST_CASE("An object with nothing but a .cao is an object", "[dataset]")
{
  const DatasetFolder folder;
  putBopScene(folder, "test/000001");
  folder.put("models/obj_000005.cao", "V1\n4\n0 0 0\n0.3 0 0\n0.3 0.4 0\n0 0.4 0\n0\n0\n1\n4 0 1 2 3\n0\n0\n");
  const bench::SequenceObject object = openSequence(folder.path(), "1", 5).object;
  CHECK(object.mesh.empty());
  CHECK(object.diameter == Approx(0.5));
}

TEST_CASE("Images in other places and types, and more of them than poses", "[dataset]")
{
  const DatasetFolder folder;
  putBop(folder);
  std::filesystem::rename(folder.path("test/000001/rgb"), folder.path("test/000001/gray"));
  folder.remove("test/000001/gray/000004.png");
  folder.put("test/000001/gray/000004.JPG");
  folder.put("test/000001/gray/000012.tif");
  folder.put("test/000001/gray/000001.jpeg");
  folder.put("test/000001/gray/notes.txt");
  folder.replace("test/000001/scene_camera.json", R"("7":)",
                 R"("12": {"cam_K": [1, 0, 0, 0, 1, 0, 0, 0, 1]}, "1": {"cam_K": [1, 0, 0, 0, 1, 0, 0, 0, 1]}, "7":)");
  const Sequence sequence = openSequence(folder.path(), "1", 5);
  std::vector<int> ids;
  for (const SequenceFrame &frame : sequence.frames) {
    ids.push_back(frame.id);
  }
  // In the order of their numbers, from the first pose on.
  CHECK(ids == std::vector<int>{3, 4, 7, 12});
  CHECK(sequence.frames[1].image == folder.path("test/000001/gray/000004.JPG"));
  CHECK_FALSE(sequence.frames[3].hasTruth);
}

TEST_CASE("A rotation with few digits becomes a rotation", "[dataset]")
{
  const DatasetFolder folder;
  putBop(folder);
  folder.replace("test/000001/scene_gt.json", "[1, 0, 0, 0, 1, 0, 0, 0, 1]",
                 "[0.8661, -0.5, 0, 0.5, 0.8661, 0, 0, 0, 1.0001]");
  const vpHomogeneousMatrix cMo = openSequence(folder.path(), "1", 5).frames[0].cMo;
  CHECK(cMo[0][0] == Approx(0.8661).margin(1e-3));
  for (unsigned int i = 0; i < 3; ++i) {
    for (unsigned int j = 0; j < 3; ++j) {
      const double product = cMo[i][0] * cMo[j][0] + cMo[i][1] * cMo[j][1] + cMo[i][2] * cMo[j][2];
      CHECK(std::fabs(product - (i == j ? 1. : 0.)) < 1e-12);
    }
  }
}
