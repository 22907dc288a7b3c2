// SPDX-License-Identifier: GPL-2.0-or-later
#include "hypotheses/vpRankedPoses.h"

#include "hypotheses/vpControlPointMotion.h"

#include <algorithm>
#include <cmath>

BEGIN_VISP_NAMESPACE

namespace {
// A pose that moved its control points by more than this many search ranges has diverged.
const double maxMotion = 2.;
// What an edge's place is uncertain by, its model and its noise together.
const double edgeNoise = 1.; // Pixels.
} // namespace

void vpRankedPoses::start(std::size_t contours)
{
  m_contours = contours;
  m_kept.clear();
  m_poses.clear();
}

void vpRankedPoses::setError(Kept &kept, double error) const
{
  kept.pose.residue = std::sqrt(error);
  kept.cost = static_cast<double>(m_contours) * error / (edgeNoise * edgeNoise) + 0.5 * kept.motion * kept.motion;
}

void vpRankedPoses::add(const vpHomogeneousMatrix &cMo, double error, const std::vector<int> &classes,
                        const vpEdgeCue &edges, const vpModelView &view, double tolerance)
{
  Kept kept;
  kept.motion = vpControlPointMotion::mean(view, cMo, edges.camera()) / edges.settings().range;
  if (kept.motion > maxMotion) {
    return;
  }
  kept.pose.cMo = cMo;
  kept.pose.classes = classes;
  setError(kept, error);
  const auto same = std::find_if(m_kept.begin(), m_kept.end(), [&](const Kept &other) {
    return vpControlPointMotion::between(view, cMo, other.pose.cMo, edges.camera()) < tolerance;
  });
  if (same == m_kept.end()) {
    m_kept.push_back(kept);
  } else if (kept.cost < same->cost) {
    *same = kept;
  }
}

void vpRankedPoses::rank()
{
  std::stable_sort(m_kept.begin(), m_kept.end(), [](const Kept &a, const Kept &b) { return a.cost < b.cost; });
  double sum = 0.;
  for (Kept &kept : m_kept) {
    kept.pose.weight = std::exp(m_kept.front().cost - kept.cost);
    sum += kept.pose.weight;
  }
  m_poses.resize(m_kept.size()); // Their memory stays in use.
  for (std::size_t i = 0; i < m_kept.size(); ++i) {
    m_kept[i].pose.weight /= sum;
    m_poses[i] = m_kept[i].pose;
  }
}

void vpRankedPoses::refine(std::size_t index, const vpHomogeneousMatrix &cMo, double error)
{
  Kept &kept = m_kept.at(index);
  kept.pose.cMo = cMo;
  setError(kept, error);
  m_poses[index].cMo = cMo;
  m_poses[index].residue = kept.pose.residue;
}

END_VISP_NAMESPACE
