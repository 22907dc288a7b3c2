// SPDX-License-Identifier: GPL-2.0-or-later
#include "point/vpPointImage.h"

#include <opencv2/video/tracking.hpp>

BEGIN_VISP_NAMESPACE

namespace {
// Copies the pixels: the image that they come from may be gone when the next frame arrives.
void buildPyramid(const cv::Mat &pixels, int window, int levels, std::vector<cv::Mat> &pyramid)
{
  cv::buildOpticalFlowPyramid(pixels, pyramid, cv::Size(window, window), levels, true, cv::BORDER_REFLECT_101,
                              cv::BORDER_CONSTANT, false);
}
} // namespace

void vpPointImage::build(const vpImage<unsigned char> &I, const cv::Rect &area, int window, int levels)
{
  // OpenCV has no matrix of constant data; nothing writes to this one.
  const cv::Mat image(static_cast<int>(I.getHeight()), static_cast<int>(I.getWidth()), CV_8U,
                      const_cast<unsigned char *>(I.bitmap));
  buildPyramid(image(area), window, levels, m_levels);
  m_area = area;
}

void vpPointImage::move(const cv::Rect &area, int window, int levels)
{
  cv::Rect known = area & m_area;
  if (known.area() == 0) {
    clear();
    return;
  }
  cv::Mat moved;
  cv::copyMakeBorder(pixels()(known - m_area.tl()), moved, known.y - area.y, area.br().y - known.br().y,
                     known.x - area.x, area.br().x - known.br().x, cv::BORDER_REPLICATE | cv::BORDER_ISOLATED);
  buildPyramid(moved, window, levels, m_levels);
  m_area = area;
}

END_VISP_NAMESPACE
