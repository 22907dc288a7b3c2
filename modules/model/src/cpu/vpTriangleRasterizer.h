// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpTriangleRasterizer_h
#define vpTriangleRasterizer_h

#include "vpTriangleClusters.h"
#include "vpTriangleFill.h"
#include "../render/vpCropCamera.h"

#include <array>

BEGIN_VISP_NAMESPACE

/*!
  Projects a model and draws its triangles into a buffer of inverse depths, and of triangle indices where they are asked
  for. Of a closed surface the triangles that are seen from behind are left out, half of them: there is always one in
  front, which covers the same pixel.
*/
class vpTriangleRasterizer
{
public:
  explicit vpTriangleRasterizer(const vpTrackedModel &model);

  //! Draws the whole model; what is closer than \e nearDistance is cut away.
  void draw(const vpHomogeneousMatrix &cMo, const vpCropCamera &camera, double nearDistance,
            const vpFillTarget &target);

private:
  //! The corners of one cluster.
  struct Screen
  {
    std::array<double, vpTriangleClusters::mostPositions> inverse;
    std::array<std::int32_t, vpTriangleClusters::mostPositions> x;
    std::array<std::int32_t, vpTriangleClusters::mostPositions> y;

    vpScreenVertex vertex(std::size_t i) const
    {
      vpScreenVertex vertex;
      vertex.inverse = inverse[i];
      vertex.x = x[i];
      vertex.y = y[i];
      return vertex;
    }
  };

  bool isWhole() const;
  void project(const vpTriangleClusters::Cluster &cluster);
  bool isDrawable(const vpScreenVertex &vertex) const;
  template <bool WithTriangle>
  void drawCluster(const vpTriangleClusters::Cluster &cluster, const vpFillTarget &target) const;
  template <bool WithTriangle>
  void drawClipped(const vpTriangleClusters::Cluster &cluster, const vpTriangleClusters::Triangle &triangle,
                   const vpFillTarget &target) const;

  vpTriangleClusters m_clusters;
  vpMeshDetail::BoundingBox m_box;
  Screen m_screen;
  bool m_isWhole = false;                           //!< Nothing has to be clipped.
  vpPoseMatrix m_projection = vpPoseMatrix::Zero(); //!< Object point to (depth x column, depth x row, depth).
  double m_near = 0.;
};

END_VISP_NAMESPACE
#endif
