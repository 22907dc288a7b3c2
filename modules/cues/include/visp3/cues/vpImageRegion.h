// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpImageRegion_h
#define vpImageRegion_h

#include <visp3/se3/vpCompatibility.h>

#include <algorithm>

BEGIN_VISP_NAMESPACE

/*!
  \ingroup group_cues_frame
  Whole pixels of an image, a rectangle. May reach beyond the image, and be empty.
*/
struct vpImageRegion
{
  int left = 0;   //!< First column.
  int top = 0;    //!< First row.
  int width = 0;  //!< Columns; empty where not positive.
  int height = 0; //!< Rows; empty where not positive.

  vpImageRegion() = default;
  vpImageRegion(int firstColumn, int firstRow, int columns, int rows)
      : left(firstColumn), top(firstRow), width(columns), height(rows)
  {
  }

  bool isEmpty() const { return width <= 0 || height <= 0; }

  //! The part of it that an image of \e columns x \e rows pixels has; all 0 where that is nothing.
  vpImageRegion clipped(unsigned int columns, unsigned int rows) const
  {
    const auto part = [](long long first, long long count, long long size, int &from, int &length) {
      const long long begin = std::max(first, 0LL);
      from = static_cast<int>(begin);
      length = static_cast<int>(std::max(std::min(first + count, size) - begin, 0LL));
    };
    vpImageRegion inside;
    part(left, width, columns, inside.left, inside.width);
    part(top, height, rows, inside.top, inside.height);
    return isEmpty() || inside.isEmpty() ? vpImageRegion() : inside;
  }
};

END_VISP_NAMESPACE
#endif
