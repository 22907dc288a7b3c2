// SPDX-License-Identifier: GPL-2.0-or-later
#include "vpSurfaceShader.h"
#include <visp3/se3/vpExactNumber.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <optional>

BEGIN_VISP_NAMESPACE

namespace {
vpRGBa toRgba(const Eigen::Vector3d &color)
{
  const auto byte = [](double c) { return static_cast<unsigned char>(std::clamp(c, 0., 255.) + 0.5); };
  return vpRGBa(byte(color.x()), byte(color.y()), byte(color.z()), 255);
}

Eigen::Vector3d toVector(const vpRGBa &color)
{
  return Eigen::Vector3d(color.R, color.G, color.B);
}

//! Index of the texel at \e i in an image of \e size texels that repeats, as mesh files expect.
unsigned int wrapped(double i, unsigned int size)
{
  const double inside = i - size * std::floor(i / size);
  return std::min(static_cast<unsigned int>(inside), size - 1);
}

//! Bilinear, texel (i, j) has its centre at ((j + 0.5) / width, (i + 0.5) / height).
vpRGBa sample(const vpImage<vpRGBa> &image, const Eigen::Vector2d &uv)
{
  const double x = uv.x() * image.getWidth() - 0.5;
  const double y = uv.y() * image.getHeight() - 0.5;
  if (!std::isfinite(x) || !std::isfinite(y)) {
    return vpRGBa(128, 128, 128, 255);
  }
  const double x0 = std::floor(x);
  const double y0 = std::floor(y);
  const vpRGBa *upper = image[wrapped(y0, image.getHeight())];
  const vpRGBa *lower = image[wrapped(y0 + 1, image.getHeight())];
  const unsigned int left = wrapped(x0, image.getWidth());
  const unsigned int right = wrapped(x0 + 1, image.getWidth());
  const double a = x - x0;
  const double b = y - y0;
  return toRgba((1 - b) * ((1 - a) * toVector(upper[left]) + a * toVector(upper[right])) +
                b * ((1 - a) * toVector(lower[left]) + a * toVector(lower[right])));
}
} // namespace

/*!
  A triangle in the camera frame, made once for a run of pixels that show it.
*/
class vpSurfaceShader::Patch
{
public:
  Patch(const vpTrackedModel &model, const vpPoseMatrix &pose, int index)
  {
    const vpModelTriangle &triangle = model.triangles()[static_cast<std::size_t>(index)];
    std::array<Eigen::Vector3d, 3> corner;
    for (std::size_t i = 0; i < 3; ++i) {
      corner[i] = vpTransform(pose, model.vertices()[static_cast<std::size_t>(triangle.vertex[i])]);
    }
    for (std::size_t i = 0; i < 3; ++i) {
      m_opposite.row(static_cast<Eigen::Index>(i)) = corner[(i + 1) % 3].cross(corner[(i + 2) % 3]);
      m_normals.col(static_cast<Eigen::Index>(i)) =
          pose.leftCols<3>() * model.normals()[static_cast<std::size_t>(triangle.normal[i])];
    }
    m_plane = (corner[1] - corner[0]).cross(corner[2] - corner[0]).normalized();
    if (m_plane.dot(corner[0]) > 0) {
      m_plane = -m_plane;
      m_normals = -m_normals;
    }
  }

  //! Shares of the corners in the surface point on a line of sight, correct under perspective, sum 1.
  Eigen::Vector3d weights(const Eigen::Vector3d &ray) const
  {
    const Eigen::Vector3d volumes = m_opposite * ray;
    const double sum = volumes.sum();
    if (vpIsZero(sum)) {
      return Eigen::Vector3d::Constant(1. / 3.);
    }
    const Eigen::Vector3d shares = (volumes / sum).cwiseMax(0.);
    return shares / shares.sum();
  }

