// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpRivalPoses_h
#define vpRivalPoses_h

#include "engine/vpEngineSettings.h"
#include "estimate/vpEdgeEstimator.h"
#include "judge/vpTrackingOutcome.h"
#include "particles/vpTrackerParticles.h"
#include "search/vpImageScore.h"
#include "starts/vpRoughStart.h"
#include "symmetry/vpAlikePoses.h"

BEGIN_VISP_NAMESPACE

//! With edges alone and particles: poses that pose hypotheses make of the best particles, and those of them that are
//! followed beside the object's until one turns out to be right. The estimation from the pose before has random
//! numbers and minimisations of its own, and does the same as without particles.
class vpRivalPoses
{
public:
  vpRivalPoses(const vpEngineSettings &settings, vpModelLooks &looks, vpCueSet &cues, vpPoseMinimiser &minimiser,
               vpEdgeEstimator &edges, vpImageScore &score, const vpTrackerSymmetries &symmetries,
               const vpAlikePoses &alike, vpTrackerParticles &particles, vpTrackingOutcome &outcome)
      : m_settings(settings), m_looks(looks), m_cues(cues), m_minimiser(minimiser), m_edges(edges), m_score(score),
        m_symmetries(symmetries), m_alike(alike), m_particles(particles), m_outcome(outcome)
  {
  }

  //! The best particles and the rivals. \param cMo Pose that the estimation goes on from.
  void optimise(const vpFrameContext &frame, const vpHomogeneousMatrix &cMo);
  //! Few particles were optimised, as the frame before was explained, and this one is not: all of it again with as many
  //! as are set. \return The pose that was estimated anew.
  vpHomogeneousMatrix lookAgain(const vpFrameContext &frame);
  //! Which pose explained the frames up to now best. \return That to go on with.
  vpHomogeneousMatrix compare(const vpFrameContext &frame, const vpHomogeneousMatrix &cMo);
  //! What the hypotheses found is proposed to the particles.
  void takeHypotheses();

private:
  vpHomogeneousMatrix optimiseParticles(const vpFrameContext &frame, const vpHomogeneousMatrix &cMo);
  void optimiseRivals(const vpFrameContext &frame, const vpHomogeneousMatrix &cMo);
  void optimiseRival(const vpFrameContext &frame, vpRivalPose &rival);
  void search(const vpFrameContext &frame, const vpHomogeneousMatrix &cMo);
  bool add(const vpHomogeneousMatrix &cMb);
  //! \return The least residue of them.
  double weigh(const vpHomogeneousMatrix &cMb, double residue);
  vpHomogeneousMatrix take(const vpFrameContext &frame, const vpHomogeneousMatrix &cMo, const vpHomogeneousMatrix &cMb,
                           bool isOld);
  void noteFollowed(const vpHomogeneousMatrix &cMb, bool isExplained);
  vpHomogeneousMatrix judged(const vpEstimate &estimate);

  const vpEngineSettings &m_settings;
  vpModelLooks &m_looks;
  vpCueSet &m_cues;
  vpPoseMinimiser &m_minimiser;
  vpEdgeEstimator &m_edges;
  vpImageScore &m_score;
  const vpTrackerSymmetries &m_symmetries;
  const vpAlikePoses &m_alike;
  vpTrackerParticles &m_particles;
  vpTrackingOutcome &m_outcome;
};

END_VISP_NAMESPACE
#endif
