// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpConfirmation_h
#define vpConfirmation_h

#include "judge/vpPoseJudge.h"
#include "starts/vpWhereabouts.h"

BEGIN_VISP_NAMESPACE

//! Whether a pose that was found after a loss may be trusted.
class vpConfirmation
{
public:
  vpConfirmation(const vpCueSet &cues, const vpObjectKnowledge &knowledge, const vpPoseJudge &judge,
                 const vpWhereabouts &whereabouts, const vpSituation &situation)
      : m_cues(cues), m_knowledge(knowledge), m_judge(judge), m_whereabouts(whereabouts), m_situation(situation)
  {
  }

  //! By frames on end that explain the pose, or by others that were looked for in vain; not before others were looked
  //! for. \param agreement Of the cues with the pose. \param inside Share of the outline that is in the image.
  bool isDue(const vpHomogeneousMatrix &cMo, const vpAgreement &agreement, double inside) const;

private:
  const vpCueSet &m_cues;
  const vpObjectKnowledge &m_knowledge;
  const vpPoseJudge &m_judge;
  const vpWhereabouts &m_whereabouts;
  const vpSituation &m_situation;
};

END_VISP_NAMESPACE
#endif
