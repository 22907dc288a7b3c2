// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpTrackerState_h
#define vpTrackerState_h

#include "particles/vpTrackerParticles.h"
#include "search/vpBlobFinder.h"
#include "search/vpContourScan.h"
#include "search/vpPoseCapture.h"
#include "search/vpPoseSearch.h"
#include "motion/vpCentreFrame.h"
#include "judge/vpContourEvidence.h"
#include "estimate/vpCueFusion.h"
#include "symmetry/vpHalfTurns.h"
#include "motion/vpInertia.h"
#include "judge/vpJudgedPose.h"
#include "knowledge/vpPastKnowledge.h"
#include "judge/vpPoseBelief.h"
#include "judge/vpPoseTracks.h"
#include "estimate/vpPoseUncertainty.h"
#include "facade/vpPresetChoice.h"
#include "starts/vpRoughStart.h"
#include "frame/vpSearchBudget.h"
#include "knowledge/vpTextureSupport.h"
#include "symmetry/vpTrackerSymmetries.h"
#include "knowledge/vpTurnEffect.h"

#include <visp3/cues/vpColorCue.h>
#include <visp3/cues/vpFrameSource.h>
#include <visp3/cues/vpKeyframes.h>
#include <visp3/cues/vpPointCue.h>
#include <visp3/multicue/vpMbMultiCueTracker.h>
#include <visp3/se3/vpPoseKalmanFilter.h>

#include <cmath>
#include <map>
#include <optional>
#include <set>

BEGIN_VISP_NAMESPACE

//! How well each cue agrees with a pose; about 1 for colours, and below 1 for the others, where all is well.
struct vpMbMultiCueTracker::Agreement
{
  double edges = 0.;
  //! Mean distance to the edges of the image ([T10] eq. 11), for edges alone; 1 is the largest.
  double mapDistance = 0.;
  double evidence = 0.;  //!< See vpEdgeCue::evidence(), for edges alone.
  double edgeCount = 0.; //!< How many there are to agree with.
  double color = 0.;
  double points = 0.;
  double surface = 0.;
  double surfaceKnown = 0.;  //!< Share of it that is remembered.
  double surfaceWeight = 0.; //!< Share of it that is remembered and tells poses apart.
  //! After a loss: the surface looks so different that the pose can hardly be right.
  bool isRefuted = false;
};

//! Everything behind vpMbMultiCueTracker that vpMbTracker does not hold.
class vpMbMultiCueTracker::Impl
{
public:
  Impl()
  {
    viewOptions.textureEdges = true;
    updateMe();
  }

