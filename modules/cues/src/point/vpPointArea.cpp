// SPDX-License-Identifier: GPL-2.0-or-later
#include "point/vpPointArea.h"

#include <algorithm>
#include <cmath>

BEGIN_VISP_NAMESPACE

namespace {
// How far points may be from where they are expected, and the window around them.
const double areaMargin = 32.; // Pixels.
// Areas grow by this much at once, so that two frames seldom need areas of different size.
const int areaStep = 64; // Pixels.
} // namespace

cv::Rect vpPointArea::expected(const vpModelView &view, const vpPointCamera &camera, const cv::Size &size)
{
  const cv::Rect whole(cv::Point(), size);
  Eigen::Vector2d low = Eigen::Vector2d::Constant(HUGE_VAL);
  Eigen::Vector2d high = -low;
  for (int k = 0; k < 8; ++k) {
    const Eigen::Vector3d &a = view.model().boxMin();
    const Eigen::Vector3d &b = view.model().boxMax();
    const Eigen::Vector3d cX =
        camera.toCamera({(k & 1) != 0 ? a.x() : b.x(), (k & 2) != 0 ? a.y() : b.y(), (k & 4) != 0 ? a.z() : b.z()});
    if (!(cX.z() > 1e-3)) {
      return cX.z() <= 1e-3 ? whole : cv::Rect();
    }
    const Eigen::Vector2d pixel = camera.project(cX);
    low = low.cwiseMin(pixel);
    high = high.cwiseMax(pixel);
  }
  low = (low.array() - areaMargin).cwiseMax(0.);
  high = (high.array() + areaMargin + 1.).min(Eigen::Array2d(size.width, size.height));
  if (!(high.x() - low.x() > 1. && high.y() - low.y() > 1.)) {
    return cv::Rect();
  }
  return cv::Rect(cv::Point(static_cast<int>(low.x()), static_cast<int>(low.y())),
                  cv::Point(static_cast<int>(high.x()), static_cast<int>(high.y())));
}

cv::Rect vpPointArea::placed(const cv::Size &size, const cv::Rect &around, const cv::Size &image)
{
  const auto start = [](int from, int length, int side, int most) {
    return std::max(std::min(from + (length - side) / 2, most - side), 0);
  };
  return cv::Rect(cv::Point(start(around.x, around.width, size.width, image.width),
                            start(around.y, around.height, size.height, image.height)),
                  size);
}

cv::Size vpPointArea::size(const cv::Rect &needed, const cv::Rect &before, const cv::Size &image)
{
  if (needed.width <= before.width && needed.height <= before.height && before.area() < 3 * needed.area()) {
    return before.size();
  }
  const auto rounded = [](int length) { return (length + areaStep - 1) / areaStep * areaStep; };
  return cv::Size(std::min(rounded(needed.width), image.width), std::min(rounded(needed.height), image.height));
}

END_VISP_NAMESPACE
