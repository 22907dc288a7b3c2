// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpMbMultiCueTracker_h
#define vpMbMultiCueTracker_h

#include <visp3/cues/vpColorCueSettings.h>
#include <visp3/model/vpModelSymmetries.h>
#include <visp3/model/vpTrackedModelBuilder.h>
#include <visp3/multicue/vpDistanceRange.h>
#include <visp3/multicue/vpMbOneCamera.h>
#include <visp3/multicue/vpMbTrackingResult.h>
#include <visp3/multicue/vpMultiCuePreset.h>
#include <visp3/multicue/vpMultiCueSettings.h>
#include <visp3/multicue/vpParticleSettings.h>
#include <visp3/multicue/vpWeightedPose.h>
#include <visp3/se3/vpPoseKalmanFilter.h>
#include <visp3/se3/vpPoseModes.h>

#include <memory>
#include <optional>

BEGIN_VISP_NAMESPACE

/*!
  \ingroup group_multicue
  Follows the pose of a known rigid object in a camera's images: takes the place of vpMbGenericTracker with one camera.

  An existing program changes the class name and the header; \ref multicue_coming tells what differs. Besides .cao and
  .wrl models, loadModel() takes meshes
  (.obj .ply .stl .dae .gltf .glb), whose edges are found by themselves; hidden lines are always removed, curved
  surfaces are tracked by their rims, and images of a camera with lens distortion are undistorted inside.

  \snippet tutorial-multicue-tracker-minimal.cpp Tracker

  Poses are \f${}^c{\bf M}_o\f$, object to camera, metres and radians; pixel centres are at integers. What an image
  shows never makes track() throw, unless setThrowOnLoss() asks for it: getTrackingState() tells how it went. Wrong
  arguments and files do throw, with a text that says what to do, and leave the tracker as it was.
*/
class VISP_EXPORT vpMbMultiCueTracker : public vpMbOneCamera
{
public:
  //! Kinds of features, with the values of vpMbGenericTracker::vpTrackerType; their sums by | are of this type, too.
  enum vpTrackerType
  {
    EDGE_TRACKER = 1 << 0, //!< Edges of the model.
    KLT_TRACKER = 1 << 1,  //!< Points on the surface.
    COLOR_TRACKER = 1 << 4 //!< Colours on both sides of the silhouette; vpMbGenericTracker has nothing like it.
  };

  using Preset = vpMultiCuePreset;

  //! With the preset Preset::ROBUST, see setPreset(), which gives way to what setTrackerType() says.
  vpMbMultiCueTracker();
  //! \param type A value of vpTrackerType, or several joined by |.
  explicit vpMbMultiCueTracker(vpTrackerType type);
  //! As vpMbGenericTracker's: a number is one of cameras and not of cues. \param nbCameras \throw vpException unless 1.
  explicit vpMbMultiCueTracker(unsigned int nbCameras);
  //! \param nbCameras Must be 1. \param trackerType See setTrackerType().
  vpMbMultiCueTracker(unsigned int nbCameras, int trackerType);
  //! \param trackerTypes One, see setTrackerType().
  explicit vpMbMultiCueTracker(const std::vector<int> &trackerTypes);
  //! \param cameraNames The camera's name. \param trackerTypes Likewise.
  vpMbMultiCueTracker(const std::vector<std::string> &cameraNames, const std::vector<int> &trackerTypes);
  ~vpMbMultiCueTracker() override;
  vpMbMultiCueTracker(const vpMbMultiCueTracker &) = delete;
  vpMbMultiCueTracker &operator=(const vpMbMultiCueTracker &) = delete;

