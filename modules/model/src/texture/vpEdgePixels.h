// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpEdgePixels_h
#define vpEdgePixels_h

#include "texture/vpTextureChart.h"

BEGIN_VISP_NAMESPACE

//! A place where the gray level changes most, to a fraction of a pixel.
struct vpEdgePixel
{
  Eigen::Vector2d place;    //!< In the chart's image, pixels.
  Eigen::Vector2d gradient; //!< Unit, towards the brighter side.
  double contrast = 0.;     //!< Height of the step, gray levels.
};

/*!
  Edges of a chart after Canny: smoothed, and kept where the gradient is largest along itself. Written here because
  OpenCV's gives neither a sub-pixel place nor can it leave out what lies beside the surface.
*/
class vpEdgePixels
{
public:
  //! \param minContrast Of an edge pixel, gray levels.
  vpEdgePixels(const vpChartImage &image, double minContrast);

  const std::vector<vpEdgePixel> &pixels() const { return m_pixels; }
  //! Distance across the edge to where the gray level changes again, pixels, at most largest.
  double clearance(const vpEdgePixel &pixel, double largest) const;
  //! Indices of pixels() that follow one another, those of one chain in order along it.
  std::vector<std::vector<int>> chains() const;

private:
  void smooth(const vpChartImage &image);
  void differentiate();
  void findMaxima(double minContrast);
  double clearance(const vpEdgePixel &pixel, const Eigen::Vector2d &towards, double largest) const;
  //! Of the gray levels along a direction, between pixels.
  double slope(const Eigen::Vector2d &place, const Eigen::Vector2d &direction) const;
  int next(int from, const Eigen::Vector2d &towards, const std::vector<char> &taken) const;

  std::size_t index(int x, int y) const
  {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(m_width) + static_cast<std::size_t>(x);
  }

  int m_width;
  int m_height;
  std::vector<float> m_smooth;
  std::vector<char> m_inside; // Nothing but surface where the smoothing looked.
  std::vector<Eigen::Vector2f> m_gradient;
  std::vector<float> m_magnitude;
  std::vector<int> m_pixelAt; // Index into m_pixels, -1 for none.
  std::vector<vpEdgePixel> m_pixels;
};

END_VISP_NAMESPACE
#endif
