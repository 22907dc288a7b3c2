// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef noisyBox_h
#define noisyBox_h

#include <modelShapes.h>

#include <visp3/core/vpCameraParameters.h>
#include <visp3/core/vpImage.h>
#include <visp3/core/vpRGBa.h>
#include <visp3/model/vpCpuRenderer.h>
#include <visp3/se3/vpPoseRandom.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <memory>
#include <string>
#include <vector>

BEGIN_VISP_NAMESPACE

/*!
  A box whose sides have colours and soft spots of their own, drawn with anti-aliasing on a plain background, and the
  noise of a camera for it.
*/
class noisyBox
{
public:
  static constexpr unsigned int width = 320;
  static constexpr unsigned int height = 240;

  explicit noisyBox(bool hasSpots = true) : m_model(make()), m_renderer(m_model), m_hasSpots(hasSpots) {}

  static Eigen::Vector3d size() { return Eigen::Vector3d(0.16, 0.12, 0.1); }
  static vpCameraParameters camera() { return vpCameraParameters(400., 400., 159.5, 119.5); }
  //! Three sides, about 150 pixels wide.
  static vpHomogeneousMatrix pose() { return vpHomogeneousMatrix(0.004, -0.003, 0.5, 0.5, 0.6, 0.1); }

  vpImage<vpRGBa> draw(const vpHomogeneousMatrix &cMo)
  {
    const vpCameraParameters cam = camera();
    const vpCameraParameters fine(factor * cam.get_px(), factor * cam.get_py(), factor * (cam.get_u0() + 0.5) - 0.5,
                                  factor * (cam.get_v0() + 0.5) - 0.5);
    vpRenderOptions options;
    options.channels = vpRenderOptions::DEPTH | vpRenderOptions::FACE;
    m_renderer.render(cMo, fine, factor * width, factor * height, options, m_view);
    const vpHomogeneousMatrix oMc = cMo.inverse();
    vpImage<vpRGBa> I(height, width);
    for (unsigned int i = 0; i < height; ++i) {
      for (unsigned int j = 0; j < width; ++j) {
        Eigen::Vector3d sum = Eigen::Vector3d::Zero();
        for (unsigned int k = 0; k < factor * factor; ++k) {
          sum += color(oMc, fine, static_cast<int>(factor * j + k % factor), static_cast<int>(factor * i + k / factor));
        }
        sum /= factor * factor;
        I[i][j] = toPixel(sum);
      }
    }
    return I;
  }

  //! \param deviation Of each channel, gray levels. \return \e I with white noise.
  static vpImage<vpRGBa> withNoise(const vpImage<vpRGBa> &I, double deviation, vpPoseRandom &random)
  {
    const std::vector<float> &normal = normalNumbers();
    vpImage<vpRGBa> noisy(I.getHeight(), I.getWidth());
    for (unsigned int i = 0; i < I.getSize(); ++i) {
      const vpRGBa &pixel = I.bitmap[i];
      const std::uint64_t bits = random.index(std::uint64_t{1} << 48U);
      const auto level = [&](unsigned char value, unsigned int shift) {
        return value + deviation * static_cast<double>(normal[(bits >> shift) & 0xFFFFU]);
      };
      noisy.bitmap[i] = toPixel(Eigen::Vector3d(level(pixel.R, 0), level(pixel.G, 16), level(pixel.B, 32)));
    }
    return noisy;
  }

  static std::string writeObj(const std::string &name)
  {
    std::ofstream file(name);
    int count = 0;
    for (const auto &side : modelShapes::boxPolygons(size())) {
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
  static constexpr unsigned int factor = 4;

  static std::shared_ptr<const vpTrackedModel> make()
  {
    return std::make_shared<const vpTrackedModel>(modelShapes::build(modelShapes::boxPolygons(size())));
  }

  // To draw from: a quarter of a million of logarithms for each image would take longer than to track it.
  static const std::vector<float> &normalNumbers()
  {
    static const std::vector<float> numbers = [] {
      vpPoseRandom random(3);
      std::vector<float> drawn(0x10000);
      std::generate(drawn.begin(), drawn.end(), [&] { return static_cast<float>(random.normal()); });
      return drawn;
    }();
    return numbers;
  }

  static vpRGBa toPixel(const Eigen::Vector3d &color)
  {
    const auto level = [](double value) {
      return static_cast<unsigned char>(std::min(std::max(std::lround(value), 0L), 255L));
    };
    return vpRGBa(level(color[0]), level(color[1]), level(color[2]));
  }

  Eigen::Vector3d color(const vpHomogeneousMatrix &oMc, const vpCameraParameters &fine, int u, int v) const
  {
    const int x = u - m_view.left;
    const int y = v - m_view.top;
    const bool inside = x >= 0 && y >= 0 && x < m_view.width && y < m_view.height;
    const auto at = static_cast<std::size_t>(inside ? y * m_view.width + x : 0);
    if (!inside || m_view.face[at] < 0) {
      return Eigen::Vector3d(50., 90., 70.);
    }
    // The faces of a box come in pairs of triangles.
    const double side = 25. * static_cast<double>(m_view.face[at] % 6);
    const Eigen::Vector3d base(90. + side, 50. + 0.6 * side, 120.);
    if (!m_hasSpots) {
      return base;
    }
    const double depth = static_cast<double>(m_view.depth[at]);
    Eigen::Vector3d oX;
    const double cX = depth * (u - fine.get_u0()) * fine.get_px_inverse();
    const double cY = depth * (v - fine.get_v0()) * fine.get_py_inverse();
    for (unsigned int i = 0; i < 3; ++i) {
      oX[i] = oMc[i][0] * cX + oMc[i][1] * cY + oMc[i][2] * depth + oMc[i][3];
    }
    return base + Eigen::Vector3d::Constant(45. * inner(oX) * spots(oX / 0.0018));
  }

  // 1 on the sides, falling to 0 where they meet: the spots are printed on labels.
  static double inner(const Eigen::Vector3d &oX)
  {
    Eigen::Array3d room = 0.5 * size().array() - oX.array().abs();
    std::sort(room.data(), room.data() + 3); // The smallest one is the distance to the side itself.
    return std::min(std::max((room[1] - 0.008) / 0.006, 0.), 1.);
  }

  // Waves whose directions do not fit together, in [-1, 1].
  static double spots(const Eigen::Vector3d &p)
  {
    const double sum = std::sin(p.x() + 0.7 * p.y()) + std::sin(0.8 * p.y() - 0.6 * p.z() + 1.) +
                       std::sin(1.1 * p.z() + 0.5 * p.x() + 2.) + std::sin(0.4 * p.x() - 1.2 * p.y() + 0.9 * p.z());
    return 0.25 * sum;
  }

  std::shared_ptr<const vpTrackedModel> m_model;
  vpCpuRenderer m_renderer;
  vpRenderedView m_view;
  bool m_hasSpots;
};

END_VISP_NAMESPACE
#endif
