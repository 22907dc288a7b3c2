// SPDX-License-Identifier: GPL-2.0-or-later
#include "color/vpFineMatch.h"

#include "color/vpLinePixels.h"
#include "color/vpMembership.h"

#include <cmath>

BEGIN_VISP_NAMESPACE

namespace {
// The contour may move by this much between match() and residuals() before pixels are missed beside it.
const int leeway = 2; // Pixels.
// Pixels farther away, in bands, hardly tell where the contour is.
const double bandReach = 2.5;
} // namespace

template <int N> void vpFineMatch<N>::run()
{
  m_cue.m_samples.clear();
  m_cue.m_whitened.clear();
  for (std::size_t i = 0; i < m_cue.m_lines.size(); ++i) {
    addSamples(i, sidesOf(i));
  }
}

template <int N> typename vpFineMatch<N>::Sides vpFineMatch<N>::sidesOf(std::size_t index) const
{
  const vpColorCueSettings &settings = m_cue.m_settings;
  const vpColorCue::Line &line = m_cue.m_lines[index];
  const std::uint32_t *pixels = m_cue.strip(index);
  const int length = static_cast<int>(settings.length);
  const typename Statistics::Sums inside = Statistics::sum(pixels, line, -length, -1);
  const typename Statistics::Sums outside = Statistics::sum(pixels, line, 1, length);
  Sides sides{inside.mean(), outside.mean(), inside.covariance(), outside.covariance()};
  const float noise = static_cast<float>(settings.regularisation * settings.regularisation);
  sides.objectSpread.diagonal().array() += noise;
  sides.backgroundSpread.diagonal().array() += noise;
  vpColorMemory::Means before;
  if (settings.alpha < 1. && m_cue.m_memory.find(line.position, before)) {
    blend(before.object.template head<N>(), sides.objectSpread, sides.object);
    blend(before.background.template head<N>(), sides.backgroundSpread, sides.background);
  }
  return sides;
}

// The temporal consistency of [P14] III-B; but colours that are nothing like those seen now, because the light or the
// background changed, do not count.
template <int N> void vpFineMatch<N>::blend(const Vector &before, const Matrix &spread, Vector &mean) const
{
  const Vector difference = before - mean;
  const float distance = difference.dot(spread.inverse() * difference) / N;
  const float share = static_cast<float>(1. - m_cue.m_settings.alpha) * std::exp(-0.5F * distance);
  mean += share * difference;
}

template <int N> void vpFineMatch<N>::addSample(double t, double a, const Vector &color, const Sides &sides)
{
  const float share = static_cast<float>(a);
  const Matrix spread = share * sides.objectSpread + (1.F - share) * sides.backgroundSpread;
  const Vector b = sides.background - color;
  const Vector d = sides.object - sides.background;
  m_cue.m_samples.emplace_back();
  vpColorCue::Sample &sample = m_cue.m_samples.back();
  sample.t = t;
  if (m_cue.m_settings.rows == vpColorCueSettings::PIXELS) {
    const Eigen::LLT<Matrix> root(spread); // spread = L L^T, so C = L^-1
    vpColorCue::WhitenedColors whitened;
    whitened.b.template head<N>() = root.matrixL().solve(b).template cast<double>();
    whitened.d.template head<N>() = root.matrixL().solve(d).template cast<double>();
    sample.bd = whitened.b.dot(whitened.d);
    sample.dd = whitened.d.dot(whitened.d);
    m_cue.m_whitened.push_back(whitened);
  } else {
    const Vector weighted = spread.inverse() * d; // C^T C d
    sample.bd = static_cast<double>(b.dot(weighted));
    sample.dd = static_cast<double>(d.dot(weighted));
  }
}

template <int N> void vpFineMatch<N>::addSamples(std::size_t index, const Sides &sides)
{
  vpColorCue::Line &line = m_cue.m_lines[index];
  const std::uint32_t *pixels = m_cue.strip(index);
  const int reach = static_cast<int>(std::ceil(bandReach * m_band)) + leeway;
  const vpMembership &membership = vpMembership::table();
  const vpLinePixels places(line);
  line.sampleFirst = static_cast<int>(m_cue.m_samples.size());
  double information = 0.;
  for (int k = std::max(-reach, line.first); k <= std::min(reach, line.last); ++k) {
    // The pixel that was read is the one nearest to the line's point at this offset; its own offset counts.
    const Eigen::Vector2d centre(places.u(k), places.v(k));
    const double t = line.normal.dot(centre - line.pixel);
    const vpMembership::Value value = membership(t / m_band);
    addSample(t, value.a, Statistics::color(pixels[k]), sides);
    information += value.f * value.f * m_cue.m_samples.back().dd;
  }
  line.sampleCount = static_cast<int>(m_cue.m_samples.size()) - line.sampleFirst;
  information /= m_band * m_band;
  const double deviation = m_cue.m_settings.contourDeviation;
  line.scale = 1. / std::sqrt(1. + deviation * deviation * information);
}

template class vpFineMatch<1>;
template class vpFineMatch<3>;

END_VISP_NAMESPACE
