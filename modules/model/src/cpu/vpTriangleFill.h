// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpTriangleFill_h
#define vpTriangleFill_h

#include <visp3/se3/vpCompatibility.h>

#include <algorithm>
#include <cstdint>

BEGIN_VISP_NAMESPACE

//! A projected corner of a triangle, rounded to a sub-pixel.
struct vpScreenVertex
{
  static constexpr int subPixelBits = 10;
  static constexpr std::int32_t subPixels = 1 << subPixelBits;
  //! |column| and |row| must not be larger, so that integers do not overflow; the crop lies inside.
  static constexpr double limit = 17000.;

  double inverse; //!< Inverse depth, > 0.
  std::int32_t x; //!< Column of the crop, sub-pixels.
  std::int32_t y; //!< Row of the crop, sub-pixels.

  vpScreenVertex() = default;
  vpScreenVertex(double column, double row, double inverseDepth)
      : inverse(inverseDepth), x(toSubPixels(column)), y(toSubPixels(row))
  {
  }

  //! The nearest sub-pixel of a coordinate up to the limit.
  static std::int32_t toSubPixels(double coordinate)
  {
    // Made positive for the cast, which cuts towards zero.
    constexpr std::int32_t offset = static_cast<std::int32_t>(limit) * subPixels;
    return static_cast<std::int32_t>(coordinate * subPixels + (offset + 0.5)) - offset;
  }
};

//! Where triangles are drawn.
struct vpFillTarget
{
  int width;
  int height;
  float *inverseDepth; //!< width x height, 0 where nothing was drawn; the nearest surface stays.
  int *triangle;       //!< Same size, or null; of surfaces that are as near, the least index.
};

/*!
  Draws triangle \e index from both sides.

  Coverage is exact in integers: a pixel belongs to a triangle when its centre is inside, and a centre on an edge to
  the triangle right of it or below, so that triangles that share an edge leave no gap and draw no pixel twice. Depth
  comes from the rounded corners too, so that surfaces that meet at an edge keep their order up to that edge.
  \tparam WithTriangle Whether target.triangle is filled.
*/
template <bool WithTriangle>
void vpFillTriangle(const vpScreenVertex &a, const vpScreenVertex &b, const vpScreenVertex &c, int index,
                    const vpFillTarget &target);

//! True where the corners go clockwise around what is seen, row by row from above.
inline bool isFromBehind(const vpScreenVertex &a, const vpScreenVertex &b, const vpScreenVertex &c)
{
  return std::int64_t(b.x - a.x) * (c.y - a.y) > std::int64_t(c.x - a.x) * (b.y - a.y);
}

//! True where no pixel's centre is in the box around the corners: most triangles of a fine mesh.
inline bool isBetweenPixels(const vpScreenVertex &a, const vpScreenVertex &b, const vpScreenVertex &c)
{
  const auto misses = [](std::int32_t p, std::int32_t q, std::int32_t r) {
    const std::int32_t least = std::min(std::min(p, q), r);
    const std::int32_t most = std::max(std::max(p, q), r);
    return (least + vpScreenVertex::subPixels - 1) >> vpScreenVertex::subPixelBits > most >>
           vpScreenVertex::subPixelBits;
  };
  return misses(a.x, b.x, c.x) || misses(a.y, b.y, c.y);
}

END_VISP_NAMESPACE
#endif
