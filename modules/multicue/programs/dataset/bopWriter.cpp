// SPDX-License-Identifier: GPL-2.0-or-later
#include "dataset/bopWriter.h"

#include <visp3/core/vpException.h>
#include <visp3/model/vpWholeFile.h>

#include <opencv2/imgcodecs.hpp>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <filesystem>
#include <iterator>
#include <sstream>

namespace programs {
namespace {
namespace fs = std::filesystem;
using nlohmann::json;

// A scene is one where the last of them is there.
const char *const truthFiles[] = {"scene_camera.json", "scene_gt_info.json", "scene_gt.json"};

void makeFolder(const fs::path &folder)
{
  std::error_code error;
  fs::create_directories(folder, error);
  if (!fs::is_directory(folder)) {
    throw vpException(vpException::ioError, "the folder %s cannot be made: %s", folder.c_str(),
                      error.message().c_str());
  }
}

std::string numbered(int id)
{
  char name[16];
  std::snprintf(name, sizeof(name), "%06d", id);
  return name;
}

// One line for each frame in their order, as in BOP's own files; nlohmann's objects are sorted as text.
using Entries = std::vector<std::pair<int, json>>;

void writeJson(const std::string &file, const Entries &entries)
{
  std::ostringstream out;
  out << "{";
  const char *separator = "\n";
  for (const auto &entry : entries) {
    out << separator << "  \"" << entry.first << "\": " << entry.second.dump();
    separator = ",\n";
  }
  out << "\n}\n";
  vpWholeFile::write(file, out.str());
}

// As BOP has it, -1 where it was not computed.
double visibleShare(const BopFrame &frame)
{
  if (frame.pixelsAll < 0) {
    return -1.;
  }
  return frame.pixelsAll > 0 ? double(frame.pixelsVisible) / frame.pixelsAll : 0.;
}

bool isNumberedImage(const fs::path &file)
{
  const std::string stem = file.stem().string();
  return (file.extension() == ".png" || file.extension() == ".jpg") && stem.size() == 6 &&
         std::all_of(stem.begin(), stem.end(), [](unsigned char c) { return std::isdigit(c) != 0; });
}
} // namespace

BopSceneWriter::BopSceneWriter(const std::string &dataset, const std::string &scene, int objectId,
                               const vpCameraParameters &cam, int jpegQuality)
    : m_folder((fs::path(dataset) / scene).string()), m_objectId(objectId), m_cam(cam), m_jpegQuality(jpegQuality)
{
  const fs::path images = fs::path(m_folder) / "rgb";
  makeFolder(images);
  for (const char *truth : truthFiles) { // First: it belongs to the earlier images.
    fs::remove(fs::path(m_folder) / truth);
  }
  for (const fs::directory_entry &entry : fs::directory_iterator(images)) {
    if (isNumberedImage(entry.path())) {
      fs::remove(entry.path());
    }
  }
}

void BopSceneWriter::writeImage(int id, const cv::Mat &image) const
{
  const bool png = m_jpegQuality == 0;
  const std::string file = m_folder + "/rgb/" + numbered(id) + (png ? ".png" : ".jpg");
  const std::vector<int> settings = png ? std::vector<int>{cv::IMWRITE_PNG_COMPRESSION, 1}
                                        : std::vector<int>{cv::IMWRITE_JPEG_QUALITY, m_jpegQuality};
  if (!cv::imwrite(file, image, settings)) {
    throw vpException(vpException::ioError, "%s cannot be written: is the disk full?", file.c_str());
  }
}

void BopSceneWriter::writeTruth(const std::vector<BopFrame> &frames) const
{
  Entries camera;
  Entries truth;
  Entries info;
  const json intrinsics = {m_cam.get_px(), 0., m_cam.get_u0(), 0., m_cam.get_py(), m_cam.get_v0(), 0., 0., 1.};
  for (const BopFrame &frame : frames) {
    json rotation;
    json translation;
    for (unsigned int i = 0; i < 3; ++i) {
      for (unsigned int j = 0; j < 3; ++j) {
        rotation.push_back(frame.cMo[i][j]);
      }
      translation.push_back(1000. * frame.cMo[i][3]);
    }
    camera.emplace_back(frame.id, json{{"cam_K", intrinsics}, {"depth_scale", 1.}});
    const json pose = {{"cam_R_m2c", rotation}, {"cam_t_m2c", translation}, {"obj_id", m_objectId}};
    truth.emplace_back(frame.id, frame.hasPose ? json::array({pose}) : json::array());
    const json seen = {{"px_count_all", frame.pixelsAll},
                       {"px_count_visib", frame.pixelsVisible},
                       {"visib_fract", visibleShare(frame)},
                       {"bbox_obj", frame.boxObject},
                       {"bbox_visib", frame.boxVisible}};
    info.emplace_back(frame.id, frame.hasPose ? json::array({seen}) : json::array());
  }
  const Entries *const entries[] = {&camera, &info, &truth};
  for (std::size_t i = 0; i < std::size(truthFiles); ++i) {
    writeJson(m_folder + "/" + truthFiles[i], *entries[i]);
  }
}

} // namespace programs
