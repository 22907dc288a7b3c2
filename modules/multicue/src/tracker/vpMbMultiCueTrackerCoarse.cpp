// SPDX-License-Identifier: GPL-2.0-or-later
#include <visp3/multicue/vpMbMultiCueTracker.h>

#include "hypotheses/vpControlPointMotion.h"
#include "frame/vpStopwatch.h"
#include "tracker/vpTrackerState.h"

#include <algorithm>

BEGIN_VISP_NAMESPACE

namespace {
// Fewer points found tell no pose by themselves.
const std::size_t fewestPoints = 12;
// Share of the points looked for that have to agree on a pose.
const double leastAgreeing = 0.5;
// Points that move the object by more than this have to agree with the colours, pixels.
const double contradiction = 3.;
// A level of the colours that is fine enough to tell poses apart, and reaches far enough to be wrong about both.
const unsigned int evidenceLevel = 1;
// Share of the usual evidence from which on the contour is within reach of that level.
const double nearContour = 0.75;
// A view serves poses that move its control points by less than this, pixels; coarse levels: times their scale.
const double nearMotion = 0.5;
} // namespace

// Few points, or many that disagree, are those of something else, or of a pose too far away to find them.
bool vpMbMultiCueTracker::pointsAgree() const
{
  const std::vector<double> &weights = m_impl->fusion[0].weights;
  const auto kept = static_cast<std::size_t>(
      std::count_if(weights.begin(), weights.end(), [](double weight) { return weight > 0.; }));
  return kept >= 2 * fewestPoints &&
         static_cast<double>(kept) >= 2. * leastAgreeing * static_cast<double>(m_impl->points->matches().size());
}

// How well the colours agree with a pose, see vpColorCue::evidence().
double vpMbMultiCueTracker::colorEvidence(const vpCueFrame &frame, const vpHomogeneousMatrix &cMo)
{
  Impl &impl = *m_impl;
  updateView(frame, cMo, nearMotion);
  const vpStopwatch stage(impl.timings.match);
  impl.color.setLevel(evidenceLevel);
  impl.color.match(frame, *impl.view);
  return impl.color.evidence();
}

// Points reach far. Those of what passes in front of the object agree on a pose, too, but the colours do not.
void vpMbMultiCueTracker::estimateByPoints(const vpCueFrame &frame)
{
  Impl &impl = *m_impl;
  {
    const vpStopwatch stage(impl.timings.match);
    impl.points->match(frame, *impl.view);
  }
  impl.usesPoints = true;
  const vpHomogeneousMatrix cMoBefore = m_cMo;
  if (!minimise({KLT_TRACKER}) || !pointsAgree()) {
    m_cMo = cMoBefore;
    return;
  }
  const bool hasCoarse = impl.uses(COLOR_TRACKER) && evidenceLevel < impl.color.settings().scales.size();
  if (!hasCoarse || vpControlPointMotion::mean(*impl.view, m_cMo, frame.camera()) < contradiction) {
    return;
  }
  const double before = colorEvidence(frame, cMoBefore);
  if (colorEvidence(frame, m_cMo) < before) {
    m_cMo = cMoBefore;
    impl.usesPoints = false;
  }
}

// Points and the coarse levels of the colours reach far, and bring the pose to where the fine cues find theirs.
void vpMbMultiCueTracker::estimateCoarse(const vpCueFrame &frame)
{
  Impl &impl = *m_impl;
  updateView(frame, m_cMo, 0.);
  impl.usesPoints = false;
  if (impl.uses(KLT_TRACKER)) {
    estimateByPoints(frame);
  }
  if (impl.uses(COLOR_TRACKER)) {
    estimateByCoarseColors(frame);
  }
}

// Coarse to fine; the levels that reach far are left out where the contour is near already.
void vpMbMultiCueTracker::estimateByCoarseColors(const vpCueFrame &frame)
{
  Impl &impl = *m_impl;
  const unsigned int levels = static_cast<unsigned int>(impl.color.settings().scales.size());
  unsigned int level = 0;
  if (levels > evidenceLevel &&
      colorEvidence(frame, m_cMo) >= nearContour * std::max(impl.usual.color, Impl::leastUsual)) {
    level = evidenceLevel;
  }
  for (bool again = level == 0; level < levels;) {
    updateView(frame, m_cMo, nearMotion * impl.color.settings().scales[level]);
    {
      const vpStopwatch stage(impl.timings.match);
      impl.color.setLevel(level);
      impl.color.match(frame, *impl.view);
    }
    const vpHomogeneousMatrix cMoBefore = m_cMo;
    if (!minimise({COLOR_TRACKER, KLT_TRACKER})) {
      m_cMo = cMoBefore;
    }
    level += again ? 0 : 1; // The coarsest one twice: its lines reach farther when they lie better.
    again = false;
  }
}

END_VISP_NAMESPACE
