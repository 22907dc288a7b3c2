// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpPixelNumber_h
#define vpPixelNumber_h

#include <visp3/core/vpRGBa.h>
#include <visp3/se3/vpCompatibility.h>

#include <cstdint>
#include <cstring>

BEGIN_VISP_NAMESPACE

//! A pixel as vpColorHistograms takes it.
inline std::uint32_t toPixelNumber(const vpRGBa &pixel)
{
  std::uint32_t number = 0;
  static_assert(sizeof(pixel) == sizeof(number), "red, green, blue and alpha");
  std::memcpy(&number, &pixel, sizeof(number));
  return number;
}

inline std::uint32_t toPixelNumber(unsigned char pixel)
{
  return pixel;
}

//! Of a pixel with three channels, gray levels; green counts double.
inline double brightnessOf(std::uint32_t pixel)
{
  return 0.25 * ((pixel & 0xFFU) + 2U * ((pixel >> 8U) & 0xFFU) + ((pixel >> 16U) & 0xFFU));
}

END_VISP_NAMESPACE
#endif
