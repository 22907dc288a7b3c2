// SPDX-License-Identifier: GPL-2.0-or-later
#include "keyframe/vpKeyframeFeatures.h"

#include <opencv2/core.hpp>

BEGIN_VISP_NAMESPACE

namespace {
// Smaller than ORB's usual 31: less of what is behind the object gets into the descriptors.
const int patch = 21; // Pixels.
const float levelScale = 1.2F;
const int levels = 5;
const int leastContrast = 6; // Gray levels.

// Made of pixels that are the same from frame to frame: what masks hide changes the descriptors all around.
cv::Mat visibleIn(const vpCueFrame &frame, const cv::Rect &area)
{
  if (!frame.hasMask()) {
    return cv::Mat();
  }
  cv::Mat visible(area.size(), CV_8U);
  for (int i = 0; i < area.height; ++i) {
    for (int j = 0; j < area.width; ++j) {
      visible.at<unsigned char>(i, j) = frame.isMasked(area.x + j, area.y + i) ? 0 : 255;
    }
  }
  return visible;
}
} // namespace

void vpKeyframeFeatures::detect(const vpCueFrame &frame, const vpImageRegion &region, int most)
{
  const vpImageRegion inside = region.clipped(frame.width(), frame.height());
  if (m_frame == frame.number() && m_most == most && m_region.left == inside.left && m_region.top == inside.top &&
      m_region.width == inside.width && m_region.height == inside.height) {
    return;
  }
  m_frame = frame.number();
  m_region = inside;
  m_most = most;
  m_corners.clear();
  m_descriptors = cv::Mat();
  if (inside.width <= 2 * patch || inside.height <= 2 * patch) {
    return;
  }
  if (m_orb.empty()) {
    m_orb = cv::ORB::create(most, levelScale, levels, patch / 2, 0, 2, cv::ORB::HARRIS_SCORE, patch, leastContrast);
  }
  m_orb->setMaxFeatures(most);
  const vpImage<unsigned char> &I = frame.gray();
  const cv::Mat whole(static_cast<int>(I.getHeight()), static_cast<int>(I.getWidth()), CV_8U, I.bitmap);
  const cv::Rect area(inside.left, inside.top, inside.width, inside.height);
  m_orb->detectAndCompute(whole(area), visibleIn(frame, area), m_corners, m_descriptors);
  for (cv::KeyPoint &corner : m_corners) {
    corner.pt += cv::Point2f(static_cast<float>(area.x), static_cast<float>(area.y));
  }
}

END_VISP_NAMESPACE
