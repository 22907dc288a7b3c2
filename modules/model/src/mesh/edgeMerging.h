// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef edgeMerging_h
#define edgeMerging_h

#include <visp3/model/vpTrackedModel.h>

BEGIN_VISP_NAMESPACE
namespace vpMeshDetail {
/*!
  Joins edges that follow each other on one straight line between the same faces.
  \param vertices, edgeFaces What the edges refer to; the faces of each edge are sorted.
  \param edges Edges of a mesh.
  \return Fewer, longer edges that refer to the same vertices and faces.
*/
std::vector<vpModelEdge> mergeStraightEdges(const std::vector<Eigen::Vector3d> &vertices,
                                            const std::vector<int> &edgeFaces, const std::vector<vpModelEdge> &edges);
} // namespace vpMeshDetail
END_VISP_NAMESPACE
#endif
