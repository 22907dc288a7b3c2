// SPDX-License-Identifier: GPL-2.0-or-later
#include "knowledge/vpTextureSupport.h"

BEGIN_VISP_NAMESPACE

namespace {
// Rows with less robust weight do not count as found.
const double goodWeight = 0.1;
// Fewer control points searched, over all frames, say nothing yet of an edge.
const double fewestSearched = 40.;
// Edges with a smaller share of their points found are left out.
const double leastFound = 0.5;
} // namespace

void vpTextureSupport::reset(vpModelViewOptions &options)
{
  m_counts.clear();
  options.textureEdgesLeftOut.clear();
}

void vpTextureSupport::update(const std::vector<vpEdgeCue::Match> &matches, const std::vector<double> &weights,
                              const vpModelView &view, vpModelViewOptions &options)
{
  if (!options.textureEdges || view.textureEdges().empty()) {
    return;
  }
  m_counts.resize(view.textureEdges().size());
  options.textureEdgesLeftOut.resize(m_counts.size(), 0);
  std::size_t row = 0;
  for (const vpEdgeCue::Match &match : matches) {
    const bool found = match.count > 0 && row < weights.size() && weights[row] > goodWeight;
    row += match.count > 0 ? 1 : 0;
    const int edge = view.textureEdgeOf(match.point);
    if (edge < 0) {
      continue;
    }
    const std::size_t i = static_cast<std::size_t>(edge);
    m_counts[i].searched += 1.;
    m_counts[i].found += found ? 1. : 0.;
    const bool judged = m_counts[i].searched >= fewestSearched;
    options.textureEdgesLeftOut[i] = judged && m_counts[i].found < leastFound * m_counts[i].searched ? 1 : 0;
  }
}

END_VISP_NAMESPACE
