// SPDX-License-Identifier: GPL-2.0-or-later
#include "judge/vpContourEvidence.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

BEGIN_VISP_NAMESPACE

namespace {
const double reach = 2.5; // See vpEdgeCue::agreement(), pixels.
// Contours that are as near and as parallel are found at the same edge of the image: pixels, cosine.
const float samePlace = 4.F;
const float sameDirection = 0.9F;
// Between what a right pose has of its contours and what a wrong one meets by chance.
const double neutral = 0.5;
// Deviation of one place's agreement: most have all of it or none. On texture, right poses had up to 3 places less of
// their own than a pose turned by half, frame after frame, of some 30 that only one of them had.
const double scatterOfPlace = 0.5;
const double weightOfPrint = 0.3; // Of edges of the texture, which meet others of it by chance.
const double fewestPlaces = 8.;   // That speak for another pose.
const double oddsOfPlace = 0.3;
const double mostOdds = 6.;
} // namespace

void vpContourEvidence::set(const vpEdgeCue &edges, const vpHomogeneousMatrix &cMo)
{
  m_places.clear();
  const std::vector<double> agreements = edges.agreements(cMo, reach);
  for (std::size_t i = 0; i < agreements.size(); ++i) {
    const vpEdgeCue::Match &match = edges.matches()[i];
    const double weight = match.light * (match.onSurface ? weightOfPrint : 1.);
    m_places.push_back({match.point.pixel.cast<float>(), match.point.normal.cast<float>(),
                        static_cast<float>(agreements[i]), static_cast<float>(weight)});
  }
  std::sort(m_places.begin(), m_places.end(), [](const Place &a, const Place &b) { return a.pixel.x() < b.pixel.x(); });
}

bool vpContourEvidence::has(const Place &place) const
{
  const float left = place.pixel.x() - samePlace;
  const float right = place.pixel.x() + samePlace;
  auto own =
      std::lower_bound(m_places.begin(), m_places.end(), left, [](const Place &a, float x) { return a.pixel.x() < x; });
  for (; own != m_places.end() && own->pixel.x() < right; ++own) {
    if ((own->pixel - place.pixel).squaredNorm() < samePlace * samePlace &&
        std::fabs(own->normal.dot(place.normal)) > sameDirection) {
      return true;
    }
  }
  return false;
}

vpContourEvidence::Own vpContourEvidence::withoutThoseOf(const vpContourEvidence &other) const
{
  Own own;
  for (const Place &place : m_places) {
    if (!other.has(place)) {
      own.weight += static_cast<double>(place.weight);
      own.agreement += static_cast<double>(place.weight * place.agreement);
    }
  }
  return own;
}

double vpContourEvidence::advantageOver(const vpContourEvidence &other) const
{
  const Own here = withoutThoseOf(other);
  const Own there = other.withoutThoseOf(*this);
  const double advantage = here.agreement - there.agreement - neutral * (here.weight - there.weight);
  // So much each way is chance.
  const double scatter = scatterOfPlace * std::sqrt(here.weight + there.weight);
  const double beyond = std::copysign(std::max(std::fabs(advantage) - scatter, 0.), advantage);
  const bool isShown = there.weight >= fewestPlaces && there.agreement > neutral * there.weight;
  return isShown ? beyond : std::max(beyond, 0.);
}

double vpContourEvidence::oddsOf(double advantage)
{
  return std::min(std::max(oddsOfPlace * advantage, -mostOdds), mostOdds);
}

END_VISP_NAMESPACE
