// SPDX-License-Identifier: GPL-2.0-or-later
#include "edge/vpEdgeSearch.h"

#include "frame/vpLight.h"

#include <algorithm>
#include <cmath>
#include <cstring>

BEGIN_VISP_NAMESPACE

namespace {
const double unknownLevel = 255.;
// Positions in 1/65536 of a pixel step along a line without drift over the lengths used here.
const int fractionBits = 16;

int toFixed(double x)
{
  return static_cast<int>(std::lround(x * (1 << fractionBits)));
}

// a b / 65536: one instruction for several numbers at once.
std::uint16_t highProduct(std::uint16_t a, std::uint16_t b)
{
  return static_cast<std::uint16_t>((static_cast<std::uint32_t>(a) * b) >> 16);
}

// 256 times the gray level at fraction / 256 from the first of two pixels to the second.
std::uint16_t between(const unsigned char *pixels, std::uint16_t fraction)
{
  return static_cast<std::uint16_t>((256 - fraction) * pixels[0] + fraction * pixels[1]);
}
} // namespace

vpEdgeSearch::vpEdgeSearch(const vpImage<unsigned char> &I, const vpEdgeCueSettings &settings)
    : m_I(I), m_range(static_cast<int>(std::ceil(settings.range))),
      m_half((static_cast<int>(settings.maskSize) - 1) / 2), m_reach(settings.range),
      m_contrast(static_cast<float>(settings.contrast))
{
  // The derivative of a Gaussian: its peak over a step is smooth, which a parabola finds to a fraction of a pixel. This
  // wide, sharp edges are found to 0.05 pixels wherever they lie between the samples.
  const double sigma = 0.7 * m_half;
  double sum = 0.;
  for (int j = 1; j <= m_half; ++j) {
    sum += j * std::exp(-0.5 * j * j / (sigma * sigma));
  }
  // So that a step's response is its height in gray levels; the profile is a sum over the mask's width in 1 / 256.
  const double scale = 1. / (256. * (2 * m_half + 1) * sum);
  for (int j = 1; j <= m_half; ++j) {
    m_kernel[static_cast<std::size_t>(j - 1)] =
        static_cast<float>(scale * j * std::exp(-0.5 * j * j / (sigma * sigma)));
  }
}

bool vpEdgeSearch::findLimits(const Eigen::Vector2d &pixel, const Eigen::Vector2d &normal, int &low, int &high) const
{
  // Everything read stays inside: the line and the mask's width beside it. A pixel to the right and below is read as
  // well where its weight may not be zero, and fixed-point steps may end this far from where they should:
  const double rounding = 0.01;
  const Eigen::Vector2d size(m_I.getWidth(), m_I.getHeight());
  double from = -m_range - 1. - m_half;
  double to = m_range + 1. + m_half;
  for (int axis = 0; axis < 2; ++axis) {
    const double margin = m_half * std::fabs(normal[1 - axis]) + rounding;
    const double least = margin - pixel[axis];
    const double most = size[axis] - 1. - margin - pixel[axis];
    if (!(least <= 0. && most >= 0.)) {
      return false; // Also where the pixel is not a number.
    }
    if (normal[axis] > 0.) {
      from = std::max(from, least / normal[axis]);
      to = std::min(to, most / normal[axis]);
    } else if (normal[axis] < 0.) {
      from = std::max(from, most / normal[axis]);
      to = std::min(to, least / normal[axis]);
    }
  }
  low = static_cast<int>(std::ceil(from)) + m_half;
  high = static_cast<int>(std::floor(to)) - m_half;
  return high - low >= 2;
}

void vpEdgeSearch::gather(const Eigen::Vector2d &pixel, const Eigen::Vector2d &normal, int first, int count)
{
  const std::ptrdiff_t stride = m_I.getWidth();
  const std::ptrdiff_t stepU = toFixed(normal.x());
  const std::ptrdiff_t stepV = toFixed(normal.y());
  const std::ptrdiff_t startU = toFixed(pixel.x()) + first * stepU;
  const std::ptrdiff_t startV = toFixed(pixel.y()) + first * stepV;
  std::size_t n = 0;
  for (int w = -m_half; w <= m_half; ++w) {
    std::ptrdiff_t u = startU - w * stepV;
    std::ptrdiff_t v = startV + w * stepU;
    for (int k = 0; k < count; ++k) {
      const unsigned char *p = m_I.bitmap + (v >> fractionBits) * stride + (u >> fractionBits);
      std::memcpy(&m_samples.upper[2 * n], p, 2);
      std::memcpy(&m_samples.lower[2 * n], p + stride, 2);
      m_samples.right[n] = static_cast<std::uint16_t>(u);
      m_samples.down[n] = static_cast<std::uint16_t>(v);
      u += stepU;
      v += stepV;
      ++n;
    }
  }
}