  //! Lets getMovingEdge() say what the edge cue does.
  void updateMe();
  //! \throw vpException before loadModel().
  const vpTrackedModel &requireModel() const;
  void setModel(vpTrackedModel &&loaded);
  void makeRenderer();
  //! Makes the cues of the tracker's type.
  void makeCues();
  //! Depth at a pose, for new points. Null where the model cannot be drawn.
  const vpRenderedView *renderDepth(const vpHomogeneousMatrix &cMo);
  //! Views from all around; made when first needed.
  vpViewSphere &viewSphere();
  //! Lets poseScore look at a frame; all of the image.
  void scoreFrame(const vpCueFrame &frame);
  //! The same for a part of the image.
  void scoreRegion(const vpCueFrame &frame, const vpImageRegion &region);
  //! How far a pose is off the expected one: distance of the object's middle in diameters, and angle in radians.
  std::array<double, 2> offExpected(const vpHomogeneousMatrix &cMo) const;
  //! The same squared, in the deviations that are usual.
  double surpriseAt(const vpHomogeneousMatrix &cMo) const;
  void learnFarDeviation(const std::array<double, 2> &off);
  //! What the cues say of a pose.
  struct Share
  {
    double sum = 0.;
    double cues = 0.;       // Their weights.
    double most = HUGE_VAL; // That the others are worth beside the edges.
  };
  //! How many points agree with a pose, each as far as it does. \param followed Becomes the number that could.
  double agreeingPoints(const vpHomogeneousMatrix &cMo, std::size_t &followed);
  //! What the points say beside other cues, and how much that counts.
  Share shareOfPoints(const vpHomogeneousMatrix &cMo);
  //! With what the keyframes say of the pose.
  double explainedBy(const Share &cues, const vpHomogeneousMatrix &cMo) const;
  //! Share of the way that the usual agreement of a cue takes to a lower one in a trusted frame.
  double fallRateOfUsual() const;
  //! A cue's agreement as a share of the usual one, as far as it counts.
  static double countedShare(double value, double usual);
  //! How much edges count whose agreement with trusted poses has this variance.
  static double reliability(double variance);
  //! How much colours and surface count.
  double weightBesideEdges(double variance) const;
  //! What a pose may explain at most, by what the edges have there.
  double mostBesideEdges() const;
  //! True where edges alone speak for a pose.
  bool isDisowned() const;
  //! Share of the object's outline at a pose that is in the image.
  double insideShare(const vpHomogeneousMatrix &cMo);
  //! Tells poseScore how much each cue counts. \param byEdges In a search in which others are hardly trusted.
  void weighScore(bool byEdges);
  //! True where colours come and go with the light.
  bool hasUnsteadyColors() const;
  //! How far a pose is from the last trusted one: 1 for half a turn or two diameters.
  double changeSince(const vpHomogeneousMatrix &cMo) const;
  //! Its depth beside that of the last trusted one, or one that a hint or a detector gave, [0, 1].
  double depthChange(const vpHomogeneousMatrix &cMo) const;
  //! Of the object's middle, metres.
  double depthOf(const vpHomogeneousMatrix &cMo) const;
  //! Where the object is looked for that is expected at a pose.
  vpImageRegion regionAround(const vpHomogeneousMatrix &cMo) const;
  void settle(vpPoseSearch &search);
  void settleByScore(vpPoseSearch &search) const;
  void scatterEverywhere(const vpCueFrame &frame, vpPoseSearch &search, std::size_t number);
  //! Adds poses whose contours were found, wherever that is. \param number Of orientations that are looked for.
  void scatterScanned(const vpCueFrame &frame, vpPoseSearch &search, std::size_t number);
  //! Where the object's centre may be.
  struct Place
  {
    Eigen::Vector3d centre; //!< In the camera's frame, metres.
    double share = 0.;      //!< How likely it is among all of them.
  };
  std::vector<Place> placesOfColors(const vpCueFrame &frame);
  //! Forgets what was learnt from images.
  void forgetImages();
  //! Features of one cue, or of all of them.
  struct Support
  {
    unsigned int expected = 0; // That were searched for.
    unsigned int good = 0;     // That the robust estimation kept.
  };
  static std::size_t indexOf(int cue) { return cue == EDGE_TRACKER ? 0 : cue == COLOR_TRACKER ? 1 : 2; }
  //! Counts the features of the last frame. \param estimated False where there is no pose for them to support.
  void countSupport(bool estimated);
  //! Share of the features that support the pose.
  double support() const { return expected == 0 ? 0. : static_cast<double>(good) / expected; }
  //! How far to believe the pose, [0, 1].
  double score() const;
  //! What a cue has to say, but for its reason.
  vpMbTrackingResult::Cue resultOf(int cue) const;
  //! The outcome as a sentence.
  std::string reasonText() const;
  //! Of the best pose hypothesis, pixels; infinite where there is none.
  double bestResidue() const
  {
    return hypotheses.hypotheses().empty() ? HUGE_VAL : hypotheses.hypotheses().front().residue;
  }
  //! True where a pose leaves no more unexplained than the trusted ones before it.
  bool explains(double residue) const { return residue < explainedResidue(); }
  //! Pixels.
  double explainedResidue() const;
  //! Of those of a frame; each search has at least one.
  unsigned int minimisationsLeft() const
  {
    const unsigned int most = hypotheses.settings().minimisations;
    return most > minimisations ? most - minimisations : 1U;
  }
  //! Takes the best hypothesis of a trusted frame for what is usual.
  void learnResidue();
  //! What a share of what is usually explained says of the pose.
  static vpTrackingState stateOf(double share);
  //! Why the state is that, where enough features were found to tell.
  static vpMbTrackingResult::Reason outcomeOf(vpTrackingState state);
  // Evidence that wrong poses have in the median after an image was shifted by 20 to 126 pixels: on ViSP's cube, its
  // teabox and its castle -0.76, -0.97 and -1.1. Right ones have 1.33, 0.33 and 1.31 there (vpEdgeCue::evidence()).
  static constexpr double evidenceByChance = -1.;
  double shareOfEvidence(double evidence) const;
  //! True where the pose may be learnt from.
  //! With edges alone, one that is followed without a loss: edges that are not looked after are lost themselves.
  bool isTrusted() const
  {
    const bool isFollowed = state == vpTrackingState::UNCERTAIN && type == EDGE_TRACKER && !searches;
    return state == vpTrackingState::TRACKING || (isFollowed && !edgesBeforeLoss);
  }
  //! Of how the object moves, nothing is known any more.
  void forgetMotion()
  {
    kalman.reset();
    inertia.reset();
    sinceUpdate = 0.;
  }
  //! True where the prediction is still better than the last pose, for an object that is not seen.
  bool mayCoast() const { return predicts && kalman.isStarted() && sinceUpdate < longestCoast; }
  //! The frame with the object's orientation at the middle of its box.
  vpHomogeneousMatrix centreFrame() const { return vpCentreFrame(*model); }
  //! Of the poses that look like one, the nearest to where the object is believed to be.
  vpHomogeneousMatrix nearestAlike(const vpHomogeneousMatrix &cMo) const;
  //! True where nothing in the last image showed a turn about an axis of the object's shape.
  bool holdsTurns() const { return symmetries.hasAxis() && !fusion.showsAll(); }
  //! True where edges show such turns, too: those of the texture.
  bool edgesShowTurns() const
  {
    return symmetries.printShowsTurns() && viewOptions.textureEdges && !view->textureEdges().empty();
  }
  double rivalDistance(const vpHomogeneousMatrix &c1Mb, const vpHomogeneousMatrix &c2Mb) const;
  vpPoseMatrix6 freeMotions(const vpMatrix &oJo) const;
  void restrictHypotheses(const vpMatrix &oJo);
  bool uses(int cue) const { return (type & cue) != 0; }
  //! True where attempts from several starts are compared by that; with edges alone: after a loss.
  bool comparesAttempts() const { return type != EDGE_TRACKER || (searches && mustConfirm); }
  //! True where the Kalman filter has to follow the object.
  bool usesVelocity() const
  {
    const vpParticleSettings &settings = particles.settings();
    return predicts || searches || (settings.enabled && settings.motion == vpParticleSettings::VELOCITY);
  }
  //! Why a cue that was matched gave no equation.
  std::string missingRows(int cue) const;

