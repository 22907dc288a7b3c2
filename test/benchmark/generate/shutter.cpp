// SPDX-License-Identifier: GPL-2.0-or-later
#include "generate/shutter.h"

#include <algorithm>

namespace bench {
namespace {
// For a row that sees a third of them and 10 pixels of motion a frame, they are less than a pixel apart.
const int instants = 16;
// In place of none at all, frames.
const double leastExposure = 1e-3;
} // namespace

cv::Mat expose(const Shutter &shutter, const std::function<cv::Mat(double, int)> &imageAt)
{
  // Each instant stands for the interval about it, and counts for a row by their overlap: with a row's number, weights
  // change without steps.
  const double wanted = std::max(shutter.exposure, leastExposure);
  const double interval = (wanted + shutter.readout) / instants;
  const double exposure = std::max(wanted, interval);
  cv::Mat sum;
  cv::Mat weights;
  for (int k = 0; k < instants; ++k) {
    const double time = interval * (k + 0.5 - 0.5 * instants);
    const cv::Mat image = imageAt(time, k);
    if (sum.empty()) {
      sum = cv::Mat::zeros(image.size(), image.type());
      weights = cv::Mat::zeros(image.rows, 1, CV_64F);
    }
    for (int i = 0; i < image.rows; ++i) {
      const double middle = shutter.timeOfRow(i, image.rows);
      const double overlap = std::min(time + 0.5 * interval, middle + 0.5 * exposure) -
                             std::max(time - 0.5 * interval, middle - 0.5 * exposure);
      if (overlap > 0.) {
        sum.row(i) += overlap * image.row(i);
        weights.at<double>(i) += overlap;
      }
    }
  }
  for (int i = 0; i < sum.rows; ++i) {
    sum.row(i) /= weights.at<double>(i);
  }
  return sum;
}

} // namespace bench
