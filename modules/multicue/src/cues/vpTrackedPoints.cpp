// SPDX-License-Identifier: GPL-2.0-or-later
#include "cues/vpTrackedPoints.h"

#include "estimate/vpModelLooks.h"

#include <algorithm>
#include <cmath>

BEGIN_VISP_NAMESPACE

namespace {
// A point that is farther than this from where a pose has it does not support the pose, pixels.
const double pointReach = 2.;

// 1 for a distance of 0, falling to 0 at the reach.
double closeness(double distance, double reach)
{
  const double share = distance / reach;
  return std::max(0., 1. - share * share);
}
} // namespace

void vpTrackedPoints::setSettings(const vpPointCueSettings &settings)
{
  settings.check();
  if (m_points) {
    m_points->setSettings(settings);
  }
  m_settings = settings;
}

void vpTrackedPoints::setUsed(bool isUsed, vpModelLooks &looks)
{
  if (!isUsed) {
    m_points.reset();
    return;
  }
  if (!m_points) {
    m_points = std::make_unique<vpPointCue>(m_settings);
    m_points->setDepthSource([&looks](const vpHomogeneousMatrix &cMo) { return &looks.renderDepth(cMo); });
  }
}

vpTrackedPoints::Agreeing vpTrackedPoints::agreeing(const vpHomogeneousMatrix &cMo, const vpCameraParameters &camera)
{
  m_points->residuals(cMo, m_block);
  Agreeing result;
  for (std::size_t i = 0; i + 1 < m_block.rows.size(); i += 2) {
    const double distance = std::hypot(m_block.rows[i].error, m_block.rows[i + 1].error);
    result.sum += closeness(distance, pointReach / camera.get_px());
  }
  result.found = m_block.rows.size() / 2;
  return result;
}

std::optional<double> vpTrackedPoints::agreement(const vpHomogeneousMatrix &cMo, const vpCameraParameters &camera)
{
  const std::size_t searched = m_points->matches().size();
  return searched == 0 ? 0. : agreeing(cMo, camera).sum / static_cast<double>(searched);
}

std::string vpTrackedPoints::missing() const
{
  const std::size_t known = m_points->pointCount();
  return known == 0 ? "no texture: 0 points on the surface"
                    : "none of " + std::to_string(known) + " points on the surface was found in the image";
}

// Those that agree with the pose nevertheless are the object's.
void vpTrackedPoints::learnRefused(const vpHomogeneousMatrix &cMo, const vpCameraParameters &camera)
{
  m_points->residuals(cMo, m_block);
  std::vector<double> weights;
  const double largest = pointReach / camera.get_px();
  for (const vpResidual &row : m_block.rows) {
    weights.push_back(std::fabs(row.error) < largest ? 1. : 0.);
  }
  m_points->updateReference(cMo, weights);
}

// They followed something else; without a search they may find the object again by themselves.
void vpTrackedPoints::noteLoss(bool isSearched)
{
  if (isSearched) {
    m_points->reset();
  }
}

void vpTrackedPoints::forget(vpModelLooks &)
{
  if (m_points) {
    m_points->reset();
  }
}

END_VISP_NAMESPACE
