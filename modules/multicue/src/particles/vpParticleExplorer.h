// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpParticleExplorer_h
#define vpParticleExplorer_h

#include "judge/vpTrackingOutcome.h"
#include "particles/vpRivalPoses.h"

BEGIN_VISP_NAMESPACE

//! Many poses at once. With edges alone: the particle filter of [T10] III-E, whose particles are drawn to where pose
//! hypotheses lead. With several cues particles follow what was estimated, and tell what else the image allows.
class vpParticleExplorer
{
public:
  vpParticleExplorer(const vpModelLooks &looks, vpEdgeEstimator &edges, const vpObjectMotion &motion,
                     vpImageScore &score, const vpRoughStart &rough, vpRivalPoses &rivals,
                     vpTrackerParticles &particles, vpTrackingOutcome &outcome)
      : m_looks(looks), m_edges(edges), m_motion(motion), m_score(score), m_rough(rough), m_rivals(rivals),
        m_particles(particles), m_outcome(outcome)
  {
  }

  //! With edges alone, before the pose is estimated. That then goes on from the pose before as without particles:
  //! theirs is not taken before several frames speak for it. \param expected Pose that it goes on from.
  void lookAround(const vpFrameContext &frame, const vpHomogeneousMatrix &expected);
  //! After it: the weights, and what they say of the pose. \return The pose to go on with.
  vpHomogeneousMatrix weigh(const vpFrameContext &frame, const vpHomogeneousMatrix &estimated);
  //! With several cues. \param proposals Poses that attempts of this frame led to.
  void update(const vpFrameContext &frame, const vpHomogeneousMatrix &cMo,
              const std::vector<vpHomogeneousMatrix> &proposals);

private:
  void move(const vpFrameContext &frame);
  vpImageRegion region(const vpCueFrame &image) const;
  double distanceAt(const vpHomogeneousMatrix &cMb) const;

  const vpModelLooks &m_looks;
  vpEdgeEstimator &m_edges;
  const vpObjectMotion &m_motion;
  vpImageScore &m_score;
  const vpRoughStart &m_rough;
  vpRivalPoses &m_rivals;
  vpTrackerParticles &m_particles;
  vpTrackingOutcome &m_outcome;
};

END_VISP_NAMESPACE
#endif