void vpEdgeSearch::interpolate(int count)
{
  const int width = 2 * m_half + 1;
  // In full blocks, of a length that the compiler knows.
  for (int block = 0; block < count * width; block += lanes) {
    for (int lane = 0; lane < lanes; ++lane) {
      const std::size_t i = static_cast<std::size_t>(block + lane);
      const std::uint16_t a = m_samples.right[i] >> 8;
      const std::uint16_t b = m_samples.down[i];
      const std::uint16_t above = between(&m_samples.upper[2 * i], a);
      const std::uint16_t below = between(&m_samples.lower[2 * i], a);
      m_samples.level[i] =
          static_cast<std::uint16_t>(highProduct(above, static_cast<std::uint16_t>(~b)) + highProduct(below, b));
    }
  }
  std::copy_n(m_samples.level.begin(), count, m_profile.begin());
  for (int w = 1; w < width; ++w) {
    const std::uint16_t *row = m_samples.level.data() + w * count;
    for (int k = 0; k < count; ++k) {
      m_profile[static_cast<std::size_t>(k)] += row[k];
    }
  }
}

void vpEdgeSearch::findGradient(int count)
{
  std::fill_n(m_gradient.begin(), count, 0.F);
  for (int j = 1; j <= m_half; ++j) {
    const float weight = m_kernel[static_cast<std::size_t>(j - 1)];
    const std::int32_t *behind = m_profile.data() + m_half - j;
    const std::int32_t *ahead = m_profile.data() + m_half + j;
    for (int k = 0; k < count; ++k) {
      m_gradient[static_cast<std::size_t>(k)] += weight * static_cast<float>(ahead[k] - behind[k]);
    }
  }
}

vpEdgeSearch::Extremum *vpEdgeSearch::findExtrema(int low, int high)
{
  const int count = high - low + 1;
  Extremum *found = m_extrema.data();
  for (std::size_t k = 1; k + 1 < static_cast<std::size_t>(count); ++k) {
    const float middle = std::fabs(m_gradient[k]);
    if (middle < m_contrast) {
      continue;
    }
    const float sign = m_gradient[k] > 0.F ? 1.F : -1.F;
    const float before = sign * m_gradient[k - 1];
    const float after = sign * m_gradient[k + 1];
    if (middle < before || middle <= after) {
      continue;
    }
    const float curvature = before - 2.F * middle + after;
    found->offset = low + static_cast<double>(k) + 0.5 * static_cast<double>((before - after) / curvature);
    found->contrast = static_cast<double>(m_gradient[k]);
    if (std::fabs(found->offset) <= m_reach) {
      ++found;
    }
  }
  return found;
}

// \param first Offset of the profile's first sample. \param count Number of its samples.
double vpEdgeSearch::findBrightest(int first, int count) const
{
  const int begin = std::max(-vpLight::reach - first, 0);
  const int end = std::min(vpLight::reach - first + 1, count);
  if (begin >= end) {
    return unknownLevel;
  }
  return *std::max_element(m_profile.begin() + begin, m_profile.begin() + end) / (256. * (2 * m_half + 1));
}

vpEdgeSearch::Extrema vpEdgeSearch::along(const Eigen::Vector2d &pixel, const Eigen::Vector2d &normal)
{
  int low = 0;
  int high = 0;
  if (!findLimits(pixel, normal, low, high)) {
    return {m_extrema.data(), m_extrema.data(), unknownLevel};
  }
  const int length = high - low + 2 * m_half + 1;
  gather(pixel, normal, low - m_half, length);
  interpolate(length);
  findGradient(high - low + 1);
  return {m_extrema.data(), findExtrema(low, high), findBrightest(low - m_half, length)};
}

END_VISP_NAMESPACE
