// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpPoseJudge_h
#define vpPoseJudge_h

#include "search/vpImageScore.h"

BEGIN_VISP_NAMESPACE

//! What the image says of a pose that the cues were matched near, beside what it said of trusted ones.
class vpPoseJudge
{
public:
  vpPoseJudge(const vpModelLooks &looks, vpCueSet &cues, const vpObjectMotion &motion,
              const vpObjectKnowledge &knowledge, const vpImageScore &score, const vpSituation &situation)
      : m_looks(looks), m_cues(cues), m_motion(motion), m_knowledge(knowledge), m_score(score), m_situation(situation)
  {
  }

  //! By all cues in use.
  vpVerdict at(const vpHomogeneousMatrix &cMo) const;
  //! By edges alone, without and with the distance map.
  vpVerdict byEvidence(const vpHomogeneousMatrix &cMo) const;
  vpVerdict byMap(const vpHomogeneousMatrix &cMo) const;
  //! Each cue's agreement as it is, at the pose of a start.
  vpAgreement agreementAtStart(const vpHomogeneousMatrix &cMo, bool looksAtMap) const;

  //! What speaks against a pose that shows fewer edges than usual: it may explain a part of what it should.
  double fewEdgesPenalty(const vpAgreement &agreement) const;
  //! The image shows something else than what is remembered of the surface.
  bool isContradicted(const vpAgreement &agreement) const;
  //! Edges alone speak for the pose.
  bool isDisowned(const vpAgreement &agreement) const;
  //! After a loss: no other pose looks like this one.
  bool isDecisive(const vpAgreement &agreement) const;

private:
  void lookAtEdges(const vpHomogeneousMatrix &cMo, vpAgreement &agreement) const;
  double mapShare(const vpHomogeneousMatrix &cMo, vpAgreement &agreement) const;
  void addEdges(const vpHomogeneousMatrix &cMo, vpVerdict &verdict) const;
  void addCuesBesideEdges(const vpHomogeneousMatrix &cMo, vpVerdict &verdict) const;
  void addSurface(const vpHomogeneousMatrix &cMo, vpVerdict &verdict) const;
  void addPoints(const vpHomogeneousMatrix &cMo, vpVerdict &verdict) const;
  double weightBesideEdges(double variance) const;
  double mostBesideEdges(const vpAgreement &agreement) const;

  const vpModelLooks &m_looks;
  vpCueSet &m_cues;
  const vpObjectMotion &m_motion;
  const vpObjectKnowledge &m_knowledge;
  const vpImageScore &m_score;
  const vpSituation &m_situation;
};

END_VISP_NAMESPACE
#endif
