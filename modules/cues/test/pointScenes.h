// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef pointScenes_h
#define pointScenes_h

#include <modelShapes.h>

#include <visp3/core/vpExponentialMap.h>
#include <visp3/se3/vpExactNumber.h>
#include <visp3/cues/vpFrameSource.h>
#include <visp3/cues/vpPointCue.h>
#include <visp3/model/vpCpuRenderer.h>

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <vector>

/*!
  \file pointScenes.h
  Images of objects with texture at known poses, and a tracker that follows them by the point cue alone.
*/

BEGIN_VISP_NAMESPACE
namespace pointScenes {

constexpr unsigned int width = 320;
constexpr unsigned int height = 240;
using Model = std::shared_ptr<const vpTrackedModel>;

inline vpCameraParameters makeCamera()
{
  return vpCameraParameters(400., 400., 159.5, 119.5);
}

//! About 150 pixels wide at 0.5 m.
inline Model makeBox()
{
  return std::make_shared<const vpTrackedModel>(
      modelShapes::build(modelShapes::boxPolygons(Eigen::Vector3d(0.16, 0.12, 0.1))));
}

//! Pose of the box that shows three of its sides.
inline vpHomogeneousMatrix startPose()
{
  return vpHomogeneousMatrix(0., 0., 0.5, 0.5, 0.6, 0.1);
}

// A number in [0, 1] that looks random, the same on every platform.
inline double hashed(int x, int y, int z)
{
  std::uint32_t h = static_cast<std::uint32_t>(x) * 374761393U + static_cast<std::uint32_t>(y) * 668265263U +
                    static_cast<std::uint32_t>(z) * 2246822519U;
  h = (h ^ (h >> 13U)) * 1274126177U;
  h = (h ^ (h >> 16U)) * 2654435761U;
  return static_cast<double>((h ^ (h >> 15U)) & 0xFFFFU) / 65535.;
}

//! Brightness in [0, 1] of a block of marble: smooth, the same wherever it is seen from.
inline double marble(const Eigen::Vector3d &place, double cell)
{
  const Eigen::Vector3d p = place / cell;
  const Eigen::Vector3d whole(std::floor(p.x()), std::floor(p.y()), std::floor(p.z()));
  const Eigen::Vector3d part = p - whole;
  double sum = 0.;
  for (int k = 0; k < 8; ++k) {
    const Eigen::Vector3i side(k & 1, (k >> 1) & 1, (k >> 2) & 1);
    double weight = 1.;
    for (int axis = 0; axis < 3; ++axis) {
      const double t = part[axis] * part[axis] * (3. - 2. * part[axis]);
      weight *= side[axis] == 1 ? t : 1. - t;
    }
    sum += weight * hashed(static_cast<int>(whole.x()) + side.x(), static_cast<int>(whole.y()) + side.y(),
                           static_cast<int>(whole.z()) + side.z());
  }
  return sum;
}

//! Draws a model of marble before a background of another one. Pixels are averaged over 2 x 2 places.
class Painter
{
public:
  explicit Painter(const Model &model) : m_renderer(model) {}

  vpImage<unsigned char> draw(const vpHomogeneousMatrix &cMo, unsigned int imageWidth = width,
                              unsigned int imageHeight = height)
  {
    const vpCameraParameters cam = makeCamera();
    const vpCameraParameters fine(2. * cam.get_px(), 2. * cam.get_py(), 2. * cam.get_u0() + 0.5,
                                  2. * cam.get_v0() + 0.5);
    m_renderer.render(cMo, fine, 2 * imageWidth, 2 * imageHeight, vpRenderOptions(), m_view);
    const vpHomogeneousMatrix oMc = cMo.inverse();
    vpImage<unsigned char> I(imageHeight, imageWidth);
    for (unsigned int i = 0; i < imageHeight; ++i) {
      for (unsigned int j = 0; j < imageWidth; ++j) {
        double sum = 0.;
        for (unsigned int k = 0; k < 4; ++k) {
          sum += level(oMc, fine, 2 * j + k % 2, 2 * i + k / 2);
        }
        I[i][j] = static_cast<unsigned char>(std::lround(sum / 4.));
      }
    }
    return I;
  }

private:
  double level(const vpHomogeneousMatrix &oMc, const vpCameraParameters &fine, double u, double v) const
  {
    const int at = m_view.index(u, v);
    const double depth = at < 0 ? 0. : static_cast<double>(m_view.depth[static_cast<std::size_t>(at)]);
    if (vpIsZero(depth)) {
      return 60. + 80. * marble(Eigen::Vector3d(u, v, 0.5), 24.);
    }
    const double x = depth * (u - fine.get_u0()) * fine.get_px_inverse();
    const double y = depth * (v - fine.get_v0()) * fine.get_py_inverse();
    Eigen::Vector3d oX;
    for (unsigned int i = 0; i < 3; ++i) {
      oX[i] = oMc[i][0] * x + oMc[i][1] * y + oMc[i][2] * depth + oMc[i][3];
    }
    return 30. + 190. * marble(oX, 0.008);
  }

