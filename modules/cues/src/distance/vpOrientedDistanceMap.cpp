// SPDX-License-Identifier: GPL-2.0-or-later
#include <visp3/cues/vpOrientedDistanceMap.h>

#include "distance/vpChamfer.h"
#include "distance/vpMapEdges.h"
#include "distance/vpMapBlocks.h"

#include <visp3/core/vpException.h>

BEGIN_VISP_NAMESPACE

namespace {
// What an edge seems farther away for in the bins beside its own, steps of the map: no cliff where a normal passes from
// one bin to the next.
const int neighbourStep = vpChamfer::side / 2;

void mark(std::uint8_t *pixel, int bin)
{
  const auto lower = [&](int k, int value) {
    std::uint8_t &place = pixel[k & (vpOrientedDistanceMap::bins - 1)];
    place = std::min(place, static_cast<std::uint8_t>(value));
  };
  lower(bin, 0);
  lower(bin - 1, neighbourStep);
  lower(bin + 1, neighbourStep);
}
} // namespace

vpOrientedDistanceMap::vpOrientedDistanceMap() : m_edges(new vpMapEdges)
{
}
vpOrientedDistanceMap::~vpOrientedDistanceMap() = default;
vpOrientedDistanceMap::vpOrientedDistanceMap(vpOrientedDistanceMap &&) noexcept = default;
vpOrientedDistanceMap &vpOrientedDistanceMap::operator=(vpOrientedDistanceMap &&) noexcept = default;

void vpOrientedDistanceMap::setSettings(const vpOrientedDistanceSettings &settings)
{
  settings.check();
  m_settings = settings;
}

void vpOrientedDistanceMap::clear()
{
  m_columns = m_rows = 0.;
  m_edgeCount = 0;
  m_threshold = m_settings.contrast;
}

void vpOrientedDistanceMap::compute(const vpCueFrame &frame, const vpImageRegion &roi)
{
  m_maxDistance = m_settings.maxDistance;
  const int block = static_cast<int>(std::lround(1. / m_settings.scale));
  const vpMapBlocks blocks(roi, block, frame.width(), frame.height());
  if (blocks.region.isEmpty()) {
    clear();
    return;
  }
  const std::vector<vpMapEdges::Edge> &edges = m_edges->find(frame, blocks.region, block, m_settings);

  m_left = blocks.region.left - 0.5;
  m_top = blocks.region.top - 0.5;
  m_perPixel = 1. / block;
  m_unit = static_cast<double>(block) / vpChamfer::side;
  m_columns = blocks.columns;
  m_rows = blocks.rows;
  m_edgeCount = edges.size();
  m_threshold = m_edges->threshold();

  const int margin = vpChamfer::margin;
  m_stride = static_cast<std::size_t>(blocks.columns + 2 * margin);
  const auto limit = static_cast<std::uint8_t>(std::ceil(m_maxDistance / m_unit - 1e-9));
  m_map.assign(m_stride * static_cast<std::size_t>(blocks.rows + 2 * margin) * bins, limit);
  std::uint8_t *first = m_map.data() + (m_stride + 1) * margin * bins;
  m_inside = first;
  for (const vpMapEdges::Edge &edge : edges) {
    mark(first + (static_cast<std::size_t>(edge.y) * m_stride + static_cast<std::size_t>(edge.x)) * bins, edge.bin);
  }
  vpChamfer(first, m_stride, blocks.columns, blocks.rows).transform();
}

void vpOrientedDistanceMap::draw(int bin, vpImage<unsigned char> &I) const
{
  if (bin < -1 || bin >= bins) {
    throw vpException(vpException::badValue, "There is no orientation bin %d: give 0 to 7, or -1 for the least of all",
                      bin);
  }
  I.resize(height(), width());
  for (unsigned int y = 0; y < height(); ++y) {
    for (unsigned int x = 0; x < width(); ++x) {
      const std::uint8_t *pixel = m_inside + (y * m_stride + x) * bins;
      const double steps = bin < 0 ? *std::min_element(pixel, pixel + bins) : pixel[bin];
      I[y][x] = static_cast<unsigned char>(255. * std::min(steps * m_unit / m_maxDistance, 1.));
    }
  }
}

END_VISP_NAMESPACE
