// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpSurfaceReader_h
#define vpSurfaceReader_h

#include "point/vpPointCamera.h"

#include <visp3/model/vpModelRenderer.h>

#include <opencv2/core.hpp>

BEGIN_VISP_NAMESPACE

//! A small piece of the surface around a point.
struct vpSurfaceElement
{
  Eigen::Vector3d position;           //!< Object frame, metres.
  Eigen::Vector3d normal;             //!< Unit length, object frame, towards the camera that saw it.
  Eigen::Matrix<double, 3, 2> across; //!< How far the surface goes in one pixel to the right and down, object frame.

  //! True where the camera sees the side that the normal points to, and not too flat. \param cX position there.
  bool isFacing(const vpPointCamera &camera, const Eigen::Vector3d &cX) const
  {
    const double leastCosine = 0.2; // 78 degrees: beyond, a pixel of the patch is five of the surface.
    return -cX.dot(camera.cRo * normal) > leastCosine * cX.norm();
  }
};

/*!
  Reads surfaces off a depth buffer. In the image the inverse depth of a plane is a linear function, so steps and
  creases are where its second differences are not 0.
*/
class vpSurfaceReader
{
public:
  explicit vpSurfaceReader(const vpRenderedView &view) : m_view(view) {}

  //! \param camera That the depth was drawn with. \return False where the surface is not smooth around the pixel.
  bool read(const vpPointCamera &camera, const Eigen::Vector2d &pixel, vpSurfaceElement &element) const;

  //! True where the surface at the pixel and around it is nearer than a point at that depth, metres.
  bool hides(const Eigen::Vector2d &pixel, double depth) const;

  //! 255 where the surface is smooth, else 0. \param area Of the image.
  void markSmooth(const cv::Rect &area, cv::Mat &mask) const;

private:
  float depth(int column, int row) const
  {
    return m_view.depth[static_cast<std::size_t>(row) * static_cast<std::size_t>(m_view.width) +
                        static_cast<std::size_t>(column)];
  }
  bool isSmooth(int column, int row, int step) const;

  const vpRenderedView &m_view;
};

END_VISP_NAMESPACE
#endif
