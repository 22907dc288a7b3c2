// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef benchDrawnImages_h
#define benchDrawnImages_h

#include <visp3/core/vpCameraParameters.h>
#include <visp3/core/vpHomogeneousMatrix.h>
#include <visp3/core/vpImage.h>
#include <visp3/model/vpCpuRenderer.h>

#include <cmath>
#include <cstdint>
#include <memory>

#ifdef ENABLE_VISP_NAMESPACE
using namespace VISP_NAMESPACE_NAME;
#endif

/*!
  \file drawnImages.h
  Images of a model, lit from one side, before a background with texture: the same at any size of the image.
*/

namespace bench {

//! Draws images of one model.
class DrawnImages
{
public:
  enum class Surface
  {
    PLAIN,
    MARBLE //!< With a pattern, the same wherever it is seen from: something for points to be found on.
  };

  explicit DrawnImages(const std::shared_ptr<const vpTrackedModel> &model, Surface surface = Surface::PLAIN)
      : m_renderer(model), m_surface(surface)
  {
  }

  vpImage<unsigned char> draw(const vpHomogeneousMatrix &cMo, const vpCameraParameters &cam, unsigned int width,
                              unsigned int height)
  {
    const vpCameraParameters fine(fineness * cam.get_px(), fineness * cam.get_py(),
                                  fineness * (cam.get_u0() + 0.5) - 0.5, fineness * (cam.get_v0() + 0.5) - 0.5);
    vpRenderOptions options;
    options.channels = vpRenderOptions::DEPTH | vpRenderOptions::NORMAL;
    m_renderer.render(cMo, fine, fineness * width, fineness * height, options, m_view);
    m_fine = fine;
    m_oMc = cMo.inverse();
    vpImage<unsigned char> I(height, width);
    for (unsigned int i = 0; i < height; ++i) {
      for (unsigned int j = 0; j < width; ++j) {
        const double scale = 640. / width;
        I[i][j] = pixel(static_cast<int>(i), static_cast<int>(j), background(scale * j, scale * i));
      }
    }
    return I;
  }

private:
  static constexpr int fineness = 2; // Rendered pixels across one of the image.

  unsigned char pixel(int i, int j, double behind) const
  {
    double sum = 0.;
    for (int y = fineness * i - m_view.top; y < fineness * (i + 1) - m_view.top; ++y) {
      for (int x = fineness * j - m_view.left; x < fineness * (j + 1) - m_view.left; ++x) {
        const bool inside = x >= 0 && y >= 0 && x < m_view.width && y < m_view.height;
        const std::size_t at = inside ? static_cast<std::size_t>(y * m_view.width + x) : 0;
        sum += inside && m_view.depth[at] > 0.F ? shade(m_view.normal[at]) * pattern(x, y, m_view.depth[at]) : behind;
      }
    }
    return static_cast<unsigned char>(sum / (fineness * fineness) + 0.5);
  }

  static double shade(const Eigen::Vector3f &normal)
  {
    const Eigen::Vector3f light = Eigen::Vector3f(-0.6F, -0.5F, -0.6F).normalized(); // Upper left, towards the viewer.
    return 90. + 150. * std::fmax(0., static_cast<double>(normal.dot(light)));
  }

  // A factor of the brightness at a pixel of the crop.
  double pattern(int x, int y, float depth) const
  {
    if (m_surface == Surface::PLAIN) {
      return 1.;
    }
    const double z = static_cast<double>(depth);
    const double cX[] = {z * (x + m_view.left - m_fine.get_u0()) * m_fine.get_px_inverse(),
                         z * (y + m_view.top - m_fine.get_v0()) * m_fine.get_py_inverse(), z};
    double oX[3];
    for (unsigned int i = 0; i < 3; ++i) {
      oX[i] = m_oMc[i][0] * cX[0] + m_oMc[i][1] * cX[1] + m_oMc[i][2] * cX[2] + m_oMc[i][3];
    }
    const double cell = 0.006; // Metres.
    return 0.2 + 0.8 * (noise(oX[0], oX[1], cell) + noise(oX[1], oX[2], cell) + noise(oX[2], oX[0], cell)) / 3.;
  }

  // A number in [0, 1] that looks random, the same on every platform.
  static double hashed(int x, int y)
  {
    std::uint32_t h = static_cast<std::uint32_t>(x) * 374761393U + static_cast<std::uint32_t>(y) * 668265263U;
    h = (h ^ (h >> 13U)) * 1274126177U;
    return static_cast<double>((h ^ (h >> 16U)) & 0xFFFFU) / 65535.;
  }

  // Hashed numbers on a grid, linear in between.
  static double noise(double u, double v, double cell)
  {
    const double x = std::floor(u / cell);
    const double y = std::floor(v / cell);
    const double fx = u / cell - x;
    const double fy = v / cell - y;
    const int i = static_cast<int>(x);
    const int j = static_cast<int>(y);
    return (1. - fy) * ((1. - fx) * hashed(i, j) + fx * hashed(i + 1, j)) +
           fy * ((1. - fx) * hashed(i, j + 1) + fx * hashed(i + 1, j + 1));
  }

  static double background(double u, double v) { return 15. + 40. * noise(u, v, 30.) + 25. * noise(u, v, 5.); }

  vpCpuRenderer m_renderer;
  Surface m_surface;
  vpCameraParameters m_fine; // Of the image that is being drawn.
  vpHomogeneousMatrix m_oMc;
  vpRenderedView m_view;
};

} // namespace bench
#endif
