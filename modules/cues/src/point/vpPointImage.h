// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpPointImage_h
#define vpPointImage_h

#include <visp3/core/vpImage.h>
#include <visp3/se3/vpCompatibility.h>

#include <Eigen/Core>
#include <opencv2/core.hpp>

#include <vector>

BEGIN_VISP_NAMESPACE

/*!
  The part of an image that the object is in, as a pyramid with gradients for KLT: made once for each frame, and kept as
  the frame to start from. Owns its pixels.
*/
class vpPointImage
{
public:
  bool isEmpty() const { return m_levels.empty(); }
  void clear() { m_levels.clear(); }

  //! \param area Of the image, inside it. \param window Side of KLT's window. \param levels Above the image itself.
  void build(const vpImage<unsigned char> &I, const cv::Rect &area, int window, int levels);
  //! Shows another area of the same image; where that was not known, the border goes on. KLT wants two images of one
  //! size.
  void move(const cv::Rect &area, int window, int levels);

  const cv::Rect &area() const { return m_area; }
  //! The area's pixels.
  const cv::Mat &pixels() const { return m_levels[0]; }
  //! Pixels and gradients of all levels, as cv::buildOpticalFlowPyramid() makes them.
  const std::vector<cv::Mat> &levels() const { return m_levels; }

  //! A place of the image in the area's coordinates.
  cv::Point2f inArea(const Eigen::Vector2d &pixel) const
  {
    return {static_cast<float>(pixel.x() - m_area.x), static_cast<float>(pixel.y() - m_area.y)};
  }
  Eigen::Vector2d inImage(const cv::Point2f &place) const
  {
    return {static_cast<double>(place.x) + m_area.x, static_cast<double>(place.y) + m_area.y};
  }
  //! True where \e margin pixels around the place are inside.
  bool contains(const Eigen::Vector2d &pixel, double margin) const
  {
    return pixel.x() >= m_area.x + margin && pixel.y() >= m_area.y + margin &&
           pixel.x() <= m_area.x + m_area.width - 1 - margin && pixel.y() <= m_area.y + m_area.height - 1 - margin;
  }

private:
  cv::Rect m_area;
  std::vector<cv::Mat> m_levels;
};

END_VISP_NAMESPACE
#endif
