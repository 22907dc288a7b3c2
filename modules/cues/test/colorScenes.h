// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef colorScenes_h
#define colorScenes_h

#include "modelShapes.h"

#include <visp3/core/vpExponentialMap.h>
#include <visp3/se3/vpExactNumber.h>
#include <visp3/core/vpImageConvert.h>
#include <visp3/cues/vpColorCue.h>
#include <visp3/cues/vpFrameSource.h>
#include <visp3/model/vpCpuRenderer.h>

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

/*! \file colorScenes.h Drawn images of coloured objects before a background, and an estimation of the pose from them.
 */

BEGIN_VISP_NAMESPACE
namespace colorScenes {

constexpr unsigned int width = 320;
constexpr unsigned int height = 240;
constexpr double focal = 320.;

using Color = Eigen::Vector3d;

inline vpCameraParameters makeCamera()
{
  return vpCameraParameters(focal, focal, 159.5, 119.5);
}

//! A number in [0, 1] that looks random, the same on every platform.
inline double hashed(int x, int y, int z = 0)
{
  std::uint32_t h = static_cast<std::uint32_t>(x) * 374761393U + static_cast<std::uint32_t>(y) * 668265263U +
                    static_cast<std::uint32_t>(z) * 2246822519U;
  h = (h ^ (h >> 13U)) * 1274126177U;
  return static_cast<double>((h ^ (h >> 16U)) & 0xFFFFU) / 65535.;
}

inline int cell(double x, double size)
{
  return static_cast<int>(std::floor(x / size));
}

//! Patches of many colours, none of them red.
inline Color clutter(double u, double v)
{
  const int i = cell(u + 6. * std::sin(0.08 * v), 17.);
  const int j = cell(v, 13.);
  const double gray = 60. + 120. * hashed(i, j);
  return {0.6 * gray, gray + 30. * hashed(i, j, 1), gray * (0.7 + 0.6 * hashed(i, j, 2))};
}

//! Printed in reds, with white patches.
inline Color printed(const Eigen::Vector3d &oX)
{
  const double patch = hashed(cell(oX.x(), 0.013), cell(oX.y(), 0.013), cell(oX.z(), 0.013));
  return patch < 0.2 ? Color(235., 230., 215.) : patch < 0.5 ? Color(150., 35., 30.) : Color(210., 60., 40.);
}

//! What is drawn: the colour of a place on the object (metres, object frame), and that of a pixel of the background.
struct Paint
{
  std::function<Color(const Eigen::Vector3d &)> object = printed;
  std::function<Color(double, double)> background = clutter;
  double gain = 1.; //!< Brightness of the light.
};

inline vpTrackedModel makeBox()
{
  return modelShapes::build(modelShapes::boxPolygons({0.2, 0.14, 0.1}));
}

//! A smooth body with three bulges.
inline vpTrackedModel makeLump()
{
  std::vector<modelShapes::Triangle> triangles = modelShapes::sphereTriangles(1., 24, 36);
  for (modelShapes::Triangle &triangle : triangles) {
    for (modelShapes::Point &corner : triangle) {
      const double azimuth = std::atan2(corner.y(), corner.x());
      const double round = corner.x() * corner.x() + corner.y() * corner.y();
      corner = 0.08 * (1. + 0.35 * round * std::cos(3. * azimuth)) * corner.cwiseProduct(Eigen::Vector3d(1., 1., 0.6));
    }
  }
  return modelShapes::build(triangles);
}

//! A model before the camera.
class Scene
{
public:
  explicit Scene(vpTrackedModel model)
      : m_model(std::make_shared<const vpTrackedModel>(std::move(model))), m_renderer(m_model), m_view(m_model)
  {
  }

  const vpModelView &look(const vpHomogeneousMatrix &cMo, double sampleStep = 3.)
  {
    vpModelViewOptions options;
    options.sampleStep = sampleStep;
    m_view.compute(cMo, makeCamera(), width, height, options, &m_renderer);
    return m_view;
  }

  //! An image, each pixel the mean of four places in it.
  vpImage<vpRGBa> draw(const vpHomogeneousMatrix &cMo, const Paint &paint = Paint())
  {
    vpRenderOptions options;
    m_renderer.render(cMo, fineCamera(), fineness * width, fineness * height, options, m_rendered);
    const vpHomogeneousMatrix oMc = cMo.inverse();
    vpImage<vpRGBa> I(height, width);
    for (unsigned int i = 0; i < height; ++i) {
      for (unsigned int j = 0; j < width; ++j) {
        Color sum = Color::Zero();
        for (unsigned int k = 0; k < fineness * fineness; ++k) {
          sum += color(static_cast<int>(fineness * j + k % fineness), static_cast<int>(fineness * i + k / fineness),
                       oMc, paint);
        }
        // A bit of noise, as cameras have it.
        sum.array() += 16. * (hashed(static_cast<int>(i), static_cast<int>(j), 7) - 0.5);
        sum = (paint.gain / (fineness * fineness) * sum).cwiseMax(0.).cwiseMin(255.);
        I[i][j] = vpRGBa(static_cast<unsigned char>(sum[0]), static_cast<unsigned char>(sum[1]),
                         static_cast<unsigned char>(sum[2]));
      }
    }
    return I;
  }

private:
  static constexpr unsigned int fineness = 2;

  static vpCameraParameters fineCamera()
  {
    const vpCameraParameters cam = makeCamera();
    return vpCameraParameters(fineness * focal, fineness * focal, fineness * (cam.get_u0() + 0.5) - 0.5,
                              fineness * (cam.get_v0() + 0.5) - 0.5);
  }

