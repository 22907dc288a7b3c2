// SPDX-License-Identifier: GPL-2.0-or-later
#include "track/recorder.h"

#include <visp3/core/vpException.h>
#include <visp3/core/vpImageConvert.h>
#include <visp3/core/vpImageTools.h>

#include <filesystem>
#include <fstream>
#include <sstream>

namespace programs {
namespace {
const int objectId = 1;

void writeModel(const std::string &folder, const vpTrackedModel &model, const std::string &file)
{
  if (model.triangles().empty()) {
    throw vpException(vpException::badValue, "--record: the model %s has no surface, and a data set needs one",
                      file.c_str());
  }
  BopModel files;
  files.id = objectId;
  if (std::filesystem::path(file).extension() == ".cao") {
    std::ostringstream text;
    text << std::ifstream(file).rdbuf();
    files.cao = text.str();
  }
  for (const vpModelTriangle &triangle : model.triangles()) {
    BopTriangle corners;
    for (std::size_t i = 0; i < 3; ++i) {
      corners.position[i] = model.vertices()[static_cast<std::size_t>(triangle.vertex[i])];
      corners.color[i] = Eigen::Vector3f::Constant(0.5F);
      corners.texture[i].setZero();
    }
    files.triangles.push_back(corners);
  }
  writeBopModel(folder, files);
}

vpCameraParameters withoutDistortion(const vpCameraParameters &cam)
{
  return vpCameraParameters(cam.get_px(), cam.get_py(), cam.get_u0(), cam.get_v0());
}
} // namespace

Recorder::Recorder(const std::string &folder, const vpCameraParameters &cam, const vpTrackedModel &model,
                   const std::string &modelFile)
    : m_cam(cam), m_writer(folder, "000001", objectId, withoutDistortion(cam))
{
  writeModel(folder, model, modelFile);
}

void Recorder::add(const vpImage<vpRGBa> &I, const TrackedFrame &frame)
{
  cv::Mat image;
  if (m_cam.get_projModel() == vpCameraParameters::perspectiveProjWithoutDistortion) {
    vpImageConvert::convert(I, image);
  } else {
    vpImage<vpRGBa> straight;
    vpImageTools::undistort(I, m_cam, straight);
    vpImageConvert::convert(straight, image);
  }
  m_writer.writeImage(frame.number, image);
  BopFrame written;
  written.id = frame.number;
  written.cMo = frame.cMo;
  written.hasPose = frame.state == vpTrackingState::TRACKING;
  written.pixelsAll = -1;
  written.pixelsVisible = -1;
  m_frames.push_back(written);
}

void Recorder::finish() const
{
  m_writer.writeTruth(m_frames);
}

} // namespace programs
