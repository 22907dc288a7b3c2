// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpLossWatch_h
#define vpLossWatch_h

#include "judge/vpConfirmation.h"
#include "judge/vpFoundPoseProof.h"
#include "judge/vpFoundPoseTwins.h"
#include "judge/vpJudgedPose.h"
#include "judge/vpTrackingOutcome.h"
#include "symmetry/vpAlikePoses.h"

BEGIN_VISP_NAMESPACE

//! Decides whether the object is followed, lost, found again, or still to be confirmed: the ladder of states.
class vpLossWatch
{
public:
  //! What the frame came to.
  struct Found
  {
    vpHomogeneousMatrix cMo;
    vpJudgedPose best;            //!< What speaks for the best pose that was attempted,
    vpHomogeneousMatrix bestPose; //!< and it.
    vpAgreement agreement;        //!< Of the cues with the pose.
  };

  vpLossWatch(const vpModelLooks &looks, vpCueSet &cues, vpObjectMotion &motion, vpObjectKnowledge &knowledge,
              vpImageScore &score, const vpPoseJudge &judge, const vpWhereabouts &whereabouts,
              const vpAlikePoses &alike, const vpHalfTurns &halfTurns, vpSituation &situation, vpFoundPoseProof &proof,
              vpFoundPoseTwins &twins, vpTrackingOutcome &outcome)
      : m_looks(looks), m_cues(cues), m_motion(motion), m_knowledge(knowledge), m_score(score),
        m_confirmation(cues, knowledge, judge, whereabouts, situation), m_alike(alike), m_halfTurns(halfTurns),
        m_situation(situation), m_proof(proof), m_twins(twins), m_outcome(outcome)
  {
  }

  //! After a loss, a frame begins. \param cMo Of the frame before.
  void beginAfterLoss(const vpHomogeneousMatrix &cMo);
  //! Ends the frame: the outcome becomes the final one. \param searches A lost object is looked for.
  void decide(const Found &found, bool searches);
  //! At a twin that won: what was learnt since the object was found is of the wrong pose.
  void startOver(const vpHomogeneousMatrix &cMo);
  //! How far to believe the pose, [0, 1].
  double score() const
  {
    const bool hasPose = m_outcome.isJudged && m_outcome.all.good > 0 && !m_outcome.isLost();
    return hasPose ? believed() : 0.;
  }

private:
  void recallLearnt();
  void beginTracks(const vpHomogeneousMatrix &cMo);
  void chooseTrack(const Found &found);
  void endTracks(const vpHomogeneousMatrix &cMo);
  void confirm(const Found &found);
  void confirmState(const Found &found);
  void believe(const Found &found, bool searches);
  void noteLoss();
  void noteFound(const vpHomogeneousMatrix &cMo);
  void startProof(const std::shared_ptr<const vpObjectKnowledge::Learnt> &known);
  double believed() const { return m_twins.believed(m_situation.belief.probability()); }
  //! True where attempts from several starts are compared.
  bool comparesAttempts() const { return !m_cues.isEdgesAlone() || m_situation.mustConfirm; }

  const vpModelLooks &m_looks;
  vpCueSet &m_cues;
  vpObjectMotion &m_motion;
  vpObjectKnowledge &m_knowledge;
  vpImageScore &m_score;
  const vpConfirmation m_confirmation;
  const vpAlikePoses &m_alike;
  const vpHalfTurns &m_halfTurns;
  vpSituation &m_situation;
  vpFoundPoseProof &m_proof;
  vpFoundPoseTwins &m_twins;
  vpTrackingOutcome &m_outcome;
};

END_VISP_NAMESPACE
#endif
