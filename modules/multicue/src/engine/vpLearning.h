// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpLearning_h
#define vpLearning_h

#include "engine/vpEngineSettings.h"
#include "estimate/vpEdgeEstimator.h"
#include "estimate/vpPoseCovariance.h"
#include "judge/vpFoundPoseProof.h"
#include "judge/vpFoundPoseTwins.h"
#include "judge/vpPoseJudge.h"
#include "judge/vpTrackingOutcome.h"
#include "particles/vpTrackerParticles.h"
#include "starts/vpRoughStart.h"

BEGIN_VISP_NAMESPACE

//! What images teach, to all parts: at a start, and at poses that are trusted. What is learnt from a wrong pose keeps
//! it wrong.
class vpLearning
{
public:
  vpLearning(const vpEngineSettings &settings, vpModelLooks &looks, vpCueSet &cues, vpPoseMinimiser &minimiser,
             vpEdgeEstimator &edges, vpPoseCovariance &covariance, const vpTrackerSymmetries &symmetries,
             vpObjectMotion &motion, vpObjectKnowledge &knowledge, vpImageScore &score, const vpPoseJudge &judge,
             vpSituation &situation, vpFoundPoseProof &proof, vpFoundPoseTwins &twins, vpTrackerParticles &particles,
             vpRoughStart &rough, vpRandomStreams &streams, vpTrackingOutcome &outcome)
      : m_settings(settings), m_looks(looks), m_cues(cues), m_minimiser(minimiser), m_edges(edges),
        m_covariance(covariance), m_symmetries(symmetries), m_motion(motion), m_knowledge(knowledge), m_score(score),
        m_judge(judge), m_situation(situation), m_proof(proof), m_twins(twins), m_particles(particles), m_rough(rough),
        m_streams(streams), m_outcome(outcome)
  {
  }

  //! Forgets what was learnt from images.
  void forget();
  //! The object is taken to be at a pose.
  void trust(const vpHomogeneousMatrix &cMo, const vpPoseTangent &velocity = vpPoseTangent::Zero());
  //! What the image shows at the pose of a start.
  void learnStart(const vpFrameContext &frame, const vpHomogeneousMatrix &cMo);
  //! From a pose that is trusted. \param value Of it, see vpJudgedPose.
  void learn(const vpFrameContext &frame, const vpHomogeneousMatrix &cMo, const vpVerdict &verdict, double value);
  //! The pose that is not trusted may be the one that was followed: how it moves is known.
  void followDoubtful(const vpHomogeneousMatrix &cMo);
  //! After the frame's pose is known.
  void updateCovariance(const vpHomogeneousMatrix &cMo);
  //! True where nothing in the last image showed a turn about an axis of the object's shape.
  bool holdsTurns() const { return m_symmetries.hasAxis() && !m_minimiser.fusion().showsAll(); }

private:
  void learnReferences(const vpHomogeneousMatrix &cMo);
  void learnReferencesOfStart(const vpFrameContext &frame, const vpHomogeneousMatrix &cMo);
  bool usesKeyframes() const { return m_settings.searches && m_cues.uses(vpCueSet::POINT); }
  void updateMotion(const vpHomogeneousMatrix &cMo, double doubt);
  bool usesVelocity() const;

  const vpEngineSettings &m_settings;
  vpModelLooks &m_looks;
  vpCueSet &m_cues;
  vpPoseMinimiser &m_minimiser;
  vpEdgeEstimator &m_edges;
  vpPoseCovariance &m_covariance;
  const vpTrackerSymmetries &m_symmetries;
  vpObjectMotion &m_motion;
  vpObjectKnowledge &m_knowledge;
  vpImageScore &m_score;
  const vpPoseJudge &m_judge;
  vpSituation &m_situation;
  vpFoundPoseProof &m_proof;
  vpFoundPoseTwins &m_twins;
  vpTrackerParticles &m_particles;
  vpRoughStart &m_rough;
  vpRandomStreams &m_streams;
  vpTrackingOutcome &m_outcome;
};

END_VISP_NAMESPACE
#endif
