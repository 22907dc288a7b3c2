// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpTwinComparison_h
#define vpTwinComparison_h

#include "frame/vpSearchSize.h"
#include "starts/vpAttempts.h"
#include "estimate/vpEdgeEstimator.h"
#include "judge/vpFoundPoseTwins.h"

BEGIN_VISP_NAMESPACE

//! Compares the pose where the object was found with its twins, by what only one of two poses has. A pose that was
//! found may be one that looks much alike, and what tells them apart is seen in some images only.
class vpTwinComparison
{
public:
  vpTwinComparison(vpModelLooks &looks, vpCueSet &cues, vpFusedEstimator &estimator, vpEdgeEstimator &edges,
                   vpImageScore &score, const vpObjectKnowledge &knowledge, const vpAlikePoses &alike,
                   const vpTrackerSymmetries &symmetries, const vpHalfTurns &halfTurns, const vpFoundPoseProof &proof,
                   vpFoundPoseTwins &twins)
      : m_looks(looks), m_cues(cues), m_estimator(estimator), m_edges(edges), m_score(score), m_knowledge(knowledge),
        m_alike(alike), m_symmetries(symmetries), m_halfTurns(halfTurns), m_proof(proof), m_twins(twins)
  {
  }

  //! \param followed Pose that is followed. \param hasMoved Becomes true where cues are no longer at it. \return The
  //! twin that turned out to be the right pose, if any did.
  std::optional<vpHomogeneousMatrix> compare(const vpFrameContext &frame, const vpHomogeneousMatrix &followed,
                                             bool &hasMoved);

private:
  using Twin = vpFoundPoseTwins::Twin;

  void search(const vpFrameContext &frame, const vpHomogeneousMatrix &followed);
  void weigh(const vpFrameContext &frame, const vpHomogeneousMatrix &followed);
  std::optional<vpHomogeneousMatrix> right(const vpFrameContext &frame, const vpHomogeneousMatrix &followed);
  std::optional<vpHomogeneousMatrix> refine(const vpFrameContext &frame, const vpHomogeneousMatrix &cMo,
                                            vpContourEvidence &contours);

  vpModelLooks &m_looks;
  vpCueSet &m_cues;
  vpFusedEstimator &m_estimator;
  vpEdgeEstimator &m_edges;
  vpImageScore &m_score;
  const vpObjectKnowledge &m_knowledge;
  const vpAlikePoses &m_alike;
  const vpTrackerSymmetries &m_symmetries;
  const vpHalfTurns &m_halfTurns;
  const vpFoundPoseProof &m_proof;
  vpFoundPoseTwins &m_twins;

  vpEdgeCue m_plainEdges; // Without memory.
  vpSearchSize m_size;
};

END_VISP_NAMESPACE
#endif
