// SPDX-License-Identifier: GPL-2.0-or-later
#include "facade/vpGradientAngle.h"

#include <visp3/core/vpMath.h>
#include <visp3/core/vpMeterPixelConversion.h>

#include <cmath>

BEGIN_VISP_NAMESPACE

namespace {
const int half = 2; // Of the Sobel kernel of 5 x 5 that ViSP takes by default.

// Binomial smoothing across, central differences along: the separable factors of Sobel's kernel of 5 x 5.
const double smooth[5] = {1., 4., 6., 4., 1.};
const double derive[5] = {-1., -2., 0., 2., 1.};

Eigen::Vector2d gradientAt(const vpImage<unsigned char> &I, int row, int column)
{
  Eigen::Vector2d gradient = Eigen::Vector2d::Zero();
  for (int i = -half; i <= half; ++i) {
    for (int j = -half; j <= half; ++j) {
      const double level = I[static_cast<unsigned int>(row + i)][static_cast<unsigned int>(column + j)];
      gradient.x() += smooth[i + half] * derive[j + half] * level;
      gradient.y() += derive[i + half] * smooth[j + half] * level;
    }
  }
  return gradient;
}

double angle(const Eigen::Vector2d &gradient, const Eigen::Vector2d &normal)
{
  const double along = std::fabs(gradient.dot(normal));
  const double across = std::fabs(gradient.x() * normal.y() - gradient.y() * normal.x());
  return along > 0. ? std::atan2(across, along) : 0.5 * M_PI; // No gradient: nothing is seen.
}
} // namespace

double vpGradientAngle::mean(const vpImage<unsigned char> &I, const vpModelView &view, const vpCameraParameters &cam)
{
  double sum = 0.;
  unsigned int count = 0;
  for (const vpControlPoint &point : view.points()) {
    double u = point.pixel.x();
    double v = point.pixel.y();
    if (cam.get_projModel() != vpCameraParameters::perspectiveProjWithoutDistortion) {
      vpMeterPixelConversion::convertPoint(cam, (u - cam.get_u0()) / cam.get_px(), (v - cam.get_v0()) / cam.get_py(), u,
                                           v);
    }
    const int row = static_cast<int>(std::lround(v));
    const int column = static_cast<int>(std::lround(u));
    if (row < half || column < half || row + half >= static_cast<int>(I.getHeight()) ||
        column + half >= static_cast<int>(I.getWidth())) {
      continue;
    }
    sum += angle(gradientAt(I, row, column), point.normal);
    ++count;
  }
  return count > 0 ? vpMath::deg(sum / count) : 90.;
}

Eigen::Vector2d vpGradientAngle::Mean::add(double u, double v, const Eigen::Vector2d &normal)
{
  const int room = static_cast<int>(m_sobelX.getRows()) / 2;
  const int row = static_cast<int>(std::lround(v));
  const int column = static_cast<int>(std::lround(u));
  if (row < room || column < room || row + room >= static_cast<int>(m_I.getHeight()) ||
      column + room >= static_cast<int>(m_I.getWidth())) {
    return Eigen::Vector2d::Zero();
  }
  Eigen::Vector2d gradient = Eigen::Vector2d::Zero();
  for (unsigned int i = 0; i < m_sobelX.getRows(); ++i) {
    const unsigned char *pixels = m_I[static_cast<unsigned int>(row - room) + i] + (column - room);
    for (unsigned int j = 0; j < m_sobelX.getCols(); ++j) {
      gradient += pixels[j] * Eigen::Vector2d(m_sobelX[i][j], m_sobelY[i][j]);
    }
  }
  m_sum += angle(gradient, normal);
  ++m_count;
  return gradient;
}

double vpGradientAngle::Mean::degrees() const
{
  return m_count > 0 ? vpMath::deg(m_sum / m_count) : 90.;
}

END_VISP_NAMESPACE
