// SPDX-License-Identifier: GPL-2.0-or-later
#include "overlayWriter.h"

#include "filePattern.h"

#include <visp3/core/vpException.h>
#include <visp3/core/vpImageConvert.h>
#include <visp3/me/vpMeSite.h>

#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include <filesystem>

namespace {
[[noreturn]] void fail(const std::string &text)
{
  throw vpException(vpException::ioError, text);
}

const cv::Scalar green(80, 220, 80), orange(0, 160, 255), red(60, 60, 255), white(255, 255, 255), black(0, 0, 0);

cv::Scalar colorOf(vpTrackingState state)
{
  switch (state) {
  case vpTrackingState::TRACKING:
    return green;
  case vpTrackingState::UNCERTAIN:
    return orange;
  default:
    return red;
  }
}

// From a row and a column to OpenCV's x and y.
cv::Point pixel(double i, double j)
{
  return cv::Point(cvRound(j), cvRound(i));
}

void drawModel(cv::Mat &image, vpMbMultiCueTracker &tracker, const cv::Scalar &color)
{
  vpCameraParameters cam;
  tracker.getCameraParameters(cam);
  const auto width = static_cast<unsigned int>(image.cols);
  const auto height = static_cast<unsigned int>(image.rows);
  // Each line is its kind, then row and column of both ends.
  for (const std::vector<double> &line : tracker.getModelForDisplay(width, height, tracker.getPose(), cam)) {
    cv::line(image, pixel(line[1], line[2]), pixel(line[3], line[4]), color, 2, cv::LINE_AA);
  }
}

void drawFeatures(cv::Mat &image, vpMbMultiCueTracker &tracker)
{
  // Each feature is its kind, row, column and, but for points, state.
  for (const std::vector<double> &feature : tracker.getFeaturesForDisplay()) {
    const bool isPoint = feature[0] > 0.;
    const bool isUsed = isPoint || static_cast<int>(feature[3]) == vpMeSite::NO_SUPPRESSION;
    cv::circle(image, pixel(feature[1], feature[2]), 1, isUsed ? white : red, cv::FILLED);
  }
}

void drawText(cv::Mat &image, const std::string &text, const cv::Scalar &color)
{
  const cv::Point origin(8, image.rows - 10);
  cv::putText(image, text, origin, cv::FONT_HERSHEY_SIMPLEX, 0.5, black, 3, cv::LINE_AA);
  cv::putText(image, text, origin, cv::FONT_HERSHEY_SIMPLEX, 0.5, color, 1, cv::LINE_AA);
}
} // namespace

OverlayWriter::OverlayWriter(const std::string &file, double framesPerSecond)
    : m_file(file), m_framesPerSecond(framesPerSecond), m_isVideo(file.find('%') == std::string::npos)
{
  const std::filesystem::path path(file);
  if (path.has_parent_path() && !std::filesystem::is_directory(path.parent_path())) {
    fail("--save " + file + ": there is no folder " + path.parent_path().string());
  }
  const std::string extension = path.extension().string();
  if (m_isVideo && extension != ".mp4" && extension != ".avi") {
    fail("--save " + file + " has to end in .mp4 or .avi, or be a pattern of images such as out%04d.png");
  }
  if (!m_isVideo && !cv::haveImageWriter(FilePattern(file).name(0))) {
    fail("--save " + file + ": OpenCV writes no images of this kind, use .png or .jpg");
  }
}

void OverlayWriter::openVideo(const cv::Size &size)
{
  if (std::filesystem::path(m_file).extension() == ".mp4") {
    m_video.open(m_file, cv::VideoWriter::fourcc('m', 'p', '4', 'v'), m_framesPerSecond, size);
    if (m_video.isOpened()) {
      return;
    }
    m_file = std::filesystem::path(m_file).replace_extension(".avi").string();
  }
  m_video.open(m_file, cv::VideoWriter::fourcc('M', 'J', 'P', 'G'), m_framesPerSecond, size);
  if (!m_video.isOpened()) {
    fail("--save " + m_file + " cannot be written: OpenCV has no encoder for it, save images such as out%04d.png");
  }
}

void OverlayWriter::write(const vpImage<vpRGBa> &I, vpMbMultiCueTracker &tracker, int frame)
{
  cv::Mat image;
  vpImageConvert::convert(I, image);
  const vpTrackingState state = tracker.getTrackingState();
  drawModel(image, tracker, colorOf(state));
  drawFeatures(image, tracker);
  drawText(image, cv::format("%d %s", frame, toString(state)), colorOf(state));
  if (!m_isVideo) {
    const std::string file = FilePattern(m_file).name(frame);
    if (!cv::imwrite(file, image)) {
      fail("--save " + file + " cannot be written: is the disk full?");
    }
    return;
  }
  // Encoders leave out the last row or column of an odd number of them.
  cv::copyMakeBorder(image, image, 0, image.rows % 2, 0, image.cols % 2, cv::BORDER_REPLICATE);
  if (!m_video.isOpened()) {
    openVideo(image.size());
  }
  m_video.write(image);
}
