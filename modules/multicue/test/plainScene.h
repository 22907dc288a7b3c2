// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef plainScene_h
#define plainScene_h

#include <meshFiles.h>
#include <modelShapes.h>

#include <visp3/core/vpCameraParameters.h>
#include <visp3/core/vpExponentialMap.h>
#include <visp3/core/vpImage.h>
#include <visp3/core/vpRGBa.h>
#include <visp3/model/vpCpuRenderer.h>
#include <visp3/multicue/vpMbMultiCueTracker.h>
#include <visp3/se3/vpPoseRandom.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

BEGIN_VISP_NAMESPACE

//! A box with a smaller one on it: parts hide others, so that every view draws depth.
inline meshFiles::Triangles stepTriangles()
{
  meshFiles::Triangles triangles = modelShapes::boxTriangles(modelShapes::Point(0.12, 0.07, 0.05));
  const meshFiles::Triangles upper =
      modelShapes::boxTriangles(modelShapes::Point(0.04, 0.07, 0.05), 1, modelShapes::Point(-0.04, 0., 0.05));
  triangles.insert(triangles.end(), upper.begin(), upper.end());
  return triangles;
}

/*!
  Things of one colour, drawn with anti-aliasing on a plain background: the light falls from the camera, so that nothing
  in an image shows how far a round one is turned about its axis.
*/
class plainScene
{
public:
  static constexpr unsigned int width = 320;
  static constexpr unsigned int height = 240;

  explicit plainScene(const std::vector<modelShapes::Triangle> &triangles)
      : m_model(std::make_shared<const vpTrackedModel>(modelShapes::build(triangles))), m_renderer(m_model)
  {
  }

  static vpCameraParameters camera() { return vpCameraParameters(400., 400., 159.5, 119.5); }

  //! Sways and tilts; does not come back to where it was within some hundred frames.
  static vpHomogeneousMatrix poseAt(int frame)
  {
    const double t = 0.08 * frame;
    vpColVector motion(6);
    motion[0] = 0.02 * std::sin(t);
    motion[1] = 0.015 * std::sin(1.3 * t);
    motion[2] = 0.03 * std::sin(0.7 * t);
    motion[3] = 0.25 * std::sin(0.9 * t);
    motion[4] = 0.25 * std::sin(1.1 * t);
    return vpHomogeneousMatrix(0.01, -0.01, 0.45, 0.8, 0.3, 0.) * vpExponentialMap::direct(motion);
  }

  vpImage<vpRGBa> draw(const vpHomogeneousMatrix &cMo)
  {
    const vpCameraParameters cam = camera();
    const vpCameraParameters fine(factor * cam.get_px(), factor * cam.get_py(), factor * (cam.get_u0() + 0.5) - 0.5,
                                  factor * (cam.get_v0() + 0.5) - 0.5);
    vpRenderOptions options;
    options.channels = vpRenderOptions::DEPTH | vpRenderOptions::NORMAL;
    m_renderer.render(cMo, fine, factor * width, factor * height, options, m_view);
    vpImage<vpRGBa> I(height, width);
    for (unsigned int i = 0; i < height; ++i) {
      for (unsigned int j = 0; j < width; ++j) {
        Eigen::Vector3d sum = Eigen::Vector3d::Zero();
        for (unsigned int k = 0; k < factor * factor; ++k) {
          sum += color(static_cast<int>(factor * j + k % factor), static_cast<int>(factor * i + k / factor));
        }
        sum /= factor * factor;
        sum += Eigen::Vector3d(m_random.normal(), m_random.normal(), m_random.normal()); // The camera's noise.
        I[i][j] = vpRGBa(level(sum.x()), level(sum.y()), level(sum.z()));
      }
    }
    return I;
  }

  //! Of the turn between two poses the part about the object's z axis, degrees.
  static double spin(const vpHomogeneousMatrix &cMo, const vpHomogeneousMatrix &next)
  {
    const Eigen::Isometry3d step = vpPoseExponential::toEigen(cMo.inverse() * next);
    const Eigen::Quaterniond q(step.linear());
    return 2. * std::atan2(q.z(), q.w()) * 180. / M_PI;
  }

  //! Between the z axes of two poses, degrees.
  static double tilt(const vpHomogeneousMatrix &a, const vpHomogeneousMatrix &b)
  {
    const double cosine = a[0][2] * b[0][2] + a[1][2] * b[1][2] + a[2][2] * b[2][2];
    return std::acos(std::min(std::max(cosine, -1.), 1.)) * 180. / M_PI;
  }

private:
  static constexpr unsigned int factor = 3;

  static unsigned char level(double value)
  {
    return static_cast<unsigned char>(std::min(std::max(std::lround(value), 0L), 255L));
  }

  Eigen::Vector3d color(int u, int v) const
  {
    const int x = u - m_view.left;
    const int y = v - m_view.top;
    const bool inside = x >= 0 && y >= 0 && x < m_view.width && y < m_view.height;
    const auto at = static_cast<std::size_t>(inside ? y * m_view.width + x : 0);
    if (!inside || !(m_view.depth[at] > 0.F)) {
      return Eigen::Vector3d(50., 90., 70.);
    }
    return (0.6 - 0.4 * static_cast<double>(m_view.normal[at].z())) * Eigen::Vector3d(210., 130., 60.);
  }

  std::shared_ptr<const vpTrackedModel> m_model;
  vpCpuRenderer m_renderer;
  vpRenderedView m_view;
  vpPoseRandom m_random{3};
};

END_VISP_NAMESPACE
#endif
