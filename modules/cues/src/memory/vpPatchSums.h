// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpPatchSums_h
#define vpPatchSums_h

#include <visp3/se3/vpCompatibility.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

BEGIN_VISP_NAMESPACE

// A colour as patches are compared by: brightness, and what two channels have more than green. Four lanes, so that they
// go through vector instructions; the fourth one is 0.
using vpShade = std::array<float, 4>;

inline vpShade vpShadeOf(const float *color, unsigned int channels)
{
  if (channels == 1) {
    return {color[0], 0.F, 0.F, 0.F};
  }
  return {0.25F * (color[0] + 2.F * color[1] + color[2]), color[0] - color[1], color[2] - color[1], 0.F};
}

/*
  Sums over the places of a patch that are seen. Brightness is compared about the patch's mean, as the light on it
  changes when the object turns; the rest of the colours about the mean of all that is remembered.
*/
struct vpPatchSums
{
  std::size_t seen = 0;
  std::size_t known = 0;

  void add(const vpShade &remembered, const vpShade &shown, const vpShade &middle)
  {
    ++known;
    for (std::size_t i = 0; i < 4; ++i) {
      const float a = remembered[i] - middle[i];
      const float b = shown[i] - middle[i];
      xx[i] += a * a;
      yy[i] += b * b;
      xy[i] += a * b;
    }
    x += remembered[0] - middle[0];
    y += shown[0] - middle[0];
  }

  // Deviation of what is remembered, gray levels. pre: known > 0.
  float deviation() const { return std::sqrt(std::max(sum(xx, x, x), 0.F) / static_cast<float>(known)); }
  // pre: known > 0.
  float correlation() const
  {
    // What noise and rounding leave on a surface of one colour correlates with nothing.
    const float least = 4.F * static_cast<float>(known);
    return sum(xy, x, y) / std::sqrt((std::max(sum(xx, x, x), 0.F) + least) * (std::max(sum(yy, y, y), 0.F) + least));
  }

private:
  float sum(const vpShade &products, float first, float second) const
  {
    return products[0] + products[1] + products[2] - first * second / static_cast<float>(known);
  }

  vpShade xx{}, yy{}, xy{};
  float x = 0.F, y = 0.F; // Of brightness.
};

END_VISP_NAMESPACE
#endif
