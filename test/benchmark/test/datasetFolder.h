// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef datasetFolder_h
#define datasetFolder_h

#include "dataset/sequence.h"

#include <exceptionMessage.h>
#include <meshFiles.h>

#include <filesystem>
#include <fstream>
#include <string>

/*!
  \file datasetFolder.h
  Small data sets, written by hand for one test. Images are files with some text: readers do not decode them.
*/

BEGIN_VISP_NAMESPACE

class DatasetFolder
{
public:
  std::string path(const std::string &name = "") const { return m_folder.path(name); }

  //! Writes a file, with the folders that it needs. \return Its path.
  std::string put(const std::string &name, const std::string &content = "not decoded") const
  {
    std::filesystem::create_directories(std::filesystem::path(path(name)).parent_path());
    return m_folder.write(name, content);
  }

  void remove(const std::string &name) const { std::filesystem::remove_all(path(name)); }

  //! \return What is in a file.
  std::string text(const std::string &name) const
  {
    std::ifstream file(path(name), std::ios::binary);
    return std::string((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
  }

  //! Replaces a bit of a file's text.
  void replace(const std::string &name, const std::string &from, const std::string &to) const
  {
    std::string text = this->text(name);
    const std::size_t at = text.find(from);
    if (at == std::string::npos) {
      throw std::runtime_error("'" + from + "' is not in " + name);
    }
    put(name, text.replace(at, from.size(), to));
  }

private:
  meshFiles::TemporaryFolder m_folder;
};

//! A mesh of a box of 60 x 40 x 20 (diagonal 74.83) in the file's own unit.
inline meshFiles::Triangles smallBox(double unit = 1.)
{
  return modelShapes::boxTriangles(unit * modelShapes::Point(60., 40., 20.));
}

/*!
  A scene of BOP: images 3, 4 and 7. Image 3 shows objects 5, 2 and a second 5; image 4 object 5; image 7 object 2.
  Object 5 moves from x = 10 mm to 20 mm at z = 500 mm, turned by 90 degrees about z in image 4.
*/
inline void putBopScene(const DatasetFolder &folder, const std::string &scene)
{
  const std::string identity = R"("cam_R_m2c": [1, 0, 0, 0, 1, 0, 0, 0, 1])";
  const auto camera = [](const std::string &fx) {
    return R"({"cam_K": [)" + fx + R"(, 0, 320.5, 0, 580, 240.25, 0, 0, 1], "depth_scale": 1.0})";
  };
  folder.put(scene + "/scene_camera.json",
             R"({"3": )" + camera("570") + R"(, "4": )" + camera("571") + R"(, "7": )" + camera("572") + "}");
  folder.put(scene + "/scene_gt.json", R"({"3": [{)" + identity + R"(, "cam_t_m2c": [10, -5, 500], "obj_id": 5}, {)" +
                                           identity + R"(, "cam_t_m2c": [90, 0, 700], "obj_id": 2}, {)" + identity +
                                           R"(, "cam_t_m2c": [-90, 0, 700], "obj_id": 5}],
  "4": [{"cam_R_m2c": [0, -1, 0, 1, 0, 0, 0, 0, 1], "cam_t_m2c": [20, -5, 500], "obj_id": 5}],
  "7": [{)" + identity + R"(, "cam_t_m2c": [80, 0, 700], "obj_id": 2}]})");
  folder.put(scene + "/scene_gt_info.json",
             R"({"3": [{"visib_fract": 0.75}, {"visib_fract": 0.5}, {}], "4": [{"visib_fract": -1}]})");
  for (const char *image : {"000003", "000004", "000007"}) {
    folder.put(scene + "/rgb/" + image + ".png");
  }
}

//! The models of objects 2 and 5; object 5 is the same turned half a turn about z (and not at all), and 2 however it is
//! turned.
inline void putBopModels(const DatasetFolder &folder, const std::string &models = "models")
{
  folder.put(models + "/obj_000002.ply", meshFiles::ply(smallBox()));
  folder.put(models + "/obj_000005.ply", meshFiles::ply(smallBox()));
  folder.put(models + "/models_info.json",
             R"({"2": {"diameter": 80.5, "symmetries_continuous": [{"axis": [0, 0, 2], "offset": [0, 30, 0]}]},
                 "5": {"diameter": 75, "symmetries_discrete": [[1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1], [-1, 0, 0, 10, 0, -1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]]}})");
}

//! One scene "test/000001" with its models.
inline void putBop(const DatasetFolder &folder)
{
  putBopScene(folder, "test/000001");
  putBopModels(folder);
}

//! The RBOT data set with one object, three poses, one variant.
inline void putRbot(const DatasetFolder &folder)
{
  folder.put("camera_calibration.txt", "fx\tfy\tcx\tcy\tk1\n650.048\t647.183\t324.328\t257.323\t0\n");
  folder.put("poses_first.txt", "r11 r12 and so on\n"
                                "1\t0\t0\t0\t1\t0\t0\t0\t1\t10\t20\t600\n"
                                "0\t-1\t0\t1\t0\t0\t0\t0\t1\t11\t20\t600\n"
                                "1\t0\t0\t0\t1\t0\t0\t0\t1\t12\t20\t600\n");
  folder.put("ape/ape.obj", meshFiles::obj(smallBox()));
  for (const char *number : {"0000", "0001", "0002"}) {
    folder.put(std::string("ape/frames/a_regular") + number + ".png");
  }
}

//! Opens the recording of putSmallRecording().
inline bench::Sequence openSmallRecording(const DatasetFolder &folder)
{
  bench::Recording recording;
  recording.images = folder.path("image%d.png");
  recording.poses = folder.path("pose%d.txt");
  recording.model = folder.path("box.obj");
  recording.camera = folder.path("camera.xml");
  return bench::openRecording(recording);
}

//! Three images with their poses, outside any data set.
inline void putSmallRecording(const DatasetFolder &folder)
{
  for (const char *number : {"0", "1", "2"}) {
    folder.put(std::string("image") + number + ".png");
    folder.put(std::string("pose") + number + ".txt", "1 0 0 0.125\n0 1 0 0.25\n0 0 1 0.5\n0 0 0 1\n");
  }
  folder.put("box.obj", meshFiles::obj(smallBox(0.001)));
  folder.put("camera.xml", "<conf><camera><px>1000</px><py>1000</py><u0>320</u0><v0>240</v0></camera></conf>");
}

END_VISP_NAMESPACE
#endif
