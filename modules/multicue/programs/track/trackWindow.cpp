// SPDX-License-Identifier: GPL-2.0-or-later
#include "track/trackWindow.h"

#include <visp3/core/vpException.h>
#include <visp3/core/vpImageConvert.h>
#include <visp3/gui/vpDisplayX.h>

#include <algorithm>
#include <cstdlib>
#include <iostream>

namespace programs {

std::unique_ptr<TrackWindow> TrackWindow::open(const cv::Size &size)
{
#ifdef VISP_HAVE_X11
  const char *name = std::getenv("DISPLAY");
  if (name && *name) {
    try {
      std::unique_ptr<TrackWindow> window(new TrackWindow);
      window->m_picture.resize(static_cast<unsigned int>(size.height), static_cast<unsigned int>(size.width));
      window->m_display = std::make_unique<vpDisplayX>(window->m_picture, 50, 50, "multicue-track: q ends");
      return window;
    } catch (const vpException &) {
      std::cout << "Without a window: display " << name << " cannot be opened" << std::endl;
      return nullptr;
    }
  }
#else
  static_cast<void>(size);
#endif
  std::cout << "Without a window: there is no display" << std::endl;
  return nullptr;
}

TrackWindow::~TrackWindow()
{
  m_display.reset(); // Before the picture that it points to.
}

void TrackWindow::show(const cv::Mat &picture)
{
  vpImage<vpRGBa> converted;
  vpImageConvert::convert(picture, converted);
  std::copy(converted.bitmap, converted.bitmap + converted.getSize(), m_picture.bitmap);
  vpDisplay::display(m_picture);
  vpDisplay::flush(m_picture);
}

std::string TrackWindow::key(bool wait)
{
  std::string key;
  return vpDisplay::getKeyboardEvent(m_picture, key, wait) ? key : "";
}

bool TrackWindow::click(vpImagePoint &point)
{
  vpMouseButton::vpMouseButtonType button = vpMouseButton::button1;
  vpDisplay::getClick(m_picture, point, button, true);
  return button == vpMouseButton::button1;
}

} // namespace programs