  Color color(int u, int v, const vpHomogeneousMatrix &oMc, const Paint &paint) const
  {
    const int index = m_rendered.index(u, v);
    const double z = index < 0 ? 0. : static_cast<double>(m_rendered.depth[static_cast<std::size_t>(index)]);
    if (vpIsZero(z)) {
      return paint.background((u + 0.5) / fineness - 0.5, (v + 0.5) / fineness - 0.5);
    }
    const vpCameraParameters cam = fineCamera();
    const double x = (u - cam.get_u0()) / cam.get_px() * z;
    const double y = (v - cam.get_v0()) / cam.get_py() * z;
    Eigen::Vector3d oX;
    for (unsigned int i = 0; i < 3; ++i) {
      oX(i) = oMc[i][0] * x + oMc[i][1] * y + oMc[i][2] * z + oMc[i][3];
    }
    return paint.object(oX);
  }

  std::shared_ptr<const vpTrackedModel> m_model;
  vpCpuRenderer m_renderer;
  vpModelView m_view;
  vpRenderedView m_rendered;
};

//! The pose after the camera moved for a second with this velocity.
inline vpHomogeneousMatrix movedBy(const vpHomogeneousMatrix &cMo, const Eigen::Matrix<double, 6, 1> &velocity)
{
  vpColVector v(6);
  for (unsigned int i = 0; i < 6; ++i) {
    v[i] = velocity(i);
  }
  return vpExponentialMap::direct(v).inverse() * cMo;
}

inline Eigen::Matrix<double, 6, 1> velocityAlong(int component, double amount)
{
  return amount * Eigen::Matrix<double, 6, 1>::Unit(component);
}

//! Moves the object in the image, pixels.
inline vpHomogeneousMatrix shifted(const vpHomogeneousMatrix &cMo, double u, double v)
{
  vpHomogeneousMatrix moved = cMo;
  moved[0][3] += u * cMo[2][3] / focal;
  moved[1][3] += v * cMo[2][3] / focal;
  return moved;
}

//! Tukey's weights with a robust scale that is not below the block's noise.
inline std::vector<double> robustWeights(const vpResidualBlock &block)
{
  std::vector<double> sizes;
  for (const vpResidual &row : block.rows) {
    sizes.push_back(std::fabs(row.error));
  }
  std::vector<double> weights;
  if (sizes.empty()) {
    return weights;
  }
  std::vector<double> sorted = sizes;
  std::nth_element(sorted.begin(), sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2), sorted.end());
  const double limit = 4.6851 * std::max(1.4826 * sorted[sorted.size() / 2], block.noise);
  for (const double size : sizes) {
    const double x = std::min(size / limit, 1.);
    weights.push_back((1. - x * x) * (1. - x * x));
  }
  return weights;
}

//! The normal equations A step = b of a block.
struct Normal
{
  Eigen::Matrix<double, 6, 6> A = Eigen::Matrix<double, 6, 6>::Zero();
  Eigen::Matrix<double, 6, 1> b = Eigen::Matrix<double, 6, 1>::Zero();

  Normal(const vpResidualBlock &block, const std::vector<double> &weights)
  {
    for (std::size_t i = 0; i < block.rows.size(); ++i) {
      const vpResidual &row = block.rows[i];
      const double w = weights[i] * row.weight * row.weight;
      A += w * row.jacobian * row.jacobian.transpose();
      b -= w * row.error * row.jacobian;
    }
  }
};

//! From \e cMo through all levels of the cue, two matches on the coarsest. \return The pose.
inline vpHomogeneousMatrix estimate(vpColorCue &cue, Scene &scene, const vpCueFrame &frame, vpHomogeneousMatrix cMo)
{
  vpResidualBlock block;
  for (unsigned int level = 0; level < cue.levels(); ++level) {
    cue.setLevel(level);
    for (int match = 0; match < (level == 0 ? 2 : 1); ++match) {
      cue.match(frame, scene.look(cMo));
      for (int iteration = 0; iteration < 3; ++iteration) {
        cue.residuals(cMo, block);
        Normal normal(block, robustWeights(block));
        normal.A.diagonal().array() += 1.;
        cMo = movedBy(cMo, normal.A.ldlt().solve(normal.b));
      }
    }
  }
  return cMo;
}

//! Matches a frame at its pose on the finest level, and has the cue learn from it.
inline void learn(vpColorCue &cue, Scene &scene, const vpCueFrame &frame, const vpHomogeneousMatrix &cMo)
{
  vpResidualBlock block;
  cue.setLevel(cue.levels() - 1);
  cue.match(frame, scene.look(cMo));
  cue.residuals(cMo, block);
  cue.updateReference(cMo, std::vector<double>(block.rows.size(), 1.));
}

//! Mean distance in the image between the model's points at two poses, pixels.
inline double pixelsOff(Scene &scene, const vpHomogeneousMatrix &a, const vpHomogeneousMatrix &b)
{
  const auto project = [](const vpHomogeneousMatrix &cMo, const Eigen::Vector3d &oX) {
    Eigen::Vector3d cX;
    for (unsigned int i = 0; i < 3; ++i) {
      cX(i) = cMo[i][0] * oX.x() + cMo[i][1] * oX.y() + cMo[i][2] * oX.z() + cMo[i][3];
    }
    return Eigen::Vector2d(focal * cX.x() / cX.z(), focal * cX.y() / cX.z());
  };
  double sum = 0.;
  const std::vector<vpControlPoint> &points = scene.look(a).points();
  for (const vpControlPoint &point : points) {
    sum += (project(a, point.position) - project(b, point.position)).norm();
  }
  return sum / static_cast<double>(points.size());
}

} // namespace colorScenes
END_VISP_NAMESPACE
#endif
