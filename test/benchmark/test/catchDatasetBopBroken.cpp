// SPDX-License-Identifier: GPL-2.0-or-later
#include <catchMain.h>

#include "datasetFolder.h"

#include <functional>

namespace {
const std::string scene = "test/000001/";

struct Damage
{
  std::string what;
  std::function<void(const DatasetFolder &)> doIt;
  std::vector<std::string> told; // What the message has to say.
};

Damage edited(const std::string &file, const std::string &from, const std::string &to,
              const std::vector<std::string> &told)
{
  return {file + ": " + from + " -> " + to,
          [file, from, to](const DatasetFolder &folder) { folder.replace(file, from, to); }, told};
}

Damage removed(const std::string &file, const std::vector<std::string> &told)
{
  return {file + " removed", [file](const DatasetFolder &folder) { folder.remove(file); }, told};
}

const std::string camera = scene + "scene_camera.json";
const std::string truth = scene + "scene_gt.json";
const std::string info = scene + "scene_gt_info.json";
const std::string models = "models/models_info.json";

std::vector<Damage> damages()
{
  return {
      removed(scene + "rgb/000004.png", {"000004.png", "missing"}),
      removed(scene + "rgb", {"rgb", "gray", "000001"}),
      removed(camera, {"scene_camera.json", "missing"}),
      removed(truth, {"scene_gt.json", "missing"}),
      removed("models/obj_000005.ply", {"obj_000005.ply", "missing", "obj_000002.ply"}),
      removed("models", {"obj_000005.ply", "missing", "none"}),
      {"truncated",
       [](const DatasetFolder &folder) { folder.put(truth, R"({"3": [{"cam_R_m2c": [1, 0, 0,)"); },
       {"scene_gt.json", "no JSON"}},
      {"a list", [](const DatasetFolder &folder) { folder.put(camera, "[]"); }, {"scene_camera.json", "object"}},
      {"no images",
       [](const DatasetFolder &folder) {
         folder.remove(scene + "rgb");
         std::filesystem::create_directories(folder.path(scene + "rgb"));
       },
       {"000003.png", "missing"}},
      edited(camera, "[570, 0,", "[0,", {"scene_camera.json", "'3'", "cam_K", "9 numbers", "8"}),
      edited(camera, "[570,", "[0,", {"scene_camera.json", "'3'", "cam_K", "focal"}),
      edited(camera, "[570,", "[-570,", {"scene_camera.json", "'3'", "cam_K", "focal"}),
      edited(camera, "[570,", "[1e400,", {"scene_camera.json", "no JSON"}),
      edited(camera, "[570,", "[NaN,", {"scene_camera.json", "no JSON"}),
      edited(camera, "[570,", "[\"570\",", {"scene_camera.json", "'3'", "cam_K", "[0]", "number", "string"}),
      edited(camera, "[570, 0,", "[570, 2,", {"scene_camera.json", "'3'", "cam_K", "skew"}),
      edited(camera, "\"cam_K\"", "\"cam_L\"", {"scene_camera.json", "'3'", "'cam_K'", "missing"}),
      edited(camera, "\"7\"", "\"8\"", {"scene_camera.json", "image 7", "camera"}),
      edited(camera, "\"7\"", "\"5\"", {"000005.png", "missing"}),
      edited(camera, "\"4\": {", "\"3\": {", {"scene_camera.json", "'3' is there twice"}),
      edited(camera, "\"4\": {", "\"03\": {", {"scene_camera.json", "number 3 is there twice"}),
      edited(camera, "\"cam_K\"", "\"cam_K\": [], \"cam_K\"", {"scene_camera.json", "'cam_K' is there twice"}),
      edited(camera, "\"4\"", "\"four\"", {"scene_camera.json", "'four'", "number"}),
      edited(truth, "\"4\"", "\"5\"", {"000005.png", "missing"}),
      edited(truth, "\"4\": [", "\"4\": {\"a\": [", {"scene_gt.json", "no JSON"}),
      edited(truth, "[1, 0, 0, 0, 1, 0, 0, 0, 1]", "[1, 0, 0, 0, 1, 0, 0, 0]",
             {"scene_gt.json", "'3'", "[0]", "cam_R_m2c", "9 numbers"}),
      edited(truth, "[1, 0, 0, 0, 1, 0, 0, 0, 1]", "[1, 0, 0, 0, 1, 0, 0, 0, 1.01]",
             {"scene_gt.json", "'3'", "[0]", "rotation"}),
      edited(truth, "[1, 0, 0, 0, 1, 0, 0, 0, 1]", "[1, 0, 0, 0, 1, 0, 0, 0, -1]",
             {"scene_gt.json", "'3'", "[0]", "rotation"}),
      edited(truth, "[10, -5, 500]", "[10, -5]", {"scene_gt.json", "'3'", "[0]", "cam_t_m2c", "3 numbers"}),
      edited(truth, "[10, -5, 500]", "[10, null, 500]", {"scene_gt.json", "'3'", "[0]", "cam_t_m2c", "null"}),
      edited(truth, "\"obj_id\": 5", "\"obj_id\": 5.5", {"scene_gt.json", "'3'", "[0]", "obj_id", "5.5"}),
      edited(truth, "\"obj_id\": 5", "\"obj\": 5", {"scene_gt.json", "'3'", "[0]", "'obj_id'", "missing"}),
      edited(info, "0.75", "1.5", {"scene_gt_info.json", "'3'", "visib_fract", "[0, 1]"}),
      edited(info, "0.75", "true", {"scene_gt_info.json", "'3'", "visib_fract", "boolean"}),
      edited(truth, "\"obj_id\": 5", "\"obj_id\": 5, \"obj_id\": 2", {"scene_gt.json", "'obj_id' is there twice"}),
      edited(models, "75", "0", {"models_info.json", "'5'", "diameter"}),
      edited(models, "75", "75, \"diameter\": 7", {"models_info.json", "'diameter' is there twice"}),
      edited(models, "[-1, 0, 0, 10,", "[-1, 0, 0,", {"models_info.json", "'5'", "symmetries_discrete", "16"}),
      edited(models, "[-1, 0, 0, 10,", "[-2, 0, 0, 10,", {"models_info.json", "'5'", "symmetries_discrete", "rot"}),
      edited(models, "0, 0, 0, 1]]", "0, 0, 1, 1]]", {"models_info.json", "symmetries_discrete", "last row"}),
  };
}
} // namespace

