// SPDX-License-Identifier: GPL-2.0-or-later
#include "color/vpContourPosterior.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

BEGIN_VISP_NAMESPACE

namespace {
// The step's height, and its width in segments.
const double height = 0.43;
const double width = 1.;
// What hides the contour is not impossible.
const double leastLikelihood = 0.02 / 13.;
} // namespace

vpContourPosterior::vpContourPosterior(const vpColorCue &cue, unsigned int scale)
    : m_histograms(cue.m_histograms), m_scale(static_cast<int>(scale)),
      m_contourVariance(cue.m_settings.contourDeviation * cue.m_settings.contourDeviation)
{
  for (int i = 0; i < 2 * around; ++i) {
    m_step[static_cast<std::size_t>(i)] = static_cast<float>(-2. * height * std::tanh((i - around + 0.5) / width));
  }
  // A contour may be anywhere between two borders; and a line that tells nothing has all borders alike.
  m_spread = m_scale * m_scale / 12.;
  m_noInformation = m_spread + m_contourVariance;
  for (int c = -borders; c <= borders; ++c) {
    m_noInformation += placeOf(c) * placeOf(c) / (2 * borders + 1);
  }
}

// The object's probability in each segment; one half where there are no pixels that may be used.
void vpContourPosterior::join(const std::uint32_t *pixels, const vpColorCue::Line &line, Segments &object) const
{
  for (int segment = -half; segment < half; ++segment) {
    float inside = 1.F;
    float outside = 1.F;
    // The pixel in the middle belongs to neither side, so that both are alike.
    const int middle = segment < 0 ? 0 : 1;
    const int end = std::min((segment + 1) * m_scale + middle, line.last + 1);
    for (int k = std::max(segment * m_scale + middle, line.first); k < end; ++k) {
      const float p = m_histograms.object(pixels[k]);
      inside *= p;
      outside *= 1.F - p;
    }
    // Twenty pixels of 1e-4 would be too small for a number.
    const float sum = inside + outside;
    object[static_cast<std::size_t>(segment + half)] = sum > 1e-30F ? inside / sum : 0.5F;
  }
}

void vpContourPosterior::evaluate(const std::uint32_t *pixels, vpColorCue::Line &line) const
{
  Segments object;
  join(pixels, line, object);
  double sum = 0.;
  double first = 0.;
  double second = 0.;
  double here = 0.;
  for (int c = -borders; c <= borders; ++c) {
    const float *segments = object.data() + (c + borders);
    float p = 1.F;
    for (std::size_t i = 0; i < 2 * around; ++i) {
      p *= 0.5F + m_step[i] * (segments[i] - 0.5F);
    }
    const double place = placeOf(c);
    sum += static_cast<double>(p);
    first += place * static_cast<double>(p);
    second += place * place * static_cast<double>(p);
    here += std::abs(c) <= 1 ? static_cast<double>(p) / 3. : 0.;
  }
  const double mean = first / sum;
  const double variance = second / sum - mean * mean + m_spread;
  line.evidence = std::log(std::max(here, leastLikelihood * sum) * (2 * borders + 1) / sum);
  line.offset = mean;
  const double information = 1. / (variance + m_contourVariance) - 1. / m_noInformation;
  line.scale = std::sqrt(std::max(0., information));
}

END_VISP_NAMESPACE
