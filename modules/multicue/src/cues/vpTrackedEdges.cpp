// SPDX-License-Identifier: GPL-2.0-or-later
#include "cues/vpTrackedEdges.h"

#include "estimate/vpModelLooks.h"

BEGIN_VISP_NAMESPACE

namespace {
// An edge that is farther away than this does not support a pose, pixels.
const double edgeReach = 2.5;
} // namespace

std::optional<double> vpTrackedEdges::agreement(const vpHomogeneousMatrix &cMo, const vpCameraParameters &)
{
  return m_edges.agreement(cMo, edgeReach);
}

std::string vpTrackedEdges::missing() const
{
  const std::size_t searched = m_edges.matches().size();
  return searched == 0 ? "no visible edge of the model is inside the image"
                       : "no edge of the image was found near any of " + std::to_string(searched) + " control points";
}

void vpTrackedEdges::matchFine(const vpCueFrame &image, const vpModelView &view, unsigned int)
{
  vpEdgeCueSettings settings = m_edges.settings();
  if (m_range > 0.) {
    settings.range = m_range;
  }
  const vpOtherEdgeSettings predicted(m_edges, settings);
  m_edges.match(image, view);
}

void vpTrackedEdges::learn(const vpHomogeneousMatrix &cMo, const std::vector<double> &weights, vpModelLooks &looks)
{
  m_edges.updateReference(cMo, weights);
  m_texture.update(m_edges.matches(), weights, looks.view(), looks.options);
}

void vpTrackedEdges::forget(vpModelLooks &looks)
{
  m_edges = vpEdgeCue(m_edges.settings());
  m_texture.reset(looks.options);
}

END_VISP_NAMESPACE
