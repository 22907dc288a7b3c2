// SPDX-License-Identifier: GPL-2.0-or-later
#include "search/vpPointProjection.h"

#include <Eigen/Core>

BEGIN_VISP_NAMESPACE

// Without a branch, so that several points go through it at once.
void vpPointProjection::project(const vpSphereView &view, std::size_t first, std::size_t count)
{
  const float *oX = view.x() + first, *oY = view.y() + first, *oZ = view.z() + first;
  const float *oDx = view.dx() + first, *oDy = view.dy() + first, *oDz = view.dz() + first;
  const float *side = view.side() + first;
  const Pose m = m_pose;
  const vpPointCamera camera = m_camera;
  for (std::size_t i = 0; i < count; ++i) {
    const float x = m[0] * oX[i] + m[1] * oY[i] + m[2] * oZ[i] + m[3];
    const float y = m[4] * oX[i] + m[5] * oY[i] + m[6] * oZ[i] + m[7];
    const float z = m[8] * oX[i] + m[9] * oY[i] + m[10] * oZ[i] + m[11];
    const float dx = m[0] * oDx[i] + m[1] * oDy[i] + m[2] * oDz[i];
    const float dy = m[4] * oDx[i] + m[5] * oDy[i] + m[6] * oDz[i];
    const float dz = m[8] * oDx[i] + m[9] * oDy[i] + m[10] * oDz[i];
    const float inverse = 1.F / z;
    m_x[i] = x;
    m_y[i] = y;
    m_z[i] = z;
    m_u[i] = camera.px * x * inverse + camera.u0;
    m_v[i] = camera.py * y * inverse + camera.v0;
    // The image of the edge's direction, turned by a quarter.
    m_normalU[i] = -side[i] * (camera.py * (dy - y * inverse * dz));
    m_normalV[i] = side[i] * (camera.px * (dx - x * inverse * dz));
    m_length[i] = m_normalU[i] * m_normalU[i] + m_normalV[i] * m_normalV[i];
  }
  // Eigen's root is one of several numbers at once; the standard one, which may set errno, is not.
  Eigen::Map<Eigen::ArrayXf> length(m_length.data(), static_cast<Eigen::Index>(count));
  length = length.sqrt();
}

END_VISP_NAMESPACE
