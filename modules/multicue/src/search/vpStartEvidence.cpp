// SPDX-License-Identifier: GPL-2.0-or-later
#include "search/vpStartEvidence.h"

#include "search/vpHundredths.h"

#include <algorithm>
#include <cmath>

BEGIN_VISP_NAMESPACE

namespace {
// Of the best poses elsewhere; a dozen of them do not tell their deviation well, so the usual one counts as much.
const double usualDeviation = 0.05;
// Deviations, where the model's colours are known, and where edges alone are compared.
const double leastAdvantage = 2.4;
const double perTry = 0.6;
const unsigned int mostTries = 6;
// What deceives seldom does so in several images at the same pose; they are alike, though: not the root.
const double againPower = 0.25;
const double leastEdgeAdvantage = 1.1;
// Correlation with the model's colours: an object of the same shape and other colours has about 0. The best of many
// poses on something else reaches more, and the more images are searched the more: on rendered objects 0.25 to 0.37.
const double leastModelColors = 0.33;
const double modelColorsPerTry = 0.02;
const double leastEdges = 0.57;
// The fewer of the edges are found below this share, the more of an advantage is needed.
const double usualEdges = 0.69;
const double perMissingEdges = 6.;
const double leastColors = 0.3;
} // namespace

void vpStartEvidence::add(const vpStartSearch::Value &value, const std::vector<vpStartSearch::Value> &clutter,
                          const Support &support, double trust)
{
  ++m_frames;
  m_total += value.seen;
  m_modelColors += value.colors;
  m_trust = trust;
  m_support.edges += support.edges;
  m_support.colors += support.colors;
  m_support.hasEdges = support.hasEdges;
  m_support.hasColors = support.hasColors;
  for (const vpStartSearch::Value &other : clutter) {
    ++m_places;
    m_clutter += other.seen;
    m_clutterSquares += other.seen * other.seen;
  }
}

double vpStartEvidence::advantage() const
{
  if (m_frames == 0) {
    return 0.;
  }
  const double places = static_cast<double>(std::max<std::size_t>(m_places, 1));
  const double middle = m_clutter / places;
  const double variance = std::max(0., m_clutterSquares / places - middle * middle);
  return (mean(m_total) - middle) / std::sqrt(0.5 * (variance + usualDeviation * usualDeviation));
}

double vpStartEvidence::neededAdvantage() const
{
  const double missing = m_support.hasEdges ? std::max(0., usualEdges - mean(m_support.edges)) : 0.;
  const double once = leastEdgeAdvantage + m_trust * (leastAdvantage - leastEdgeAdvantage + perTry * triesBefore());
  return once / std::pow(1. + m_again, againPower) + perMissingEdges * missing;
}

double vpStartEvidence::neededModelColors() const
{
  return m_trust * (leastModelColors + modelColorsPerTry * triesBefore());
}

double vpStartEvidence::triesBefore() const
{
  return std::min(std::max(m_tries, 1U), mostTries) - 1U;
}

bool vpStartEvidence::isEnough(double strict) const
{
  return text(strict).empty();
}

std::string vpStartEvidence::text(double strict) const
{
  if (advantage() < strict * neededAdvantage()) {
    return "it is " + vpHundredths(advantage()) + " deviations better than what is elsewhere in the image, " +
           vpHundredths(strict * neededAdvantage()) + " are needed";
  }
  if (mean(m_modelColors) < strict * neededModelColors()) {
    return "the image does not have the model's colours there (correlation " + vpHundredths(mean(m_modelColors)) +
           " of " + vpHundredths(strict * neededModelColors()) + ")";
  }
  if (m_support.hasEdges && mean(m_support.edges) < strict * leastEdges) {
    return "a share of " + vpHundredths(mean(m_support.edges)) + " of the edges is there, " +
           vpHundredths(strict * leastEdges) + " is needed";
  }
  if (m_support.hasColors && mean(m_support.colors) < strict * leastColors) {
    return "the colours on both sides of the outline do not differ enough (" + vpHundredths(mean(m_support.colors)) +
           " of " + vpHundredths(strict * leastColors) + ")";
  }
  return "";
}

END_VISP_NAMESPACE
