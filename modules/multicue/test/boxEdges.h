// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef boxEdges_h
#define boxEdges_h

#include "renderedBox.h"

#include <visp3/core/vpImagePoint.h>
#include <visp3/core/vpMeterPixelConversion.h>
#include <visp3/core/vpPoint.h>

#include <algorithm>
#include <vector>

/*! \file boxEdges.h Where the edges of a renderedBox are in its images, computed without the library's models. */

BEGIN_VISP_NAMESPACE

//! An edge of the box in the image.
struct BoxEdge
{
  //! Of a point to it, pixels.
  double distance(const vpImagePoint &point) const
  {
    const Eigen::Vector2d direction(to.get_u() - from.get_u(), to.get_v() - from.get_v());
    const Eigen::Vector2d off(point.get_u() - from.get_u(), point.get_v() - from.get_v());
    const double along = std::min(std::max(off.dot(direction) / direction.squaredNorm(), 0.), 1.);
    return (off - along * direction).norm();
  }

  vpImagePoint from;
  vpImagePoint to;
  bool isVisible = false; //!< One of its two sides is.
};

//! All twelve, by the sides that the camera is in front of.
inline std::vector<BoxEdge> boxEdges(const vpHomogeneousMatrix &cMo)
{
  const vpHomogeneousMatrix oMc = cMo.inverse();
  const Eigen::Vector3d eye(oMc[0][3], oMc[1][3], oMc[2][3]);
  const Eigen::Vector3d half = 0.5 * renderedBox::size();
  std::vector<BoxEdge> edges;
  for (int axis = 0; axis < 3; ++axis) {
    const int second = (axis + 1) % 3;
    const int third = (axis + 2) % 3;
    for (int corner = 0; corner < 4; ++corner) {
      Eigen::Vector3d end = half;
      end[second] *= (corner & 1) ? 1. : -1.;
      end[third] *= (corner & 2) ? 1. : -1.;
      const auto faces = [&](int side) { return end[side] * (eye[side] - end[side]) > 0.; };
      const auto pixel = [&](double sign) {
        vpPoint point(axis == 0 ? sign * end[0] : end[0], axis == 1 ? sign * end[1] : end[1],
                      axis == 2 ? sign * end[2] : end[2]);
        point.track(cMo);
        vpImagePoint place;
        vpMeterPixelConversion::convertPoint(renderedBox::camera(), point.get_x(), point.get_y(), place);
        return place;
      };
      edges.push_back({pixel(-1.), pixel(1.), faces(second) || faces(third)});
    }
  }
  return edges;
}

END_VISP_NAMESPACE
#endif
