// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpDepthProbe_h
#define vpDepthProbe_h

#include <visp3/model/vpModelRenderer.h>
#include <visp3/se3/vpExactNumber.h>

BEGIN_VISP_NAMESPACE

/*!
  Looks into a depth buffer, many times for each view: so all of it is inline.
*/
class vpDepthProbe
{
public:
  //! \param view Null where there is no depth buffer: then nothing is hidden, and everything is background.
  //! \param shift, farther How far the object moved in the image since the buffer was drawn, pixels, and away, metres.
  explicit vpDepthProbe(const vpRenderedView *view, const Eigen::Vector2d &shift = Eigen::Vector2d::Zero(),
                        double farther = 0.)
      : m_view(view), m_shift(shift), m_farther(farther)
  {
  }

  bool exists() const { return m_view != nullptr; }

  //! Depth at the nearest pixel of an image point, metres; 0 where there is no object.
  float at(const Eigen::Vector2d &pixel) const
  {
    int column = 0;
    int row = 0;
    return exists() && find(pixel, column, row) && isInside(column, row) ? moved(depth(column, row)) : 0.F;
  }

  //! True where the pixel and its eight neighbours all show something nearer than \e limit, metres.
  bool isCovered(const Eigen::Vector2d &pixel, double limit) const
  {
    int column = 0;
    int row = 0;
    if (!exists() || !find(pixel, column, row) || !isInside(column - 1, row - 1) || !isInside(column + 1, row + 1)) {
      return false; // Outside the crop there is background.
    }
    for (int i = row - 1; i <= row + 1; ++i) {
      for (int j = column - 1; j <= column + 1; ++j) {
        const float seen = depth(j, i);
        if (vpIsZero(seen) || static_cast<double>(seen) + m_farther >= limit) {
          return false;
        }
      }
    }
    return true;
  }

private:
  // As vpRenderedView::index() has it. The limits only keep the conversion to integers defined.
  bool find(const Eigen::Vector2d &pixel, int &column, int &row) const
  {
    const double x = (pixel.x() - m_shift.x() + 0.5) * m_view->scale - m_view->left;
    const double y = (pixel.y() - m_shift.y() + 0.5) * m_view->scale - m_view->top;
    if (!(x >= 0. && x < m_view->width && y >= 0. && y < m_view->height)) {
      return false;
    }
    column = static_cast<int>(x);
    row = static_cast<int>(y);
    return true;
  }
  bool isInside(int column, int row) const
  {
    return column >= 0 && column < m_view->width && row >= 0 && row < m_view->height;
  }
  float moved(float seen) const { return seen > 0.F ? seen + static_cast<float>(m_farther) : 0.F; }
  float depth(int column, int row) const
  {
    return m_view->depth[static_cast<std::size_t>(row) * static_cast<std::size_t>(m_view->width) +
                         static_cast<std::size_t>(column)];
  }

  const vpRenderedView *m_view;
  Eigen::Vector2d m_shift;
  double m_farther;
};

END_VISP_NAMESPACE
#endif
