// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef programsVideoFile_h
#define programsVideoFile_h

#include <opencv2/videoio.hpp>

#include <string>

namespace programs {

//! Writes pictures as a video, or as numbered images.
class VideoFile
{
public:
  /*!
    \param option Name of the option that asked for the file, for messages.
    \param file .mp4 or .avi for a video, or a pattern such as out%04d.png for images.
    \param framesPerSecond Of the video, > 0.
    \throw vpException naming the file, if it can never be written.
  */
  VideoFile(const std::string &option, const std::string &file, double framesPerSecond);

  /*!
    \param picture 8-bit BGR, all of one size.
    \param number Of the picture; images are called so.
    \throw vpException naming the file that cannot be written.
  */
  void write(const cv::Mat &picture, int number);

  //! \return The file that is written: another one than asked for where OpenCV cannot encode .mp4.
  const std::string &file() const { return m_file; }

private:
  void openVideo(const cv::Size &size);
  [[noreturn]] void fail(const std::string &text) const;

  std::string m_option;
  std::string m_file;
  double m_framesPerSecond;
  bool m_isVideo;
  cv::VideoWriter m_video;
};

} // namespace programs
#endif
