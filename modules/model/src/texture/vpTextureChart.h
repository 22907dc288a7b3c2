// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpTextureChart_h
#define vpTextureChart_h

#include <visp3/model/vpTrackedModel.h>

BEGIN_VISP_NAMESPACE

//! Triangles that are looked at together, along one direction.
struct vpTextureChart
{
  std::vector<int> triangles;
  Eigen::Vector3d normal = Eigen::Vector3d::Zero(); //!< The side that is looked at, unit.
  bool oriented = true;                             //!< As vpModelFace has it.
};

//! Coplanar triangles together, those of curved faces by the axes that they look along; plain ones left out.
//! \param minContrast Charts whose gray levels differ less are left out.
std::vector<vpTextureChart> vpMakeTextureCharts(const vpTrackedModel &model, double minContrast);

/*!
  A chart drawn from the front, without perspective. Pixel (x, y) shows the surface at toObject(x, y).
*/
class vpChartImage
{
public:
  //! \param pixel Side of a pixel, metres.
  vpChartImage(const vpTrackedModel &model, const vpTextureChart &chart, double pixel);

  int width() const { return m_width; }
  int height() const { return m_height; }
  //! Mean gray level over a pixel.
  float gray(int x, int y) const { return m_gray[index(x, y)]; }
  //! True where all of a pixel shows surface, and the same layer of it as its neighbours.
  bool isUsable(int x, int y) const { return m_usable[index(x, y)] != 0; }
  //! Object frame; \e x and \e y inside the image.
  Eigen::Vector3d toObject(double x, double y) const;
  //! Unit outward normal of the surface. \param step Of the differences that it is taken from, pixels.
  Eigen::Vector3d normal(double x, double y, double step) const;

private:
  struct FineImage;

  std::size_t index(int x, int y) const
  {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(m_width) + static_cast<std::size_t>(x);
  }
  void place(const vpTrackedModel &model, const vpTextureChart &chart);
  void reduce(const FineImage &fine);
  void dropSteps();
  double depth(double x, double y) const;

  double m_pixel;
  int m_width = 0;
  int m_height = 0;
  Eigen::Vector3d m_origin = Eigen::Vector3d::Zero(); // Of pixel (0, 0), at depth 0.
  Eigen::Matrix3d m_axes;                             // Columns: right, down, towards the viewer; unit.
  std::vector<float> m_gray;
  std::vector<float> m_depth; // Towards the viewer, metres.
  std::vector<char> m_usable;
};

END_VISP_NAMESPACE
#endif
