// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpSegmentTree_h
#define vpSegmentTree_h

#include <visp3/se3/vpCompatibility.h>

#include <Eigen/Geometry>

#include <cstddef>
#include <vector>

BEGIN_VISP_NAMESPACE

//! A straight bit of an edge.
struct vpSegment
{
  Eigen::Vector3d start, end;
  Eigen::Vector3d direction; //!< Unit length.
};

//! Finds segments within a fixed distance of a point: a tree of boxes, each around the two below it.
class vpSegmentTree
{
public:
  vpSegmentTree() = default;
  //! \param reach How far from a point segments are looked for, metres.
  vpSegmentTree(const std::vector<vpSegment> &segments, double reach);

  //! \return True where a segment within reach of a point has a direction whose cosine is above \e cosine, either way.
  bool hasNear(const Eigen::Vector3d &point, const Eigen::Vector3d &direction, double cosine) const;

private:
  struct Node
  {
    Eigen::AlignedBox3d box; // With the reach.
    std::size_t first;       // Of m_segments.
    std::size_t last;
    std::size_t right = 0; // The other node follows this one; 0 for a leaf.
  };

  void build(std::size_t first, std::size_t last);
  bool leafHasNear(const Node &leaf, const Eigen::Vector3d &point, const Eigen::Vector3d &direction,
                   double cosine) const;

  double m_reach = 0.;
  std::vector<vpSegment> m_segments;
  std::vector<Node> m_nodes;
};

END_VISP_NAMESPACE
#endif
