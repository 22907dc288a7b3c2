// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpChamfer_h
#define vpChamfer_h

#include <visp3/se3/vpCompatibility.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>

BEGIN_VISP_NAMESPACE

/*!
  The two-pass distance transform with weights 5, 7 and 11 for steps to the side, along a diagonal and of the knight in
  chess, here doubled, so that a distance is at most 2 % from the Euclidean one. Works on eight maps at once, whose
  values at a pixel are beside each other: the steps of the recursion are vector instructions.
*/
class vpChamfer
{
public:
  static constexpr int lanes = 8;
  static constexpr int margin = 2; //!< Pixels around the map that the transform reads; they hold the limit.
  static constexpr int side = 10;  //!< Steps of the map per pixel.
  static constexpr int diagonal = 14;
  static constexpr int knight = 22;
  static constexpr double maxDistance = 23.; //!< Pixels: a limit and a step together are below 256.

  //! \param inside First pixel of the map, within its margin. \param stride Pixels per row, margin included.
  vpChamfer(std::uint8_t *inside, std::size_t stride, int columns, int rows)
      : m_inside(inside), m_stride(static_cast<std::ptrdiff_t>(stride)), m_columns(columns), m_rows(rows)
  {
  }

  //! From 0 at the edges, and the limit elsewhere, to distances.
  void transform() const
  {
    for (int y = 0; y < m_rows; ++y) {
      takeOver<-1>(row(y));
      takeAlong<1>(row(y));
    }
    for (int y = m_rows - 1; y >= 0; --y) {
      takeOver<1>(row(y));
      takeAlong<-1>(row(y) + (m_columns - 1) * lanes);
    }
  }

private:
  std::uint8_t *row(int y) const { return m_inside + y * m_stride * lanes; }

  static std::uint8_t sum(std::uint8_t value, int step) { return static_cast<std::uint8_t>(value + step); }

  // From the two rows before this one; all of a row at once.
  template <int Before> void takeOver(std::uint8_t *here) const
  {
    const std::ptrdiff_t n = static_cast<std::ptrdiff_t>(m_columns) * lanes;
    std::uint8_t *__restrict to = here;
    const std::uint8_t *__restrict near = here + Before * m_stride * lanes;
    const std::uint8_t *__restrict far = near + Before * m_stride * lanes;
    for (std::ptrdiff_t k = 0; k < n; ++k) {
      const std::uint8_t knights = std::min(std::min(near[k - 2 * lanes], near[k + 2 * lanes]), //
                                            std::min(far[k - lanes], far[k + lanes]));
      const std::uint8_t diagonals = std::min(near[k - lanes], near[k + lanes]);
      const std::uint8_t stepped = std::min(sum(knights, knight), sum(diagonals, diagonal));
      to[k] = std::min(std::min(to[k], sum(near[k], side)), stepped);
    }
  }

  // From the pixel before this one, which is only known then. Plain loops over the lanes, without std::copy and
  // std::min: GCC then keeps that pixel in a vector register, which makes this pass several times as fast.
  template <int Step> void takeAlong(std::uint8_t *first) const
  {
    std::uint8_t last[lanes];
    for (int k = 0; k < lanes; ++k) {
      last[k] = first[k];
    }
    const int count = m_columns;
    std::uint8_t *__restrict row = first;
    for (int x = 1; x < count; ++x) {
      std::uint8_t *here = row + x * Step * lanes;
      for (int k = 0; k < lanes; ++k) {
        const std::uint8_t stepped = sum(last[k], side);
        last[k] = here[k] < stepped ? here[k] : stepped;
      }
      for (int k = 0; k < lanes; ++k) {
        here[k] = last[k];
      }
    }
  }

  std::uint8_t *m_inside;
  std::ptrdiff_t m_stride;
  int m_columns;
  int m_rows;
};

END_VISP_NAMESPACE
#endif
