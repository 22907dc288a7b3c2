// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef overlayWriter_h
#define overlayWriter_h

#include <visp3/multicue/vpMbMultiCueTracker.h>

#include <opencv2/videoio.hpp>

#include <string>

#ifdef ENABLE_VISP_NAMESPACE
using namespace VISP_NAMESPACE_NAME;
#endif

/*!
  Draws the model's edges and the features over the images, without a display, and writes them as a video or as images.
  Edges are green, orange or red for the states TRACKING, UNCERTAIN and LOST.
*/
class OverlayWriter
{
public:
  /*!
    \param file .mp4 or .avi for a video, or a pattern such as out%04d.png for images.
    \param framesPerSecond Of the video, > 0.
    \throw vpException naming the file, if it can never be written.
  */
  OverlayWriter(const std::string &file, double framesPerSecond);

  /*!
    \param I Image in which the pose was found.
    \param tracker After its track().
    \param frame Number of the frame.
    \throw vpException naming the file that cannot be written.
  */
  void write(const vpImage<vpRGBa> &I, vpMbMultiCueTracker &tracker, int frame);

  //! \return The file that is written: another one than asked for where OpenCV cannot encode .mp4.
  const std::string &file() const { return m_file; }

private:
  void openVideo(const cv::Size &size);

  std::string m_file;
  double m_framesPerSecond;
  bool m_isVideo;
  cv::VideoWriter m_video;
};

#endif
