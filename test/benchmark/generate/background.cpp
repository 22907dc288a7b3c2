// SPDX-License-Identifier: GPL-2.0-or-later
#include "generate/background.h"

#include <visp3/core/vpException.h>
#include <visp3/core/vpIoTools.h>
#include <visp3/se3/vpPoseRandom.h>

#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace bench {
namespace {
// File names without their extensions, which differ between versions of the data set.
const std::array<const char *, 4> photographs = {{"Solvay/Solvay_conference_1927_Version2_2126x1463", "Klimt/Klimt",
                                                  "Solvay/Solvay_conference_1927_Version2_1280x881",
                                                  "mbt/cube/image0000"}};

cv::Mat readAnyFormat(const std::string &stem)
{
  for (const char *extension : {".png", ".ppm", ".jpg", ".jpeg", ".pgm"}) {
    if (vpIoTools::checkFilename(stem + extension)) {
      const cv::Mat image = cv::imread(stem + extension, cv::IMREAD_COLOR);
      if (!image.empty()) {
        return image;
      }
    }
  }
  return cv::Mat();
}

std::vector<std::string> photosIn(const std::string &folder)
{
  std::vector<std::string> found;
  for (const char *name : photographs) {
    const std::string stem = folder + "/" + name;
    for (const char *extension : {".png", ".ppm", ".jpg", ".jpeg", ".pgm"}) {
      if (vpIoTools::checkFilename(stem + extension)) {
        found.push_back(stem);
        break;
      }
    }
  }
  return found;
}

bool isGray(const cv::Mat &image)
{
  std::vector<cv::Mat> channels;
  cv::split(image, channels);
  return cv::norm(channels[0], channels[2], cv::NORM_INF) < 8.;
}

//! Light of a colour on a gray picture, so that colour says something there too.
void tint(cv::Mat &image, vpPoseRandom &random)
{
  cv::Scalar factors;
  for (int i = 0; i < 3; ++i) {
    factors[i] = 0.72 + 0.28 * random.uniform();
  }
  cv::multiply(image, factors, image);
}

//! From pixels of a turned camera to those of one that is not.
cv::Matx33d turnedBack(const vpCameraParameters &cam, const Eigen::Matrix3d &turn)
{
  const cv::Matx33d K(cam.get_px(), 0., cam.get_u0(), 0., cam.get_py(), cam.get_v0(), 0., 0., 1.);
  cv::Matx33d back;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      back(i, j) = turn(j, i);
    }
  }
  return K * back * K.inv();
}
} // namespace

cv::Mat openPhoto(std::uint64_t which)
{
  const std::string folder = vpIoTools::getViSPImagesDataPath();
  std::vector<std::string> stems;
  if (!folder.empty()) {
    stems = photosIn(folder + "/ViSP-images");
    const std::vector<std::string> direct = photosIn(folder);
    stems.insert(stems.end(), direct.begin(), direct.end());
  }
  vpPoseRandom random(which, {0x70686f746f});
  cv::Mat image;
  if (!stems.empty()) {
    image = readAnyFormat(stems[random.index(stems.size())]);
  }
  if (image.empty()) {
    throw vpException(vpException::ioError,
                      "there are no photographs for the background in '%s': install ViSP's data set (Debian: "
                      "visp-images-data), let VISP_INPUT_IMAGE_PATH name its folder, or give --background plain",
                      folder.c_str());
  }
  if (isGray(image)) {
    tint(image, random);
  }
  return image;
}

Background::Background(const std::string &kind, const SceneCamera &camera, std::uint64_t seed)
    : m_camera(camera), m_seed(seed)
{
  if (kind == "photo") {
    m_picture = openPhoto(seed);
  } else if (kind == "space") {
    m_picture = drawSpace(1100, 850, seed);
  } else if (kind == "wall") {
    m_picture = drawWall(1100, 850, seed);
  } else if (kind != "plain") {
    throw vpException(vpException::badValue, "there is no background '%s': give photo, wall, plain or space",
                      kind.c_str());
  }
}

cv::Mat Background::at(double time, const Eigen::Matrix3d &turn) const
{
  const cv::Size size(static_cast<int>(m_camera.width), static_cast<int>(m_camera.height));
  if (m_picture.empty()) {
    return cv::Mat(size, CV_32FC3, cv::Scalar(96., 92., 88.));
  }
  vpPoseRandom random(m_seed, {0x70616e});
  const auto wave = [&](double period) { return std::sin(2. * M_PI * (time / period + random.uniform())); };
  // At most one and a half of its pixels to one of the image, so that it needs no smoothing.
  const double fit = std::min(double(m_picture.cols) / size.width, double(m_picture.rows) / size.height);
  const double zoom = std::min(0.8 * fit, 1.1 / m_camera.scale()) * (1. + 0.08 * wave(171.));
  // The part of the picture in whose middle the camera sways.
  const double startX = 0.25 + 0.5 * random.uniform();
  const double startY = 0.25 + 0.5 * random.uniform();
  const double roomX = std::max(0., m_picture.cols - zoom * size.width);
  const double roomY = std::max(0., m_picture.rows - zoom * size.height);
  const double left = startX * roomX + std::min(0.25 * roomX, 60.) * wave(211.);
  const double top = startY * roomY + std::min(0.25 * roomY, 45.) * wave(157.);
  const cv::Matx33d map(zoom, 0., left, 0., zoom, top, 0., 0., 1.);
  const int flags = cv::INTER_LINEAR | cv::WARP_INVERSE_MAP;
  cv::Mat seen;
  if (turn.isIdentity(0.)) {
    cv::warpAffine(m_picture, seen, map.get_minor<2, 3>(0, 0), size, flags, cv::BORDER_REFLECT);
  } else {
    cv::warpPerspective(m_picture, seen, map * turnedBack(m_camera.cam, turn), size, flags, cv::BORDER_REFLECT);
  }
  cv::Mat result;
  seen.convertTo(result, CV_32FC3);
  return result;
}

} // namespace bench
