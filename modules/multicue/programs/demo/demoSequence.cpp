// SPDX-License-Identifier: GPL-2.0-or-later
#include "demo/demoSequence.h"

#include <visp3/core/vpException.h>
#include <visp3/core/vpIoTools.h>

#include <nlohmann/json.hpp>

#include <fstream>

namespace programs {
namespace {
const double millimetre = 0.001;

nlohmann::json readJson(const std::string &file)
{
  std::ifstream stream(file);
  try {
    return nlohmann::json::parse(stream);
  } catch (const nlohmann::json::exception &e) {
    throw vpException(vpException::ioError, file + ": " + e.what());
  }
}

vpHomogeneousMatrix toPose(const nlohmann::json &entry)
{
  vpHomogeneousMatrix cMo;
  for (unsigned int i = 0; i < 3; ++i) {
    for (unsigned int j = 0; j < 3; ++j) {
      cMo[i][j] = entry.at("cam_R_m2c").at(3 * i + j).get<double>();
    }
    cMo[i][3] = millimetre * entry.at("cam_t_m2c").at(i).get<double>();
  }
  return cMo;
}

// BOP's files of one object.
void readTruth(const std::string &folder, DemoSequence &sequence)
{
  const nlohmann::json poses = readJson(folder + "/scene_gt.json");
  const nlohmann::json infos = readJson(folder + "/scene_gt_info.json");
  for (const auto &pose : poses.items()) {
    DemoTruth truth;
    truth.cMo = toPose(pose.value().at(0));
    truth.visibility = infos.at(pose.key()).at(0).at("visib_fract").get<double>();
    sequence.truth[std::stoi(pose.key())] = truth;
  }
}

DemoSequence cube(const std::string &images)
{
  DemoSequence sequence;
  sequence.title = "a real cube (ViSP's mbt/cube)";
  // .pgm up to ViSP 3.5, .png later.
  const std::string pattern = images + "/mbt/cube/image%04d.";
  sequence.images = pattern + (vpIoTools::checkFilename(images + "/mbt/cube/image0000.pgm") ? "pgm" : "png");
  sequence.model = images + "/mbt/cube.cao";
  sequence.config = images + "/mbt/cube.xml";
  sequence.start = images + "/mbt/cube.0.pos";
  return sequence;
}

DemoSequence handheldBox(const std::string &data)
{
  DemoSequence sequence;
  sequence.title = "a box in a hand, covered in part and hidden for a while (rendered, true poses are known)";
  sequence.images = data + "/handheld-box/rgb/%06d.jpg";
  sequence.model = data + "/models/obj_000001.cao";
  sequence.config = data + "/handheld-box.xml";
  sequence.start = data + "/handheld-box.pos";
  const std::string info = data + "/models/models_info.json";
  sequence.diameter = millimetre * readJson(info).at("1").at("diameter").get<double>();
  readTruth(data + "/handheld-box", sequence);
  return sequence;
}
} // namespace

std::vector<DemoSequence> demoSequences(const std::string &images, const std::string &data)
{
  return {cube(images), handheldBox(data)};
}

} // namespace programs
