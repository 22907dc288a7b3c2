// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef benchDrawnImages_h
#define benchDrawnImages_h

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
  explicit DrawnImages(const std::shared_ptr<const vpTrackedModel> &model) : m_renderer(model) {}

  vpImage<unsigned char> draw(const vpHomogeneousMatrix &cMo, const vpCameraParameters &cam, unsigned int width,
                              unsigned int height)
  {
    const vpCameraParameters fine(fineness * cam.get_px(), fineness * cam.get_py(),
                                  fineness * (cam.get_u0() + 0.5) - 0.5, fineness * (cam.get_v0() + 0.5) - 0.5);
    vpRenderOptions options;
    options.channels = vpRenderOptions::DEPTH | vpRenderOptions::NORMAL;
    m_renderer.render(cMo, fine, fineness * width, fineness * height, options, m_view);
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
        sum += inside && m_view.depth[at] > 0.F ? shade(m_view.normal[at]) : behind;
      }
    }
    return static_cast<unsigned char>(sum / (fineness * fineness) + 0.5);
  }

  static double shade(const Eigen::Vector3f &normal)
  {
    const Eigen::Vector3f light = Eigen::Vector3f(-0.6F, -0.5F, -0.6F).normalized(); // Upper left, towards the viewer.
    return 90. + 150. * std::fmax(0., static_cast<double>(normal.dot(light)));
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
  vpRenderedView m_view;
};

} // namespace bench
#endif
