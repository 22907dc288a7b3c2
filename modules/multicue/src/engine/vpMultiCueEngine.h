// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpMultiCueEngine_h
#define vpMultiCueEngine_h

#include "engine/vpEdgeFollower.h"
#include "engine/vpStartPlan.h"
#include "engine/vpTwinComparison.h"
#include "judge/vpLossWatch.h"
#include "particles/vpParticleExplorer.h"

BEGIN_VISP_NAMESPACE

//! Follows an object from image to image: pose in, pose out. Each part owns what it knows, and the engine says in which
//! order they look at a frame.
class vpMultiCueEngine
{
public:
  //! \param servoing Has to outlive this.
  explicit vpMultiCueEngine(vpServoing &servoing);
  vpMultiCueEngine(const vpMultiCueEngine &) = delete;
  vpMultiCueEngine &operator=(const vpMultiCueEngine &) = delete;

  void setModel(vpTrackedModel &&model);
  //! \return What belongs to the frame of an image.
  vpFrameContext frameOf(const vpCueFrame &image);
  //! A pose that the object is taken to be at, in images of a size; what other images taught is forgotten.
  void start(unsigned int width, unsigned int height, const vpHomogeneousMatrix &cMo);
  //! The pose may be some pixels off, as one that was clicked is: where the image shows the object near it, the next
  //! track() begins there, and what is learnt of the object is learnt there.
  void captureStart(const vpCueFrame &image, const vpHomogeneousMatrix &cMo);
  //! \param candidates Poses that are not exact. \param cMo Becomes the best one. \return True where it was accepted.
  bool startRoughly(const vpCueFrame &image, const std::vector<vpWeightedPose> &candidates,
                    const vpPoseDeviation &deviation, vpHomogeneousMatrix &cMo);
  //! Looks for the object in all of the image. \param sizes How large it may be. \param cMo Becomes the best pose.
  //! \return True where it was accepted.
  bool startAnywhere(const vpCueFrame &image, const vpImageSearch::Sizes &sizes, vpHomogeneousMatrix &cMo);
  //! \param cMo Pose in the frame before, and in this one.
  void track(const vpCueFrame &image, vpHomogeneousMatrix &cMo);
  //! True where attempts from several starts are compared; with edges alone: after a loss.
  bool comparesAttempts() const { return !cues.isEdgesAlone() || (settings.searches && situation.mustConfirm); }
  //! Number of the last frame's pose that is believed, [0, 1].
  double score() const { return m_watch.score(); }
  //! The last frame's agreement of cues with the pose.
  const vpAgreement &agreement() const { return m_verdict.agreement; }

  // Parts with settings, or with results that are asked for.
  vpEngineSettings settings;
  vpModelLooks looks;
  vpCueSet cues;
  vpTrackerSymmetries symmetries;
  vpPoseMinimiser minimiser;
  vpPoseCovariance covariance;
  vpObjectMotion motion;
  vpTrackerParticles particles;
  vpFrameDeadline deadline;
  void setViewCache(const std::string &folder) { m_score.setViewCache(folder); }
  const std::string &viewCache() const { return m_score.viewCache(); }
  vpTrackingTimings timings;
  vpRoughStart rough;
  vpTrackingOutcome outcome;
  vpEdgeEstimator edges;

  vpSituation situation;

private:
  struct Found
  {
    vpHomogeneousMatrix cMo;
    vpAttempts::Attempt best;
  };
  //! The same of an image to start in: a start has no deadline.
  vpFrameContext startOf(const vpCueFrame &image);
  void predict(vpHomogeneousMatrix &cMo);
  void refuseUnbelievable(const vpHomogeneousMatrix &before, Found &found);
  Found fuse(const vpFrameContext &frame);
  Found followEdges(const vpFrameContext &frame, const vpHomogeneousMatrix &expected,
                    const vpHomogeneousMatrix &before);
  void compareTwins(const vpFrameContext &frame);
  void askDetector(const vpCueFrame &image);
  bool isTrusted() const;
  void endFrame(const vpFrameContext &frame, const Found &found, const vpHomogeneousMatrix &before,
                vpHomogeneousMatrix &cMo);
  void forgetImages();

  vpRandomStreams m_streams;
  vpFrameDeadline m_noDeadline;
  vpHalfTurns m_halfTurns;
  vpObjectKnowledge m_knowledge;
  vpFoundPoseProof m_proof;
  vpFoundPoseTwins m_twins;
  std::optional<vpHomogeneousMatrix> m_captured; // Where the object is by the image of the start.
  vpVerdict m_verdict;

  vpAlikePoses m_alike;
  vpWhereabouts m_whereabouts;
  vpImageScore m_score;
  vpPoseJudge m_judge;
  vpFusedEstimator m_fused;
  vpLearning m_learning;
  vpAttempts m_attempts;
  vpStartCapture m_capture;
  vpHintedStarts m_hints;
  vpRoughStarter m_starter;
  vpKeyframeStarts m_keyframes;
  vpNearSearch m_near;
  vpEverywhereSearch m_everywhere;
  vpStartPlan m_plan;
  vpTwinComparison m_twinComparison;
  vpLossWatch m_watch;
  vpRivalPoses m_rivals;
  vpParticleExplorer m_explorer;
  vpEdgeFollower m_follower;
};

END_VISP_NAMESPACE
#endif
