// SPDX-License-Identifier: GPL-2.0-or-later
#include "color/vpColorLineFinder.h"

#include "color/vpLinePixels.h"
#include "color/vpPixelNumber.h"

#include <algorithm>
#include <cmath>

BEGIN_VISP_NAMESPACE

namespace {
const double mostOverlap = 3.; // Pixels.

template <typename Pixel> void readLine(const vpImage<Pixel> &I, const vpColorCue::Line &line, std::uint32_t *pixels)
{
  const std::ptrdiff_t stride = I.getWidth();
  const vpLinePixels places(line);
  for (int k = line.first; k <= line.last; ++k) {
    pixels[k] = toPixelNumber(I.bitmap[places.v(k) * stride + places.u(k)]);
  }
}
} // namespace

vpColorLineFinder::vpColorLineFinder(vpColorCue &cue, const vpCueFrame &frame) : m_cue(cue), m_frame(frame), m_bars(cue)
{
}

// Every so many silhouette points of a contour, so that the lines are spread evenly.
void vpColorLineFinder::choose(const vpModelView &view)
{
  double total = 0.;
  for (const vpControlPoint &point : view.points()) {
    const bool isRim = point.kind == vpEdgeKind::SILHOUETTE;
    total += isRim ? view.contours()[static_cast<std::size_t>(point.contour)].step : 0.;
  }
  const double spacing = std::max(m_cue.m_settings.spacing, total / m_cue.m_settings.lines);
  for (const vpContour &contour : view.contours()) {
    const int count =
        std::max(1, std::min(contour.count, static_cast<int>(contour.count * contour.step / spacing + 0.01)));
    const double length = contour.count * contour.step / count;
    // Longer than the contour's share, for points beside a corner may be missing.
    const double half = 0.5 * length + std::min(mostOverlap, 0.5 * length);
    for (int k = 0; k < count; ++k) {
      const int i = (2 * k + 1) * contour.count / (2 * count);
      const vpControlPoint &point = view.points()[static_cast<std::size_t>(contour.first + i)];
      if (point.kind != vpEdgeKind::SILHOUETTE) {
        continue;
      }
      m_bars.add(point.pixel, point.normal, half);
      m_cue.m_lines.emplace_back();
      vpColorCue::Line &line = m_cue.m_lines.back();
      line.position = point.position;
      line.pixel = point.pixel;
      line.normal = point.normal;
    }
  }
}

bool vpColorLineFinder::clipToImage(vpColorCue::Line &line) const
{
  const Eigen::Vector2d high(m_frame.width() - 1., m_frame.height() - 1.);
  double from = -m_cue.m_reach;
  double to = m_cue.m_reach;
  for (int axis = 0; axis < 2; ++axis) {
    const double place = line.pixel[axis];
    const double n = line.normal[axis];
    if (!(place >= 0. && place <= high[axis])) {
      return false;
    }
    if (std::fabs(n) > 1e-9) {
      from = std::max(from, ((n > 0. ? 0. : high[axis]) - place) / n);
      to = std::min(to, ((n > 0. ? high[axis] : 0.) - place) / n);
    }
  }
  line.first = static_cast<int>(std::ceil(from));
  line.last = static_cast<int>(std::floor(to));
  return true;
}

void vpColorLineFinder::clipToMask(vpColorCue::Line &line) const
{
  const vpLinePixels places(line);
  const auto isMasked = [&](int k) { return m_frame.isMasked(places.u(k), places.v(k)); };
  // Without a mask only what the lens did not see is hidden, and that is outside: the ends tell.
  if (!m_frame.hasMask() && !isMasked(line.first) && !isMasked(line.last)) {
    return;
  }
  if (isMasked(0)) {
    line.first = line.last = 0;
    return;
  }
  for (int k = -1; k >= line.first; --k) {
    line.first = isMasked(k) ? k + 1 : line.first;
  }
  for (int k = 1; k <= line.last; ++k) {
    line.last = isMasked(k) ? k - 1 : line.last;
  }
}

bool vpColorLineFinder::fit(vpColorCue::Line &line, int least) const
{
  if (!clipToImage(line)) {
    return false;
  }
  // A pixel is left between, which shows some of both.
  const vpContourBars::Gap gap = m_bars.around(line.pixel, line.normal, static_cast<float>(m_cue.m_reach) + 1.F);
  line.first = std::max(line.first, static_cast<int>(std::ceil(gap.behind + 1.F)));
  line.last = std::min(line.last, static_cast<int>(std::floor(gap.ahead - 1.F)));
  if (line.first > -least || line.last < least) {
    return false;
  }
  clipToMask(line);
  return line.first <= -least && line.last >= least;
}

void vpColorLineFinder::find(const vpModelView &view, int least)
{
  std::vector<vpColorCue::Line> &lines = m_cue.m_lines;
  lines.clear();
  choose(view);
  m_bars.enclose();
  std::size_t kept = 0;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    vpColorCue::Line line = lines[i];
    if (fit(line, least)) {
      lines[kept++] = line;
    }
  }
  lines.resize(kept);

  const std::size_t width = static_cast<std::size_t>(2 * m_cue.m_reach + 1);
  m_cue.m_pixels.resize(kept * width);
  for (std::size_t i = 0; i < kept; ++i) {
    std::uint32_t *pixels = m_cue.m_pixels.data() + i * width + m_cue.m_reach;
    if (m_frame.hasColor()) {
      readLine(m_frame.color(), lines[i], pixels);
    } else {
      readLine(m_frame.gray(), lines[i], pixels);
    }
  }
}

END_VISP_NAMESPACE
