// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpLinePixels_h
#define vpLinePixels_h

#include <visp3/cues/vpColorCue.h>

#include <cmath>
#include <cstdint>

BEGIN_VISP_NAMESPACE

/*!
  The pixel nearest to each whole offset along a line. In steps of 1 / 65536 pixels, without drift over the lengths used
  here.
*/
class vpLinePixels
{
public:
  //! \pre The line's point is inside the image, and so is what is asked for.
  explicit vpLinePixels(const vpColorCue::Line &line)
      : m_u(toFixed(line.pixel.x() + 0.5)), m_v(toFixed(line.pixel.y() + 0.5)), m_stepU(toFixed(line.normal.x())),
        m_stepV(toFixed(line.normal.y()))
  {
  }

  int u(int offset) const { return (m_u + offset * m_stepU) >> bits; }
  int v(int offset) const { return (m_v + offset * m_stepV) >> bits; }

private:
  static constexpr int bits = 16;
  static int toFixed(double x) { return static_cast<int>(std::lround(x * (1 << bits))); }

  int m_u, m_v, m_stepU, m_stepV;
};

END_VISP_NAMESPACE
#endif