TEST_CASE("A broken scene of BOP ends with the file, the frame and the key", "[dataset]")
{
  for (const Damage &damage : damages()) {
    CAPTURE(damage.what);
    const DatasetFolder folder;
    putBop(folder);
    damage.doIt(folder);
    const std::string message = messageOf([&] { bench::openSequence(folder.path(), "test/000001", 5); });
    for (const std::string &told : damage.told) {
      CHECK_THAT(message, ContainsSubstring(told));
    }
  }
}

TEST_CASE("Objects and scenes that there are not are told with those that there are", "[dataset]")
{
  const DatasetFolder folder;
  putBop(folder);
  CHECK_THAT(messageOf([&] { bench::openSequence(folder.path(), "1", 9); }),
             ContainsSubstring("scene_gt.json") && ContainsSubstring("object 9") && ContainsSubstring("2, 5"));
  CHECK_THAT(messageOf([&] { bench::openSequence(folder.path(), "13", 5); }),
             ContainsSubstring("'13'") && ContainsSubstring("test/000001"));
  folder.replace("models/models_info.json", "[0, 0, 2]", "[0, 0, 0]");
  CHECK_THAT(messageOf([&] { bench::openSequence(folder.path(), "1", 2); }),
             ContainsSubstring("models_info.json") && ContainsSubstring("symmetries_continuous") &&
                 ContainsSubstring("axis"));
}

TEST_CASE("Folders without a scene, and scenes that are too short", "[dataset]")
{
  const DatasetFolder folder;
  CHECK_THAT(messageOf([&] { bench::listScenes(folder.path("nowhere")); }), ContainsSubstring("nowhere"));
  CHECK_THAT(messageOf([&] { bench::listScenes(folder.path()); }), ContainsSubstring("no scene"));
  CHECK_THAT(messageOf([&] { bench::openSequence(folder.path(), "1"); }), ContainsSubstring("no scene"));
  putBop(folder);
  folder.put("test/000001/scene_camera.json", R"({"3": {"cam_K": [9, 0, 1, 0, 9, 1, 0, 0, 1]}})");
  folder.put("test/000001/scene_gt.json",
             R"({"3": [{"cam_R_m2c": [1,0,0,0,1,0,0,0,1], "cam_t_m2c": [0, 0, 9], "obj_id": 5}]})");
  folder.remove("test/000001/rgb/000004.png");
  folder.remove("test/000001/rgb/000007.png");
  CHECK_THAT(messageOf([&] { bench::openSequence(folder.path(), "1", 5); }),
             ContainsSubstring("000001") && ContainsSubstring("1 frames") && ContainsSubstring("two"));
}
