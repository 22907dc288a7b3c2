// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpPointGrid_h
#define vpPointGrid_h

#include <visp3/model/vpModelView.h>

#include <algorithm>
#include <cmath>

BEGIN_VISP_NAMESPACE

/*!
  Finds control points near a place in the image without looking at all of them: each cell as wide as the distance that
  is asked for holds a list.
*/
class vpPointGrid
{
public:
  //! \param width, height Of the image, pixels. \param reach Distance that counts as near, pixels.
  //! \param first, next Memory.
  vpPointGrid(double width, double height, double reach, std::vector<int> &first, std::vector<int> &next)
      : m_reach(reach), m_columns(static_cast<int>(width / reach) + 1), m_rows(static_cast<int>(height / reach) + 1),
        m_first(first), m_next(next)
  {
    m_first.assign(static_cast<std::size_t>(m_columns) * static_cast<std::size_t>(m_rows), -1);
    m_next.clear();
  }

  //! Takes the points from the first that is not in it yet on.
  void add(const std::vector<vpControlPoint> &points)
  {
    for (std::size_t i = m_next.size(); i < points.size(); ++i) {
      int &first = m_first[cell(column(points[i]), row(points[i]))];
      m_next.push_back(first);
      first = static_cast<int>(i);
    }
  }

  //! True where a point of the grid that runs in the same direction is within reach of another one.
  bool hasParallel(const std::vector<vpControlPoint> &points, const vpControlPoint &point) const
  {
    const int x = column(point);
    const int y = row(point);
    for (int i = std::max(y - 1, 0); i <= std::min(y + 1, m_rows - 1); ++i) {
      for (int j = std::max(x - 1, 0); j <= std::min(x + 1, m_columns - 1); ++j) {
        for (int other = m_first[cell(j, i)]; other >= 0; other = m_next[static_cast<std::size_t>(other)]) {
          const vpControlPoint &near = points[static_cast<std::size_t>(other)];
          if ((near.pixel - point.pixel).norm() < m_reach && std::fabs(near.normal.dot(point.normal)) > parallel) {
            return true;
          }
        }
      }
    }
    return false;
  }

private:
  static constexpr double parallel = 0.8; // Cosine of the largest angle between edges that can be confused.

  // Points at the border may lie outside by rounding.
  int column(const vpControlPoint &point) const
  {
    return std::min(std::max(static_cast<int>(point.pixel.x() / m_reach), 0), m_columns - 1);
  }
  int row(const vpControlPoint &point) const
  {
    return std::min(std::max(static_cast<int>(point.pixel.y() / m_reach), 0), m_rows - 1);
  }
  std::size_t cell(int x, int y) const
  {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(m_columns) + static_cast<std::size_t>(x);
  }

  double m_reach;
  int m_columns;
  int m_rows;
  std::vector<int> &m_first; // Of each cell's points, -1 for none.
  std::vector<int> &m_next;  // Per point: the next one of its cell, -1 for none.
};

END_VISP_NAMESPACE
#endif
