// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpContourBars_h
#define vpContourBars_h

#include <visp3/se3/vpCompatibility.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

BEGIN_VISP_NAMESPACE

/*!
  The silhouette as short straight bars, one for each line's point: what a line meets of it is where the object begins
  again (outwards) or ends (inwards).

  All lines are tried with all bars, several bars at once: for some hundred of them that takes less time than to sort
  them by place.
*/
class vpContourBars
{
public:
  //! \param memory Scratch.
  explicit vpContourBars(std::vector<float> &memory) : m_memory(memory) { m_memory.clear(); }

  //! \param half Half of the bar's length, pixels.
  void add(const Eigen::Vector2d &centre, const Eigen::Vector2d &normal, double half)
  {
    const std::size_t lane = m_count % lanes;
    if (lane == 0) {
      m_memory.resize(m_memory.size() + sizeof(Block) / sizeof(float), -1.F); // Bars of negative length are never met.
    }
    ++m_count;
    float *block = m_memory.data() + m_memory.size() - sizeof(Block) / sizeof(float) + lane;
    const std::array<double, 5> values = {{centre.x(), centre.y(), -normal.y(), normal.x(), half}};
    for (std::size_t i = 0; i < values.size(); ++i) {
      block[i * lanes] = static_cast<float>(values[i]);
    }
  }

  //! Offsets of the first bars that a line meets on both sides of its own, at most \e reach pixels away.
  struct Gap
  {
    float behind = 0.F;
    float ahead = 0.F;
  };
  Gap around(const Eigen::Vector2d &point, const Eigen::Vector2d &normal, float reach) const
  {
    Lanes ahead;
    Lanes behind;
    ahead.fill(reach);
    behind.fill(-reach);
    const float x = static_cast<float>(point.x());
    const float y = static_cast<float>(point.y());
    const float nx = static_cast<float>(normal.x());
    const float ny = static_cast<float>(normal.y());
    for (std::size_t at = 0; at < m_memory.size(); at += sizeof(Block) / sizeof(float)) {
      const float *bars = m_memory.data() + at;
      for (std::size_t i = 0; i < lanes; ++i) {
        // point + t normal = centre + r tangent
        const float dx = bars[i] - x;
        const float dy = bars[lanes + i] - y;
        const float tx = bars[2 * lanes + i];
        const float ty = bars[3 * lanes + i];
        const float cross = nx * ty - ny * tx;
        const float t = (dx * ty - dy * tx) / cross;
        const bool isMet = std::fabs(nx * dy - ny * dx) <= bars[4 * lanes + i] * std::fabs(cross);
        ahead[i] = isMet & (t > nearest) & (t < ahead[i]) ? t : ahead[i];
        behind[i] = isMet & (t < -nearest) & (t > behind[i]) ? t : behind[i];
      }
    }
    return {*std::max_element(behind.begin(), behind.end()), *std::min_element(ahead.begin(), ahead.end())};
  }

private:
  static constexpr std::size_t lanes = 8;
  // A line's own bar, and those beside it on a bent contour, are this close.
  static constexpr float nearest = 1.5F;
  using Lanes = std::array<float, lanes>;
  using Block = std::array<Lanes, 5>; // Centre, tangent, half length.

  std::vector<float> &m_memory;
  std::size_t m_count = 0;
};

END_VISP_NAMESPACE
#endif