  // Other calls of these names, of vpMbTracker, vpMbTrackerCalls and vpMbOneCamera.
  using vpMbOneCamera::display;
  using vpMbOneCamera::getFeaturesForDisplay;
  using vpMbOneCamera::getKltOpencv;
  using vpMbOneCamera::getModelForDisplay;
  using vpMbOneCamera::getNbPoints;
  using vpMbOneCamera::loadConfigFile;
  using vpMbOneCamera::loadModel;
  using vpMbOneCamera::reInitModel;
  using vpMbOneCamera::setCameraParameters;
  using vpMbOneCamera::setKltMaskBorder;
  using vpMbOneCamera::setKltOpencv;
  using vpMbOneCamera::setPose;
  using vpMbOneCamera::setTrackerType;
  using vpMbOneCamera::track;

  /** @name Model */
  //@{
  /*!
    Adds a file to the model, as ViSP's trackers do: several files make one object. reInitModel() and resetTracker()
    begin anew. \param modelFile Path of a .cao, .wrl (metres), or mesh file (unit of setModelUnit()). \param verbose
    Print the report of what was loaded. \param odTo Pose of the file's frame in the object frame. \throw vpException
    naming the file where it is missing, broken, empty, or of an unbelievable size.
  */
  void loadModel(const std::string &modelFile, bool verbose = false,
                 const vpHomogeneousMatrix &odTo = vpHomogeneousMatrix()) override;
  /*!
    Sets the unit of mesh files, for the next loadModel().
    \param metresPerUnit 1 for metres (default), 0.01 for centimetres, 0.001 for millimetres; > 0.
  */
  void setModelUnit(double metresPerUnit);
  //! Crease angle and limits of the believed size for the next loadModel(). \throw vpException naming what is out of
  //! range.
  void setModelOptions(const vpModelOptions &options);
  const vpModelOptions &getModelOptions() const;
  //! What was found in the model file. \throw vpException before loadModel().
  const vpModelReport &getModelReport() const;
  //! The model itself, null before loadModel().
  std::shared_ptr<const vpTrackedModel> getModel() const;
  /*!
    Says from where the object looks the same, see \ref multicue_symmetries. None by default; reInitModel() forgets
    them. \param symmetries Given, read by vpModelSymmetriesReader, or found by vpFindSymmetries().
  */
  void setSymmetries(const vpModelSymmetries &symmetries);
  const vpModelSymmetries &getSymmetries() const;
  //! Replaces the model by another one and starts it at a pose. \throw vpException as loadModel() and init(); the old
  //! model is then tracked on.
  void reInitModel(const vpImage<unsigned char> &I, const std::string &modelFile, const vpHomogeneousMatrix &cMo,
                   bool verbose = false, const vpHomogeneousMatrix &odTo = vpHomogeneousMatrix()) override;
  void reInitModel(const vpImage<vpRGBa> &I_color, const std::string &modelFile, const vpHomogeneousMatrix &cMo,
                   bool verbose = false, const vpHomogeneousMatrix &odTo = vpHomogeneousMatrix()) override;
  void addCircle(const vpPoint &P1, const vpPoint &P2, const vpPoint &P3, double r,
                 const std::string &name = "") override;
  //@}

