// SPDX-License-Identifier: GPL-2.0-or-later
#include <visp3/multicue/vpMbMultiCueTracker.h>

#include "tracker/vpTrackerState.h"

#include <visp3/se3/vpPoseImageDeviation.h>

#include <algorithm>
#include <cmath>

BEGIN_VISP_NAMESPACE

namespace {
// Standard deviations of where a point is expected.
const double reach = 3.;
// Shorter searches miss what the contour's own inaccuracy moves, pixels.
const double leastRange = 6.;
// Of the default range, where the user set none.
const double most = 2.;
} // namespace

void vpMbMultiCueTracker::setPredictedRange(bool flag)
{
  m_impl->rangeIsPredicted = flag;
}

// By the corner of the object's box whose place is known least.
void vpMbMultiCueTracker::predictRange(const vpPoseMatrix6 &covariance)
{
  Impl &impl = *m_impl;
  if (!impl.rangeIsPredicted) {
    return;
  }
  double largest = 0.;
  for (unsigned int i = 0; i < 8; ++i) {
    const Eigen::Vector3d corner(((i & 1U) ? impl.model->boxMax() : impl.model->boxMin()).x(),
                                 ((i & 2U) ? impl.model->boxMax() : impl.model->boxMin()).y(),
                                 ((i & 4U) ? impl.model->boxMax() : impl.model->boxMin()).z());
    // The trace bounds the variance in any direction, and needs no eigenvalues.
    largest = std::max(largest, vpPoseImageDeviation::covariance(m_cam, m_cMo, covariance, corner).trace());
  }
  const double set = impl.edges.settings().range;
  const double usual = vpEdgeCueSettings().range;
  const double longest = set == usual ? most * usual : set;
  impl.predictedRange = std::min(std::max(reach * std::sqrt(largest), leastRange), longest);
}

void vpMbMultiCueTracker::matchEdges(const vpCueFrame &frame)
{
  Impl &impl = *m_impl;
  const vpEdgeCueSettings asSet = impl.edges.settings();
  if (impl.predictedRange > 0.) {
    vpEdgeCueSettings settings = asSet;
    settings.range = impl.predictedRange;
    impl.edges.setSettings(settings);
  }
  impl.edges.match(frame, *impl.view);
  impl.edges.setSettings(asSet);
}

END_VISP_NAMESPACE
