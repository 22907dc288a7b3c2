// SPDX-License-Identifier: GPL-2.0-or-later
#include <visp3/cues/vpColorCue.h>

#include "color/vpColorLineFinder.h"
#include "color/vpContourPosterior.h"
#include "color/vpContourShift.h"
#include "color/vpFineMatch.h"
#include "color/vpMembership.h"
#include "color/vpPixelNumber.h"
#include "frame/vpLight.h"

#include <visp3/core/vpException.h>

#include <algorithm>
#include <cmath>

BEGIN_VISP_NAMESPACE

namespace {
// Fewer pixels of a side have no statistics.
const int leastPixels = 3;
// On the fine levels so many pixels are read beyond the statistics' ones, for the trusted pose may be off the matched
// one.
const int leeway = 3;
// Information, per square pixel, below which a line tells nothing.
const double noInformation = 1e-12;
// Of a contour that can be seen, gray levels: as edges have it.
const double leastContrast = 5.;
// Evidence of a place that was not seen in the last trusted frame: it is believed.
const double unknownEvidence = 0.6931; // log(2)
} // namespace

vpColorCue::vpColorCue(const vpColorCueSettings &settings)
{
  setSettings(settings);
}

void vpColorCue::setSettings(const vpColorCueSettings &settings)
{
  settings.check();
  m_settings = settings;
  m_level = levels() - 1;
  m_lines.clear();
  reset();
}

unsigned int vpColorCue::levels() const
{
  return static_cast<unsigned int>(m_settings.scales.size() + m_settings.bands.size());
}

void vpColorCue::setLevel(unsigned int level)
{
  m_level = std::min(level, levels() - 1);
}

void vpColorCue::reset()
{
  m_histograms.reset(m_channels);
  m_memory.clear();
}

void vpColorCue::setReference(const Reference &reference)
{
  if (reference.histograms.channels() == m_channels) {
    m_histograms = reference.histograms;
    m_memory = reference.memory;
  }
}

void vpColorCue::match(const vpCueFrame &frame, const vpModelView &view)
{
  m_camera = frame.camera();
  const unsigned int channels = frame.hasColor() ? 3 : 1;
  if (channels != m_channels) {
    m_channels = channels;
    reset();
  }
  m_memory.setModel(view.model());
  m_matchedBand = isCoarse() ? 0. : band();
  const double furthest = std::max(std::max(m_settings.length, m_settings.histogramLength), 3. * m_matchedBand);
  m_reach = static_cast<int>(std::ceil(furthest)) + leeway;
  int least = leastPixels;
  if (isCoarse()) {
    const unsigned int scale = m_settings.scales[m_level];
    m_reach = std::max(m_reach, vpContourPosterior::reach(scale));
    least = std::max(least, 2 * static_cast<int>(scale));
  }
  vpColorLineFinder(*this, frame).find(view, least);
  if (!m_histograms.isKnown()) {
    m_lessons.clear();
    for (std::size_t i = 0; i < m_lines.size(); ++i) {
      m_lessons.push_back({i, 0});
    }
    learnHistograms(1.);
  }
  if (isCoarse()) {
    const vpContourPosterior posterior(*this, m_settings.scales[m_level]);
    for (std::size_t i = 0; i < m_lines.size(); ++i) {
      posterior.evaluate(strip(i), m_lines[i]);
      doubtLine(m_lines[i]);
      m_lines[i].light = lightAt(strip(i), m_lines[i]);
      m_lines[i].scale *= std::sqrt(vpLight::pull(m_lines[i].light));
    }
  } else if (m_channels == 1) {
    vpFineMatch<1>(*this).run();
  } else {
    vpFineMatch<3>(*this).run();
  }
}

// Where the histograms did not tell the contour in the last trusted frame, in a shadow, or because the background there
// has the object's colours, they do not tell it now.
void vpColorCue::doubtLine(Line &line) const
{
  const double likelihood = std::exp(m_memory.evidence(line.position, unknownEvidence));
  const double belief = std::min(std::max(likelihood - 0.5, 0.), 1.);
  line.scale *= std::sqrt(belief);
  line.evidence *= belief;
}

