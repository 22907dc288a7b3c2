// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpTriangleGrid_h
#define vpTriangleGrid_h

#include <visp3/model/vpTrackedModel.h>

#include <vector>

BEGIN_VISP_NAMESPACE

//! A place on the surface.
struct vpSurfacePlace
{
  int triangle = -1;                                 //!< -1: none.
  Eigen::Vector3d weights = Eigen::Vector3d::Zero(); //!< Shares of its corners, sum 1.
};

//! Finds the surface within a fixed distance of a point: triangles sorted into the cells that they are near to.
class vpTriangleGrid
{
public:
  //! \param model Must outlive the grid. \param reach How far from a point the surface is looked for, metres, > 0.
  vpTriangleGrid(const vpTrackedModel &model, double reach);

  /*!
    The place of the surface nearest to a point.
    \param normal Of the surface that is looked for; zero for any. Other sides of the object do not count.
  */
  vpSurfacePlace nearest(const Eigen::Vector3d &point, const Eigen::Vector3d &normal) const;
  //! Unit normal of a triangle.
  const Eigen::Vector3d &normal(int triangle) const { return m_normals[static_cast<std::size_t>(triangle)]; }

private:
  Eigen::Array3i cellOf(const Eigen::Vector3d &point) const;
  std::size_t indexOf(const Eigen::Array3i &cell) const;
  const Eigen::Vector3d &corner(int triangle, std::size_t i) const;
  template <typename Use> void forEachCell(int triangle, const Use &use) const;

  const vpTrackedModel &m_model;
  double m_reach;
  double m_size; // Of a cell.
  Eigen::Vector3d m_origin;
  Eigen::Array3i m_cells;
  std::vector<Eigen::Vector3d> m_normals;
  std::vector<std::size_t> m_starts; // Per cell, in m_triangles; one more at the end.
  std::vector<int> m_triangles;
};

END_VISP_NAMESPACE
#endif
