// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef chiralObject_h
#define chiralObject_h

#include <modelShapes.h>

#include <visp3/core/vpCameraParameters.h>
#include <visp3/core/vpImage.h>
#include <visp3/core/vpRGBa.h>
#include <visp3/io/vpImageIo.h>
#include <visp3/model/vpCpuRenderer.h>
#include <visp3/model/vpTrackedModelBuilder.h>

#include <array>
#include <fstream>
#include <memory>
#include <string>
#include <vector>

/*!
  Two boxes that share a side in such a way that no turn and no mirror brings the object onto itself, as a mesh, and
  images of it.
*/
class chiralObject
{
public:
  static constexpr unsigned int width = 640, height = 480;

  static vpCameraParameters camera() { return vpCameraParameters(600., 600., 319.5, 239.5); }
  static vpHomogeneousMatrix pose() { return vpHomogeneousMatrix(-0.03, -0.02, 0.55, 0.7, 0.6, -0.3); }

  //! Changes that are made to a mesh before it is written.
  struct Change
  {
    double scale = 1.;
    std::array<double, 3> stretch = {{1., 1., 1.}}; //!< -1 mirrors.
    Eigen::Vector3d shift = Eigen::Vector3d::Zero();
    bool isMirroredBack = false; //!< The corners of each triangle the other way round.
    std::size_t leftOut = 0;     //!< Triangles at the end.
  };

  //! An .obj file.
  static std::string write(const std::string &file, const Change &change)
  {
    std::ofstream stream(file);
    std::vector<std::array<Eigen::Vector3d, 3>> all = triangles();
    all.resize(all.size() - change.leftOut);
    std::size_t count = 0;
    for (const auto &triangle : all) {
      for (const Eigen::Vector3d &corner : triangle) {
        const Eigen::Vector3d p =
            change.scale *
                corner.cwiseProduct(Eigen::Vector3d(change.stretch[0], change.stretch[1], change.stretch[2])) +
            change.shift;
        stream << "v " << p.x() << " " << p.y() << " " << p.z() << "\n";
      }
      stream << "f " << count + 1 << " " << count + (change.isMirroredBack ? 3 : 2) << " "
             << count + (change.isMirroredBack ? 2 : 3) << "\n";
      count += 3;
    }
    return file;
  }

  //! An image of it before a background of soft spots. \param file To be written.
  static std::string writeImage(const std::string &file, const vpHomogeneousMatrix &cMo)
  {
    vpTrackedModelBuilder builder;
    for (const auto &triangle : triangles()) {
      std::array<vpTrackedModelBuilder::Corner, 3> corners;
      for (std::size_t k = 0; k < corners.size(); ++k) {
        corners[k].position = triangle[k];
      }
      builder.addTriangle(corners);
    }
    vpCpuRenderer renderer(std::make_shared<const vpTrackedModel>(builder.build("chiral")));
    constexpr int factor = 3; // Of finer pixels, whose mean is an image's.
    const vpCameraParameters cam = camera();
    const vpCameraParameters fine(factor * cam.get_px(), factor * cam.get_py(), factor * (cam.get_u0() + 0.5) - 0.5,
                                  factor * (cam.get_v0() + 0.5) - 0.5);
    vpRenderOptions options;
    options.channels = vpRenderOptions::DEPTH | vpRenderOptions::NORMAL;
    vpRenderedView view;
    renderer.render(cMo, fine, factor * width, factor * height, options, view);
    vpImage<unsigned char> I(height, width);
    for (unsigned int i = 0; i < height; ++i) {
      for (unsigned int j = 0; j < width; ++j) {
        double sum = 0.;
        for (int k = 0; k < factor * factor; ++k) {
          const int y = factor * static_cast<int>(i) + k / factor - view.top;
          const int x = factor * static_cast<int>(j) + k % factor - view.left;
          sum += level(view, x, y, 90. + 12. * std::sin(0.03 * j) * std::cos(0.04 * i));
        }
        I[i][j] = static_cast<unsigned char>(sum / (factor * factor) + 0.5);
      }
    }
    vpImageIo::write(I, file);
    return file;
  }

private:
  static std::vector<std::array<Eigen::Vector3d, 3>> triangles()
  {
    // Outlines of the two storeys as seen from above: each storey is a prism of its own.
    std::vector<std::array<Eigen::Vector3d, 3>> all;
    addBox({0., 0., 0.}, {0.12, 0.07, 0.04}, all);
    addBox({0.005, 0.01, 0.0405}, {0.06, 0.045, 0.1}, all);
    return all;
  }

  static void addBox(const Eigen::Vector3d &low, const Eigen::Vector3d &high,
                     std::vector<std::array<Eigen::Vector3d, 3>> &all)
  {
    for (const auto &side : modelShapes::boxPolygons(high - low)) {
      const Eigen::Vector3d middle = 0.5 * (low + high);
      all.push_back({{side[0] + middle, side[1] + middle, side[2] + middle}});
      all.push_back({{side[0] + middle, side[2] + middle, side[3] + middle}});
    }
  }

  static double level(const vpRenderedView &view, int x, int y, double background)
  {
    if (x < 0 || y < 0 || x >= view.width || y >= view.height) {
      return background;
    }
    const auto at = static_cast<std::size_t>(y * view.width + x);
    const Eigen::Vector3f light(0.36F, -0.48F, -0.8F);
    return view.depth[at] > 0.F ? 130. + 110. * static_cast<double>(view.normal[at].dot(light)) : background;
  }
};
#endif
