// SPDX-License-Identifier: GPL-2.0-or-later
#include <visp3/multicue/vpMbMultiCueTracker.h>

#include "tracker/vpTrackerState.h"
#include "estimate/vpUnobservedMotions.h"

#include <algorithm>
#include <limits>

BEGIN_VISP_NAMESPACE

namespace {
using Reason = vpMbTrackingResult::Reason;
} // namespace

const char *toString(vpMbTrackingResult::Reason reason)
{
  switch (reason) {
  case Reason::NOT_STARTED:
    return "NOT_STARTED";
  case Reason::WELL_EXPLAINED:
    return "WELL_EXPLAINED";
  case Reason::PARTLY_EXPLAINED:
    return "PARTLY_EXPLAINED";
  case Reason::NOTHING_SEEN:
    return "NOTHING_SEEN";
  case Reason::FEW_FEATURES:
    return "FEW_FEATURES";
  case Reason::CONTRADICTED:
    return "CONTRADICTED";
  case Reason::CONFIRMING:
    return "CONFIRMING";
  case Reason::COASTING:
    break;
  }
  return "COASTING";
}

// How far to believe the pose; the one place that turns what was measured into a number in [0, 1].
double vpMbMultiCueTracker::Impl::score() const
{
  if (!isJudged || good == 0) {
    return 0.;
  }
  return state == vpTrackingState::LOST ? 0. : believed();
}

vpMbTrackingResult::Cue vpMbMultiCueTracker::Impl::resultOf(int cue) const
{
  const double none = std::numeric_limits<double>::quiet_NaN();
  vpMbTrackingResult::Cue result;
  result.type = cue;
  result.expected = supportOf[indexOf(cue)].expected;
  result.good = supportOf[indexOf(cue)].good;
  if (cue == EDGE_TRACKER) {
    result.name = "edge";
    result.agreement = agreement.edges;
  } else if (cue == COLOR_TRACKER) {
    result.name = "color";
    result.agreement = agreement.color;
  } else {
    result.name = "point";
    result.agreement = type == KLT_TRACKER ? agreement.points : none;
  }
  if (good == 0 && result.agreement > 0.) {
    result.agreement = 0.; // What is remembered is of a frame before.
  }
  return result;
}

std::string vpMbMultiCueTracker::Impl::reasonText() const
{
  if (width == 0) {
    return "no initial pose was given";
  }
  const std::string detector = rough.detectorText.empty() ? "" : "; " + rough.detectorText;
  return reason + (outcome == Reason::COASTING ? "; the pose is the predicted one" : "") + detector;
}

vpMbTrackingResult vpMbMultiCueTracker::getTrackingResult() const
{
  const Impl &impl = *m_impl;
  vpMbTrackingResult result;
  result.cMo = m_cMo;
  if (computeCovariance) {
    result.covariance = getCovarianceMatrix();
  }
  result.state = impl.state;
  result.score = impl.score();
  result.reason = impl.outcome;
  result.text = impl.reasonText();
  for (const int cue : {EDGE_TRACKER, COLOR_TRACKER, KLT_TRACKER}) {
    if (impl.uses(cue)) {
      result.cues.push_back(impl.resultOf(cue));
      result.cues.back().reason = getCueReason(cue);
    }
  }
  if (impl.isJudged) {
    result.unobserved = vpUnobservedMotions(*impl.model, impl.symmetries).find(impl.fusion);
  }
  result.hypotheses = getPoseHypotheses();
  result.timings = impl.timings;
  return result;
}

END_VISP_NAMESPACE
