// SPDX-License-Identifier: GPL-2.0-or-later
#include "search/vpBlobFinder.h"

#include <algorithm>
#include <cmath>

BEGIN_VISP_NAMESPACE

namespace {
const int cell = 8; // Pixels.
const double scales[] = {0.7, 1., 1.4};
const double around = 1.7; // Side of what is around, in that of the window.
const double fullOdds = 2.;
const double leastContrast = 0.2;
const double leastSeen = 0.15;  // Share of a window that is in the image.
const double mostOutside = 0.8; // How far its middle may be outside, in halves of its side.
} // namespace

// Sums over all cells above and to the left.
void vpBlobFinder::sumUp(const vpColorOddsMap &colors)
{
  const std::size_t stride = static_cast<std::size_t>(m_columns) + 1;
  m_sums.assign(stride * (static_cast<std::size_t>(m_rows) + 1), 0.);
  for (int i = 0; i < m_rows; ++i) {
    double row = 0.;
    for (int j = 0; j < m_columns; ++j) {
      double odds = 0.;
      for (int k = 0; k < 4; ++k) {
        const double at = colors.logOdds(cell * (j + 0.25 + 0.5 * (k % 2)), cell * (i + 0.25 + 0.5 * (k / 2)));
        odds += std::min(std::max(at, -fullOdds), fullOdds);
      }
      row += 0.25 * odds;
      const std::size_t place = static_cast<std::size_t>(i + 1) * stride + static_cast<std::size_t>(j + 1);
      m_sums[place] = m_sums[place - stride] + row;
    }
  }
}

double vpBlobFinder::sum(int left, int top, int right, int bottom) const
{
  const auto at = [this](int row, int column) {
    row = std::min(std::max(row, 0), m_rows);
    column = std::min(std::max(column, 0), m_columns);
    return m_sums[static_cast<std::size_t>(row) * (static_cast<std::size_t>(m_columns) + 1) +
                  static_cast<std::size_t>(column)];
  };
  return at(bottom, right) - at(top, right) - at(bottom, left) + at(top, left);
}

// Number of cells of a square that are in the image.
double vpBlobFinder::cells(int column, int row, int half) const
{
  const auto length = [half](int at, int end) { return std::min(at + half, end) - std::max(at - half, 0); };
  return static_cast<double>(std::max(length(column, m_columns), 0)) * std::max(length(row, m_rows), 0);
}

// Mean inside less mean around, in units of the largest; a window that reaches out of the image shows less.
double vpBlobFinder::contrastAt(int column, int row, int half) const
{
  const int wide = static_cast<int>(std::lround(around * half)) + 1;
  const double area = cells(column, row, half);
  const double rest = cells(column, row, wide) - area;
  const double seen = area / (4. * half * half);
  if (seen < leastSeen || !(rest > 0.)) {
    return 0.;
  }
  const double inside = sum(column - half, row - half, column + half, row + half);
  const double all = sum(column - wide, row - wide, column + wide, row + wide);
  return std::sqrt(seen) * 0.5 * (inside / area - (all - inside) / rest) / fullOdds;
}

const std::vector<vpBlob> &vpBlobFinder::find(const vpColorOddsMap &colors, unsigned int width, unsigned int height,
                                              double size, std::size_t most)
{
  m_columns = static_cast<int>(width) / cell;
  m_rows = static_cast<int>(height) / cell;
  sumUp(colors);
  m_found.clear();
  for (const double scale : scales) {
    const int half = std::max(1, static_cast<int>(std::lround(0.5 * scale * size / cell)));
    const int step = std::max(1, half / 3);
    const int outside = static_cast<int>(mostOutside * half) / step * step;
    for (int row = -outside; row < m_rows + outside; row += step) {
      for (int column = -outside; column < m_columns + outside; column += step) {
        const double contrast = contrastAt(column, row, half);
        if (contrast > leastContrast) {
          m_found.push_back({static_cast<double>(cell * column), static_cast<double>(cell * row),
                             static_cast<double>(2 * cell * half), contrast});
        }
      }
    }
  }
  std::stable_sort(m_found.begin(), m_found.end(),
                   [](const vpBlob &a, const vpBlob &b) { return a.contrast > b.contrast; });
  m_kept.clear();
  for (const vpBlob &blob : m_found) {
    const bool isNew = std::none_of(m_kept.begin(), m_kept.end(), [&](const vpBlob &other) {
      return std::hypot(blob.u - other.u, blob.v - other.v) < 0.5 * other.size;
    });
    if (isNew && m_kept.size() < most) {
      m_kept.push_back(blob);
    }
  }
  return m_kept;
}

END_VISP_NAMESPACE