  /*!
    Interpolated normal on the side that is seen. On the rim of a curved surface it may look past the camera; it is then
    turned to be perpendicular to the line of sight, because its opposite would look like an edge.
  */
  Eigen::Vector3f normal(const Eigen::Vector3d &weights, const Eigen::Vector3d &ray) const
  {
    Eigen::Vector3d n = m_normals * weights;
    const double away = n.dot(ray);
    if (away > 0) {
      n -= ray * (away / ray.squaredNorm());
    }
    const double length = n.norm();
    return (length > 1e-6 ? Eigen::Vector3d(n / length) : m_plane).cast<float>();
  }

private:
  Eigen::Matrix3d m_opposite; //!< Row i times a ray is the volume that corner i's share is proportional to.
  Eigen::Matrix3d m_normals;  //!< Column i is corner i's normal, camera frame, on the seen side.
  Eigen::Vector3d m_plane;    //!< Unit normal of the triangle itself, towards the camera.
};

vpRGBa vpSurfaceShader::color(int triangle, const Eigen::Vector3d &weights) const
{
  const vpModelAppearance &look = m_model->appearance();
  const std::size_t t = static_cast<std::size_t>(triangle);
  if (t < look.image.size() && look.image[t] >= 0 && t < look.texture.size()) {
    const vpImage<vpRGBa> &image = look.images[static_cast<std::size_t>(look.image[t])];
    const std::array<Eigen::Vector2f, 3> &uv = look.texture[t];
    if (image.getSize() > 0) {
      return sample(image, weights.x() * uv[0].cast<double>() + weights.y() * uv[1].cast<double>() +
                               weights.z() * uv[2].cast<double>());
    }
  }
  if (t < look.color.size()) {
    const std::array<Eigen::Vector3f, 3> &corner = look.color[t];
    return toRgba(255. * (weights.x() * corner[0].cast<double>() + weights.y() * corner[1].cast<double>() +
                          weights.z() * corner[2].cast<double>()));
  }
  return vpRGBa(128, 128, 128, 255);
}

void vpSurfaceShader::shade(const vpHomogeneousMatrix &cMo, const vpCropCamera &camera, unsigned int channels,
                            const std::vector<int> &triangles, vpRenderedView &view) const
{
  const bool withFace = (channels & vpRenderOptions::FACE) != 0;
  const bool withSurface = (channels & (vpRenderOptions::NORMAL | vpRenderOptions::COLOR)) != 0;
  view.normal.assign((channels & vpRenderOptions::NORMAL) ? triangles.size() : 0, Eigen::Vector3f::Zero());
  view.face.assign(withFace ? triangles.size() : 0, -1);
  view.color.assign((channels & vpRenderOptions::COLOR) ? triangles.size() : 0, vpRGBa(0, 0, 0, 0));
  if (withFace) {
    std::transform(triangles.begin(), triangles.end(), view.face.begin(), [this](int triangle) {
      return triangle < 0 ? -1 : m_model->triangles()[static_cast<std::size_t>(triangle)].face;
    });
  }
  if (withSurface) {
    shadeSurface(vpToPoseMatrix(cMo), camera, triangles, view);
  }
}

void vpSurfaceShader::shadeSurface(const vpPoseMatrix &pose, const vpCropCamera &camera,
                                   const std::vector<int> &triangles, vpRenderedView &view) const
{
  std::optional<Patch> patch;
  int patchTriangle = -1;
  std::size_t i = 0;
  for (int row = 0; row < view.height; ++row) {
    for (int column = 0; column < view.width; ++column, ++i) {
      const int triangle = triangles[i];
      if (triangle < 0) {
        continue;
      }
      if (triangle != patchTriangle) {
        patch.emplace(*m_model, pose, triangle);
        patchTriangle = triangle;
      }
      const Eigen::Vector3d ray = camera.ray(column, row);
      const Eigen::Vector3d weights = patch->weights(ray);
      if (!view.normal.empty()) {
        view.normal[i] = patch->normal(weights, ray);
      }
      if (!view.color.empty()) {
        view.color[i] = color(triangle, weights);
      }
    }
  }
}

END_VISP_NAMESPACE
