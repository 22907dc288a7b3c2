// SPDX-License-Identifier: GPL-2.0-or-later
#include "distance/vpMapEdges.h"

#include <numeric>

BEGIN_VISP_NAMESPACE

namespace {
// Pixels of which the noise is estimated; more of them do not change the estimate.
const int mostSamples = 4000;
// Of the samples, those with the least response: what the image shows makes the others greater.
const double quietShare = 0.3;
const double quietDeviations = 0.38532; // What that share of a normal distribution is within, standard deviations.
// Standard deviations that noise of deviation 1 in the reduced image has behind the mask, and in the gradient: the
// roots of the sums of the squared weights.
const double maskGain = 6.;
const double gradientGain = 6.6144;

// Both pixels of each block of four from one row, which compilers turn into vector instructions.
void reducePairs(const unsigned char *upper, const unsigned char *lower, int count, std::int16_t *to)
{
  for (int x = 0; x < count; ++x) {
    to[x] = static_cast<std::int16_t>(upper[2 * x] + upper[2 * x + 1] + lower[2 * x] + lower[2 * x + 1]);
  }
}

// Apart, and with pointers that are parameters, so that compilers turn them into vector instructions.
void differentiateLine(const std::int16_t *__restrict sum, const std::int16_t *__restrict difference, int count,
                       std::int16_t *__restrict gradientU, std::int16_t *__restrict gradientV)
{
  for (int x = 0; x < count; ++x) {
    gradientU[x] = static_cast<std::int16_t>(sum[x + 1] - sum[x - 1]);
    gradientV[x] = static_cast<std::int16_t>(difference[x - 1] + 2 * difference[x] + difference[x + 1]);
  }
}

void squareLine(const std::int16_t *__restrict gradientU, const std::int16_t *__restrict gradientV, int count,
                std::int32_t *__restrict square)
{
  for (int x = 0; x < count; ++x) {
    square[x] = gradientU[x] * gradientU[x] + gradientV[x] * gradientV[x];
  }
}

// Keeps the squares that are maxima among their neighbours along the gradient's greater component, and makes the others
// 0. Without branches, for in a textured image these would go either way.
void keepMaxima(const std::int32_t *__restrict squares, std::ptrdiff_t stride, const std::int16_t *__restrict gradientU,
                const std::int16_t *__restrict gradientV, int count, std::int32_t *__restrict maxima)
{
  for (int x = 0; x < count; ++x) {
    const std::int32_t u = gradientU[x] * gradientU[x];
    const std::int32_t v = gradientV[x] * gradientV[x];
    const std::int32_t left = squares[x - 1];
    const std::int32_t right = squares[x + 1];
    const std::int32_t above = squares[x - stride];
    const std::int32_t below = squares[x + stride];
    const std::int32_t before = u >= v ? left : above;
    const std::int32_t behind = u >= v ? right : below;
    const std::int32_t most = std::max(before + 1, behind); // Of two that are equal the first counts.
    maxima[x] = squares[x] >= most ? squares[x] : 0;
  }
}

// The average of a block that the image may cut off.
std::int16_t reduceBlock(const vpImage<unsigned char> &I, int u, int v, int block)
{
  const int right = std::min(u + block, static_cast<int>(I.getWidth()));
  const int bottom = std::min(v + block, static_cast<int>(I.getHeight()));
  int sum = 0;
  for (int i = v; i < bottom; ++i) {
    const unsigned char *row = I[static_cast<unsigned int>(i)];
    for (int j = u; j < right; ++j) {
      sum += row[j];
    }
  }
  return static_cast<std::int16_t>(4 * sum / ((right - u) * (bottom - v)));
}

// So that a line's ends are as the pixels beside them.
void repeatEnds(std::vector<std::int16_t> &line, int count)
{
  const std::size_t n = static_cast<std::size_t>(count);
  line[0] = line[1];
  line[n + 1] = line[n];
}
} // namespace

void vpMapEdges::reduce(const vpImage<unsigned char> &I, const vpImageRegion &roi, int block)
{
  // How many blocks of two by two are whole: those are the usual ones.
  const int pairs = block == 2 ? roi.width / 2 : 0;
  for (int y = 0; y < m_rows; ++y) {
    const int v = roi.top + y * block;
    std::int16_t *to = m_levels.data() + at(0, y);
    int x = 0;
    if (block == 2 && v + 1 < static_cast<int>(I.getHeight())) {
      const unsigned char *row = I[static_cast<unsigned int>(v)] + roi.left;
      reducePairs(row, row + I.getWidth(), pairs, to);
      x = pairs;
    }
    for (; x < m_columns; ++x) {
      to[x] = reduceBlock(I, roi.left + x * block, v, block);
    }
  }
}

