// SPDX-License-Identifier: GPL-2.0-or-later
#include <visp3/cues/vpColorHistograms.h>

#include <algorithm>
#include <numeric>

BEGIN_VISP_NAMESPACE

namespace {
const std::size_t colorBins = 16 * 16 * 16;
const std::size_t grayBins = 64;
// Share of all pixels that a colour which was hardly ever seen may still turn out to have: it then says little.
const float rare = 1e-4F;
} // namespace

void vpColorHistograms::reset(unsigned int channels)
{
  m_channels = channels;
  m_isKnown = false;
  const std::size_t bins = channels == 1 ? grayBins : colorBins;
  for (const Side side : {OBJECT, BACKGROUND}) {
    m_counts[side].assign(bins, 0);
    m_frequency[side].assign(bins, 0.F);
  }
  m_object.assign(bins, 0.5F);
}

void vpColorHistograms::learn(double rate)
{
  const float share = m_isKnown ? static_cast<float>(rate) : 1.F;
  for (const Side side : {OBJECT, BACKGROUND}) {
    const std::uint32_t total = std::accumulate(m_counts[side].begin(), m_counts[side].end(), std::uint32_t{0});
    if (total == 0) {
      continue;
    }
    const float scale = share / static_cast<float>(total);
    for (std::size_t i = 0; i < m_object.size(); ++i) {
      m_frequency[side][i] = (1.F - share) * m_frequency[side][i] + scale * static_cast<float>(m_counts[side][i]);
    }
    std::fill(m_counts[side].begin(), m_counts[side].end(), 0U);
    m_isKnown = true;
  }
  for (std::size_t i = 0; i < m_object.size(); ++i) {
    const float object = m_frequency[OBJECT][i] + rare;
    const float background = m_frequency[BACKGROUND][i] + rare;
    m_object[i] = object / (object + background);
  }
}

END_VISP_NAMESPACE
