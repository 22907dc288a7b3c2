// SPDX-License-Identifier: GPL-2.0-or-later
#include "generate/background.h"
#include "generate/printTexture.h"

#include <visp3/se3/vpPoseRandom.h>

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>

namespace bench {
namespace {
void drawStars(cv::Mat &image, vpPoseRandom &random)
{
  const int count = image.rows * image.cols / 900;
  for (int i = 0; i < count; ++i) {
    const cv::Point2d at(random.uniform() * image.cols, random.uniform() * image.rows);
    const double brightness = 40. + 210. * std::pow(random.uniform(), 4);
    const int shift = 4;
    cv::circle(image, cv::Point(static_cast<int>(at.x * 16), static_cast<int>(at.y * 16)),
               static_cast<int>((0.4 + 0.5 * random.uniform()) * 16), cv::Scalar::all(brightness), cv::FILLED,
               cv::LINE_AA, shift);
  }
}
} // namespace

cv::Mat drawSpace(int width, int height, std::uint64_t seed)
{
  vpPoseRandom random(seed, {0x7370616365});
  cv::Mat image(height, width, CV_8UC3, cv::Scalar(4, 3, 3));
  drawStars(image, random);
  const cv::Mat clouds = cloudTexture(width, height, 6, 6, seed, 11);
  const cv::Mat land = cloudTexture(width, height, 3, 5, seed, 12);
  // The globe reaches into the picture from a side of its lower edge.
  const double radius = 1.1 * width;
  const cv::Point2d centre(width * (0.15 + 0.7 * random.uniform()), height * 0.55 + radius);
  for (int i = 0; i < height; ++i) {
    for (int j = 0; j < width; ++j) {
      const double distance = std::hypot(j - centre.x, i - centre.y);
      const double glow = std::exp(-std::abs(distance - radius) / 14.);
      const cv::Vec3d air(230., 160., 90.);
      cv::Vec3d color = image.at<cv::Vec3b>(i, j);
      if (distance < radius) {
        const double cover = std::clamp(3.2 * double(clouds.at<float>(i, j)) - 1.25, 0., 1.);
        const bool dry = land.at<float>(i, j) > 0.56F;
        const cv::Vec3d ground = dry ? cv::Vec3d(55., 95., 95.) : cv::Vec3d(110., 60., 22.);
        color = ground * (1. - cover) + cv::Vec3d(228., 224., 220.) * cover;
        const double inside = (radius - distance) / radius;
        color *= std::clamp(0.35 + 3. * inside, 0., 0.85);
      }
      color += 0.5 * glow * air;
      for (int k = 0; k < 3; ++k) {
        image.at<cv::Vec3b>(i, j)[k] = cv::saturate_cast<uchar>(color[k]);
      }
    }
  }
  return image;
}

} // namespace bench
