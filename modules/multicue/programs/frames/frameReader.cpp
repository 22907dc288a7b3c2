// SPDX-License-Identifier: GPL-2.0-or-later
#include "frames/frameReader.h"

#include "frames/filePattern.h"
#include "frames/imageFile.h"

#include <visp3/core/vpException.h>
#include <visp3/core/vpImageConvert.h>

#include <opencv2/videoio.hpp>

#include <algorithm>
#include <map>

namespace programs {
namespace {
[[noreturn]] void fail(const std::string &text)
{
  throw vpException(vpException::ioError, text);
}

class ImageFiles : public FrameReader
{
public:
  explicit ImageFiles(const FrameSource &source)
      : m_files(FilePattern(source.images).frames(source.first, source.last, source.step))
  {
    if (m_files.empty()) {
      fail("--images " + source.images + ": --last is before --first");
    }
    m_next = m_files.begin();
  }

  bool next(vpImage<vpRGBa> &I) override
  {
    if (m_next == m_files.end()) {
      return false;
    }
    vpImageConvert::convert(readColorImage(m_next->second, m_depth), I);
    m_number = m_next->first;
    ++m_next;
    return true;
  }

  int last() const override { return m_files.rbegin()->first; }

private:
  std::map<int, std::string> m_files;
  std::map<int, std::string>::const_iterator m_next;
  ImageDepth m_depth;
};

// A video file or a camera. Frames are skipped one by one, since seeking is not exact in most formats.
class VideoFrames : public FrameReader
{
public:
  explicit VideoFrames(const FrameSource &source)
      : m_skip(std::max(source.first, 0)), m_step(source.step), m_last(source.last)
  {
    if (source.camera >= 0) {
      m_capture.open(source.camera);
    } else {
      m_capture.open(source.video);
    }
    if (!m_capture.isOpened()) {
      fail(source.camera >= 0 ? "--camera " + std::to_string(source.camera) + ": there is no such camera"
                              : "--video " + source.video + ": no such file, or no video that OpenCV reads");
    }
    const int count = source.camera >= 0 ? 0 : static_cast<int>(m_capture.get(cv::CAP_PROP_FRAME_COUNT));
    if (count > 0 && (m_last < 0 || m_last >= count)) {
      m_last = count - 1;
    }
  }

  bool next(vpImage<vpRGBa> &I) override
  {
    cv::Mat frame;
    for (; m_skip > 0; m_skip--, m_number++) {
      if (!m_capture.grab()) {
        return false;
      }
    }
    if ((m_last >= 0 && m_number >= m_last) || !m_capture.read(frame)) {
      return false;
    }
    m_number++;
    m_skip = m_step - 1;
    vpImageConvert::convert(frame, I);
    return true;
  }

  int last() const override { return m_last; }
  double framesPerSecond() const override { return m_capture.get(cv::CAP_PROP_FPS); }

private:
  cv::VideoCapture m_capture;
  int m_skip;
  int m_step;
  int m_last;
};
} // namespace

std::unique_ptr<FrameReader> openFrames(const FrameSource &source)
{
  if (!source.images.empty()) {
    return std::make_unique<ImageFiles>(source);
  }
  return std::make_unique<VideoFrames>(source);
}

} // namespace programs