  // Settings. What vpMbTracker holds itself (camera, angles, clipping, LOD) is not repeated here.
  int type = EDGE_TRACKER;
  vpPresetChoice choice;
  vpModelViewOptions viewOptions; // Brought up to date by vpMbMultiCueTracker::viewOptions().
  vpMe me;                        // As the user gave it, for getMovingEdge().
  vpPointCueSettings klt;
  vpModelOptions modelOptions;
  vpModelRenderer::Preference preference = vpModelRenderer::AUTOMATIC;
  double goodRatio = 0.4;
  bool throwOnLoss = false;
  bool rangeIsPredicted = false;
  bool predicts = false;           // With the Kalman filter.
  double frameInterval = 1. / 30.; // Seconds.
  bool displayHypotheses = false;
  std::map<int, double> featureFactors; // By cue; 1 for those that are not in it.
  //! Names of the model's faces that take no part.
  struct Untracked
  {
    std::set<std::string> edges;
    std::set<std::string> points;
  };
  Untracked untracked;
  bool filtersPoints = false; // By them.
  //! Takes over the settings that vpMultiCueSettings has not.
  void take(const Impl &before);

  // Model and what is derived from it.
  std::unique_ptr<vpTrackedModelBuilder> parts; // What loadModel() added up to now.
  bool hasMesh = false;                         // One of the parts is a mesh.
  std::shared_ptr<const vpTrackedModel> model;
  vpTrackerSymmetries symmetries;
  vpMatrix visibleMotions; // Scratch memory.
  std::unique_ptr<vpModelRenderer> renderer;
  std::unique_ptr<vpModelView> view;
  std::unique_ptr<vpModelRenderer> depthRenderer; // For new points, of convex models too; made when first needed.
  vpRenderedView depth;
  vpCameraParameters frameCamera; // Of the last frame, without distortion.
  std::unique_ptr<vpModelView> displayView;

