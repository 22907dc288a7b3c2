// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpPoseScore_h
#define vpPoseScore_h

#include "knowledge/vpSurfaceTrust.h"
#include "search/vpPointProjection.h"

#include <visp3/cues/vpColorOddsMap.h>
#include <visp3/cues/vpOrientedDistanceMap.h>
#include <visp3/cues/vpSurfaceMemory.h>
#include <visp3/model/vpViewSphere.h>

#include <array>

BEGIN_VISP_NAMESPACE

/*
  How well an image shows the object at a pose, in microseconds: from a precomputed view, the oriented distances to
  edges ([T10] eq. 11), the colours on both sides of the silhouette, and what is remembered of the surface.
*/
class vpPoseScore
{
public:
  // Each part is about 1 where all is well, and about 0 or less by chance.
  struct Value
  {
    double distance = 1.; // Mean of the distances to edges, in units of the largest one ([T10] eq. 11).
    double color = 0.;    // Separation across the silhouette, [-1, 1].
    double surface = 0.;  // Correlation with what is remembered, as far as anything is; [-1, 1].
    double inside = 0.;   // Share of the object's outline that is in the image.
    bool isSeen = false;  // Enough of it is.
    double total = -1.;   // Weighted mean of the parts that there are.
  };

  void setSphere(vpViewSphere *sphere)
  {
    m_sphere = sphere;
    m_level = sphere->options().level;
  }
  // The finest one whose views are looked at.
  void setLevel(unsigned int level) { m_level = level; }
  // The image products that are looked at; null for those that there are not.
  void setImage(const vpOrientedDistanceMap *edges, const vpColorOddsMap *colors, const vpSurfaceMemory *surface,
                const vpCameraParameters &cam, unsigned int width, unsigned int height);
  // How much each part counts in the total.
  void setWeights(double edges, double color, double surface) { m_weights = {{edges, color, surface}}; }
  Value operator()(const vpHomogeneousMatrix &cMo) const { return at(cMo, m_level); }
  // The same by a coarser level, of which fewer views have to be made.
  Value at(const vpHomogeneousMatrix &cMo, unsigned int level) const;

private:
  struct Sums;

  void addPoint(const vpSeenPoint &point, bool isSilhouette, float reach, Sums &sums) const;
  float separation(const vpSeenPoint &point, float reach) const;
  void combine(const Sums &sums, const vpHomogeneousMatrix &cMo, Value &value) const;

  vpViewSphere *m_sphere = nullptr;
  unsigned int m_level = 0;
  const vpOrientedDistanceMap *m_edges = nullptr;
  const vpColorOddsMap *m_colors = nullptr;
  const vpSurfaceMemory *m_surface = nullptr;
  vpPointCamera m_camera;
  std::array<double, 3> m_weights = {{1., 1., 1.}}; // Of edges, colours and surface.
};

END_VISP_NAMESPACE
#endif