// Of the contour. \param pixels Of the line, by offset from it.
double vpColorCue::lightAt(const std::uint32_t *pixels, const Line &line) const
{
  double brightest = 0.;
  const int last = std::min(vpLight::reach, line.last);
  for (int k = std::max(-vpLight::reach, line.first); k <= last; ++k) {
    brightest = std::max(brightest, m_channels == 1 ? pixels[k] : brightnessOf(pixels[k]));
  }
  return vpLight::at(brightest, leastContrast);
}

double vpColorCue::evidence() const
{
  vpLight::Mean mean;
  for (const Line &line : m_lines) {
    mean.add(line.evidence, line.light);
  }
  return mean.value();
}

std::size_t vpColorCue::rowsOf(const Line &line) const
{
  return hasRowPerPixel() ? static_cast<std::size_t>(line.sampleCount) * m_channels : 1;
}

void vpColorCue::residuals(const vpHomogeneousMatrix &cMo, vpResidualBlock &block) const
{
  block.rows.clear();
  block.noise = 1.;
  vpContourShift shift(cMo, m_camera);
  for (const Line &line : m_lines) {
    const std::size_t first = block.rows.size();
    block.rows.resize(first + rowsOf(line));
    if (!shift.project(line)) {
      for (std::size_t i = first; i < block.rows.size(); ++i) {
        block.rows[i].weight = 0.;
      }
      continue;
    }
    vpResidual *rows = block.rows.data() + first;
    if (isCoarseMatch()) {
      rows->error = line.scale * (shift.pixels() - line.offset);
      shift.jacobian(line.scale, rows->jacobian);
    } else if (hasRowPerPixel()) {
      setPixelRows(line, shift, rows);
    } else {
      setLineRow(line, shift, *rows);
    }
  }
}

// The error's derivative in the direction of the contour's shift is g = f d, of the same direction for all poses. Of
// the stacked errors e only their part along g pulls at the pose: (g . e / |g|) and |g| L give the same J^T J and J^T
// e.
void vpColorCue::setLineRow(const Line &line, const vpContourShift &shift, vpResidual &row) const
{
  const vpMembership &membership = vpMembership::table();
  const double inverseBand = 1. / m_matchedBand;
  double pull = 0.;
  double information = 0.;
  const Sample *sample = m_samples.data() + line.sampleFirst;
  for (int i = 0; i < line.sampleCount; ++i, ++sample) {
    const vpMembership::Value value = membership((sample->t - shift.pixels()) * inverseBand);
    pull += value.f * (sample->bd + value.a * sample->dd);
    information += value.f * value.f * sample->dd;
  }
  if (information < noInformation) {
    return;
  }
  const double length = std::sqrt(information);
  row.error = line.scale * pull / length;
  shift.jacobian(line.scale * length * inverseBand, row.jacobian);
}

// [P14] eq. 8 before the norm is taken: e = C (I^ - I) with I^ = a I_O + (1 - a) I_B.
void vpColorCue::setPixelRows(const Line &line, const vpContourShift &shift, vpResidual *rows) const
{
  const vpMembership &membership = vpMembership::table();
  for (int i = line.sampleFirst; i < line.sampleFirst + line.sampleCount; ++i) {
    const WhitenedColors &colors = m_whitened[static_cast<std::size_t>(i)];
    const double t = m_samples[static_cast<std::size_t>(i)].t - shift.pixels();
    const vpMembership::Value value = membership(t / m_matchedBand);
    for (unsigned int c = 0; c < m_channels; ++c, ++rows) {
      rows->error = line.scale * (colors.b[c] + value.a * colors.d[c]);
      shift.jacobian(line.scale * value.f / m_matchedBand * colors.d[c], rows->jacobian);
    }
  }
}

END_VISP_NAMESPACE
