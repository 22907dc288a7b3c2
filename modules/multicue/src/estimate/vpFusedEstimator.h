// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpFusedEstimator_h
#define vpFusedEstimator_h

#include "estimate/vpEstimate.h"
#include "estimate/vpPoseMinimiser.h"
#include "knowledge/vpObjectKnowledge.h"

BEGIN_VISP_NAMESPACE

//! Brings all cues to one start, coarse to fine ([P14] III).
class vpFusedEstimator
{
public:
  vpFusedEstimator(vpModelLooks &looks, vpCueSet &cues, vpPoseMinimiser &minimiser, const vpObjectMotion &motion,
                   const vpObjectKnowledge &knowledge, const vpTrackerSymmetries &symmetries)
      : m_looks(looks), m_cues(cues), m_minimiser(minimiser), m_motion(motion), m_knowledge(knowledge),
        m_symmetries(symmetries)
  {
  }

  vpEstimate from(const vpFrameContext &frame, const vpStart &start);
  //! The rounds of all cues alone. \param usesPoints As they were matched in this frame.
  vpEstimate refine(const vpFrameContext &frame, const vpStart &start, bool usesPoints);
  //! The colours' coarse levels alone.
  vpHomogeneousMatrix byCoarseColors(const vpFrameContext &frame, const vpStart &start, bool usesPoints);

private:
  bool minimise(const vpFrameContext &frame, int cues, const vpStart &start, vpHomogeneousMatrix &cMo);
  vpPosePrior priorOf(const vpStart &start, const vpHomogeneousMatrix &cMo) const;
  bool byPoints(const vpFrameContext &frame, const vpStart &start, vpHomogeneousMatrix &cMo);
  bool pointsAgree() const;
  double colorEvidence(const vpFrameContext &frame, const vpHomogeneousMatrix &cMo);
  int withPoints(int cues, bool usesPoints) const { return usesPoints ? cues | vpCueSet::POINT : cues; }

  vpModelLooks &m_looks;
  vpCueSet &m_cues;
  vpPoseMinimiser &m_minimiser;
  const vpObjectMotion &m_motion;
  const vpObjectKnowledge &m_knowledge;
  const vpTrackerSymmetries &m_symmetries;
};

END_VISP_NAMESPACE
#endif
