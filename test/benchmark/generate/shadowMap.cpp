// SPDX-License-Identifier: GPL-2.0-or-later
#include "generate/shadowMap.h"

#include <Eigen/Geometry>

#include <cmath>

namespace bench {
namespace {
const int size = 1024;
// The light's rays are nearly parallel from there.
const double distanceOfLight = 20.;
} // namespace

ShadowMap::ShadowMap(const std::shared_ptr<const vpTrackedModel> &model)
    : m_model(model), m_renderer(model), m_extent(model->diameter())
{
  const double focal = 0.95 * size * distanceOfLight;
  m_focal = static_cast<float>(focal);
  m_texel = static_cast<float>(m_extent * distanceOfLight / focal);
}

void ShadowMap::update(const vpHomogeneousMatrix &cMo, const Eigen::Vector3d &toLight)
{
  if (m_model->isConvex()) {
    return;
  }
  const Eigen::Vector3d o = m_model->centre();
  Eigen::Vector3d centre;
  for (unsigned int i = 0; i < 3; ++i) {
    centre(i) = cMo[i][0] * o.x() + cMo[i][1] * o.y() + cMo[i][2] * o.z() + cMo[i][3];
  }
  Eigen::Matrix3d axes; // Of the light's camera, as rows.
  axes.row(2) = -toLight;
  axes.row(0) = toLight.unitOrthogonal();
  axes.row(1) = axes.row(2).cross(axes.row(0));
  const Eigen::Vector3d translation = Eigen::Vector3d(0., 0., distanceOfLight * m_extent) - axes * centre;
  m_rotation = axes.cast<float>();
  m_translation = translation.cast<float>();
  vpHomogeneousMatrix lMc;
  for (unsigned int i = 0; i < 3; ++i) {
    for (unsigned int j = 0; j < 3; ++j) {
      lMc[i][j] = axes(i, j);
    }
    lMc[i][3] = translation(i);
  }
  vpRenderOptions options;
  m_renderer.render(lMc * cMo, vpCameraParameters(double(m_focal), double(m_focal), size / 2., size / 2.), size, size,
                    options, m_view);
}

float ShadowMap::litAt(int column, int row, float depth) const
{
  const int j = column - m_view.left;
  const int i = row - m_view.top;
  if (j < 0 || i < 0 || j >= m_view.width || i >= m_view.height) {
    return 1.F;
  }
  const float first =
      m_view.depth[static_cast<std::size_t>(i) * static_cast<std::size_t>(m_view.width) + static_cast<std::size_t>(j)];
  return first > 0.F && first < depth ? 0.F : 1.F;
}

float ShadowMap::lit(const Eigen::Vector3f &point, const Eigen::Vector3f &normal) const
{
  if (m_view.depth.empty()) {
    return 1.F;
  }
  // Moved off the surface by some texels, so that no surface throws a shadow on itself.
  const Eigen::Vector3f p = m_rotation * (point + 2.F * m_texel * normal) + m_translation;
  const float x = m_focal * p.x() / p.z() + size / 2.F;
  const float y = m_focal * p.y() / p.z() + size / 2.F;
  const float depth = p.z() - 2.F * m_texel;
  const int column = static_cast<int>(std::floor(x));
  const int row = static_cast<int>(std::floor(y));
  const float a = x - static_cast<float>(column);
  const float b = y - static_cast<float>(row);
  return (1.F - b) * ((1.F - a) * litAt(column, row, depth) + a * litAt(column + 1, row, depth)) +
         b * ((1.F - a) * litAt(column, row + 1, depth) + a * litAt(column + 1, row + 1, depth));
}

} // namespace bench
