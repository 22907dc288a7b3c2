// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpTrackingOutcome_h
#define vpTrackingOutcome_h

#include "cues/vpCueSet.h"
#include "estimate/vpCueFusion.h"

#include <visp3/multicue/vpMbTrackingResult.h>
#include <visp3/multicue/vpTrackingState.h>

#include <string>

BEGIN_VISP_NAMESPACE

//! What the last frame came to: state, reason, and the features that support the pose.
struct vpTrackingOutcome
{
  using Reason = vpMbTrackingResult::Reason;

  //! Features of one cue, or of all of them.
  struct Support
  {
    unsigned int expected = 0; //!< That were searched for.
    unsigned int good = 0;     //!< That the robust estimation kept.
  };

  //! Counts the features. \param isEstimated False where there is no pose for them to support.
  void countSupport(bool isEstimated, const vpCueSet &cues, const vpCueFusion &fusion);
  //! State and reason by the features alone. \param goodRatio Share of them that TRACKING needs.
  void judgeSupport(double goodRatio);
  //! Both, of a frame's last minimisation.
  void judge(bool isEstimated, const vpCueSet &cues, const vpCueFusion &fusion, double goodRatio)
  {
    countSupport(isEstimated, cues, fusion);
    judgeSupport(goodRatio);
  }
  //! By what the pose explains of the usual, where enough features support it.
  void judgeShare(double share);
  void set(vpTrackingState newState, Reason newReason)
  {
    state = newState;
    reason = newReason;
  }
  //! A pose that no image can show.
  void setUnseen(const std::string &why);
  bool isLost() const { return state == vpTrackingState::LOST; }
  bool isTracking() const { return state == vpTrackingState::TRACKING; }
  //! Share of the features that support the pose.
  double support() const { return all.expected == 0 ? 0. : static_cast<double>(all.good) / all.expected; }

  static vpTrackingState stateOf(double share);
  static Reason reasonOf(vpTrackingState state);

  vpTrackingState state = vpTrackingState::UNCERTAIN;
  Reason reason = Reason::NOT_STARTED;
  std::string text;       //!< The same as a sentence.
  std::string failure;    //!< What ended working in the frame and was done without; mostly nothing.
  bool isJudged = false;  //!< An image was tracked since the start.
  bool usesPoints = true; //!< They do not contradict the other cues at the pose.
  Support all;
  std::array<Support, vpCueKinds::most> of; //!< Of each cue, in the order of vpCueKinds.
};

END_VISP_NAMESPACE
#endif