void vpMapEdges::smooth()
{
  std::int16_t *__restrict line = m_line[0].data() + 1;
  for (int y = 0; y < m_rows; ++y) {
    const std::int16_t *above = m_levels.data() + at(0, nearestRow(y - 1));
    const std::int16_t *here = m_levels.data() + at(0, y);
    const std::int16_t *below = m_levels.data() + at(0, nearestRow(y + 1));
    for (int x = 0; x < m_columns; ++x) {
      line[x] = static_cast<std::int16_t>(above[x] + 2 * here[x] + below[x]);
    }
    repeatEnds(m_line[0], m_columns);
    std::int16_t *__restrict to = m_smoothed.data() + at(0, y);
    for (int x = 0; x < m_columns; ++x) {
      to[x] = static_cast<std::int16_t>((line[x - 1] + 2 * line[x] + line[x + 1] + 2) >> 2);
    }
  }
}

void vpMapEdges::differentiate()
{
  std::int16_t *__restrict sum = m_line[0].data() + 1;
  std::int16_t *__restrict difference = m_line[1].data() + 1;
  for (int y = 0; y < m_rows; ++y) {
    const std::int16_t *above = m_smoothed.data() + at(0, nearestRow(y - 1));
    const std::int16_t *here = m_smoothed.data() + at(0, y);
    const std::int16_t *below = m_smoothed.data() + at(0, nearestRow(y + 1));
    for (int x = 0; x < m_columns; ++x) {
      sum[x] = static_cast<std::int16_t>(above[x] + 2 * here[x] + below[x]);
      difference[x] = static_cast<std::int16_t>(below[x] - above[x]);
    }
    repeatEnds(m_line[0], m_columns);
    repeatEnds(m_line[1], m_columns);
    std::int16_t *gradientU = m_gradientU.data() + at(0, y);
    std::int16_t *gradientV = m_gradientV.data() + at(0, y);
    differentiateLine(sum, difference, m_columns, gradientU, gradientV);
    squareLine(gradientU, gradientV, m_columns, m_squares.data() + at(0, y));
  }
}

// The mask does not answer to slopes, nor to straight edges along rows or columns, so little but noise is left
// (Immerkaer, "Fast noise variance estimation", 1996).
double vpMapEdges::gradientNoise()
{
  const int step = 1 + static_cast<int>(std::sqrt(m_columns * m_rows / static_cast<double>(mostSamples)));
  m_samples.clear();
  for (int y = 1; y < m_rows - 1; y += step) {
    const std::int16_t *above = m_levels.data() + at(0, y - 1);
    const std::int16_t *here = m_levels.data() + at(0, y);
    const std::int16_t *below = m_levels.data() + at(0, y + 1);
    for (int x = 1; x < m_columns - 1; x += step) {
      const auto column = [&](int k) { return above[k] - 2 * here[k] + below[k]; };
      m_samples.push_back(std::abs(column(x - 1) - 2 * column(x) + column(x + 1)));
    }
  }
  if (m_samples.empty()) {
    return 0.;
  }
  const double place = quietShare * static_cast<double>(m_samples.size());
  const auto quiet = m_samples.begin() + static_cast<std::ptrdiff_t>(place);
  std::nth_element(m_samples.begin(), quiet, m_samples.end());
  return gradientGain / (maskGain * quietDeviations) * *quiet;
}

// The mean length of the gradients of each tile and the eight around it. Lengths are the sums of both components'
// magnitudes, which are 4 / pi times as long over all directions.
void vpMapEdges::chooseThresholds(const vpOrientedDistanceSettings &settings)
{
  m_threshold = std::max(settings.contrast * gradientPerLevel, settings.noiseFactor * gradientNoise());
  const int across = (m_columns + tile - 1) / tile;
  const int down = (m_rows + tile - 1) / tile;
  m_sums.resize(static_cast<std::size_t>(across * down));
  for (int j = 0; j < down; ++j) {
    for (int i = 0; i < across; ++i) {
      m_sums[static_cast<std::size_t>(j * across + i)] = sumOfTile(i * tile, j * tile);
    }
  }
  m_least.resize(m_sums.size());
  const double factor = settings.clutterFactor * 0.25 * M_PI;
  for (int j = 0; j < down; ++j) {
    for (int i = 0; i < across; ++i) {
      const double least = std::max(m_threshold, factor * meanAround(i, j, across, down));
      m_least[static_cast<std::size_t>(j * across + i)] = static_cast<std::int32_t>(least * least);
    }
  }
}

