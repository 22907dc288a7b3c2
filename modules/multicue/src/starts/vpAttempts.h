// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpAttempts_h
#define vpAttempts_h

#include "estimate/vpFusedEstimator.h"
#include "judge/vpJudgedPose.h"
#include "judge/vpPoseJudge.h"
#include "starts/vpWhereabouts.h"
#include "symmetry/vpAlikePoses.h"

BEGIN_VISP_NAMESPACE

//! The poses that a frame's starts led to, and the best of them. The one loop that estimates and judges: whoever looks
//! for poses hands its starts to attempt(), one at a time.
class vpAttempts
{
public:
  struct Attempt : vpJudgedPose
  {
    vpHomogeneousMatrix cMo;
    vpCueShare share;
    bool usesPoints = false;
  };

  vpAttempts(vpFusedEstimator &estimator, const vpPoseJudge &judge, const vpModelLooks &looks, const vpCueSet &cues,
             const vpObjectMotion &motion, vpObjectKnowledge &knowledge, vpImageScore &score,
             const vpWhereabouts &whereabouts, const vpAlikePoses &alike, vpSituation &situation)
      : m_estimator(estimator), m_judge(judge), m_looks(looks), m_cues(cues), m_motion(motion), m_knowledge(knowledge),
        m_score(score), m_whereabouts(whereabouts), m_alike(alike), m_situation(situation)
  {
  }

  //! A frame begins.
  void begin();
  //! Estimates and judges; where there is a pose already, only if that ends in time. \return True where the pose is
  //! enough, and no other one has to be looked for.
  bool attempt(const vpFrameContext &frame, const vpStart &start);
  //! The likeliest poses of a search. \return True where one of them is enough.
  bool attemptBest(const vpFrameContext &frame, vpPoseSearch &search, bool byColors = true);
  //! With edges alone there is one pose, and what it explains.
  void setOnly(const vpHomogeneousMatrix &cMo, double explained);
  //! Keyframes were seen that the attempts before did not know of.
  void learnKeyframes();

  const Attempt &best() const { return m_best; }
  bool hasBest() const { return m_best.explained >= 0.; }
  //! Goes back to what was the best one.
  void setBest(const Attempt &attempt);
  //! Nothing that was attempted counts any more.
  void forgetBest() { setBest(Attempt()); }
  //! The cues are no longer at the best pose.
  void noteMoved() { m_bestIsLast = false; }
  //! Brings the cues to the best pose, and after a loss to the one that looks like it and is nearest.
  vpEstimate settle(const vpFrameContext &frame);
  //! What was said of the pose that was judged last.
  const vpVerdict &verdict() const { return m_verdict; }
  //! Poses that attempts led to.
  const std::vector<vpHomogeneousMatrix> &attempted() const { return m_attempted; }

private:
  bool take(const vpEstimate &estimate);
  double valueAfterLoss(const vpEstimate &estimate, double share);
  bool mustCompare(const vpHomogeneousMatrix &cMo);
  vpEstimate nearestAlike(const vpFrameContext &frame, const vpEstimate &estimate);

  vpFusedEstimator &m_estimator;
  const vpPoseJudge &m_judge;
  const vpModelLooks &m_looks;
  const vpCueSet &m_cues;
  const vpObjectMotion &m_motion;
  vpObjectKnowledge &m_knowledge;
  vpImageScore &m_score;
  const vpWhereabouts &m_whereabouts;
  const vpAlikePoses &m_alike;
  vpSituation &m_situation;

  Attempt m_best;
  bool m_bestIsLast = false;
  vpEstimate m_last;
  vpVerdict m_verdict;
  std::vector<vpHomogeneousMatrix> m_attempted;
};

END_VISP_NAMESPACE
#endif
