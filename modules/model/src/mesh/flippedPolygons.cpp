// SPDX-License-Identifier: GPL-2.0-or-later
#include "primitiveAssembler.h"

#include <algorithm>

BEGIN_VISP_NAMESPACE
namespace vpMeshDetail {
namespace {
struct Neighbour
{
  std::size_t face;
  bool disagrees;
};

std::vector<std::vector<Neighbour>> neighbours(const std::vector<PolygonEdge> &edges, std::size_t faceCount)
{
  std::vector<std::vector<Neighbour>> result(faceCount);
  for (const PolygonEdge &edge : edges) {
    if (edge.side.size() == 2 && edge.side[0].first != edge.side[1].first) {
      const auto a = static_cast<std::size_t>(edge.side[0].first);
      const auto b = static_cast<std::size_t>(edge.side[1].first);
      const bool disagrees = edge.side[0].second == edge.side[1].second;
      result[a].push_back({b, disagrees});
      result[b].push_back({a, disagrees});
    }
  }
  return result;
}
} // namespace

std::size_t countFlippedFaces(const std::vector<PolygonEdge> &edges, std::size_t faceCount)
{
  enum : char
  {
    UNKNOWN,
    KEPT,
    TURNED
  };
  const std::vector<std::vector<Neighbour>> around = neighbours(edges, faceCount);
  std::vector<char> state(faceCount, UNKNOWN);
  std::size_t flipped = 0;
  for (std::size_t seed = 0; seed < faceCount; ++seed) {
    if (state[seed] != UNKNOWN) {
      continue;
    }
    state[seed] = KEPT;
    std::vector<std::size_t> group(1, seed);
    std::size_t turned = 0;
    for (std::size_t i = 0; i < group.size(); ++i) {
      for (const Neighbour &next : around[group[i]]) {
        if (state[next.face] == UNKNOWN) {
          state[next.face] = next.disagrees == (state[group[i]] == KEPT) ? TURNED : KEPT;
          turned += state[next.face] == TURNED ? 1U : 0U;
          group.push_back(next.face);
        }
      }
    }
    flipped += std::min(turned, group.size() - turned);
  }
  return flipped;
}
} // namespace vpMeshDetail
END_VISP_NAMESPACE
