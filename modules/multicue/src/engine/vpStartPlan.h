// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpStartPlan_h
#define vpStartPlan_h

#include "engine/vpEngineSettings.h"
#include "judge/vpTrackingOutcome.h"
#include "starts/vpEverywhereSearch.h"
#include "starts/vpHintedStarts.h"
#include "starts/vpKeyframeStarts.h"
#include "starts/vpNearSearch.h"

BEGIN_VISP_NAMESPACE

//! From which poses a frame's attempts start, and in which order: the nearest and cheapest first, until one is enough.
class vpStartPlan
{
public:
  vpStartPlan(const vpEngineSettings &settings, const vpModelLooks &looks, vpCueSet &cues, vpEdgeEstimator &edges,
              vpObjectMotion &motion, const vpFoundPoseProof &proof, const vpHalfTurns &halfTurns,
              const vpAlikePoses &alike, vpSituation &situation, const vpTrackingOutcome &outcome,
              vpHintedStarts &hints, vpRoughStart &rough, vpKeyframeStarts &keyframes, vpNearSearch &near,
              vpEverywhereSearch &everywhere, vpAttempts &attempts)
      : m_settings(settings), m_looks(looks), m_cues(cues), m_edges(edges), m_motion(motion), m_proof(proof),
        m_halfTurns(halfTurns), m_alike(alike), m_situation(situation), m_outcome(outcome), m_hints(hints),
        m_rough(rough), m_keyframes(keyframes), m_near(near), m_everywhere(everywhere), m_attempts(attempts)
  {
  }

  void run(const vpFrameContext &frame);

private:
  bool follow(const vpFrameContext &frame, const vpPoseTracks::Track &first);
  bool followInert(const vpFrameContext &frame);
  bool followAhead(const vpFrameContext &frame, const vpPoseTracks::Track &track);
  bool followOthers(const vpFrameContext &frame);
  bool tryHint(const vpFrameContext &frame);
  void tryOthers(const vpFrameContext &frame);
  void findAgain(const vpFrameContext &frame);
  bool followExpected(const vpFrameContext &frame);
  bool tryProposed(const vpFrameContext &frame);
  bool attemptProposed(const vpFrameContext &frame, const vpHomogeneousMatrix &cMo);
  bool tryKeyframes(const vpFrameContext &frame, bool isNear);

  const vpEngineSettings &m_settings;
  const vpModelLooks &m_looks;
  vpCueSet &m_cues;
  vpEdgeEstimator &m_edges;
  vpObjectMotion &m_motion;
  const vpFoundPoseProof &m_proof;
  const vpHalfTurns &m_halfTurns;
  const vpAlikePoses &m_alike;
  vpSituation &m_situation;
  const vpTrackingOutcome &m_outcome; // Of the frame before.
  vpHintedStarts &m_hints;
  vpRoughStart &m_rough;
  vpKeyframeStarts &m_keyframes;
  vpNearSearch &m_near;
  vpEverywhereSearch &m_everywhere;
  vpAttempts &m_attempts;
};

END_VISP_NAMESPACE
#endif
