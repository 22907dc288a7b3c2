// SPDX-License-Identifier: GPL-2.0-or-later
#include <visp3/cues/vpCueFrame.h>

#include <visp3/core/vpMeterPixelConversion.h>

#include <cmath>

BEGIN_VISP_NAMESPACE

bool vpCueFrame::isHidden(double u, double v) const
{
  if (m_isDistorted) {
    const double x = (u - m_camera.get_u0()) * m_camera.get_px_inverse();
    const double y = (v - m_camera.get_v0()) * m_camera.get_py_inverse();
    vpMeterPixelConversion::convertPoint(m_distortedCamera, x, y, u, v);
  }
  const double i = std::round(v);
  const double j = std::round(u);
  if (!(i >= 0. && j >= 0. && i < height() && j < width())) {
    return true;
  }
  return m_mask != nullptr && !(*m_mask)[static_cast<unsigned int>(i)][static_cast<unsigned int>(j)];
}

END_VISP_NAMESPACE
