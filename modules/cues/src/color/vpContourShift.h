// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpContourShift_h
#define vpContourShift_h

#include <visp3/cues/vpColorCue.h>

BEGIN_VISP_NAMESPACE

/*!
  How far a line's point, projected at another pose, is from where the match had it, along the line's normal: the
  contour's offset on the line, and its interaction matrix n^T dx/dr, pixels.
*/
class vpContourShift
{
public:
  vpContourShift(const vpHomogeneousMatrix &cMo, const vpCameraParameters &cam)
      : m_px(cam.get_px()), m_py(cam.get_py()), m_u0(cam.get_u0()), m_v0(cam.get_v0())
  {
    for (unsigned int i = 0; i < 3; ++i) {
      for (unsigned int j = 0; j < 3; ++j) {
        m_cRo(i, j) = cMo[i][j];
      }
      m_cto(i) = cMo[i][3];
    }
  }

  //! \return False where the point is not in front of the camera.
  bool project(const vpColorCue::Line &line)
  {
    const Eigen::Vector3d X = m_cRo * line.position + m_cto;
    if (!(X.z() > 0.)) {
      return false;
    }
    m_inverseZ = 1. / X.z();
    m_x = X.x() * m_inverseZ;
    m_y = X.y() * m_inverseZ;
    m_nu = m_px * line.normal.x();
    m_nv = m_py * line.normal.y();
    m_pixels =
        m_nu * m_x + m_nv * m_y + line.normal.x() * (m_u0 - line.pixel.x()) + line.normal.y() * (m_v0 - line.pixel.y());
    return true;
  }

  //! Of the point projected last.
  double pixels() const { return m_pixels; }
  //! \param factor The interaction matrix is multiplied by it.
  void jacobian(double factor, Eigen::Matrix<double, 6, 1> &row) const
  {
    const double nu = factor * m_nu;
    const double nv = factor * m_nv;
    const double along = nu * m_x + nv * m_y;
    row[0] = -nu * m_inverseZ;
    row[1] = -nv * m_inverseZ;
    row[2] = along * m_inverseZ;
    row[3] = nv + along * m_y;
    row[4] = -nu - along * m_x;
    row[5] = nu * m_y - nv * m_x;
  }

private:
  Eigen::Matrix3d m_cRo;
  Eigen::Vector3d m_cto;
  double m_px, m_py, m_u0, m_v0;
  double m_inverseZ = 0., m_x = 0., m_y = 0., m_nu = 0., m_nv = 0., m_pixels = 0.;
};

END_VISP_NAMESPACE
#endif
