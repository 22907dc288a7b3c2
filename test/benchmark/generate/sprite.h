// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef benchSprite_h
#define benchSprite_h

#include <opencv2/core.hpp>

namespace bench {

//! A flat picture with an outline.
struct Sprite
{
  cv::Mat color; //!< 8-bit BGR.
  cv::Mat alpha; //!< 32-bit floats, [0, 1], 0 along the border.

  //! \param map From the sprite's pixels to the image's.
  //! \param image, hidden See Foreground::draw().
  void draw(const cv::Matx23d &map, cv::Mat &image, cv::Mat &hidden) const;
};

} // namespace bench
#endif
