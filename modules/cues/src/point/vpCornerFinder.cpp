// SPDX-License-Identifier: GPL-2.0-or-later
#include "point/vpCornerFinder.h"
#include <visp3/se3/vpExactNumber.h>

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>

BEGIN_VISP_NAMESPACE

namespace {
class Grid
{
public:
  Grid(const cv::Size &size, double cell, std::vector<char> &occupied)
      : m_cell(static_cast<float>(cell)), m_columns(static_cast<int>(size.width / cell) + 1), m_occupied(occupied)
  {
    m_occupied.assign(static_cast<std::size_t>(m_columns * (static_cast<int>(size.height / cell) + 1)), 0);
  }
  char &at(const cv::Point2f &place)
  {
    const int column = static_cast<int>(place.x / m_cell);
    const int row = static_cast<int>(place.y / m_cell);
    return m_occupied[static_cast<std::size_t>(row * m_columns + column)];
  }

private:
  float m_cell;
  int m_columns;
  std::vector<char> &m_occupied;
};
} // namespace

void vpCornerFinder::find(const cv::Mat &pixels, cv::Mat &mask, const std::vector<cv::Point2f> &taken,
                          const vpPointCueSettings &settings, std::vector<cv::Point2f> &corners)
{
  corners.clear();
  const std::size_t most = static_cast<std::size_t>(settings.maxFeatures);
  const double surface = cv::countNonZero(mask);
  if (vpIsZero(surface) || taken.size() >= most) {
    return;
  }
  const double distance = std::max(settings.minDistance, 1.);
  for (const cv::Point2f &place : taken) {
    cv::circle(mask, cv::Point(cvRound(place.x), cvRound(place.y)), cvRound(distance), cv::Scalar(0), cv::FILLED);
  }
  const cv::Rect around = cv::boundingRect(mask);
  if (around.area() == 0) {
    return;
  }
  cv::goodFeaturesToTrack(pixels(around), m_candidates, 0, settings.quality, settings.minDistance, mask(around),
                          settings.blockSize, settings.useHarris, settings.harris);
  Grid grid(pixels.size(), std::max(distance, std::sqrt(surface / settings.maxFeatures)), m_occupied);
  for (const cv::Point2f &place : taken) {
    grid.at(place) = 1;
  }
  const std::size_t missing = most - taken.size();
  // Candidates come in the order of their strength; those of the first round are moved out of the second's way.
  auto rest = m_candidates.begin();
  for (cv::Point2f &candidate : m_candidates) {
    candidate += cv::Point2f(around.tl());
    char &occupied = grid.at(candidate);
    if (occupied == 0 && corners.size() < missing) {
      corners.push_back(candidate);
      occupied = 1;
    } else {
      *rest++ = candidate;
    }
  }
  for (auto candidate = m_candidates.begin(); candidate != rest && corners.size() < missing; ++candidate) {
    corners.push_back(*candidate);
  }
}

END_VISP_NAMESPACE
