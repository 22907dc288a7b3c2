// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpTriangleRasterizer_h
#define vpTriangleRasterizer_h

#include "vpTriangleFill.h"
#include "../render/vpCropCamera.h"

#include <array>
#include <vector>

BEGIN_VISP_NAMESPACE

/*!
  Projects a model and draws its triangles into a buffer of inverse depths, and of triangle indices where they are asked
  for. Every vertex is projected once, into memory that is used again. Of a closed surface the triangles that are seen
  from behind are left out, half of them: there is always one in front, which covers the same pixel.
*/
class vpTriangleRasterizer
{
public:
  explicit vpTriangleRasterizer(const vpTrackedModel &model);

  //! Draws the whole model; what is closer than \e nearDistance is cut away.
  void draw(const vpHomogeneousMatrix &cMo, const vpCropCamera &camera, double nearDistance,
            const vpFillTarget &target);

private:
  using Corners = std::array<int, 3>;

  struct Vertex
  {
    vpScreenVertex screen;
    bool drawable; //!< False where its triangles have to be clipped first.
  };

  Vertex project(const Eigen::Vector3d &image) const;
  template <bool WithTriangle> void drawAll(const vpFillTarget &target) const;
  template <bool WithTriangle> void drawClipped(const Corners &corners, int index, const vpFillTarget &target) const;

  std::vector<Eigen::Vector3d> m_positions;
  std::vector<Corners> m_triangles;
  std::vector<char> m_hasBack; //!< Of each triangle: 1 where its back is inside a closed surface.
  std::vector<Vertex> m_vertices;
  bool m_isWhole = false;                           //!< Nothing is before the near plane.
  vpPoseMatrix m_projection = vpPoseMatrix::Zero(); //!< Object point to (depth x column, depth x row, depth).
  double m_near = 0.;
};

END_VISP_NAMESPACE
#endif
