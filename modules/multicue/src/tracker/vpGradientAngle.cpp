// SPDX-License-Identifier: GPL-2.0-or-later
#include "tracker/vpGradientAngle.h"

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
    const Eigen::Vector2d gradient = gradientAt(I, row, column);
    const double along = std::fabs(gradient.dot(point.normal));
    const double across = std::fabs(gradient.x() * point.normal.y() - gradient.y() * point.normal.x());
    sum += along > 0. ? std::atan2(across, along) : 0.5 * M_PI; // No gradient: nothing is seen.
    ++count;
  }
  return count > 0 ? vpMath::deg(sum / count) : 90.;
}

END_VISP_NAMESPACE
