// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpContourBars_h
#define vpContourBars_h

#include <visp3/cues/vpColorCue.h>

#include <algorithm>
#include <cmath>

BEGIN_VISP_NAMESPACE

/*!
  The silhouette as short straight bars, one for each line's point: what a line meets of it is where the object begins
  again (outwards) or ends (inwards).

  Neighbours on a contour are in one block of several, which are tried at once, and most blocks are seen to be out of
  the way before that.
*/
class vpContourBars
{
  using Block = vpColorCue::BarBlock;
  using Lanes = Block::Lanes;

public:
  //! \param cue Whose scratch memory is used.
  explicit vpContourBars(vpColorCue &cue) : m_blocks(cue.m_bars) { m_blocks.clear(); }

  //! \param half Half of the bar's length, pixels.
  void add(const Eigen::Vector2d &centre, const Eigen::Vector2d &normal, double half)
  {
    if (m_blocks.empty() || m_blocks.back().count == lanes) {
      m_blocks.emplace_back();
      m_blocks.back().half.fill(-1.F); // Bars of negative length are never met.
    }
    Block &block = m_blocks.back();
    const std::size_t lane = block.count++;
    block.x[lane] = static_cast<float>(centre.x());
    block.y[lane] = static_cast<float>(centre.y());
    block.tangentX[lane] = static_cast<float>(-normal.y());
    block.tangentY[lane] = static_cast<float>(normal.x());
    block.half[lane] = static_cast<float>(half);
  }

  //! To be called once all bars are there.
  void enclose()
  {
    for (Block &block : m_blocks) {
      block.middleX = 0.5F * (block.x[0] + block.x[block.count - 1]);
      block.middleY = 0.5F * (block.y[0] + block.y[block.count - 1]);
      block.radius = 0.F;
      for (std::size_t i = 0; i < block.count; ++i) {
        const float away = std::hypot(block.x[i] - block.middleX, block.y[i] - block.middleY);
        block.radius = std::max(block.radius, away + block.half[i]);
      }
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
    for (const Block &block : m_blocks) {
      const float dx = block.middleX - x;
      const float dy = block.middleY - y;
      const float along = std::fabs(dx * nx + dy * ny);
      const float beside = std::fabs(nx * dy - ny * dx);
      if (beside <= block.radius && along <= reach + block.radius) {
        meet(block, {x, y, nx, ny}, behind, ahead);
      }
    }
    return {*std::max_element(behind.begin(), behind.end()), *std::min_element(ahead.begin(), ahead.end())};
  }

private:
  static constexpr std::size_t lanes = Block::lanes;
  // A line's own bar, and those beside it on a bent contour, are this close.
  static constexpr float nearest = 1.5F;
  struct Ray
  {
    float x, y, nx, ny;
  };

  static void meet(const Block &block, const Ray &ray, Lanes &behind, Lanes &ahead)
  {
    for (std::size_t i = 0; i < lanes; ++i) {
      // ray + t normal = centre + r tangent
      const float dx = block.x[i] - ray.x;
      const float dy = block.y[i] - ray.y;
      const float cross = ray.nx * block.tangentY[i] - ray.ny * block.tangentX[i];
      const float t = (dx * block.tangentY[i] - dy * block.tangentX[i]) / cross;
      const bool isMet = std::fabs(ray.nx * dy - ray.ny * dx) <= block.half[i] * std::fabs(cross);
      ahead[i] = isMet && t > nearest && t < ahead[i] ? t : ahead[i];
      behind[i] = isMet && t < -nearest && t > behind[i] ? t : behind[i];
    }
  }

  std::vector<Block> &m_blocks;
};

END_VISP_NAMESPACE
#endif