  vpCpuRenderer m_renderer;
  vpRenderedView m_view;
};

inline void fill(vpImage<unsigned char> &I, int left, int top, int right, int bottom, unsigned char level)
{
  for (int i = std::max(top, 0); i < std::min(bottom, static_cast<int>(I.getHeight())); ++i) {
    for (int j = std::max(left, 0); j < std::min(right, static_cast<int>(I.getWidth())); ++j) {
      I[static_cast<unsigned int>(i)][static_cast<unsigned int>(j)] = level;
    }
  }
}

inline Eigen::Vector2d project(const vpHomogeneousMatrix &cMo, const Eigen::Vector3d &oX)
{
  const vpCameraParameters cam = makeCamera();
  Eigen::Vector3d cX;
  for (unsigned int i = 0; i < 3; ++i) {
    cX[i] = cMo[i][0] * oX[0] + cMo[i][1] * oX[1] + cMo[i][2] * oX[2] + cMo[i][3];
  }
  return {cam.get_px() * cX.x() / cX.z() + cam.get_u0(), cam.get_py() * cX.y() / cX.z() + cam.get_v0()};
}

//! How far the corners of the model's box are off in the image, the mean in pixels.
inline double imageError(const vpTrackedModel &model, const vpHomogeneousMatrix &cMo, const vpHomogeneousMatrix &truth)
{
  double sum = 0.;
  for (int k = 0; k < 8; ++k) {
    const Eigen::Vector3d corner((k & 1) != 0 ? model.boxMin().x() : model.boxMax().x(),
                                 (k & 2) != 0 ? model.boxMin().y() : model.boxMax().y(),
                                 (k & 4) != 0 ? model.boxMin().z() : model.boxMax().z());
    sum += (project(cMo, corner) - project(truth, corner)).norm();
  }
  return sum / 8.;
}

//! Tukey's weights of the rows, with a scale of their median and not below the block's noise.
inline std::vector<double> robustWeights(const vpResidualBlock &block)
{
  std::vector<double> sizes;
  for (const vpResidual &row : block.rows) {
    sizes.push_back(std::fabs(row.error));
  }
  std::vector<double> weights(sizes.size(), 1.);
  if (sizes.empty()) {
    return weights;
  }
  std::vector<double> sorted = sizes;
  std::sort(sorted.begin(), sorted.end());
  const double limit = 4.6851 * std::max(1.4826 * sorted[sorted.size() / 2], block.noise);
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    const double share = sizes[i] / limit;
    weights[i] = share < 1. ? (1. - share * share) * (1. - share * share) * block.rows[i].weight : 0.;
  }
  return weights;
}

//! A tracker of one cue.
class Follower
{
public:
  explicit Follower(const Model &model, const vpPointCueSettings &settings = vpPointCueSettings())
      : cue(settings), view(model), m_renderer(model)
  {
    cue.setDepthSource([this](const vpHomogeneousMatrix &cMo) {
      ++renders;
      m_renderer.render(cMo, makeCamera(), m_width, m_height, vpRenderOptions(), m_depth);
      return &m_depth;
    });
  }

  //! Matches an image with the view of a pose that is expected.
  void match(const vpImage<unsigned char> &I, const vpHomogeneousMatrix &expected, const vpImage<bool> *mask = nullptr)
  {
    m_width = I.getWidth();
    m_height = I.getHeight();
    view.compute(expected, makeCamera(), m_width, m_height, vpModelViewOptions(), &m_renderer);
    cue.match(source.frame(I, makeCamera(), mask), view);
  }

  //! The pose that fits the last match best. \param cMo Where to start.
  vpHomogeneousMatrix estimate(vpHomogeneousMatrix cMo)
  {
    weights.clear();
    for (int iteration = 0; iteration < 15; ++iteration) {
      cue.residuals(cMo, block);
      weights = robustWeights(block);
      Eigen::Matrix<double, 6, 6> A = Eigen::Matrix<double, 6, 6>::Zero();
      Eigen::Matrix<double, 6, 1> b = Eigen::Matrix<double, 6, 1>::Zero();
      for (std::size_t i = 0; i < weights.size(); ++i) {
        A += weights[i] * block.rows[i].jacobian * block.rows[i].jacobian.transpose();
        b += weights[i] * block.rows[i].error * block.rows[i].jacobian;
      }
      if (weights.size() < 6) {
        return cMo;
      }
      vpColVector velocity(6);
      Eigen::Map<Eigen::Matrix<double, 6, 1>>(velocity.data) = -A.ldlt().solve(b);
      cMo = vpExponentialMap::direct(velocity).inverse() * cMo;
    }
    cue.residuals(cMo, block);
    weights = robustWeights(block);
    return cMo;
  }

  //! Has the cue learn from the last match at a pose, with the weights of estimate() or all 1.
  void learn(const vpHomogeneousMatrix &cMo)
  {
    cue.residuals(cMo, block);
    weights.resize(block.rows.size(), 1.);
    cue.updateReference(cMo, weights);
  }

  //! The first image.
  void start(const vpImage<unsigned char> &I, const vpHomogeneousMatrix &cMo, const vpImage<bool> *mask = nullptr)
  {
    match(I, cMo, mask);
    weights.clear();
    learn(cMo);
  }

  //! A whole frame. \return The pose.
  vpHomogeneousMatrix track(const vpImage<unsigned char> &I, const vpHomogeneousMatrix &expected)
  {
    match(I, expected);
    const vpHomogeneousMatrix cMo = estimate(expected);
    learn(cMo);
    return cMo;
  }

  std::size_t found() const
  {
    return static_cast<std::size_t>(
        std::count_if(cue.matches().begin(), cue.matches().end(), [](const auto &match) { return match.found; }));
  }

  vpPointCue cue;
  vpModelView view;
  vpFrameSource source;
  vpResidualBlock block;
  std::vector<double> weights;
  int renders = 0;

private:
  vpCpuRenderer m_renderer;
  vpRenderedView m_depth;
  unsigned int m_width = 0;
  unsigned int m_height = 0;
};

} // namespace pointScenes
END_VISP_NAMESPACE
#endif
