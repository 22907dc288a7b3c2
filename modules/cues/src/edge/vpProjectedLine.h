// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpProjectedLine_h
#define vpProjectedLine_h

#include <visp3/cues/vpEdgeCue.h>

#include <Eigen/Geometry>

BEGIN_VISP_NAMESPACE

/*!
  The image of the line through a control point along its edge.

  With X and D the point and the direction in the camera frame, the line's points p = (x, y, 1) satisfy n . p = 0 where
  n = X x D, and the signed distance of a point is e = n . p / |(n_x, n_y)|. The camera's velocity (v, w) moves the
  point by -v - w x X and turns the direction by -w x D, so n changes by -v x D - w x n, and with q = (p - e m) / |(n_x,
  n_y)|, m = (n_x, n_y, 0) / |(n_x, n_y)|, the distance by q . dn = -(D x q) . v - (n x q) . w. That is [P14] eq. 6 with
  the normal's dependence on the pose in it.
*/
class vpProjectedLine
{
public:
  vpProjectedLine(const Eigen::Vector3d &cX, const Eigen::Vector3d &cD)
      : m_direction(cD), m_plane(cX.cross(cD)), m_length(m_plane.head<2>().norm()),
        // Behind the camera, or seen end-on, there is no line.
        m_isSeen(cX.z() > 0. && m_length > 1e-6 * cX.norm())
  {
  }

  bool isSeen() const { return m_isSeen; }

  //! Signed distance of \e place, normalised coordinates. \pre isSeen()
  double distance(const Eigen::Vector2d &place) const
  {
    return (m_plane.head<2>().dot(place) + m_plane.z()) / m_length;
  }

  //! \param error distance() of \e place. \return Its interaction matrix.
  Eigen::Matrix<double, 6, 1> jacobian(const Eigen::Vector2d &place, double error) const
  {
    Eigen::Vector3d q(place.x(), place.y(), 1.);
    q.head<2>() -= error * m_plane.head<2>() / m_length;
    q /= m_length;
    Eigen::Matrix<double, 6, 1> row;
    row << q.cross(m_direction), q.cross(m_plane);
    return row;
  }

  //! The one of \e count candidates that is closest to the line ([P14] eq. 7).
  const vpEdgeCue::Candidate &nearest(const vpEdgeCue::Candidate *candidates, int count) const
  {
    const vpEdgeCue::Candidate *best = candidates;
    for (int i = 1; i < count; ++i) {
      if (std::fabs(distance(candidates[i].place)) < std::fabs(distance(best->place))) {
        best = candidates + i;
      }
    }
    return *best;
  }

private:
  Eigen::Vector3d m_direction;
  Eigen::Vector3d m_plane; // Normal of the plane through the camera's centre and the line.
  double m_length;
  bool m_isSeen;
};

//! Projects control points at one pose.
class vpLineProjector
{
public:
  explicit vpLineProjector(const vpHomogeneousMatrix &cMo)
  {
    for (unsigned int i = 0; i < 3; ++i) {
      for (unsigned int j = 0; j < 3; ++j) {
        m_cRo(i, j) = cMo[i][j];
      }
      m_cto(i) = cMo[i][3];
    }
  }

  vpProjectedLine operator()(const vpControlPoint &point) const
  {
    return vpProjectedLine(m_cRo * point.position + m_cto, m_cRo * point.direction);
  }

private:
  Eigen::Matrix3d m_cRo;
  Eigen::Vector3d m_cto;
};

END_VISP_NAMESPACE
#endif
