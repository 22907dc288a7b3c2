// SPDX-License-Identifier: GPL-2.0-or-later
#include "point/vpFaceBorder.h"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <vector>

BEGIN_VISP_NAMESPACE

namespace {
// Up to this border, pixels, faces that have no room for it have no points.
const int widestSureBorder = 5;
} // namespace

void vpFaceBorder::takeOff(cv::Mat &mask, int border)
{
  const int sure = std::min(border, widestSureBorder);
  const int side = 2 * sure + 1;
  cv::erode(mask, mask, cv::Mat::ones(side, side, CV_8U), cv::Point(-1, -1), 1, cv::BORDER_CONSTANT, cv::Scalar(0));
  if (border == sure) {
    return;
  }
  cv::Mat framed, distances, labels;
  cv::copyMakeBorder(mask, framed, 1, 1, 1, 1, cv::BORDER_CONSTANT, cv::Scalar(0)); // What is outside is no face.
  cv::distanceTransform(framed, distances, cv::DIST_L2, 5, CV_32F);
  const int faces = cv::connectedComponents(framed, labels, 4, CV_32S);
  std::vector<float> deepest(static_cast<std::size_t>(faces), 0.F);
  for (int i = 0; i < framed.rows; ++i) {
    for (int j = 0; j < framed.cols; ++j) {
      float &most = deepest[static_cast<std::size_t>(labels.at<int>(i, j))];
      most = std::max(most, distances.at<float>(i, j));
    }
  }
  const float wanted = static_cast<float>(border - sure);
  for (int i = 0; i < mask.rows; ++i) {
    for (int j = 0; j < mask.cols; ++j) {
      const float most = deepest[static_cast<std::size_t>(labels.at<int>(i + 1, j + 1))];
      const float needed = most > wanted ? wanted : 0.F;
      if (distances.at<float>(i + 1, j + 1) <= needed) {
        mask.at<unsigned char>(i, j) = 0;
      }
    }
  }
}

END_VISP_NAMESPACE
