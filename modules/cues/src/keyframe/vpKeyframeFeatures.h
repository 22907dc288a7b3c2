// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpKeyframeFeatures_h
#define vpKeyframeFeatures_h

#include <visp3/cues/vpCueFrame.h>
#include <visp3/cues/vpImageRegion.h>

#include <opencv2/features2d.hpp>

#include <vector>

BEGIN_VISP_NAMESPACE

// Corners of a part of an image with their descriptors; those of the last frame are kept.
class vpKeyframeFeatures
{
public:
  // \param most Number of features wanted.
  void detect(const vpCueFrame &frame, const vpImageRegion &region, int most);
  const std::vector<cv::KeyPoint> &corners() const { return m_corners; } // In pixels of the whole image.
  const cv::Mat &descriptors() const { return m_descriptors; }           // A row each.

private:
  std::vector<cv::KeyPoint> m_corners;
  cv::Mat m_descriptors;
  cv::Ptr<cv::ORB> m_orb;
  unsigned long long m_frame = 0;
  vpImageRegion m_region;
  int m_most = 0;
};

END_VISP_NAMESPACE
#endif
