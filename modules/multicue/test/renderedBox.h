// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef renderedBox_h
#define renderedBox_h

#include <modelShapes.h>

#include <visp3/core/vpCameraParameters.h>
#include <visp3/core/vpImageConvert.h>
#include <visp3/core/vpRGBa.h>
#include <visp3/model/vpCpuRenderer.h>
#include <visp3/model/vpTrackedModelBuilder.h>

#include <array>
#include <cstdio>
#include <fstream>
#include <memory>
#include <string>

BEGIN_VISP_NAMESPACE

/*!
  A box of 20 x 12 x 8 cm whose six sides have gray levels of their own, drawn with anti-aliasing on a plain background,
  and the model files that go with it.
*/
class renderedBox
{
public:
  static constexpr unsigned int width = 640;
  static constexpr unsigned int height = 480;
  static constexpr unsigned char background = 25;

  renderedBox() : m_model(std::make_shared<const vpTrackedModel>(make())), m_renderer(m_model) {}

  static Eigen::Vector3d size() { return Eigen::Vector3d(0.2, 0.12, 0.08); }

  static vpCameraParameters camera() { return vpCameraParameters(600., 600., 319.5, 239.5); }

  //! Seen from a corner, 0.6 m away.
  static vpHomogeneousMatrix pose() { return vpHomogeneousMatrix(0.02, -0.01, 0.6, 0.9, 0.5, -0.2); }

  vpImage<unsigned char> draw(const vpHomogeneousMatrix &cMo, const vpCameraParameters &cam = camera())
  {
    const int factor = 4;
    const vpCameraParameters fine(factor * cam.get_px(), factor * cam.get_py(), factor * (cam.get_u0() + 0.5) - 0.5,
                                  factor * (cam.get_v0() + 0.5) - 0.5);
    vpRenderOptions options;
    options.channels = vpRenderOptions::DEPTH | vpRenderOptions::FACE;
    m_renderer.render(cMo, fine, factor * width, factor * height, options, m_view);
    vpImage<unsigned char> I(height, width, background);
    for (unsigned int i = 0; i < height; ++i) {
      for (unsigned int j = 0; j < width; ++j) {
        I[i][j] = level(static_cast<int>(i), static_cast<int>(j), factor);
      }
    }
    return I;
  }

  //! The gray levels of the sides as colours.
  vpImage<vpRGBa> drawColor(const vpHomogeneousMatrix &cMo)
  {
    const vpImage<unsigned char> gray = draw(cMo);
    vpImage<vpRGBa> I(gray.getHeight(), gray.getWidth());
    for (unsigned int i = 0; i < I.getSize(); ++i) {
      const unsigned char g = gray.bitmap[i];
      I.bitmap[i] = vpRGBa(g, static_cast<unsigned char>(255 - g), 90);
    }
    return I;
  }

  //! A .cao file of the box. \param scale Of all lengths.
  static std::string writeCao(const std::string &name, double scale = 1.)
  {
    std::ofstream file(name);
    const auto sides = modelShapes::boxPolygons(scale * size());
    file << "V1\n" << 4 * sides.size() << "\n";
    for (const auto &side : sides) {
      for (const Eigen::Vector3d &corner : side) {
        file << corner.x() << " " << corner.y() << " " << corner.z() << "\n";
      }
    }
    file << "0\n0\n" << sides.size() << "\n";
    for (std::size_t i = 0; i < sides.size(); ++i) {
      file << "4 " << 4 * i << " " << 4 * i + 1 << " " << 4 * i + 2 << " " << 4 * i + 3 << "\n";
    }
    file << "0\n0\n";
    return name;
  }

  //! The same box as triangles. \param scale Of all lengths.
  static std::string writeObj(const std::string &name, double scale = 1.)
  {
    std::ofstream file(name);
    int count = 0;
    for (const auto &side : modelShapes::boxPolygons(scale * size())) {
      for (const Eigen::Vector3d &corner : side) {
        file << "v " << corner.x() << " " << corner.y() << " " << corner.z() << "\n";
      }
      file << "f " << count + 1 << " " << count + 2 << " " << count + 3 << "\nf " << count + 1 << " " << count + 3
           << " " << count + 4 << "\n";
      count += 4;
    }
    return name;
  }

private:
  static vpTrackedModel make()
  {
    vpTrackedModelBuilder builder;
    for (const auto &side : modelShapes::boxPolygons(size())) {
      builder.addFace(side);
    }
    return builder.build("box");
  }

  unsigned char level(int i, int j, int factor) const
  {
    static const std::array<double, 6> sides = {{60., 95., 130., 165., 200., 235.}};
    double sum = 0.;
    for (int y = i * factor - m_view.top; y < (i + 1) * factor - m_view.top; ++y) {
      for (int x = j * factor - m_view.left; x < (j + 1) * factor - m_view.left; ++x) {
        const bool inside = x >= 0 && y >= 0 && x < m_view.width && y < m_view.height;
        const int face = inside ? m_view.face[static_cast<std::size_t>(y * m_view.width + x)] : -1;
        sum += face < 0 ? static_cast<double>(background) : sides[static_cast<std::size_t>(face) % sides.size()];
      }
    }
    return static_cast<unsigned char>(sum / (factor * factor) + 0.5);
  }

  std::shared_ptr<const vpTrackedModel> m_model;
  vpCpuRenderer m_renderer;
  vpRenderedView m_view;
};

END_VISP_NAMESPACE
#endif