  /** @name Tracking */
  //@{
  /*!
    Starts at the current pose; the init functions of vpMbTracker end here. The pose may be some pixels off: the image
    is looked at, see \ref multicue_capture, and tracking begins where it shows the object; getPose() stays until then.
    \throw vpException where there is no model, the image is empty, or the pose is not finite, behind the camera or
    outside the image; the pose before stays.
  */
  void init(const vpImage<unsigned char> &I) override;
  using vpMbOneCamera::initClick;
  using vpMbOneCamera::initFromPoints;
  using vpMbOneCamera::initFromPose;
  /*!
    As vpMbTracker's.
    \throw vpException naming the file, and the line, where it lacks a number; ViSP takes 0 for it.
  */
  void initClick(const vpImage<unsigned char> &I, const std::string &initFile, bool displayHelp = false,
                 const vpHomogeneousMatrix &T = vpHomogeneousMatrix()) override;
  //! As vpMbTracker's. \throw vpException naming the file, and the line, where it lacks a number.
  void initFromPoints(const vpImage<unsigned char> &I, const std::string &initFile) override;
  //! As vpMbTracker's. \throw vpException naming the file where it does not hold six numbers.
  void initFromPose(const vpImage<unsigned char> &I, const std::string &initFile) override;
  /** @name Starts on colour images: as vpMbTracker's, and the colours that the image shows there are learnt. */
  //@{
  void initClick(const vpImage<vpRGBa> &I_color, const std::string &initFile, bool displayHelp = false,
                 const vpHomogeneousMatrix &T = vpHomogeneousMatrix()) override;
  void initClick(const vpImage<vpRGBa> &I_color, const std::vector<vpPoint> &points3D_list,
                 const std::string &displayFile = "") override;
  void initFromPoints(const vpImage<vpRGBa> &I_color, const std::string &initFile) override;
  void initFromPoints(const vpImage<vpRGBa> &I_color, const std::vector<vpImagePoint> &points2D_list,
                      const std::vector<vpPoint> &points3D_list) override;
  void initFromPose(const vpImage<vpRGBa> &I_color, const std::string &initFile) override;
  void initFromPose(const vpImage<vpRGBa> &I_color, const vpHomogeneousMatrix &cMo) override;
  void initFromPose(const vpImage<vpRGBa> &I_color, const vpPoseVector &cPo) override;
  //@}
  /** @name Starts at poses that are not exact, see \ref multicue_starts */
  //@{
  /*!
    Looks for the object in this image, about a pose that may be off, and follows it from where it is found.

    A pose is accepted where the image speaks for it more than for any other place of the image. The state is then
    UNCERTAIN until some frames confirm it, or refuse it. After a refusal the state is LOST, getTrackingResult() tells
    why, and track() looks for the object again where setSearch() is on, else it stays LOST until the next start. Works
    with every tracker type. What was learnt before is forgotten either way.
    \param I Image. \param cMo Where the object may be. \param deviation How far off that may be.
    \return True where a pose was accepted; getPose() is it.
    \throw vpException as init(), or where the deviation is out of range; the tracker then stays as it was.
  */
  bool initFromRoughPose(const vpImage<unsigned char> &I, const vpHomogeneousMatrix &cMo,
                         const vpPoseDeviation &deviation = vpPoseDeviation());
  bool initFromRoughPose(const vpImage<vpRGBa> &I_color, const vpHomogeneousMatrix &cMo,
                         const vpPoseDeviation &deviation = vpPoseDeviation());
  //! Likewise about several poses, such as those of a detector. \param candidates At least one; weights above 0.
  bool initFromRoughPoses(const vpImage<unsigned char> &I, const std::vector<vpWeightedPose> &candidates,
                          const vpPoseDeviation &deviation = vpPoseDeviation());
  bool initFromRoughPoses(const vpImage<vpRGBa> &I_color, const std::vector<vpWeightedPose> &candidates,
                          const vpPoseDeviation &deviation = vpPoseDeviation());
  /*!
    Looks for the object everywhere in this image, with no pose given, and follows it from where it is found: by its
    contours, and by the colours and the texture that the model's file has. Whatever the image shows, the same image
    gives the same pose.

    Accepted or refused as initFromRoughPose() does, and likewise confirmed by the images after it. After a refusal the
    state is LOST, getTrackingResult() tells what is missing, and another image may be tried by calling again; where
    setSearch() is on, track() looks at all of each image again, and takes as long as this call.
    \param I Image. \param distances How far away the object may be, metres; the narrower, the faster and the surer.
    \return True where a pose was accepted; getPose() is it.
    \throw vpException where there is no model, the image is empty, the camera is singular, or the distances are
    negative, not finite or none; the tracker then stays as it was.
  */
  bool initFromImage(const vpImage<unsigned char> &I, const vpDistanceRange &distances = vpDistanceRange());
  bool initFromImage(const vpImage<vpRGBa> &I_color, const vpDistanceRange &distances = vpDistanceRange());
  /*!
    Asks a program of yours where the object may be: once in each track() before which it was lost, or found again and
    not yet confirmed, where setSearch() is on. Its poses are looked at beside those that the search finds by itself.
    Poses that cannot be are passed over, and what it throws stays inside; getTrackingResult() tells so. Off by default.
    \param detector May be called until the next setDetector() or the tracker's end; an empty one, or null, removes it.
  */
  void setDetector(const vpPoseDetector &detector);
  /*!
    Tells the next track() of a pose that the object may have, at any time. It is taken where it explains that image
    better than the pose that is tracked, and forgotten else.
    \param cMo Pose in the next image. \param deviation How far off it may be.
    \throw vpException where the pose is not rigid or behind the camera, or the deviation is out of range, and before
    loadModel(); a hint before it then stays.
  */
  void setPoseHint(const vpHomogeneousMatrix &cMo, const vpPoseDeviation &deviation = vpPoseDeviation());
  //@}
  /*!
    Moves the tracker to another pose, as init() does. A pose that no camera can see the object at, such as a detector
    may give, does not throw: the state is LOST and tells why, and the last good pose stays.
    \throw vpException where there is no model, the image is empty, or the pose is not finite or not rigid.
  */
  void setPose(const vpImage<unsigned char> &I, const vpHomogeneousMatrix &cdMo) override;
  void setPose(const vpImage<vpRGBa> &I_color, const vpHomogeneousMatrix &cdMo) override;
  /*!
    Follows the object into the next image.
    \throw vpException where no model was loaded, init() is missing, or the image's size is not that of init().
  */
  void track(const vpImage<unsigned char> &I) override;
  void track(const vpImage<vpRGBa> &I_color) override;
  //! All that is known of the last frame in one copy: pose, state, how far to believe it and why.
  vpMbTrackingResult getTrackingResult() const;
  /*!
    Scores any pose in any image, of any size, without tracking: the tracker stays as it is. For what vpRBTracker's
    score(cMo, I, ...) is used for: poses of a detector, of another tracker, or of a file.

    The score is the probability that the pose is right, if right poses (about a pixel off) and wrong ones (8 pixels off
    and more) were equally likely before the image was looked at. It is that of the edges' evidence
    (\ref cues_edge_evidence), whatever the tracker's cues are, and of the colours' where COLOR_TRACKER is chosen and
    colours were learnt from images of this kind, gray or in colour. It is fitted to rendered images of whole objects:
    of 2676 poses, 99.7 % of the right ones had more than 0.5, and 99.1 % of the wrong ones less. Poses at which the
    object looks nearly the same, as half a turn of a box, score high too; getTrackingResult() knows more, as it has
    seen more than one image. \param I Image, as track() gets it: with the lens distortion of the tracker's camera;
    setMask() holds for it. \param cMo Pose, object to camera, metres. \return [0, 1]; 0 where the camera cannot see the
    object at the pose, or sees too little of it. \throw vpException where there is no model, the image is empty, or the
    pose is not finite or not rigid.
  */
  double score(const vpImage<unsigned char> &I, const vpHomogeneousMatrix &cMo) const;
  double score(const vpImage<vpRGBa> &I_color, const vpHomogeneousMatrix &cMo) const;
  //! How the last frame went; UNCERTAIN before the first one.
  vpTrackingState getTrackingState() const;
  //! Share of the features that the robust estimation kept in the last frame, [0, 1]. The state is judged by it and by
  //! what the pose explains, see \ref multicue_pose and \ref multicue_fusion.
  double getSupport() const;
  //! Where the time of the last track() went.
  const vpTrackingTimings &getTimings() const;
  //! \throw vpTrackingException where getTrackingState() is LOST, with the reason.
  void testTracking() override;
  //! Makes track() throw as testTracking() does, as ViSP's trackers do. Off by default.
  void setThrowOnLoss(bool flag);
  /*!
    Forgets model, pose, symmetries and all that was learnt. Camera, moving edges, cues and their settings stay; angles,
    clipping, level of detail and the estimation's settings go back to their defaults, as in ViSP.
  */
  void resetTracker() override;
  //@}

