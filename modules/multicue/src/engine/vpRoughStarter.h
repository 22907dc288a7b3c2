// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpRoughStarter_h
#define vpRoughStarter_h

#include "engine/vpLearning.h"
#include "estimate/vpFusedEstimator.h"
#include "symmetry/vpAlikePoses.h"

BEGIN_VISP_NAMESPACE

//! Starts at poses that are not exact: looks for the object about them, and follows what it found until the images
//! confirm or refuse it.
class vpRoughStarter
{
public:
  vpRoughStarter(vpModelLooks &looks, vpCueSet &cues, vpFusedEstimator &fused, vpEdgeEstimator &edges,
                 vpObjectMotion &motion, vpImageScore &score, const vpAlikePoses &alike, vpLearning &learning,
                 vpRoughStart &rough, vpTrackingOutcome &outcome)
      : m_looks(looks), m_cues(cues), m_fused(fused), m_edges(edges), m_motion(motion), m_score(score), m_alike(alike),
        m_learning(learning), m_rough(rough), m_outcome(outcome)
  {
  }

  //! Looks for the object about the poses that were given, and goes on from the best one where the image speaks for it.
  //! \param cMo Where the image before had it; becomes the best one. \return True where it was accepted.
  bool search(const vpFrameContext &frame, vpHomogeneousMatrix &cMo);
  //! In the frames after such a start. \return False where there is no pose to follow.
  bool resume(const vpFrameContext &frame, bool searches, vpHomogeneousMatrix &cMo);
  //! Whether the pose explains this image as well as a right one does.
  void confirm(const vpFrameContext &frame, const vpHomogeneousMatrix &cMo);
  //! What edges and the model's colours say of poses in this image.
  const vpStartSearch &look(const vpFrameContext &frame);

private:
  struct Refined
  {
    vpHomogeneousMatrix cMo;
    double value = -HUGE_VAL;
  };
  std::vector<vpPoseCandidate> candidates(const vpFrameContext &frame, const std::vector<vpWeightedPose> &starts);
  Refined refine(const vpFrameContext &frame, const vpHomogeneousMatrix &cMo);
  vpEstimate estimate(const vpFrameContext &frame, const vpHomogeneousMatrix &cMo);
  bool take(const vpFrameContext &frame, const vpHomogeneousMatrix &cMo);
  double valueOf(const vpHomogeneousMatrix &cMo) const;
  double edgeAgreement(const vpHomogeneousMatrix &cMo) const;
  void addEvidence(const vpHomogeneousMatrix &cMo, unsigned int places);

  vpModelLooks &m_looks;
  vpCueSet &m_cues;
  vpFusedEstimator &m_fused;
  vpEdgeEstimator &m_edges;
  vpObjectMotion &m_motion;
  vpImageScore &m_score;
  const vpAlikePoses &m_alike;
  vpLearning &m_learning;
  vpRoughStart &m_rough;
  vpTrackingOutcome &m_outcome;
};

END_VISP_NAMESPACE
#endif
