// SPDX-License-Identifier: GPL-2.0-or-later
#include "edge/vpEdgeClaims.h"

#include <algorithm>
#include <cmath>

BEGIN_VISP_NAMESPACE

namespace {
const float fallOff = 0.7F;     // s, pixels.
const float samePlace = 1.F;    // Across the edge, pixels.
const float overlap = 0.5F;     // Of a point's length: the next one on the same edge is one length away.
const float mostAlong = 7.F;    // Pixels.
const float sameNormal = 0.95F; // Cosine.
const float cell = 16.F;        // Pixels: a claim's rivals are in four of them at most.

// How far along the edge a rival may be, pixels.
float reachOf(const vpEdgeClaims::Claim &claim)
{
  return std::min(overlap * claim.length, mostAlong);
}

int cellOf(float pixel)
{
  return static_cast<int>(std::floor(pixel / cell));
}
} // namespace

void vpEdgeClaims::Rivals::add(const Rival &rival)
{
  const auto end = edges.begin() + count;
  const auto same = std::find_if(edges.begin(), end, [&](const Rival &other) { return other.edge == rival.edge; });
  if (same != end) {
    *same = rival.along < same->along ? rival : *same;
  } else if (count < mostRivals) {
    edges[static_cast<std::size_t>(count++)] = rival;
  }
}

std::size_t vpEdgeClaims::slotOf(int column, int row)
{
  return (static_cast<std::size_t>(column) + 37U * static_cast<std::size_t>(row)) % slots;
}

// \param first Claim of a cell, with all behind it.
void vpEdgeClaims::addRivals(const Claim &claim, int first, Rivals &rivals) const
{
  const float reach = reachOf(claim);
  for (int i = first; i != none; i = m_next[static_cast<std::size_t>(i)]) {
    const Claim &other = m_claims[static_cast<std::size_t>(i)];
    const bool isSameEdge = other.edge == claim.edge || (other.edge < 0 && claim.edge < 0);
    const Eigen::Vector2f offset = other.place - claim.place;
    const float along = std::fabs(claim.normal.x() * offset.y() - claim.normal.y() * offset.x());
    if (!isSameEdge && along <= reach && std::fabs(claim.normal.dot(offset)) <= samePlace &&
        std::fabs(claim.normal.dot(other.normal)) >= sameNormal) {
      rivals.add({other.edge, along, other.distance});
    }
  }
}

float vpEdgeClaims::shareOf(const Claim &claim) const
{
  Rivals rivals;
  const float reach = reachOf(claim) + samePlace;
  for (int row = cellOf(claim.place.y() - reach); row <= cellOf(claim.place.y() + reach); ++row) {
    for (int column = cellOf(claim.place.x() - reach); column <= cellOf(claim.place.x() + reach); ++column) {
      addRivals(claim, m_first[slotOf(column, row)], rivals);
    }
  }
  float all = 1.F;
  for (int i = 0; i < rivals.count; ++i) {
    all += std::exp((claim.distance - rivals.edges[static_cast<std::size_t>(i)].distance) / fallOff);
  }
  return 1.F / all;
}

std::vector<float> vpEdgeClaims::shares()
{
  m_first.fill(none);
  m_next.resize(m_claims.size());
  for (std::size_t i = 0; i < m_claims.size(); ++i) {
    int &first = m_first[slotOf(cellOf(m_claims[i].place.x()), cellOf(m_claims[i].place.y()))];
    m_next[i] = first;
    first = static_cast<int>(i);
  }
  std::vector<float> shares;
  shares.reserve(m_claims.size());
  for (const Claim &claim : m_claims) {
    shares.push_back(shareOf(claim));
  }
  return shares;
}

END_VISP_NAMESPACE
