// SPDX-License-Identifier: GPL-2.0-or-later
#include "drawing/modelDrawing.h"

#include <visp3/me/vpMeSite.h>

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>

namespace programs {
namespace {
const cv::Scalar white(255, 255, 255), black(0, 0, 0), refused(60, 60, 255);
const int lineHeight = 18; // Pixels, of the text.
// Ellipses are drawn as so many degrees a step.
const int degreesPerStep = 5;

// From a row and a column to OpenCV's x and y.
cv::Point pixel(double i, double j)
{
  return cv::Point(cvRound(j), cvRound(i));
}
} // namespace

cv::Scalar colorOf(vpTrackingState state)
{
  switch (state) {
  case vpTrackingState::TRACKING:
    return {80, 220, 80};
  case vpTrackingState::UNCERTAIN:
    return {0, 160, 255};
  default:
    return {60, 60, 255};
  }
}

void drawModelLine(cv::Mat &image, const std::vector<double> &line, const cv::Scalar &color, int thickness)
{
  if (line.size() == 5) {
    cv::line(image, pixel(line[1], line[2]), pixel(line[3], line[4]), color, thickness, cv::LINE_AA);
    return;
  }
  if (line.size() < 6) {
    return;
  }
  // ViSP's circles: centre, then the three normalised moments of their ellipse.
  const double n20 = line[3], n11 = line[4], n02 = line[5];
  const double root = std::sqrt((n20 - n02) * (n20 - n02) + 4. * n11 * n11);
  const cv::Size axes(cvRound(std::sqrt(2. * (n20 + n02 + root))),
                      cvRound(std::sqrt(2. * std::max(0., n20 + n02 - root))));
  const double angle = 0.5 * std::atan2(2. * n11, n20 - n02);
  std::vector<cv::Point> outline;
  cv::ellipse2Poly(pixel(line[1], line[2]), axes, cvRound(angle * 180. / CV_PI), 0, 360, degreesPerStep, outline);
  cv::polylines(image, outline, true, color, thickness, cv::LINE_AA);
}

void drawFeatures(cv::Mat &image, const std::vector<std::vector<double>> &features)
{
  // Each is its kind, row, column and, but for points, state.
  for (const std::vector<double> &feature : features) {
    const bool isPoint = feature[0] > 0.;
    const bool isUsed = isPoint || static_cast<int>(feature[3]) == vpMeSite::NO_SUPPRESSION;
    cv::circle(image, pixel(feature[1], feature[2]), 1, isUsed ? white : refused, cv::FILLED);
  }
}

void drawText(cv::Mat &image, const std::vector<std::string> &lines, const cv::Point &at, const cv::Scalar &color)
{
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const cv::Point origin = at + cv::Point(0, static_cast<int>(i) * lineHeight);
    cv::putText(image, lines[i], origin, cv::FONT_HERSHEY_SIMPLEX, 0.45, black, 3, cv::LINE_AA);
    cv::putText(image, lines[i], origin, cv::FONT_HERSHEY_SIMPLEX, 0.45, color, 1, cv::LINE_AA);
  }
}

} // namespace programs
