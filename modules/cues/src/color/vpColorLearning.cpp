// SPDX-License-Identifier: GPL-2.0-or-later
#include <visp3/cues/vpColorCue.h>

#include "color/vpContourPosterior.h"
#include "color/vpContourShift.h"
#include "color/vpLocalStatistics.h"
#include "frame/vpLight.h"

#include <visp3/core/vpException.h>

#include <algorithm>
#include <cmath>

BEGIN_VISP_NAMESPACE

namespace {
// Rows with less robust weight are called outliers and teach nothing.
const double outlierWeight = 0.1;
// Pixels that both sides need to teach something.
const int leastPixels = 3;

template <int N>
vpColorMemory::Means meansOf(const std::uint32_t *pixels, const vpColorCue::Line &line, int shift, int length)
{
  using Statistics = vpLocalStatistics<N>;
  vpColorMemory::Means means;
  means.object.head<N>() = Statistics::sum(pixels, line, shift - length, shift - 1).mean();
  means.background.head<N>() = Statistics::sum(pixels, line, shift + 1, shift + length).mean();
  return means;
}
} // namespace

// The largest weight of a line's rows: pixels that are occluded do not make outliers of the others.
double vpColorCue::weightOf(const Line &line, const double *weights) const
{
  return *std::max_element(weights, weights + rowsOf(line));
}

void vpColorCue::findLessons(const vpHomogeneousMatrix &cMo, const std::vector<double> &weights)
{
  m_lessons.clear();
  vpContourShift contour(cMo, m_camera);
  const double *weight = weights.data();
  for (std::size_t i = 0; i < m_lines.size(); ++i) {
    const Line &line = m_lines[i];
    const bool isTrusted = rowsOf(line) > 0 && weightOf(line, weight) > outlierWeight;
    weight += rowsOf(line);
    if (!isTrusted || !contour.project(line) || !(std::fabs(contour.pixels()) < m_reach)) {
      continue;
    }
    const int shift = static_cast<int>(std::lround(contour.pixels()));
    if (line.first <= shift - leastPixels && line.last >= shift + leastPixels) {
      m_lessons.push_back({i, shift});
    }
  }
}

void vpColorCue::learnHistograms(double rate)
{
  const int length = static_cast<int>(m_settings.histogramLength);
  for (const Lesson &lesson : m_lessons) {
    const Line &line = m_lines[lesson.line];
    const std::uint32_t *pixels = strip(lesson.line);
    // The contour's own pixel shows some of both sides.
    for (int k = std::max(line.first, lesson.shift - length); k < lesson.shift; ++k) {
      m_histograms.count(pixels[k], vpColorHistograms::OBJECT);
    }
    for (int k = lesson.shift + 1; k <= std::min(line.last, lesson.shift + length); ++k) {
      m_histograms.count(pixels[k], vpColorHistograms::BACKGROUND);
    }
  }
  m_histograms.learn(rate);
}

double vpColorCue::evidenceAt(const vpHomogeneousMatrix &cMo)
{
  m_evidence.assign(m_lines.size(), 0.);
  if (m_settings.scales.empty() || m_lines.empty()) {
    return 0.;
  }
  const vpContourPosterior posterior(*this, m_settings.scales.back());
  vpContourShift contour(cMo, m_camera);
  vpLight::Mean mean;
  for (std::size_t i = 0; i < m_lines.size(); ++i) {
    if (!contour.project(m_lines[i]) || !(std::fabs(contour.pixels()) < m_reach)) {
      mean.add(0., 1.);
      continue;
    }
    const int shift = static_cast<int>(std::lround(contour.pixels()));
    Line moved = m_lines[i];
    moved.first = std::min(moved.first - shift, 0);
    moved.last = std::max(moved.last - shift, 0);
    posterior.evaluate(strip(i) + shift, moved);
    m_evidence[i] = moved.evidence;
    doubtLine(moved);
    mean.add(moved.evidence, lightAt(strip(i) + shift, moved));
  }
  return mean.value();
}

void vpColorCue::updateReference(const vpHomogeneousMatrix &cMo, const std::vector<double> &weights)
{
  std::size_t rows = 0;
  for (const Line &line : m_lines) {
    rows += rowsOf(line);
  }
  if (weights.size() != rows) {
    throw vpException(
        vpException::dimensionError,
        "vpColorCue::updateReference() was given %zu weights for %zu rows: pass one for each of residuals()",
        weights.size(), rows);
  }
  findLessons(cMo, weights);
  evidenceAt(cMo);
  learnHistograms(m_settings.learningRate);
  m_memory.beginFrame();
  // Of outliers too: there it is most needed.
  for (std::size_t i = 0; i < m_lines.size(); ++i) {
    m_memory.addEvidence(m_lines[i].position, m_evidence[i]);
  }
  const int length = static_cast<int>(m_settings.length);
  for (const Lesson &lesson : m_lessons) {
    const Line &line = m_lines[lesson.line];
    const std::uint32_t *pixels = strip(lesson.line);
    m_memory.add(line.position, m_channels == 1 ? meansOf<1>(pixels, line, lesson.shift, length)
                                                : meansOf<3>(pixels, line, lesson.shift, length));
  }
}

void vpColorCue::getFeatures(const vpHomogeneousMatrix &cMo, const std::vector<double> &weights,
                             std::vector<vpCueFeature> &features) const
{
  features.clear();
  vpContourShift contour(cMo, m_camera);
  std::size_t row = 0;
  for (const Line &line : m_lines) {
    const std::size_t rows = rowsOf(line);
    const bool isKnown = rows > 0 && row + rows <= weights.size();
    const double shift = contour.project(line) ? contour.pixels() : 0.;
    vpCueFeature feature;
    feature.u = line.pixel.x() + shift * line.normal.x();
    feature.v = line.pixel.y() + shift * line.normal.y();
    const bool isOutlier = isKnown && weightOf(line, weights.data() + row) <= outlierWeight;
    feature.state = isOutlier ? vpFeatureState::OUTLIER : vpFeatureState::GOOD;
    features.push_back(feature);
    row += rows;
  }
}

END_VISP_NAMESPACE
