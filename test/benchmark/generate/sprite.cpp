// SPDX-License-Identifier: GPL-2.0-or-later
#include "generate/sprite.h"

#include <opencv2/imgproc.hpp>

#include <algorithm>

namespace bench {

void Sprite::draw(const cv::Matx23d &map, cv::Mat &image, cv::Mat &hidden) const
{
  cv::Mat seenColor;
  cv::Mat seenAlpha;
  cv::warpAffine(color, seenColor, map, image.size(), cv::INTER_LINEAR, cv::BORDER_REPLICATE);
  cv::warpAffine(alpha, seenAlpha, map, image.size(), cv::INTER_LINEAR, cv::BORDER_CONSTANT);
  for (int i = 0; i < image.rows; ++i) {
    for (int j = 0; j < image.cols; ++j) {
      const float a = seenAlpha.at<float>(i, j);
      if (a > 0.F) {
        const cv::Vec3f own = seenColor.at<cv::Vec3b>(i, j);
        cv::Vec3f &pixel = image.at<cv::Vec3f>(i, j);
        pixel = (1.F - a) * pixel + a * own;
        hidden.at<float>(i, j) = std::max(hidden.at<float>(i, j), a);
      }
    }
  }
}

} // namespace bench
