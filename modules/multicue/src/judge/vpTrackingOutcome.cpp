// SPDX-License-Identifier: GPL-2.0-or-later
#include "judge/vpTrackingOutcome.h"

#include "judge/vpJudgedPose.h"

#include <algorithm>

BEGIN_VISP_NAMESPACE

namespace {
// Rows with less robust weight do not count as support.
const double goodWeight = 0.1;
// Fewer features than this happen to agree anywhere.
const unsigned int fewestGood = 8;
} // namespace

const char *toString(vpTrackingState state)
{
  switch (state) {
  case vpTrackingState::TRACKING:
    return "TRACKING";
  case vpTrackingState::UNCERTAIN:
    return "UNCERTAIN";
  case vpTrackingState::LOST:
    break;
  }
  return "LOST";
}

const char *toString(vpMbTrackingResult::Reason reason)
{
  using Reason = vpMbTrackingResult::Reason;
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

void vpTrackingOutcome::countSupport(bool isEstimated, const vpCueSet &cues, const vpCueFusion &fusion)
{
  of.fill(Support());
  for (const vpCueSet::Used &used : cues.used()) {
    of[vpCueKinds::indexOf(used.kind->type)].expected = used.cue->expected();
  }
  for (std::size_t i = 0; isEstimated && i < fusion.size(); ++i) {
    const std::vector<double> &weights = fusion[i].weights;
    of[vpCueKinds::indexOf(fusion[i].type)].good = static_cast<unsigned int>(
        std::count_if(weights.begin(), weights.end(), [](double weight) { return weight > goodWeight; }));
  }
  all = Support();
  for (const Support &part : of) {
    all.expected += part.expected;
    all.good += part.good;
  }
}

void vpTrackingOutcome::judgeSupport(double goodRatio)
{
  const double needed = goodRatio * all.expected;
  if (all.good < fewestGood || all.good < 0.5 * needed) {
    set(vpTrackingState::LOST, all.good == 0 ? Reason::NOTHING_SEEN : Reason::FEW_FEATURES);
  } else {
    state = all.good < needed ? vpTrackingState::UNCERTAIN : vpTrackingState::TRACKING;
    reason = reasonOf(state);
  }
  isJudged = true;
  text = std::to_string(all.good) + " of " + std::to_string(all.expected) + " features support the pose";
}

void vpTrackingOutcome::judgeShare(double share)
{
  if (!isLost()) {
    state = stateOf(share);
    reason = reasonOf(state);
  }
}

void vpTrackingOutcome::setUnseen(const std::string &why)
{
  set(vpTrackingState::LOST, Reason::NOTHING_SEEN);
  text = why;
  all = Support();
  of.fill(Support());
}

vpTrackingState vpTrackingOutcome::stateOf(double share)
{
  if (share < vpJudgedPose::leastExplained) {
    return vpTrackingState::LOST;
  }
  return share < vpJudgedPose::badlyExplained ? vpTrackingState::UNCERTAIN : vpTrackingState::TRACKING;
}

vpMbTrackingResult::Reason vpTrackingOutcome::reasonOf(vpTrackingState state)
{
  switch (state) {
  case vpTrackingState::TRACKING:
    return Reason::WELL_EXPLAINED;
  case vpTrackingState::UNCERTAIN:
    return Reason::PARTLY_EXPLAINED;
  case vpTrackingState::LOST:
    break;
  }
  return Reason::CONTRADICTED;
}

END_VISP_NAMESPACE
