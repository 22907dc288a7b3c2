// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpContourScan_h
#define vpContourScan_h

#include "search/vpPointProjection.h"

#include <visp3/cues/vpOrientedDistanceMap.h>
#include <visp3/model/vpViewSphere.h>

#include <Eigen/Geometry>

#include <array>
#include <cstdint>
#include <vector>

BEGIN_VISP_NAMESPACE

/*
  Looks for the contours of one view at all places of an image at once. For each orientation of an edge, a coarse grid
  holds how near the next edge of it is. The grids of all points of the view, each shifted by where the point is, are
  added up in bytes, many places with one instruction.
*/
class vpContourScan
{
public:
  // Where a view fits best.
  struct Find
  {
    float u = 0.F, v = 0.F; // Pixels, of the middle of the object's box; may be outside the image.
    double share = 0.;      // Of the view's points: 1 where all are on edges of their orientation.
  };

  void setSphere(vpViewSphere *sphere)
  {
    m_sphere = sphere;
    m_level = sphere->options().level;
  }
  // The finest one whose views are looked at.
  void setLevel(unsigned int level) { m_level = level; }
  // Before find(). radius: how large the object is about to be in the image, pixels.
  void setImage(const vpOrientedDistanceMap &edges, const vpCameraParameters &cam, unsigned int width,
                unsigned int height, double radius);
  // The same with coarser or finer grids. clutter: what an edge of any orientation counts against one that is as it
  // should be; with 1, places full of edges fit no better than empty ones.
  void setImage(const vpOrientedDistanceMap &edges, const vpCameraParameters &cam, unsigned int width,
                unsigned int height, double radius, double cellsPerRadius, double clutter);
  // Of the side that this pose shows, as near and as it is turned in the image.
  Find find(const Eigen::Isometry3d &cMo);
  // Likewise the best places that are apart, best first: added to finds, at most as many.
  void find(const Eigen::Isometry3d &cMo, std::size_t most, std::vector<Find> &finds);
  // A pose that shows the same side there.
  Eigen::Isometry3d movedTo(const Find &find, const Eigen::Isometry3d &cMo) const;

private:
  static constexpr int phases = 2; // Grids for each step, in each direction.

  void fill(const vpOrientedDistanceMap &edges, int rowPhase, int columnPhase);
  std::array<double, vpOrientedDistanceMap::bins> matchesAt(const vpOrientedDistanceMap &edges, double u, double v,
                                                            double reach) const;
  void addPoint(const vpSeenPoint &point);
  std::size_t addPoints(const Eigen::Isometry3d &cMo);
  Find largestSum(std::size_t points) const;
  void blankAround(const Find &find);
  std::size_t gridOf(int bin, int rowPhase, int columnPhase) const
  {
    return static_cast<std::size_t>((bin * phases + rowPhase) * phases + columnPhase) * m_gridSize;
  }

  vpViewSphere *m_sphere = nullptr;
  unsigned int m_level = 0;
  vpPointCamera m_camera;
  double m_step = 8.;     // Of the grids, pixels.
  double m_radius = 100.; // Pixels.
  double m_clutter = 0.;
  double m_reach = 8.;           // How near an edge has to be, pixels.
  int m_margin = 0;              // Cells around the image in which the middle may be.
  int m_border = 0;              // Further cells, for the points.
  int m_columns = 0, m_rows = 0; // Of places for the middle.
  int m_stride = 0;              // Columns with the borders.
  std::size_t m_gridSize = 0;
  std::vector<std::uint8_t> m_grids; // Of all orientations and phases.
  std::vector<std::uint8_t> m_sums;  // Of the places of one view.
};

END_VISP_NAMESPACE
#endif