  // Image and features.
  vpFrameSource source;
  vpEdgeCue edges;
  vpTextureSupport textureSupport;
  vpColorCue color;
  std::unique_ptr<vpPointCue> points; // Null where they are not asked for.
  bool usesPoints = true;             // False where they contradict the other cues in this frame.
  unsigned long long viewedFrame = 0; // That the view is of.
  vpPoseHypotheses hypotheses;
  vpPoseHypotheses otherHypotheses; // Those of the near search while a farther one goes on.
  double usualResidue = 0.;         // Of the best hypothesis in trusted frames, pixels; 0: none yet.
  std::uint64_t draws = 0;          // Since the start: each has a stream of random numbers.
  unsigned int minimisations = 0;   // In the last frame.
  unsigned int width = 0;           // Of the images since init(); 0 before it.
  unsigned int height = 0;

  vpTrackerParticles particles;

  // Search for poses.
  bool searches = false;
  vpSearchBudget searchBudget;
  std::unique_ptr<vpViewSphere> sphere;
  vpOrientedDistanceMap distanceMap;
  vpColorOddsMap oddsMap;
  vpSurfaceMemory surface;
  vpKeyframes keyframes;
  unsigned int mostAgreeing = 0;      // Features of keyframes with one pose, in this frame.
  bool keyframeIsProvisional = false; // Of the start, whose pose may be a little off.
  vpPoseScore poseScore;
  vpBlobFinder blobs;
  vpContourAligner aligner;
  vpContourScan contourScan;
  vpHalfTurns halfTurns;
  unsigned long long scoredFrame = 0;
  std::vector<vpPoseCandidate> searched; // The best ones of the frames before, while the object is lost.
  bool mustConfirm = false;
  unsigned int outsideFrames = 0;  // On end.
  unsigned int doubtfulFrames = 0; // The same, with a pose that is not explained.
  unsigned int disbelievedFrames = 0;
  std::optional<vpEdgeCue> edgesBeforeLoss; // Of edges alone without a search, until a pose is confirmed.
  //! The last pose that was started from or tracked.
  struct Trusted
  {
    vpHomogeneousMatrix cMo;
    vpPoseTangent velocity = vpPoseTangent::Zero(); //!< Of the object in its own frame, 1 / s; 0 where it is unknown.
    double time = 0.;
  };
  void trust(const vpHomogeneousMatrix &cMo, const vpPoseTangent &velocity = vpPoseTangent::Zero())
  {
    trusted = {cMo, velocity, time};
    rough.depths.clear();
  }
  vpHomogeneousMatrix movedOn(const Trusted &from, double share) const;
  std::vector<vpHomogeneousMatrix> atTrustedDepth(const std::vector<vpPoseCandidate> &candidates) const;
  //! Where the object was trusted to be, where it is if it went on as it moved then, and halfway.
  std::array<vpHomogeneousMatrix, 3> whereaboutsOf(const Trusted &from) const;
  //! The same of where it was trusted last, and of where it was before that.
  std::vector<vpHomogeneousMatrix> whereabouts() const;
  //! Where a search begins.
  const Trusted &searchOrigin() const;
  //! What trusted frames told of the object.
  struct Learnt
  {
    vpColorCue::Reference color;
    vpSurfaceMemory::Reference surface;
    Agreement usual;
    Trusted trusted;
    unsigned int period = 0; //!< See below.
  };
  void noteLoss();
  void noteFound(const vpHomogeneousMatrix &cMo);
  void keepLearnt();
  std::optional<unsigned int> levelToRecall() const;
  void recallLearnt();
  void forgetPeriod();
  vpPastKnowledge<std::shared_ptr<const Learnt>> past;
  unsigned int period = 0; // How often the object was found again.
  vpTurnEffect turnEffect; // On the surface.
  std::size_t turns = 0;   // That it was learnt from.
  void learnTurnEffect();
  //! How far the object is turned from where it was seen before the loss, radians.
  double turnSince(const vpHomogeneousMatrix &cMo) const;
  //! Share of the surface that is known and tells poses apart.
  static double weightOf(const vpSurfaceMemory::Agreement &seen) { return vpSurfaceTrust(seen.texture) * seen.known; }
  //! Of its agreement with what was learnt before a turn by so many radians, as a share of the usual one.
  double surfaceVariance(double turn) const { return unsteadiness.surface + turnEffect.variance(turn); }
  //! True where the surface differs so much from what is known of it that the pose can hardly be right. Stronger than
  //! isContradicted().
  bool isRefutedBy(const vpSurfaceMemory::Agreement &seen, double variance) const;
  //! Whether the pose where the object was found again is right: it may have shown sides that were never seen, and
  //! turn to others.
  struct Proof
  {
    std::shared_ptr<const Learnt> known; //!< Before it was found.
    bool isOpen = false;
    unsigned int agreeing = 0;       //!< Frames in which what was known agreed with the image.
    unsigned int undecided = 0;      //!< In which it could not have told.
    unsigned int contradictions = 0; //!< In which it did not agree, on end.
    bool hasFailed = false;          //!< The object was lost for that.
  };
  Proof proof;
  void startProof();
  //! By what was known before.
  void startProof(const std::shared_ptr<const Learnt> &known);
  //! A pose that may be the right one instead of the one that was found.
  struct Twin
  {
    vpHomogeneousMatrix oMt; //!< From the object's frame at it to that at the pose that is followed.
    double lead = 0.;        //!< Of the followed pose before it, as a logarithm of odds.
  };
  std::vector<Twin> twins;
  unsigned int twinFrames = 0; // In which they were compared; the most where they no longer are.
  vpEdgeCue plainEdges;        // Without memory.
  void startTwins(const vpHomogeneousMatrix &cMo);
  void endTwins();
  double surfaceEvidence(const vpHomogeneousMatrix &cMo) const;
  //! Goes back to what was known before the object was found, and on from a pose.
  void startOver(const vpHomogeneousMatrix &cMo);
  void recall(const Learnt &learnt);
  //! Probability of the pose, with what speaks for its twins.
  double believed() const;
  //! \return True where the pose that is followed turned out to be wrong.
  bool isDisproved(const vpHomogeneousMatrix &cMo);
  double lastExplained = 0.;            // When a trusted frame was explained well.
  bool wasSudden = false;               // The last loss.
  std::optional<Trusted> trustedBefore; // Of what was recalled, while what was trusted since may be something else.
  unsigned int framesSinceLoss = 0;     // While it has to be confirmed; 0 before the first frame.
  bool wasFound = false;                // After a loss.
  unsigned int trustedFrames = 0;       // Since the start, or since the object was found again.
  unsigned int confirmations = 0;       // Frames that explained a pose on end since the object was lost.
  vpPoseTracks tracks;                  // While it has to be confirmed.
  //! True where two poses are followed as one.
  vpPoseTracks::Same sameTrack() const;
  //! True where others have to be looked for before a pose that explains the image is confirmed.
  bool mustCompare(const vpHomogeneousMatrix &cMo);
  //! What speaks against a pose that shows fewer edges than usual: it may explain a part of what it should.
  double fewEdgesPenalty() const;
  void beginTracks(const vpHomogeneousMatrix &cMo);
  void chooseTrack();
  void endTracks(const vpHomogeneousMatrix &cMo);

