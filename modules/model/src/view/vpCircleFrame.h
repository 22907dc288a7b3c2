// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpCircleFrame_h
#define vpCircleFrame_h

#include <visp3/model/vpTrackedModel.h>

#include <Eigen/Geometry>

#include <cmath>

BEGIN_VISP_NAMESPACE

//! Points of a circle by their share of the way around it.
class vpCircleFrame
{
public:
  explicit vpCircleFrame(const vpModelCircle &circle)
      : m_centre(circle.centre), m_x(circle.radius * circle.normal.unitOrthogonal()), m_y(circle.normal.cross(m_x))
  {
  }

  //! \param parameter In [0, 1], counter-clockwise around the circle's normal. \param direction Of unit length.
  void place(double parameter, Eigen::Vector3d &position, Eigen::Vector3d &direction) const
  {
    const double cosine = std::cos(2. * M_PI * parameter);
    const double sine = std::sin(2. * M_PI * parameter);
    position = m_centre + cosine * m_x + sine * m_y;
    direction = (cosine * m_y - sine * m_x).normalized();
  }

private:
  Eigen::Vector3d m_centre;
  Eigen::Vector3d m_x;
  Eigen::Vector3d m_y;
};

END_VISP_NAMESPACE
#endif
