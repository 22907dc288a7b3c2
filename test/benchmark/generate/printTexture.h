// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef benchPrintTexture_h
#define benchPrintTexture_h

#include <opencv2/core.hpp>

#include <cstdint>

namespace bench {

/*!
  A picture as it is printed on packages: a coloured ground with pictures, shapes, stripes and text.
  \param width, height Pixels, at least 16.
  \param seed, which The same numbers give the same picture.
  \return 8-bit BGR.
*/
cv::Mat printTexture(int width, int height, std::uint64_t seed, std::uint64_t which);

/*!
  Smooth random clouds.
  \param cells Number of the coarsest waves across the larger side, > 0.
  \param octaves Number of scales, each half the size of the one before.
  \return 32-bit floats around 0.5, mostly in [0, 1].
*/
cv::Mat cloudTexture(int width, int height, int cells, int octaves, std::uint64_t seed, std::uint64_t which);

} // namespace bench
#endif