  vpPoseCapture poseCapture;
  std::uint64_t captures = 0;                  // Since the start: each has a stream of random numbers.
  std::optional<vpHomogeneousMatrix> captured; // Where the object is by the image of the start.

  vpRoughStart rough;

  // Pose estimation; members so that their memory is used again.
  vpCueFusion fusion;
  vpPoseUncertainty uncertainty; // Of the last frame.
  vpPosePrior prior;
  bool holdsPrediction = false; // The prior is around the predicted pose.
  vpResidualBlock block;        // Scratch memory.
  Agreement agreement;          // At the pose that was judged last.
  Agreement usual;              // Mean over the trusted frames.
  Agreement unsteadiness;       // Variance of its share of the usual one over the trusted frames.
  Share share;                  // At the pose that was judged last.
  // A pose that the cues were brought to.
  struct Attempt : vpJudgedPose
  {
    vpHomogeneousMatrix cMo;
    Share share;
    bool usesPoints = false;
  };
  Attempt best;                               // Of this frame.
  std::vector<vpHomogeneousMatrix> attempted; // Poses that attempts of this frame led to.
  static constexpr double longestCoast = 0.5; // Seconds.
  static constexpr double leastTexture =
      0.15; // A surface of one colour tells no pose from another, and has no corners.
  static constexpr double insideToConfirm = 0.4; // Share of the outline that is in the image.
  static constexpr double leastUsual = 0.4;      // What a right pose has at least, whatever the frames before had.
  bool bestIsLast = false;
  vpHomogeneousMatrix expectedPose; // Of the object in this frame, before it was looked at.
  vpHomogeneousMatrix startPose;    // Of the attempt that goes on.
  // How far off a pose is no surprise, as offExpected(), and what is taken where nothing is known.
  std::array<double, 2> farDeviation = {0., 0.};
  static constexpr std::array<double, 2> mostFarDeviation = {{0.2, 0.4}};
  std::array<double, 2> surprise = {0., 0.}; // Mean squared distance from it, in diameters and radians.
  vpColVector weightedError;
  vpColVector errorBefore;
  vpMatrix LTL;
  vpColVector LTR;
  vpColVector velocity;
  double mu = 0.;                // Of Levenberg and Marquardt.
  double lastStep = 0.;          // Largest motion of a control point in the last iteration, pixels.
  double residual = 0.;          // Root of the weighted mean square error.
  vpHomogeneousMatrix cMoBefore; // Of the last iteration.

  // Motion.
  vpPoseKalmanFilter kalman;
  vpInertia inertia;
  double sinceUpdate = 0.;    // Of the filter, seconds.
  double predictedRange = 0.; // Of the edges' search, pixels; 0: as it is set.

  // Outcome.
  vpTrackingState state = vpTrackingState::UNCERTAIN;
  bool wasTracking = false; // In the frame before.
  vpMbTrackingResult::Reason outcome = vpMbTrackingResult::Reason::NOT_STARTED;
  std::string reason;
  vpPoseBelief belief;              // Of several cues.
  bool isJudged = false;            // An image was tracked since the start.
  unsigned int expected = 0;        // Features that were searched for.
  unsigned int good = 0;            // That the robust estimation kept.
  std::array<Support, 3> supportOf; // Both for each cue, by indexOf().
  vpTrackingTimings timings;
  double time = 0.; // Of all frames since the object was made, seconds.
  Trusted trusted;
};

END_VISP_NAMESPACE
#endif
