// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpEdgeFollower_h
#define vpEdgeFollower_h

#include "engine/vpEngineSettings.h"
#include "engine/vpRoughStarter.h"
#include "starts/vpAttempts.h"
#include "starts/vpHintedStarts.h"

#include <optional>

BEGIN_VISP_NAMESPACE

//! Follows the object by edges alone. An image's evidence for a pose is then all that tells a right one from a wrong
//! one.
class vpEdgeFollower
{
public:
  vpEdgeFollower(const vpEngineSettings &settings, vpModelLooks &looks, vpCueSet &cues, vpPoseMinimiser &minimiser,
                 vpEdgeEstimator &edges, vpObjectMotion &motion, const vpObjectKnowledge &knowledge,
                 vpImageScore &score, const vpPoseJudge &judge, vpSituation &situation, vpStartCapture &capture,
                 vpHintedStarts &hints, vpRoughStarter &starter, vpTrackingOutcome &outcome)
      : m_settings(settings), m_looks(looks), m_cues(cues), m_minimiser(minimiser), m_edges(edges), m_motion(motion),
        m_knowledge(knowledge), m_score(score), m_judge(judge), m_situation(situation), m_capture(capture),
        m_hints(hints), m_starter(starter), m_outcome(outcome)
  {
  }

  void forgetImages();
  //! From the pose that is expected; where the image does not show the object there, in another light, and around the
  //! pose that was trusted last. \param before The last frame's pose.
  vpHomogeneousMatrix follow(const vpFrameContext &frame, const vpHomogeneousMatrix &expected,
                             const vpHomogeneousMatrix &before);
  //! The better one of a pose and those of a hint.
  vpHomogeneousMatrix compareHint(const vpFrameContext &frame, const vpHomogeneousMatrix &tracked);
  //! With a search for what is lost the distance map decides, since what hides the object leaves few of the matches of
  //! a right pose.
  void judgeByMap(const vpFrameContext &frame, const vpHomogeneousMatrix &cMo, bool isMapped);
  //! What was said of the pose.
  const vpVerdict &verdict() const { return m_verdict; }
  //! True where the object was lost, and no pose found since is confirmed.
  bool mustConfirm() const { return m_edgesBeforeLoss.has_value(); }

private:
  vpHomogeneousMatrix judged(const vpEstimate &estimate);
  vpHomogeneousMatrix captureAgain(const vpFrameContext &frame, const vpHomogeneousMatrix &cMo);
  void confirm(const vpFrameContext &frame, const vpHomogeneousMatrix &cMo);

  const vpEngineSettings &m_settings;
  vpModelLooks &m_looks;
  vpCueSet &m_cues;
  vpPoseMinimiser &m_minimiser;
  vpEdgeEstimator &m_edges;
  vpObjectMotion &m_motion;
  const vpObjectKnowledge &m_knowledge;
  vpImageScore &m_score;
  const vpPoseJudge &m_judge;
  vpSituation &m_situation;
  vpStartCapture &m_capture;
  vpHintedStarts &m_hints;
  vpRoughStarter &m_starter;
  vpTrackingOutcome &m_outcome;

  vpVerdict m_verdict;
  std::optional<vpEdgeCue> m_edgesBeforeLoss; // Until a pose is confirmed.
};

END_VISP_NAMESPACE
#endif
