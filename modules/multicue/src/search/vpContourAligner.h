// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpContourAligner_h
#define vpContourAligner_h

#include "search/vpPointProjection.h"

#include <visp3/cues/vpColorOddsMap.h>
#include <visp3/cues/vpOrientedDistanceMap.h>
#include <visp3/model/vpViewSphere.h>

#include <Eigen/Geometry>

BEGIN_VISP_NAMESPACE

/*
  Moves a pose to what the image shows near it, in some microseconds: one Gauss-Newton step for each look at the image,
  with the contours of the nearest precomputed view.

  By colours: so that the silhouette separates those of the object from the others. Along the normal of each silhouette
  point, the logarithms of odds are summed up on both sides of every place that the contour could be at; where the
  difference is largest, the contour is taken to be.

  By edges: so that all edges lie on edges of the image of their orientation, a distance map's slope telling on which
  side those are.
*/
class vpContourAligner
{
public:
  void setSphere(vpViewSphere *sphere)
  {
    m_sphere = sphere;
    m_level = sphere->options().level;
  }
  // The finest one whose views are looked at.
  void setLevel(unsigned int level) { m_level = level; }
  // Either map may be null, and the step that needs it is then not to be called.
  void setImage(const vpColorOddsMap *colors, const vpOrientedDistanceMap *edges, const vpCameraParameters &cam,
                unsigned int width, unsigned int height);
  // reach: how far from the silhouette is looked, in projected diameters. every: one point of so many takes part.
  // Returns false, and leaves the pose as it is, where hardly anything is in view.
  bool stepByColors(Eigen::Isometry3d &cMo, double reach, std::size_t every = 1) const;
  // The map's largest distance is what it reaches.
  bool stepByEdges(Eigen::Isometry3d &cMo) const;

private:
  // Where the contour is on the line across it.
  struct Contour
  {
    float weight; // 0: there is none.
    float offset; // Pixels, outwards.
  };
  struct Equations;

  Contour findByColors(const vpSeenPoint &point, float spacing) const;
  Contour findByEdges(const vpSeenPoint &point) const;
  void addContour(const vpSeenPoint &point, const Eigen::Vector3f &centre, const Contour &contour,
                  Equations &equations) const;
  // Those of a view that take part: every so many of the first ones.
  struct Points
  {
    std::size_t count;
    std::size_t every;
  };
  template <typename Finder>
  bool step(Eigen::Isometry3d &cMo, const vpSphereView &view, const Points &points, double unit, Finder &&find) const;
  const vpSphereView &viewAt(const Eigen::Isometry3d &cMo) const;

  vpViewSphere *m_sphere = nullptr;
  unsigned int m_level = 0;
  const vpColorOddsMap *m_colors = nullptr;
  const vpOrientedDistanceMap *m_edges = nullptr;
  vpPointCamera m_camera;
};

END_VISP_NAMESPACE
#endif
