// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpSymmetryTest_h
#define vpSymmetryTest_h

#include "symmetry/vpSegmentTree.h"
#include "symmetry/vpTriangleGrid.h"

#include "render/vpSurfaceShader.h"

#include <visp3/model/vpModelSymmetries.h>

BEGIN_VISP_NAMESPACE

/*!
  Tells whether a turn brings a model back onto itself: places on its surface with their colours, its vertices, and
  places on its edges are turned and looked for on the model. As turns keep areas and lengths, nothing is left over.
*/
class vpSymmetryTest
{
public:
  //! \param model Must outlive the test.
  vpSymmetryTest(const vpTrackedModel &model, const vpSymmetryOptions &options);

  bool operator()(const Eigen::Isometry3d &turn) const;

private:
  struct Place // On the surface.
  {
    Eigen::Vector3d position;
    Eigen::Vector3d normal; // Zero for vertices.
    Eigen::Vector3d color;
    bool hasColor = false;
  };
  struct EdgePlace
  {
    Eigen::Vector3d position, direction;
  };

  void addSurface();
  void addVertices();
  void addEdgePlaces(const std::vector<vpSegment> &segments);
  bool surfaceFits(const Eigen::Isometry3d &turn) const;
  bool edgesFit(const Eigen::Isometry3d &turn) const;
  Eigen::Vector3d colorAt(const vpSurfacePlace &place) const;

  const vpTrackedModel &m_model;
  vpSymmetryOptions m_options;
  double m_reach; // Metres.
  vpTriangleGrid m_grid;
  vpSurfaceShader m_shader;
  std::vector<Place> m_places;
  vpSegmentTree m_edges;
  std::vector<EdgePlace> m_edgePlaces;
};

END_VISP_NAMESPACE
#endif
