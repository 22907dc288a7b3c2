// SPDX-License-Identifier: GPL-2.0-or-later
#include "generate/background.h"
#include "generate/printTexture.h"

#include <visp3/se3/vpPoseRandom.h>

#include <opencv2/imgproc.hpp>

#include <algorithm>

namespace bench {
namespace {
const int columns = 5; // Of posters.
const int rows = 4;

// Plaster, lit from one side.
cv::Mat drawPlaster(int width, int height, std::uint64_t seed)
{
  const cv::Mat grain = cloudTexture(width, height, 40, 4, seed, 51);
  const cv::Mat stains = cloudTexture(width, height, 4, 4, seed, 52);
  cv::Mat wall(height, width, CV_8UC3);
  for (int i = 0; i < height; ++i) {
    for (int j = 0; j < width; ++j) {
      const double light = 150. + 50. * j / width;
      const double tone =
          light + 60. * (double(stains.at<float>(i, j)) - 0.5) + 40. * (double(grain.at<float>(i, j)) - 0.5);
      wall.at<cv::Vec3b>(i, j) = cv::Vec3b(cv::saturate_cast<uchar>(0.85 * tone), cv::saturate_cast<uchar>(0.95 * tone),
                                           cv::saturate_cast<uchar>(tone));
    }
  }
  return wall;
}
} // namespace

cv::Mat drawWall(int width, int height, std::uint64_t seed)
{
  vpPoseRandom random(seed, {0x77616c6c});
  cv::Mat wall = drawPlaster(width, height, seed);
  const cv::Size cell(width / columns, height / rows);
  for (int k = 0; k < columns * rows; ++k) {
    const cv::Size size(static_cast<int>(cell.width * (0.5 + 0.4 * random.uniform())),
                        static_cast<int>(cell.height * (0.5 + 0.4 * random.uniform())));
    const cv::Point at(k % columns * cell.width + static_cast<int>(random.uniform() * (cell.width - size.width)),
                       k / columns * cell.height + static_cast<int>(random.uniform() * (cell.height - size.height)));
    const cv::Mat poster = printTexture(size.width, size.height, seed, 60 + static_cast<std::uint64_t>(k));
    poster.copyTo(wall(cv::Rect(at, size)));
  }
  return wall;
}

} // namespace bench
