// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef programsTrackWindow_h
#define programsTrackWindow_h

#include <visp3/core/vpDisplay.h>
#include <visp3/core/vpImage.h>
#include <visp3/core/vpRGBa.h>

#include <opencv2/core.hpp>

#include <memory>
#include <string>

#ifdef ENABLE_VISP_NAMESPACE
using namespace VISP_NAMESPACE_NAME;
#endif

namespace programs {

//! A window that shows pictures of one size, and asks for keys and clicks.
class TrackWindow
{
public:
  //! \return Null where there is no display to open it on, which is said on the output. \param size Of the pictures.
  static std::unique_ptr<TrackWindow> open(const cv::Size &size);
  ~TrackWindow();
  TrackWindow(const TrackWindow &) = delete;
  TrackWindow &operator=(const TrackWindow &) = delete;

  void show(const cv::Mat &picture);
  //! \return The key that was pressed, empty for none. \param wait Wait for one.
  std::string key(bool wait);
  //! Waits for a click. \return False for another button than the left one.
  bool click(vpImagePoint &point);

private:
  TrackWindow() = default;

  vpImage<vpRGBa> m_picture;
  std::unique_ptr<vpDisplay> m_display;
};

} // namespace programs
#endif
