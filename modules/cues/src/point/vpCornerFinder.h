// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpCornerFinder_h
#define vpCornerFinder_h

#include <visp3/cues/vpPointCue.h>

#include <opencv2/core.hpp>

BEGIN_VISP_NAMESPACE

/*!
  Chooses the strongest corners, spread over the surface: first the best of every cell of a grid in which there is no
  point yet, then the best of all. Cells are as large as it takes for one point in each.
*/
class vpCornerFinder
{
public:
  /*!
    \param pixels Image to look in. \param mask 255 where a corner may be; changed.
    \param taken Places of the points that there are.
    \param corners Result: as many as are missing to vpPointCueSettings::maxFeatures, or less.
  */
  void find(const cv::Mat &pixels, cv::Mat &mask, const std::vector<cv::Point2f> &taken,
            const vpPointCueSettings &settings, std::vector<cv::Point2f> &corners);

private:
  std::vector<cv::Point2f> m_candidates;
  std::vector<char> m_occupied;
};

END_VISP_NAMESPACE
#endif
