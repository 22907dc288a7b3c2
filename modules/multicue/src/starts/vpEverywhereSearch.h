// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpEverywhereSearch_h
#define vpEverywhereSearch_h

#include "frame/vpSearchSize.h"
#include "search/vpBlobFinder.h"
#include "starts/vpAttempts.h"

BEGIN_VISP_NAMESPACE

//! Starts all around and in all of the image, after a loss; the best poses of the frames before are among them.
class vpEverywhereSearch
{
public:
  vpEverywhereSearch(const vpModelLooks &looks, const vpCueSet &cues, const vpObjectMotion &motion, vpImageScore &score,
                     const vpTrackerSymmetries &symmetries, const vpHalfTurns &halfTurns,
                     const vpWhereabouts &whereabouts, const vpRoughStart &rough, vpSituation &situation,
                     vpAttempts &attempts)
      : m_looks(looks), m_cues(cues), m_motion(motion), m_score(score), m_symmetries(symmetries),
        m_halfTurns(halfTurns), m_whereabouts(whereabouts), m_rough(rough), m_situation(situation), m_attempts(attempts)
  {
  }

  void search(const vpFrameContext &frame);
  //! The best pose of this frame, where it is turned far, the other way round; and once it is about to be confirmed,
  //! all those that look much alike.
  void turnByHalf(const vpFrameContext &frame);

private:
  //! Where the object's centre may be.
  struct Place
  {
    Eigen::Vector3d centre; //!< In the camera's frame, metres.
    double share = 0.;      //!< How likely it is among all of them.
  };

  bool searchDetected(const vpFrameContext &frame);
  void scatter(const vpFrameContext &frame, vpPoseSearch &search);
  void scatterScanned(const vpFrameContext &frame, vpPoseSearch &search);
  std::vector<Place> placesOfColors(const vpFrameContext &frame);
  std::vector<vpHomogeneousMatrix> atTrustedDepth(const std::vector<vpPoseCandidate> &candidates) const;
  void attemptAtDistance(const vpFrameContext &frame, const std::vector<vpHomogeneousMatrix> &poses, bool byEdges);

  const vpModelLooks &m_looks;
  const vpCueSet &m_cues;
  const vpObjectMotion &m_motion;
  vpImageScore &m_score;
  const vpTrackerSymmetries &m_symmetries;
  const vpHalfTurns &m_halfTurns;
  const vpWhereabouts &m_whereabouts;
  const vpRoughStart &m_rough;
  vpSituation &m_situation;
  vpAttempts &m_attempts;
  vpBlobFinder m_blobs;
  vpSearchSize m_size;
};

END_VISP_NAMESPACE
#endif
