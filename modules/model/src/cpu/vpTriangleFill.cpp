// SPDX-License-Identifier: GPL-2.0-or-later
#include "vpTriangleFill.h"
#include <visp3/se3/vpExactNumber.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

BEGIN_VISP_NAMESPACE

namespace {
constexpr int subPixelBits = vpScreenVertex::subPixelBits;
constexpr std::int32_t subPixels = vpScreenVertex::subPixels;
//! Triangles up to this extent are tested pixel by pixel in 32 bits.
constexpr std::int32_t smallExtent = 12 * subPixels;

//! First pixel whose centre is at or behind a sub-pixel coordinate.
int firstPixel(std::int32_t fixed)
{
  return (fixed + subPixels - 1) >> subPixelBits;
}

//! Last pixel whose centre is at or before a sub-pixel coordinate.
int lastPixel(std::int32_t fixed)
{
  return fixed >> subPixelBits;
}

//! The corners, turned so that the inside is right of every edge, and the pixels whose centres may be inside.
struct Triangle
{
  std::array<const vpScreenVertex *, 3> corner;
  int left;
  int right;
  int top;
  int bottom;
  bool small;
  bool empty;
  bool fromBehind; //!< Seen from the side where its corners go clockwise.

  Triangle(const vpScreenVertex &a, const vpScreenVertex &b, const vpScreenVertex &c, const vpFillTarget &target)
      : corner({{&a, &b, &c}})
  {
    const std::int32_t minX = std::min(std::min(a.x, b.x), c.x);
    const std::int32_t maxX = std::max(std::max(a.x, b.x), c.x);
    const std::int32_t minY = std::min(std::min(a.y, b.y), c.y);
    const std::int32_t maxY = std::max(std::max(a.y, b.y), c.y);
    left = std::max(firstPixel(minX), 0);
    right = std::min(lastPixel(maxX), target.width - 1);
    top = std::max(firstPixel(minY), 0);
    bottom = std::min(lastPixel(maxY), target.height - 1);
    small = maxX - minX <= smallExtent && maxY - minY <= smallExtent;
    const std::int64_t area = std::int64_t(b.x - a.x) * (c.y - a.y) - std::int64_t(c.x - a.x) * (b.y - a.y);
    empty = left > right || top > bottom || area == 0;
    fromBehind = area > 0;
    if (area < 0) {
      std::swap(corner[1], corner[2]);
    }
  }
};

/*!
  One side of a triangle: pixel (x, y) is inside where perColumn (x - left) + perRow (y - top) + first >= 0, in
  integers that 32 bits hold for a small triangle and 53 bits for any.
*/
template <class Integer> struct Edge
{
  Integer perColumn;
  Integer perRow;
  Integer first;

  Edge(const vpScreenVertex &from, const vpScreenVertex &to, int left, int top)
  {
    const Integer dx = to.x - from.x;
    const Integer dy = to.y - from.y;
    const bool ownsItsPoints = dy < 0 || (dy == 0 && dx > 0);
    perColumn = -dy * subPixels;
    perRow = dx * subPixels;
    first = dx * (top * subPixels - from.y) - dy * (left * subPixels - from.x) - (ownsItsPoints ? 0 : 1);
  }
};

/*!
  Inverse depth over the image: a linear function, held between the corners' values.

  At a silhouette edge the back of an object has the depth of its front. Backs are moved away by more than the rounding
  of floats, so that fronts win there.
*/
struct DepthPlane
{
  double perColumn;
  double perRow;
  double atOrigin;
  float lowest;
  float highest;

  explicit DepthPlane(const Triangle &triangle)
  {
    constexpr double backwards = 1. - 1e-6;
    const vpScreenVertex &a = *triangle.corner[0];
    const vpScreenVertex &b = *triangle.corner[1];
    const vpScreenVertex &c = *triangle.corner[2];
    const double bx = b.x - a.x;
    const double by = b.y - a.y;
    const double cx = c.x - a.x;
    const double cy = c.y - a.y;
    const double factor = triangle.fromBehind ? backwards : 1.;
    const double perArea = factor * subPixels / (bx * cy - cx * by);
    const double db = b.inverse - a.inverse;
    const double dc = c.inverse - a.inverse;
    perColumn = (db * cy - dc * by) * perArea;
    perRow = (dc * bx - db * cx) * perArea;
    atOrigin = factor * a.inverse - (perColumn * a.x + perRow * a.y) / subPixels;
    lowest = static_cast<float>(factor * std::min(std::min(a.inverse, b.inverse), c.inverse));
    highest = static_cast<float>(factor * std::max(std::max(a.inverse, b.inverse), c.inverse));
  }

