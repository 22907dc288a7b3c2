// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpProjectedLine_h
#define vpProjectedLine_h

#include <visp3/cues/vpEdgeCue.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

BEGIN_VISP_NAMESPACE

/*!
  The image of the line through a control point along its edge.

  With X and D the point and the direction in the camera frame and n = X x D, the line's points p = (x, y, 1) satisfy
  n . p = 0, and with s = 1 / |(n_x, n_y)| the signed distance of a point is e = s n . p. The camera's velocity (v, w)
  moves the point by -v - w x X and turns the direction by -w x D, so n changes by -v x D - w x n; and with q = p - s e
  (n_x, n_y, 0), the foot of p on the line, e changes by s q . dn = s (q x D) . v + s (q x n) . w. That is [P14] eq. 6
  with the normal's dependence on the pose in it.

  Products are written out where Eigen would read two numbers at once that were just written one by one, for which the
  processor waits: residuals() take a third of the time so.
*/
class vpProjectedLine
{
public:
  vpProjectedLine(const Eigen::Vector3d &cX, const Eigen::Vector3d &cD) : m_direction(cD), m_plane(cX.cross(cD))
  {
    const double squaredLength = m_plane.x() * m_plane.x() + m_plane.y() * m_plane.y();
    // Behind the camera, or seen end-on, there is no line.
    m_isSeen = cX.z() > 0. && squaredLength > 1e-12 * cX.squaredNorm();
    m_scale = m_isSeen ? 1. / std::sqrt(squaredLength) : 0.;
  }

  bool isSeen() const { return m_isSeen; }

  //! Signed distance of \e place, normalised coordinates. \pre isSeen()
  double distance(const Eigen::Vector2d &place) const { return m_scale * offPlane(place); }

  //! \param error distance() of \e place. \param row Its interaction matrix.
  void jacobian(const Eigen::Vector2d &place, double error, Eigen::Matrix<double, 6, 1> &row) const
  {
    const double step = m_scale * error;
    const Eigen::Vector3d foot(place.x() - step * m_plane.x(), place.y() - step * m_plane.y(), 1.);
    row.head<3>() = m_scale * foot.cross(m_direction);
    row.tail<3>() = m_scale * foot.cross(m_plane);
  }

  //! The one of \e count candidates that is closest to the line ([P14] eq. 7).
  const vpEdgeCue::Candidate &nearest(const vpEdgeCue::Candidate *candidates, int count) const
  {
    const vpEdgeCue::Candidate *best = candidates;
    double least = std::fabs(offPlane(best->place));
    for (int i = 1; i < count; ++i) {
      const double d = std::fabs(offPlane(candidates[i].place));
      best = d < least ? candidates + i : best;
      least = std::min(d, least);
    }
    return *best;
  }

  //! The likeliest of \e count candidates, best first, where the line may be off by a normal deviation.
  //! \param precision 1 / (2 deviation^2), in normalised coordinates.
  const vpEdgeCue::Candidate &likeliest(const vpEdgeCue::Candidate *candidates, int count, double precision) const
  {
    int best = 0;
    double least = HUGE_VAL;
    for (int i = 0; i < count; ++i) {
      const double d = distance(candidates[i].place);
      const double cost = precision * d * d + std::log1p(i);
      best = cost < least ? i : best;
      least = std::min(cost, least);
    }
    return candidates[best];
  }

private:
  double offPlane(const Eigen::Vector2d &place) const
  {
    return m_plane.x() * place.x() + m_plane.y() * place.y() + m_plane.z();
  }

  Eigen::Vector3d m_direction;
  Eigen::Vector3d m_plane; // n: normal of the plane through the camera's centre and the line, metres.
  double m_scale;          // s, per metre.
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