  /** @name Settings */
  //@{
  /*!
    Reads an XML file of vpMbGenericTracker, which says nothing of cues, or a JSON file, see vpMultiCueSettingsReader.
    Where the file says a model and none was loaded, it is loaded.
    \param configFile Path. \param verbose Print all settings that result, and getConfigReport().
    \throw vpException as vpMultiCueSettingsReader::read() and loadModel(); all settings then stay as they were.
  */
  void loadConfigFile(const std::string &configFile, bool verbose = true) override;
  //! What the last loadConfigFile() that did not throw took of its file, and what it left.
  const vpConfigReport &getConfigReport() const;
  /*!
    Writes all settings that are in force as JSON, from which loadConfigFile() makes a tracker with the same settings:
    the preset, and of the cues only what differs from its own; of the others all. A model is written where a
    configuration file said it. Not written is what belongs to a model or to a program: pose, faces that are left out or
    have a level of detail of their own, symmetries given by setSymmetries(), mask, detector, names of cameras.
    \param filename Path, ends in .json. \throw vpException naming the file where it cannot be written.
  */
  void saveConfigFile(const std::string &filename) const;
  /*!
    Chooses cues, pose hypotheses, particles, prediction, search and what belongs to them by purpose, see
    \ref multicue_presets; default Preset::ROBUST. May be called between frames. Camera, model, clipping, moving edges
    but for vpEdgeCueSettings::candidates, points, texture's edges and frame interval stay. Without OpenCV's modules
    for points, a preset does without them.
  */
  void setPreset(Preset preset);
  //! The last one, of which single settings may have been changed since; none after setTrackerType().
  std::optional<Preset> getPreset() const;
  /*!
    Chooses the cues, and nothing else after setPreset(); may be called between frames. With a tracker that was made
    without a type and got no preset, these are the cues of a tracker made with this type: prediction, search and its
    budget are off, but where setPrediction(), setSearch(), setFrameDeadline() or a file's keys asked for them.
    \param type Sum of vpTrackerType values. \throw vpException for other values, and for points where the library was
    built without OpenCV's video, features2d or calib3d module.
  */
  void setTrackerType(int type) override;
  int getTrackerType() const override;
  using vpMbOneCamera::getMovingEdge;
  using vpMbOneCamera::setMovingEdge;
  void setMovingEdge(const vpMe &me) override;
  vpMe getMovingEdge() const override;
  virtual void getMovingEdge(vpMe &me) const;
  //! Likewise, with the scale of the threshold given: ViSP 3.5 has no name for it. \throw vpException naming what is
  //! out of range.
  void setMovingEdge(const vpMe &me, vpEdgeCueSettings::ThresholdScale scale);
  void setEdgeSettings(const vpEdgeCueSettings &settings);
  vpEdgeCueSettings getEdgeSettings() const;
  /*!
    Has strong edges of the model's texture or colours searched like those of its geometry ([P14] III-A). They are
    found when the first image is tracked, which then takes some tenths of a second more; an edge that the images
    show too rarely is left out until the next start. On by default, and without effect on models without texture.
  */
  void setTextureEdges(bool flag);
  bool getTextureEdges() const;
  //! Several poses for each image, see vpPoseHypotheses; with vpEdgeCueSettings::candidates above 1, best 5. Off by
  //! default. \throw vpException naming what is out of range.
  void setPoseHypothesisSettings(const vpPoseHypothesisSettings &settings);
  vpPoseHypothesisSettings getPoseHypothesisSettings() const;
  /*!
    Many poses at once ([T10] III), see \ref multicue_particles. With edges alone the pose is theirs; with several cues
    they follow the poses that were estimated, and tell what else the image allows. Off by default. The next frame
    starts with the new settings; init() and setPose() start the particles about the pose.
    \throw vpException naming what is out of range; the old settings then stay.
  */
  void setParticleSettings(const vpParticleSettings &settings);
  vpParticleSettings getParticleSettings() const;
  void setColorSettings(const vpColorCueSettings &settings);
  vpColorCueSettings getColorSettings() const;
  /*!
    Starts each frame where a Kalman filter with constant velocity expects the object ([P14] IV). On by default, off in
    a tracker that was made with a type.
    \param flag On or off. \param settings How the object is taken to move.
  */
  void setPrediction(bool flag, const vpPoseKalmanSettings &settings = vpPoseKalmanSettings());
  /*!
    Lets the prediction choose how far edges are searched for where several cues are fused: three of its standard
    deviations, at least 6 pixels, at most the range that was set, or twice the default one where none was. Off by
    default: on rendered sequences it helped with fast motion and lost some of the slow one, both by a few frames
    (satellite, every fourth image: 77.0 instead of 71.6 % of the poses right; every second: 89.9 instead of 92.6).
    \param flag On or off; without setPrediction() of no effect.
  */
  void setPredictedRange(bool flag);
  //! Time between two images for the prediction. \param seconds > 0, default 1/30; may change from image to image.
  void setFrameInterval(double seconds);
  /*!
    Looks for a lost object in all of the image and turned any way, see \ref multicue_search; with several cues, best
    with all three and with setPrediction(). After a loss, the state is TRACKING again only where several frames on end
    confirm a pose. A frame in which the object is lost takes ten to thirty times as long as others, 50 to 170 ms with
    640 x 480 pixels on one core of a shared server, where setFrameDeadline() does not limit it. On by default, off in a
    tracker that was made with a type. With edges alone, too, state and score are then of what the pose explains (\ref
    multicue_search_edges). \param flag On or off; may change between frames, and init() begins anew.
  */
  void setSearch(bool flag);
  /*!
    When a call of track() has to end, see \ref multicue_deadline. Work is done in the order of its worth: the expected
    pose is followed and judged first, then other starts, then searches, which go on in the next frame from what they
    found. What would not end in time is not begun, and vpMbTrackingResult::putOff tells it. With a deadline the same
    images no longer give the same poses to the last bit, and a lost object may be found some frames later. The views
    that searches look at are then made by a thread of low priority from the start on; until the first of them are there
    nothing is searched for. Not limited are a rough start and the search of the frames after one that was refused.
    \param milliseconds From the call on, [0, 10000]; 0: none. 33, the time between two images of a camera with 30 of
    them in a second, in the presets ROBUST (the default), STATIC and FAST; 0 in the others and in a tracker that was
    made with a type.
    \throw vpException where it is outside.
  */
  void setFrameDeadline(double milliseconds);
  double getFrameDeadline() const;
  /*!
    Keeps the views that searches look at (\ref multicue_deadline) for the next start of the program: with a deadline
    they are made beside the frames, which takes 3 seconds of a core with 30,000 triangles. The file's name has a
    fingerprint of the model; one that is damaged or of another version is made anew.
    \param folder That is there; empty: none, the default. Counts from the next loadModel() on.
    \throw vpException naming the folder, where it is none or nothing can be written there.
  */
  void setViewCache(const std::string &folder);
  std::string getViewCache() const;
  void setKltOpencv(const vpKltOpencv &klt) override;
  vpKltOpencv getKltOpencv() const override;
  void setKltMaskBorder(const unsigned int &border) override;
  unsigned int getKltMaskBorder() const override;
  void setKltThresholdAcceptation(double threshold) override;
  double getKltThresholdAcceptation() const override;
  void setUseEdgeTracking(const std::string &name, const bool &useEdgeTracking) override;
  void setUseKltTracking(const std::string &name, const bool &useKltTracking) override;
  //! How much each cue counts beside what its errors tell of it. \param mapOfFeatureFactors > 0, 1 by default; cues
  //! that are not in it keep theirs. \throw vpException for others.
  virtual void setFeatureFactors(const std::map<vpTrackerType, double> &mapOfFeatureFactors);
  //! \param threshold Share of the control points that must be found for the state TRACKING, [0, 1], default 0.4.
  virtual void setGoodMovingEdgesRatioThreshold(double threshold);
  virtual double getGoodMovingEdgesRatioThreshold() const;
  //! \param cam With or without distortion. \throw vpException where it is singular.
  void setCameraParameters(const vpCameraParameters &cam) override;
  void setLod(bool useLod, const std::string &name = "") override;
  void setMinLineLengthThresh(double minLineLengthThresh, const std::string &name = "") override;
  void setMinPolygonAreaThresh(double minPolygonAreaThresh, const std::string &name = "") override;
  //! What draws the depth buffers that hide edges; AUTOMATIC by default. Where EGL fails in a frame, the CPU draws from
  //! then on, and vpMbTrackingResult::text of that frame says why.
  void setRenderer(vpModelRenderer::Preference preference);
  //@}

