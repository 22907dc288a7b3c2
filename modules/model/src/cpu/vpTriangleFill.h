// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpTriangleFill_h
#define vpTriangleFill_h

#include <visp3/se3/vpCompatibility.h>

#include <cstdint>

BEGIN_VISP_NAMESPACE

//! A projected corner of a triangle.
struct vpScreenVertex
{
  //! |x| and |y| must not be larger, so that sub-pixel integers do not overflow; the crop lies inside.
  static constexpr double limit = 70000.;

  double x;            //!< Crop pixels.
  double y;            //!< Crop pixels.
  double inverse;      //!< Inverse depth, > 0.
  std::int32_t fixedX; //!< Rounded to 1/256 pixel, times 256.
  std::int32_t fixedY;

  vpScreenVertex() = default;
  vpScreenVertex(double column, double row, double inverseDepth);
};

//! Where triangles are drawn.
struct vpFillTarget
{
  int width;
  int height;
  float *inverseDepth; //!< width x height, 0 where nothing was drawn; the nearest surface stays.
  int *triangle;       //!< Same size, or null.
};

/*!
  Draws triangle \e index from both sides.

  Coverage is exact in integers of 1/256 pixel: a pixel belongs to a triangle when its centre is inside, and a
  centre on an edge to the triangle right of it or below, so that triangles that share an edge leave no gap and draw no
  pixel twice. Depth comes from the corners before rounding.
  \tparam WithTriangle Whether target.triangle is filled.
*/
template <bool WithTriangle>
void vpFillTriangle(const vpScreenVertex &a, const vpScreenVertex &b, const vpScreenVertex &c, int index,
                    const vpFillTarget &target);

inline vpScreenVertex::vpScreenVertex(double column, double row, double inverseDepth)
    : x(column), y(row), inverse(inverseDepth)
{
  // Made positive for the cast, which cuts towards zero.
  constexpr std::int32_t offset = static_cast<std::int32_t>(limit) * 256;
  fixedX = static_cast<std::int32_t>(x * 256. + (offset + 0.5)) - offset;
  fixedY = static_cast<std::int32_t>(y * 256. + (offset + 0.5)) - offset;
}

END_VISP_NAMESPACE
#endif
