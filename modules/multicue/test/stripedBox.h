// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef stripedBox_h
#define stripedBox_h

#include "renderedBox.h"

#include <cmath>

BEGIN_VISP_NAMESPACE

//! A box with a dark stripe on its front side (-z), along the right border and stronger in contrast than the border.
class stripedBox
{
public:
  static constexpr double gap = 0.008; //!< From the right border to the stripe, metres.
  static constexpr double wide = 0.03; //!< Of the stripe, metres.
  static constexpr unsigned char dark = 5;

  //! The front side, seen so that the others are hidden.
  static vpHomogeneousMatrix frontal(int i)
  {
    return vpHomogeneousMatrix(0.01 * std::sin(i), 0.01 * std::cos(2. * i), 0.6, 0.05 * std::sin(3. * i),
                               0.05 * std::cos(i), 0.4 * std::sin(2. * i));
  }

  vpImage<unsigned char> draw(const vpHomogeneousMatrix &cMo)
  {
    vpImage<unsigned char> I = m_box.draw(cMo);
    const vpHomogeneousMatrix oMc = cMo.inverse();
    const int factor = 4;
    for (unsigned int i = 0; i < renderedBox::height; ++i) {
      for (unsigned int j = 0; j < renderedBox::width; ++j) {
        int inside = 0;
        for (int k = 0; k < factor * factor; ++k) {
          inside += isStripe(oMc, j + (k % factor + 0.5) / factor - 0.5, i + (k / factor + 0.5) / factor - 0.5);
        }
        const int all = factor * factor;
        I[i][j] = static_cast<unsigned char>((inside * dark + (all - inside) * I[i][j]) / all);
      }
    }
    return I;
  }

private:
  static int isStripe(const vpHomogeneousMatrix &oMc, double u, double v)
  {
    const vpCameraParameters cam = renderedBox::camera();
    const double x = (u - cam.get_u0()) / cam.get_px();
    const double y = (v - cam.get_v0()) / cam.get_py();
    // Where the line of sight meets the front side.
    const double rise = oMc[2][0] * x + oMc[2][1] * y + oMc[2][2];
    const double depth = (-0.5 * renderedBox::size().z() - oMc[2][3]) / rise;
    const double X = depth * (oMc[0][0] * x + oMc[0][1] * y + oMc[0][2]) + oMc[0][3];
    const double Y = depth * (oMc[1][0] * x + oMc[1][1] * y + oMc[1][2]) + oMc[1][3];
    const double right = 0.5 * renderedBox::size().x() - gap;
    return std::fabs(Y) < 0.5 * renderedBox::size().y() && X < right && X > right - wide ? 1 : 0;
  }

  renderedBox m_box;
};

END_VISP_NAMESPACE
#endif