  /** @name Results */
  //@{
  using vpMbTracker::getCovarianceMatrix;
  /*!
    Covariance of the pose's error as one cue alone knows it, at the pose of all of them ([P14] eq. 14).

    The fused one is vpMbTracker::getCovarianceMatrix(). Both are computed by track() after
    setCovarianceComputation(true), and in ViSP's parameters: the error of the translation of cMo (metres) and of its
    theta-u vector (radians), 6 x 6. They hold for errors by the image's noise and by what of the model's inaccuracy is
    seen in the errors that remain; what shifts all features alike, as a wrong focal length does, cannot be seen.
    Motions that the cue does not show have the deviation of the object's distance (translations) and 1 radian (turns
    about the object's centre), those that are kept fixed (setEstimatedDoF()) 0.

    \param cue EDGE_TRACKER, KLT_TRACKER or COLOR_TRACKER.
    \throw vpException with the reason of getCueReason() where the cue had no part in the last pose, or where
    setCovarianceComputation() is off.
  */
  vpMatrix getCovarianceMatrix(int cue) const;
  /*!
    Why a cue had no part in the last pose: it drops out by itself where the image shows nothing of it.
    \param cue EDGE_TRACKER, KLT_TRACKER or COLOR_TRACKER. \return Empty where it took part. \throw vpException for
    other values.
  */
  std::string getCueReason(int cue) const;
  //! Errors of the features that took part in the last pose, cue by cue: edges, then points (two each) and colours. In
  //! metres at 1 m, those of colours in deviations of their brightness.
  vpColVector getError() const override;
  //! Robust weight of each row of getError(), [0, 1].
  vpColVector getRobustWeights() const override;
  //! Number of control points that were found in the last image and entered the pose.
  virtual unsigned int getNbFeaturesEdge() const;
  //! The poses that the last image allows, best first; empty where hypotheses are off or nothing was found.
  const std::vector<vpPoseHypothesis> &getPoseHypotheses() const;
  //! Number of combinations of potential edges that were minimised for the last image.
  unsigned int getNbPoseMinimisations() const;
  //! The particles of the last frame, those that were optimised at the end; empty where they are off or not started.
  std::vector<vpPoseParticle> getParticles() const;
  //! Where they gather, the heaviest mode first; the covariances are in the object's frame. Empty as getParticles() is.
  std::vector<vpPoseMode> getPoseModes() const;
  //! Weighted mean of all particles ([T10] III-B2); the pose where there are none.
  vpHomogeneousMatrix getParticleMean() const;
  //! Number of rows of the points that entered the pose, two for each of them, as vpMbGenericTracker has it.
  virtual unsigned int getNbFeaturesKlt() const;
  std::map<int, vpImagePoint> getKltImagePointsWithId() const override;
  //! Number of lines across the silhouette that entered the pose.
  virtual unsigned int getNbFeaturesColor() const;
  //! As vpMbGenericTracker's: number of control points of edges found and not refused. \param level Must be 0.
  unsigned int getNbPoints(unsigned int level = 0) const override;
  // vpMbTracker::getProjectionError() after setProjectionErrorComputation(true): mean angle between the normals of the
  // edges that were tracked and the image's gradient where they were found, degrees, as vpMbGenericTracker has it.
  /*!
    Mean angle between the image's gradient and the normals of the model's edges, degrees, 90 where nothing is seen.
    Unlike getProjectionError() it looks where the model is, so that a pose that is a little off shows more.
    ViSP's own measure for .cao and .wrl models, and the same taken over the control points for meshes. ViSP's walks
    along whole lines, outside the image too, and takes minutes where they are long: of poses at which a corner of the
    model's box is behind the camera, or seen farther from the image's corner than ten times the sum of its width and
    height, that over the control points is taken for all models. It may differ by some degrees.
  */
  double computeCurrentProjectionError(const vpImage<unsigned char> &I, const vpHomogeneousMatrix &cMo,
                                       const vpCameraParameters &cam) override;
  double computeCurrentProjectionError(const vpImage<vpRGBa> &I_color, const vpHomogeneousMatrix &cMo,
                                       const vpCameraParameters &cam);
  //! Per feature, in the image as it was taken: 0, row, column, state (vpMeSite::vpMeSiteState); of a point that was
  //! found: 1, row, column, row and column for its number, the number.
  std::vector<std::vector<double>> getFeaturesForDisplay() override;
  //! Per visible bit of line: 0, row and column of one end, row and column of the other.
  std::vector<std::vector<double>> getModelForDisplay(unsigned int width, unsigned int height,
                                                      const vpHomogeneousMatrix &cMo, const vpCameraParameters &cam,
                                                      bool displayFullModel = false) override;
  void display(const vpImage<unsigned char> &I, const vpHomogeneousMatrix &cMo, const vpCameraParameters &cam,
               const vpColor &col, unsigned int thickness = 1, bool displayFullModel = false) override;
  void display(const vpImage<vpRGBa> &I, const vpHomogeneousMatrix &cMo, const vpCameraParameters &cam,
               const vpColor &col, unsigned int thickness = 1, bool displayFullModel = false) override;
  //! Has display() draw the potential edges, the likely ones in dark gray and the unlikely ones in light gray ([T10]
  //! figure 4), and the poses of getPoseHypotheses() in colours of their own. Off by default.
  void setDisplayHypotheses(bool flag);
  //! Has display() draw the 30 heaviest particles, the heavier the darker, and the modes in colours of their own. Off
  //! by default.
  void setDisplayParticles(bool flag);
  //@}

protected:
  //! Without an image: nothing is computed anew; 90 where setProjectionErrorComputation() is off.
  virtual void computeProjectionError();
  void computeVVSInit() override;
  void computeVVSInteractionMatrixAndResidu() override;
  void loadCAOModel(const std::string &modelFile, std::vector<std::string> &vectorOfModelFilename, int &startIdFace,
                    bool verbose = false, bool parent = true,
                    const vpHomogeneousMatrix &odTo = vpHomogeneousMatrix()) override;
  void initCircle(const vpPoint &, const vpPoint &, const vpPoint &, double, int = 0, const std::string & = "") override
  {
  }
  void initCylinder(const vpPoint &, const vpPoint &, double, int = 0, const std::string & = "") override {}
  void initFaceFromCorners(vpMbtPolygon &) override {}
  void initFaceFromLines(vpMbtPolygon &) override {}

  vpColVector m_error; //!< Of all rows at the last iteration, scaled; those of what was expected before come last.
  vpColVector m_w;     //!< Their robust weights.
  vpMatrix m_L;        //!< Their interaction matrix.

private:
  class Impl;
  class CaoPrimitives;

  std::unique_ptr<Impl> m_impl;
};

//! Joins cues, so that a sum of them is not taken for a number of cameras.
constexpr vpMbMultiCueTracker::vpTrackerType operator|(vpMbMultiCueTracker::vpTrackerType a,
                                                       vpMbMultiCueTracker::vpTrackerType b)
{
  return static_cast<vpMbMultiCueTracker::vpTrackerType>(static_cast<int>(a) | static_cast<int>(b));
}

END_VISP_NAMESPACE
#endif
