// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpContourAligner_h
#define vpContourAligner_h

#include "search/vpPointProjection.h"

#include <visp3/cues/vpColorOddsMap.h>
#include <visp3/model/vpViewSphere.h>

#include <Eigen/Geometry>

BEGIN_VISP_NAMESPACE

/*
  Moves a pose so that its silhouette separates the object's colours from the others, in some microseconds: one
  Gauss-Newton step for each look at the image, with the silhouette of the nearest precomputed view.

  Along the normal of each silhouette point, the logarithms of odds are summed up on both sides of every place that the
  contour could be at; where the difference is largest, the contour is taken to be.
*/
class vpContourAligner
{
public:
  void setSphere(vpViewSphere *sphere) { m_sphere = sphere; }
  void setImage(const vpColorOddsMap &colors, const vpCameraParameters &cam, unsigned int width, unsigned int height);
  // reach: how far from the silhouette is looked, in projected diameters. Returns false, and leaves the pose as it is,
  // where hardly anything is in view.
  bool step(Eigen::Isometry3d &cMo, double reach) const;

private:
  // Where the contour is on the line across it.
  struct Contour
  {
    float gain;   // How much better than none it explains the line, sum of log-odds.
    float offset; // Pixels, outwards.
  };
  struct Equations;

  Contour findContour(float u, float v, float du, float dv, float spacing) const;
  void addPoint(const vpSeenPoint &point, const Eigen::Vector3f &centre, float spacing, Equations &equations) const;

  vpViewSphere *m_sphere = nullptr;
  const vpColorOddsMap *m_colors = nullptr;
  vpPointCamera m_camera;
};

END_VISP_NAMESPACE
#endif
