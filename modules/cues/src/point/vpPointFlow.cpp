// SPDX-License-Identifier: GPL-2.0-or-later
#include "point/vpPointFlow.h"

#include <opencv2/video/tracking.hpp>

#include <algorithm>
#include <cmath>

BEGIN_VISP_NAMESPACE

namespace {
// Farther from where it started than this, a point has followed something else on its way.
const float farthestReturn = 0.7F; // Pixels.
// A level of the pyramid doubles how far a point may have to go back. Points that went this many times as far as the
// middle one have most likely gone wrong.
const float reachOfOneLevel = 2.F; // Pixels.
const float farPoint = 4.F;
// As in ViSP's vpKltOpencv.
const double leastEigenvalue = 1e-4;
const cv::TermCriteria criteria(cv::TermCriteria::COUNT | cv::TermCriteria::EPS, 20, 0.03);
} // namespace

void vpPointFlow::clear()
{
  m_from.clear();
  m_seed.clear();
}

void vpPointFlow::add(const cv::Point2f &from, const cv::Point2f &seed)
{
  m_from.push_back(from);
  m_seed.push_back(seed);
}

int vpPointFlow::levelsBack()
{
  m_sorted.clear();
  for (std::size_t i = 0; i < m_to.size(); ++i) {
    if (isFound(i)) {
      m_sorted.push_back(std::hypot(m_to[i].x - m_seed[i].x, m_to[i].y - m_seed[i].y));
    }
  }
  if (m_sorted.empty()) {
    return 0;
  }
  const auto middle = m_sorted.begin() + static_cast<std::ptrdiff_t>(m_sorted.size() / 2);
  std::nth_element(m_sorted.begin(), middle, m_sorted.end());
  int levels = 1;
  for (float reach = reachOfOneLevel; reach < farPoint * *middle; reach *= 2.F) {
    ++levels;
  }
  return levels;
}

void vpPointFlow::run(const vpPointImage &first, const vpPointImage &second, const vpPointCueSettings &settings)
{
  m_to = m_seed;
  m_back = m_from;
  m_found.assign(m_from.size(), 0);
  m_foundBack.assign(m_from.size(), 0);
  if (m_from.empty() || first.isEmpty() || second.isEmpty()) {
    return;
  }
  const cv::Size window(settings.windowSize, settings.windowSize);
  const auto follow = [&](const vpPointImage &a, const vpPointImage &b, const std::vector<cv::Point2f> &from,
                          std::vector<cv::Point2f> &to, std::vector<unsigned char> &found, int levels) {
    cv::calcOpticalFlowPyrLK(a.levels(), b.levels(), from, to, found, m_error, window, levels, criteria,
                             cv::OPTFLOW_USE_INITIAL_FLOW, leastEigenvalue);
  };
  follow(first, second, m_from, m_to, m_found, settings.pyramidLevels);
  // As far from the answer as the way there began: a start at the answer itself would prove little.
  for (std::size_t i = 0; i < m_from.size(); ++i) {
    m_back[i] = m_to[i] - (m_seed[i] - m_from[i]);
  }
  follow(second, first, m_to, m_back, m_foundBack, std::min(levelsBack(), settings.pyramidLevels));
  for (std::size_t i = 0; i < m_from.size(); ++i) {
    const cv::Point2f off = m_back[i] - m_from[i];
    m_found[i] = m_found[i] != 0 && m_foundBack[i] != 0 && std::hypot(off.x, off.y) < farthestReturn;
  }
}

cv::Point2f vpPointFlow::medianCorrection()
{
  const auto median = [this](float cv::Point2f::*axis) {
    m_sorted.clear();
    for (std::size_t i = 0; i < m_to.size(); ++i) {
      if (isFound(i)) {
        m_sorted.push_back(m_to[i].*axis - m_seed[i].*axis);
      }
    }
    if (m_sorted.empty()) {
      return 0.F;
    }
    const auto middle = m_sorted.begin() + static_cast<std::ptrdiff_t>(m_sorted.size() / 2);
    std::nth_element(m_sorted.begin(), middle, m_sorted.end());
    return *middle;
  };
  return {median(&cv::Point2f::x), median(&cv::Point2f::y)};
}

END_VISP_NAMESPACE
