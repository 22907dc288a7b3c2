// SPDX-License-Identifier: GPL-2.0-or-later
#include <visp3/cues/vpColorOddsMap.h>

#include "color/vpPixelNumber.h"
#include "distance/vpMapBlocks.h"

#include <visp3/core/vpException.h>

#include <algorithm>
#include <cmath>

BEGIN_VISP_NAMESPACE

namespace {
// Steps of the histograms' colours: a table of them is small enough to stay in the fastest cache.
const std::uint32_t colors = 16 * 16 * 16;
const std::uint32_t grays = 64;

// Keys take the upper four bits of each channel, or six of a gray level, as the histograms do; in an order that costs
// little.
std::uint32_t keyOf(const vpRGBa &pixel)
{
  const std::uint32_t number = toPixelNumber(pixel);
  return ((number >> 4U) & 0x0FU) | ((number >> 8U) & 0xF0U) | ((number >> 12U) & 0xF00U);
}

std::uint32_t keyOf(unsigned char pixel)
{
  return pixel >> 2U;
}

std::uint32_t colorOf(std::uint32_t key)
{
  return ((key & 0x0FU) << 4U) | ((key & 0xF0U) << 8U) | ((key & 0xF00U) << 12U);
}

std::int8_t toSteps(float object)
{
  const float odds = std::log(object / (1.F - object));
  const float clamped = std::min(std::max(odds, -vpColorOddsMap::mostOdds), vpColorOddsMap::mostOdds);
  return static_cast<std::int8_t>(std::lround(clamped * vpColorOddsMap::stepsPerUnit));
}

// Nearest whole of a quarter, half upwards.
std::int8_t quarter(int sum)
{
  return static_cast<std::int8_t>((sum + 2) >> 2);
}

// Apart from the lookups, because this can be done for several pixels in one instruction.
template <typename Pixel> void findKeys(const Pixel *__restrict pixels, int count, std::uint32_t *__restrict keys)
{
  for (int k = 0; k < count; ++k) {
    keys[k] = keyOf(pixels[k]);
  }
}

// The last column and row of blocks may be cut off by the image: what is there counts double.
template <typename Pixel>
void fillMap(const vpImage<Pixel> &I, const vpMapBlocks &blocks, const std::int8_t *table, std::uint32_t *keys,
             std::int8_t *map)
{
  const vpImageRegion &region = blocks.region;
  const int whole = region.width / vpColorOddsMap::block;
  std::uint32_t *upper = keys;
  std::uint32_t *lower = keys + region.width;
  for (int y = 0; y < blocks.rows; ++y) {
    const int v = region.top + y * vpColorOddsMap::block;
    const int next = std::min(v + 1, region.top + region.height - 1);
    findKeys(I[static_cast<unsigned int>(v)] + region.left, region.width, upper);
    findKeys(I[static_cast<unsigned int>(next)] + region.left, region.width, lower);
    for (int x = 0; x < whole; ++x) {
      map[x] = quarter(table[upper[2 * x]] + table[upper[2 * x + 1]] + table[lower[2 * x]] + table[lower[2 * x + 1]]);
    }
    if (whole < blocks.columns) {
      map[whole] = quarter(2 * (table[upper[2 * whole]] + table[lower[2 * whole]]));
    }
    map += blocks.columns;
  }
}
} // namespace

void vpColorOddsMap::fillTable(const vpColorHistograms &histograms)
{
  const bool isGray = histograms.channels() == 1;
  m_table.resize(isGray ? grays : colors);
  for (std::uint32_t key = 0; key < m_table.size(); ++key) {
    m_table[key] = toSteps(histograms.object(isGray ? key << 2U : colorOf(key)));
  }
}

// Without a mask only what the lens did not see is hidden: that is beside the image, so it ends where the first visible
// pixel of a row begins. With a mask each pixel has to be asked for.
void vpColorOddsMap::clearMasked(const vpCueFrame &frame)
{
  const int columns = static_cast<int>(m_columns);
  const int rows = static_cast<int>(m_rows);
  const auto clearIfMasked = [&](int x, int y) {
    const double u = m_left + block * (x + 0.5);
    const double v = m_top + block * (y + 0.5);
    const bool isMasked = frame.isMasked(std::min(u, frame.width() - 1.), std::min(v, frame.height() - 1.));
    if (isMasked) {
      m_map[static_cast<std::size_t>(y) * m_stride + static_cast<std::size_t>(x)] = 0;
    }
    return isMasked;
  };
  const bool hasMask = frame.hasMask();
  for (int y = 0; y < rows; ++y) {
    int first = 0;
    while (first < columns && (clearIfMasked(first, y) || hasMask)) {
      ++first;
    }
    for (int x = columns - 1; x > first && clearIfMasked(x, y); --x) {
    }
  }
}

void vpColorOddsMap::compute(const vpCueFrame &frame, const vpColorHistograms &histograms, const vpImageRegion &roi)
{
  const bool isGray = histograms.channels() == 1;
  if (!isGray && !frame.hasColor()) {
    throw vpException(vpException::badValue,
                      "The histograms are of colours and the frame is gray: give histograms of one channel");
  }
  const vpMapBlocks blocks(roi, block, frame.width(), frame.height());
  m_left = blocks.region.left - 0.5;
  m_top = blocks.region.top - 0.5;
  m_columns = blocks.columns;
  m_rows = blocks.rows;
  m_stride = static_cast<std::size_t>(blocks.columns);
  m_map.resize(m_stride * static_cast<std::size_t>(blocks.rows));
  m_keys.resize(2 * static_cast<std::size_t>(blocks.region.width));
  fillTable(histograms);
  if (isGray) {
    fillMap(frame.gray(), blocks, m_table.data(), m_keys.data(), m_map.data());
  } else {
    fillMap(frame.color(), blocks, m_table.data(), m_keys.data(), m_map.data());
  }
  clearMasked(frame);
}

void vpColorOddsMap::draw(vpImage<unsigned char> &I) const
{
  I.resize(height(), width());
  for (unsigned int k = 0; k < I.getSize(); ++k) {
    I.bitmap[k] = static_cast<unsigned char>(128 + m_map[k] * 127 / (stepsPerUnit * static_cast<int>(mostOdds)));
  }
}

END_VISP_NAMESPACE
