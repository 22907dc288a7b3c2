// SPDX-License-Identifier: GPL-2.0-or-later
#include "frames/videoFile.h"

#include "frames/filePattern.h"

#include <visp3/core/vpException.h>

#include <opencv2/imgcodecs.hpp>

#include <filesystem>

#ifdef ENABLE_VISP_NAMESPACE
using namespace VISP_NAMESPACE_NAME;
#endif

namespace programs {

void VideoFile::fail(const std::string &text) const
{
  throw vpException(vpException::ioError, m_option + " " + m_file + " " + text);
}

VideoFile::VideoFile(const std::string &option, const std::string &file, double framesPerSecond)
    : m_option(option), m_file(file), m_framesPerSecond(framesPerSecond), m_isVideo(file.find('%') == std::string::npos)
{
  const std::filesystem::path path(file);
  if (path.has_parent_path() && !std::filesystem::is_directory(path.parent_path())) {
    fail("cannot be written: there is no folder " + path.parent_path().string());
  }
  const std::string extension = path.extension().string();
  if (m_isVideo && extension != ".mp4" && extension != ".avi") {
    fail("has to end in .mp4 or .avi, or be a pattern of images such as out%04d.png");
  }
  if (!m_isVideo && !cv::haveImageWriter(FilePattern(file).name(0))) {
    fail("cannot be written: OpenCV writes no images of this kind, use .png or .jpg");
  }
}

void VideoFile::openVideo(const cv::Size &size)
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
    fail("cannot be written: OpenCV has no encoder for it, save images such as out%04d.png");
  }
}

void VideoFile::write(const cv::Mat &picture, int number)
{
  if (!m_isVideo) {
    const std::string file = FilePattern(m_file).name(number);
    if (!cv::imwrite(file, picture)) {
      fail("cannot be written: is the disk full?");
    }
    return;
  }
  // Encoders leave out the last row or column of an odd number of them.
  cv::Mat even;
  cv::copyMakeBorder(picture, even, 0, picture.rows % 2, 0, picture.cols % 2, cv::BORDER_REPLICATE);
  if (!m_video.isOpened()) {
    openVideo(even.size());
  }
  m_video.write(even);
}

} // namespace programs