  float at(int x, int y) const { return static_cast<float>(atOrigin + perRow * y + perColumn * x); }
  float held(float inverse) const { return std::min(std::max(inverse, lowest), highest); }
};

//! Whether a triangle is seen at a pixel rather than what is there, whatever the order in which they are drawn.
bool isNearer(float value, float before, int index, int triangleBefore)
{
  return value > before || (vpIsSame(value, before) && index < triangleBefore);
}

template <bool WithTriangle> void fillSmall(const Triangle &t, int index, const vpFillTarget &target)
{
  const Edge<std::int32_t> ab(*t.corner[0], *t.corner[1], t.left, t.top);
  const Edge<std::int32_t> bc(*t.corner[1], *t.corner[2], t.left, t.top);
  const Edge<std::int32_t> ca(*t.corner[2], *t.corner[0], t.left, t.top);
  // Many triangles of a fine mesh miss the only pixel of their box, and need no depth.
  if (t.left == t.right && t.top == t.bottom && (ab.first | bc.first | ca.first) < 0) {
    return;
  }
  const DepthPlane plane(t);
  const float perColumn = static_cast<float>(plane.perColumn);
  for (int y = t.top; y <= t.bottom; ++y) {
    const int row = y - t.top;
    std::int32_t inAb = ab.first + row * ab.perRow;
    std::int32_t inBc = bc.first + row * bc.perRow;
    std::int32_t inCa = ca.first + row * ca.perRow;
    float inverse = plane.at(t.left, y);
    std::size_t pixel =
        static_cast<std::size_t>(y) * static_cast<std::size_t>(target.width) + static_cast<std::size_t>(t.left);
    for (int x = t.left; x <= t.right; ++x, ++pixel) {
      const float value = plane.held(inverse);
      if ((inAb | inBc | inCa) >= 0 &&
          isNearer(value, target.inverseDepth[pixel], index, WithTriangle ? target.triangle[pixel] : -1)) {
        target.inverseDepth[pixel] = value;
        if (WithTriangle) {
          target.triangle[pixel] = index;
        }
      }
      inAb += ab.perColumn;
      inBc += bc.perColumn;
      inCa += ca.perColumn;
      inverse += perColumn;
    }
  }
}

//! Narrows the pixels first..last, counted from the triangle's left, to those inside one edge in a row.
void narrow(const Edge<std::int64_t> &edge, int row, int &first, int &last)
{
  const double slope = static_cast<double>(edge.perColumn);
  const double atLeft = static_cast<double>(edge.first + row * edge.perRow);
  if (vpIsZero(slope)) {
    last = atLeft < 0. ? first - 1 : last;
    return;
  }
  // The quotient of these integers never rounds across one: it is exact where it is whole.
  const double crossing = std::min(std::max(-atLeft / slope, first - 1.), last + 1.);
  const int pixel = static_cast<int>(crossing);
  if (slope > 0.) {
    first = std::max(first, pixel + (pixel < crossing ? 1 : 0));
  } else {
    last = std::min(last, pixel - (pixel > crossing ? 1 : 0));
  }
}

template <bool WithTriangle> void fillLarge(const Triangle &t, int index, const vpFillTarget &target)
{
  const std::array<Edge<std::int64_t>, 3> edges = {{{*t.corner[0], *t.corner[1], t.left, t.top},
                                                    {*t.corner[1], *t.corner[2], t.left, t.top},
                                                    {*t.corner[2], *t.corner[0], t.left, t.top}}};
  const DepthPlane plane(t);
  const float perColumn = static_cast<float>(plane.perColumn);
  for (int y = t.top; y <= t.bottom; ++y) {
    int first = 0;
    int last = t.right - t.left;
    for (const Edge<std::int64_t> &edge : edges) {
      narrow(edge, y - t.top, first, last);
    }
    const float atFirst = plane.at(t.left + first, y);
    const std::ptrdiff_t start = std::ptrdiff_t(y) * target.width + t.left + first;
    float *inverseDepth = target.inverseDepth + start;
    int *triangle = WithTriangle ? target.triangle + start : nullptr;
    for (int i = 0; i <= last - first; ++i) {
      const float value = plane.held(atFirst + perColumn * static_cast<float>(i));
      const bool nearer = isNearer(value, inverseDepth[i], index, WithTriangle ? triangle[i] : -1);
      inverseDepth[i] = nearer ? value : inverseDepth[i];
      if (WithTriangle) {
        triangle[i] = nearer ? index : triangle[i];
      }
    }
  }
}
} // namespace

template <bool WithTriangle>
void vpFillTriangle(const vpScreenVertex &a, const vpScreenVertex &b, const vpScreenVertex &c, int index,
                    const vpFillTarget &target)
{
  const Triangle t(a, b, c, target);
  if (t.empty) {
    return;
  }
  if (t.small) {
    fillSmall<WithTriangle>(t, index, target);
  } else {
    fillLarge<WithTriangle>(t, index, target);
  }
}

template void vpFillTriangle<false>(const vpScreenVertex &, const vpScreenVertex &, const vpScreenVertex &, int,
                                    const vpFillTarget &);
template void vpFillTriangle<true>(const vpScreenVertex &, const vpScreenVertex &, const vpScreenVertex &, int,
                                   const vpFillTarget &);

END_VISP_NAMESPACE
