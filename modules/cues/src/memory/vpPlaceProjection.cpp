// SPDX-License-Identifier: GPL-2.0-or-later
#include "memory/vpPlaceProjection.h"

#include <Eigen/Core>

BEGIN_VISP_NAMESPACE

// Pixel j of the reduced image is the mean of pixels 2 j and 2 j + 1, so its middle is at 2 j + 0.5 of the whole one.
vpPlaceProjection::vpPlaceProjection(const vpHomogeneousMatrix &cMo, const vpCameraParameters &cam, int width,
                                     int height)
    : m_px(static_cast<float>(0.5 * cam.get_px())), m_py(static_cast<float>(0.5 * cam.get_py())),
      m_u0(static_cast<float>(0.5 * cam.get_u0() - 0.25)), m_v0(static_cast<float>(0.5 * cam.get_v0() - 0.25)),
      m_width(width), m_right(static_cast<float>(width) - 0.5F), m_bottom(static_cast<float>(height) - 0.5F)
{
  // Its operators are no inline functions.
  std::transform(cMo.data, cMo.data + 12, m_pose, [](double value) { return static_cast<float>(value); });
}

// Without a branch, so that several places go through it at once.
void vpPlaceProjection::project(const float *first, std::size_t stride, std::size_t count)
{
  const float m0 = m_pose[0], m1 = m_pose[1], m2 = m_pose[2], m3 = m_pose[3];
  const float m4 = m_pose[4], m5 = m_pose[5], m6 = m_pose[6], m7 = m_pose[7];
  const float m8 = m_pose[8], m9 = m_pose[9], m10 = m_pose[10], m11 = m_pose[11];
  const float px = m_px, py = m_py, u0 = m_u0, v0 = m_v0;
  for (std::size_t i = 0; i < count; ++i) {
    const float *place = first + i;
    const float oX = place[0], oY = place[stride], oZ = place[2 * stride];
    const float oNx = place[3 * stride], oNy = place[4 * stride], oNz = place[5 * stride];
    const float x = m0 * oX + m1 * oY + m2 * oZ + m3;
    const float y = m4 * oX + m5 * oY + m6 * oZ + m7;
    const float z = m8 * oX + m9 * oY + m10 * oZ + m11;
    const float nx = m0 * oNx + m1 * oNy + m2 * oNz;
    const float ny = m4 * oNx + m5 * oNy + m6 * oNz;
    const float nz = m8 * oNx + m9 * oNy + m10 * oNz;
    const float inverse = 1.F / z;
    m_u[i] = px * x * inverse + u0;
    m_v[i] = py * y * inverse + v0;
    m_depth[i] = z;
    m_facing[i] = -(nx * x + ny * y + nz * z);
    m_distance[i] = x * x + y * y + z * z;
  }
  // Eigen's root is one of several numbers at once; the standard one, which may set errno, is not.
  const Eigen::Index size = static_cast<Eigen::Index>(count);
  Eigen::Map<Eigen::ArrayXf>(m_facing.data(), size) /= Eigen::Map<Eigen::ArrayXf>(m_distance.data(), size).sqrt();
}

END_VISP_NAMESPACE
