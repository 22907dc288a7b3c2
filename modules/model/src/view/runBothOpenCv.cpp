// SPDX-License-Identifier: GPL-2.0-or-later
#include "view/runBoth.h"

#include <opencv2/core/utility.hpp>

#include <array>
#include <exception>

BEGIN_VISP_NAMESPACE

// OpenCV's threads wait for work, so a task costs microseconds, and its user has set how many there are.
void vpRunBoth(const std::function<void()> &first, const std::function<void()> &second)
{
  std::array<std::exception_ptr, 2> thrown;
  cv::parallel_for_(cv::Range(0, 2), [&](const cv::Range &range) {
    for (int i = range.start; i < range.end; ++i) {
      try {
        i == 0 ? first() : second();
      } catch (...) { // Not all of OpenCV's threads hand on what it is.
        thrown[static_cast<std::size_t>(i)] = std::current_exception();
      }
    }
  });
  for (const std::exception_ptr &exception : thrown) {
    if (exception) {
      std::rethrow_exception(exception);
    }
  }
}

END_VISP_NAMESPACE
