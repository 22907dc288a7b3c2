// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpTrackerState_h
#define vpTrackerState_h

#include <visp3/core/vpRobust.h>
#include <visp3/cues/vpFrameSource.h>
#include <visp3/multicue/vpMbMultiCueTracker.h>

BEGIN_VISP_NAMESPACE

//! Everything behind vpMbMultiCueTracker that vpMbTracker does not hold.
class vpMbMultiCueTracker::Impl
{
public:
  Impl() { updateMe(); }

  //! Lets getMovingEdge() say what the edge cue does.
  void updateMe();
  //! \throw vpException before loadModel().
  const vpTrackedModel &requireModel() const;
  void setModel(vpTrackedModel &&loaded);
  void makeRenderer();
  //! Forgets what was learnt from images.
  void forgetImages();

  // Settings. What vpMbTracker holds itself (camera, angles, clipping, LOD) is not repeated here.
  int type = EDGE_TRACKER;
  vpModelViewOptions viewOptions; // Brought up to date by vpMbMultiCueTracker::viewOptions().
  vpMe me;                        // As the user gave it, for getMovingEdge().
  vpKltSettings klt;
  vpModelOptions modelOptions;
  vpModelRenderer::Preference preference = vpModelRenderer::AUTOMATIC;
  double goodRatio = 0.4;
  bool throwOnLoss = false;
  bool displayHypotheses = false;

  // Model and what is derived from it.
  std::unique_ptr<vpTrackedModelBuilder> parts; // What loadModel() added up to now.
  bool hasMesh = false;                         // One of the parts is a mesh.
  std::shared_ptr<const vpTrackedModel> model;
  std::unique_ptr<vpModelRenderer> renderer;
  std::unique_ptr<vpModelView> view;
  std::unique_ptr<vpModelView> displayView;

  // Image and features.
  vpFrameSource source;
  vpEdgeCue edges;
  vpPoseHypotheses hypotheses;
  std::uint64_t frames = 0;       // Since the start.
  unsigned int minimisations = 0; // In the last frame.
  unsigned int width = 0;         // Of the images since init(); 0 before it.
  unsigned int height = 0;

  // Pose estimation; members so that their memory is used again.
  vpRobust robust;
  vpResidualBlock block;
  std::vector<double> weights; // Robust weights of the block's rows.
  vpColVector weightedError;
  vpColVector errorBefore;
  vpMatrix LTL;
  vpColVector LTR;
  vpColVector velocity;
  double mu = 0.;       // Of Levenberg and Marquardt.
  double lastStep = 0.; // Largest motion of a control point in the last iteration, pixels.
  double residual = 0.; // Root of the weighted mean square error.
  vpColVector wTrue;    // For the covariance.
  vpMatrix LTrue, LVJTrue;
  vpHomogeneousMatrix cMoBefore; // Of the last iteration.

  // Outcome.
  vpTrackingState state = vpTrackingState::UNCERTAIN;
  std::string reason;
  unsigned int expected = 0;   // Control points that were searched for.
  unsigned int found = 0;      // That gave a row.
  unsigned int good = 0;       // That the robust estimation kept.
  vpHomogeneousMatrix trusted; // The last pose that was started from or tracked.
};

END_VISP_NAMESPACE
#endif