double vpMapEdges::sumOfTile(int left, int top) const
{
  std::int32_t sums[tile] = {}; // One for each column: several are added to in one instruction.
  const int columns = std::min(tile, m_columns - left);
  const int bottom = std::min(top + tile, m_rows);
  for (int y = top; y < bottom; ++y) {
    const std::int16_t *gradientU = m_gradientU.data() + at(left, y);
    const std::int16_t *gradientV = m_gradientV.data() + at(left, y);
    for (int x = 0; x < columns; ++x) {
      sums[x] += std::abs(gradientU[x]) + std::abs(gradientV[x]);
    }
  }
  return std::accumulate(sums, sums + tile, 0.);
}

double vpMapEdges::meanAround(int i, int j, int across, int down) const
{
  const int left = std::max(i - 1, 0);
  const int right = std::min(i + 2, across);
  const int top = std::max(j - 1, 0);
  const int bottom = std::min(j + 2, down);
  double sum = 0.;
  for (int row = top; row < bottom; ++row) {
    const auto first = m_sums.begin() + row * across;
    sum = std::accumulate(first + left, first + right, sum);
  }
  const int columns = std::min(right * tile, m_columns) - left * tile;
  const int rows = std::min(bottom * tile, m_rows) - top * tile;
  return sum / (columns * rows);
}

// Nothing is known behind the map's border, so that its outermost pixels have no maxima.
void vpMapEdges::findMaxima()
{
  const int across = (m_columns + tile - 1) / tile;
  std::int32_t *maxima = m_maxima.data();
  for (int y = 1; y < m_rows - 1; ++y) {
    const std::size_t first = at(0, y);
    const std::int16_t *gradientU = m_gradientU.data() + first;
    const std::int16_t *gradientV = m_gradientV.data() + first;
    keepMaxima(m_squares.data() + first + 1, m_columns, gradientU + 1, gradientV + 1, m_columns - 2, maxima + 1);
    const std::int32_t *least = m_least.data() + y / tile * across;
    for (int i = 0; i < across; ++i) {
      const int end = std::min((i + 1) * tile, m_columns - 1);
      const std::int32_t limit = least[i];
      // Listed first, without a branch that nobody could predict.
      int places[tile + 1];
      int count = 0;
      for (int x = std::max(i * tile, 1); x < end; ++x) {
        places[count] = x;
        count += maxima[x] > limit;
      }
      for (int k = 0; k < count; ++k) {
        const int x = places[k];
        m_found.push_back({x, y, vpOrientedDistanceMap::bin(gradientU[x], gradientV[x])});
      }
    }
  }
}

void vpMapEdges::dropMasked(const vpCueFrame &frame, const vpImageRegion &roi, int block)
{
  const double middle = 0.5 * (block - 1);
  const auto isMasked = [&](const Edge &edge) {
    return frame.isMasked(std::min(roi.left + edge.x * block + middle, frame.width() - 1.),
                          std::min(roi.top + edge.y * block + middle, frame.height() - 1.));
  };
  m_found.erase(std::remove_if(m_found.begin(), m_found.end(), isMasked), m_found.end());
}

const std::vector<vpMapEdges::Edge> &vpMapEdges::find(const vpCueFrame &frame, const vpImageRegion &roi, int block,
                                                      const vpOrientedDistanceSettings &settings)
{
  m_columns = (roi.width + block - 1) / block;
  m_rows = (roi.height + block - 1) / block;
  const std::size_t count = at(0, m_rows);
  for (auto *image : {&m_levels, &m_smoothed, &m_gradientU, &m_gradientV}) {
    image->resize(count);
  }
  m_squares.resize(count);
  m_maxima.resize(static_cast<std::size_t>(m_columns));
  m_samples.reserve(count);
  m_found.clear();
  m_found.reserve(count);
  for (auto &line : m_line) {
    line.resize(static_cast<std::size_t>(m_columns) + 2);
  }

  reduce(frame.gray(), roi, block);
  smooth();
  differentiate();
  chooseThresholds(settings);
  findMaxima();
  dropMasked(frame, roi, block);
  return m_found;
}

END_VISP_NAMESPACE
