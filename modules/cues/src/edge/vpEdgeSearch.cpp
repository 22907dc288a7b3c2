// SPDX-License-Identifier: GPL-2.0-or-later
#include "edge/vpEdgeSearch.h"

#include <algorithm>
#include <cmath>

BEGIN_VISP_NAMESPACE

namespace {
// Positions in 1/65536 of a pixel step along a line without drift over the lengths used here; 8 bits weight the
// neighbours.
const int fractionBits = 16;
const int weightBits = 8;

int toFixed(double x)
{
  return static_cast<int>(std::lround(x * (1 << fractionBits)));
}

// 65536 times the bilinear gray level.
int interpolate(const unsigned char *pixels, int stride, int u, int v)
{
  const unsigned char *p = pixels + (v >> fractionBits) * stride + (u >> fractionBits);
  const int a = (u >> (fractionBits - weightBits)) & ((1 << weightBits) - 1);
  const int b = (v >> (fractionBits - weightBits)) & ((1 << weightBits) - 1);
  const int upper = (p[0] << weightBits) + a * (p[1] - p[0]);
  const int lower = (p[stride] << weightBits) + a * (p[stride + 1] - p[stride]);
  return (upper << weightBits) + b * (lower - upper);
}
} // namespace

vpEdgeSearch::vpEdgeSearch(const vpImage<unsigned char> &I, const vpEdgeCueSettings &settings)
    : m_I(I), m_range(static_cast<int>(std::ceil(settings.range))),
      m_half((static_cast<int>(settings.maskSize) - 1) / 2), m_reach(settings.range),
      m_contrast(static_cast<float>(settings.contrast))
{
  // The derivative of a Gaussian: its peak over a step is smooth, which a parabola finds to a fraction of a pixel.
  const double sigma = 0.5 * m_half;
  double sum = 0.;
  for (int j = 1; j <= m_half; ++j) {
    m_kernel.push_back(static_cast<float>(j * std::exp(-0.5 * j * j / (sigma * sigma))));
    sum += static_cast<double>(m_kernel.back());
  }
  for (float &weight : m_kernel) {
    weight /= static_cast<float>(sum); // So that a step's response is its height in gray levels.
  }
  const std::size_t length = static_cast<std::size_t>(2 * (m_range + m_half + 1) + 1);
  m_profile.resize(length);
  m_gradient.resize(length);
}

bool vpEdgeSearch::findLimits(const Eigen::Vector2d &pixel, const Eigen::Vector2d &normal, int &low, int &high) const
{
  // Everything read stays inside: the line, the mask's width beside it, and a neighbour for the interpolation.
  const double margin = m_half + 1.;
  const Eigen::Vector2d size(m_I.getWidth(), m_I.getHeight());
  double from = -m_range - 1. - m_half;
  double to = m_range + 1. + m_half;
  for (int axis = 0; axis < 2; ++axis) {
    const double least = margin - pixel[axis];
    const double most = size[axis] - 2. - margin - pixel[axis];
    if (least > 0. || most < 0.) {
      return false;
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

void vpEdgeSearch::readProfile(const Eigen::Vector2d &pixel, const Eigen::Vector2d &normal, int low, int high)
{
  const int stride = static_cast<int>(m_I.getWidth());
  const int stepU = toFixed(normal.x());
  const int stepV = toFixed(normal.y());
  const int first = low - m_half;
  const int count = high - low + 2 * m_half + 1;
  const int width = 2 * m_half + 1;
  std::fill_n(m_profile.begin(), count, 0.F);
  const float scale = 1.F / (65536.F * static_cast<float>(width));
  for (int w = -m_half; w <= m_half; ++w) {
    int u = toFixed(pixel.x()) + first * stepU - w * stepV;
    int v = toFixed(pixel.y()) + first * stepV + w * stepU;
    for (int k = 0; k < count; ++k) {
      m_profile[static_cast<std::size_t>(k)] += static_cast<float>(interpolate(m_I.bitmap, stride, u, v)) * scale;
      u += stepU;
      v += stepV;
    }
  }
}

float vpEdgeSearch::gradient(int index) const
{
  float sum = 0.F;
  for (int j = 1; j <= m_half; ++j) {
    sum += m_kernel[static_cast<std::size_t>(j - 1)] *
           (m_profile[static_cast<std::size_t>(index + j)] - m_profile[static_cast<std::size_t>(index - j)]);
  }
  return sum;
}

void vpEdgeSearch::findExtrema(int low, int high)
{
  const int count = high - low + 1;
  for (int k = 0; k < count; ++k) {
    m_gradient[static_cast<std::size_t>(k)] = gradient(k + m_half);
  }
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
    Extremum extremum;
    extremum.offset = low + static_cast<double>(k) + 0.5 * static_cast<double>((before - after) / curvature);
    extremum.contrast = static_cast<double>(m_gradient[k]);
    if (std::fabs(extremum.offset) <= m_reach) {
      m_extrema.push_back(extremum);
    }
  }
}

const std::vector<vpEdgeSearch::Extremum> &vpEdgeSearch::along(const Eigen::Vector2d &pixel,
                                                               const Eigen::Vector2d &normal)
{
  m_extrema.clear();
  int low = 0;
  int high = 0;
  if (findLimits(pixel, normal, low, high)) {
    readProfile(pixel, normal, low, high);
    findExtrema(low, high);
  }
  return m_extrema;
}

END_VISP_NAMESPACE
