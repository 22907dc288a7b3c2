// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpMultiCueSettings_h
#define vpMultiCueSettings_h

#include <visp3/core/vpCameraParameters.h>
#include <visp3/cues/vpColorCueSettings.h>
#include <visp3/cues/vpEdgeCue.h>
#include <visp3/cues/vpPointCue.h>
#include <visp3/model/vpModelRenderer.h>
#include <visp3/model/vpModelView.h>
#include <visp3/model/vpTrackedModelBuilder.h>
#include <visp3/multicue/vpConfigReport.h>
#include <visp3/multicue/vpMultiCuePreset.h>
#include <visp3/multicue/vpParticleSettings.h>
#include <visp3/multicue/vpPoseHypotheses.h>
#include <visp3/se3/vpPoseKalmanFilter.h>

#include <map>
#include <string>
#include <vector>

BEGIN_VISP_NAMESPACE

/*!
  \ingroup group_multicue_settings
  How a pose is estimated: what vpMbTracker has setters for.
*/
struct VISP_EXPORT vpEstimationSettings
{
  //! vpMbTracker::vpMbtOptimizationMethod.
  enum Method
  {
    GAUSS_NEWTON,
    LEVENBERG_MARQUARDT
  };

  Method method = GAUSS_NEWTON;
  double gain = 1.;                //!< Of the virtual visual servoing, vpMbTracker::setLambda(), (0, 10].
  unsigned int maxIterations = 30; //!< Most steps of a minimisation, [1, 10000].
  double initialMu = 0.01;         //!< First damping of LEVENBERG_MARQUARDT, >= 0.
  double convergence = 1e-8;       //!< Change of the error at which the iterations end, >= 0.
  bool covariance = false;         //!< See vpMbTracker::setCovarianceComputation().
  bool projectionError = false;    //!< See vpMbTracker::setProjectionErrorComputation().
  //! Which of the six motions (three shifts, three turns) are estimated, 1, and which are kept, 0; see
  //! vpMbTracker::setEstimatedDoF().
  std::vector<unsigned int> motions = {1, 1, 1, 1, 1, 1};
};

/*!
  \ingroup group_multicue_settings
  What vpMbMultiCueTracker::display() draws beside the model.
*/
struct VISP_EXPORT vpDisplaySettings
{
  bool features = false;   //!< See vpMbTracker::setDisplayFeatures().
  bool hypotheses = false; //!< See vpMbMultiCueTracker::setDisplayHypotheses().
  bool particles = false;  //!< See vpMbMultiCueTracker::setDisplayParticles().
};

/*!
  \ingroup group_multicue_settings
  Everything that a configuration file can say.
*/
struct VISP_EXPORT vpMultiCueSettings
{
  vpCameraParameters camera;
  int cues = 1; //!< Sum of vpMbMultiCueTracker::vpTrackerType values, see vpMbMultiCueTracker::setTrackerType().
  vpEdgeCueSettings edge;
  vpPoseHypothesisSettings hypotheses;
  vpParticleSettings particles;
  vpModelViewOptions view; //!< Its details are set by the tracker, from the three members below.
  vpPointCueSettings klt;
  vpColorCueSettings color;
  bool predicts = false;           //!< Start each frame at a predicted pose, see vpMbMultiCueTracker::setPrediction().
  vpPoseKalmanSettings prediction; //!< How the object is taken to move.
  double frameInterval = 1. / 30.; //!< Time between two images, seconds, > 0.
  bool searches = false;           //!< Look for a lost object everywhere, see vpMbMultiCueTracker::setSearch().
  double frameDeadline = 0.;       //!< See vpMbMultiCueTracker::setFrameDeadline(), milliseconds, [0, 10000].
  //! Poses that look alike: "none", "find" (vpFindSymmetries()) or the path of a models_info.json; empty: as
  //! vpMbMultiCueTracker::setSymmetries() says.
  std::string symmetries;
  unsigned int symmetricObject = 0; //!< Its number in models_info.json; 0 for the only one.
  bool useLod = false;              //!< Leave out what is small in the image, see vpMbTracker::setLod().
  double minLineLength = 50.;       //!< With useLod: shortest line, pixels, >= 0.
  double minPolygonArea = 2500.;    //!< With useLod: smallest face, square pixels, >= 0.
  bool clipToImage = false; //!< ViSP's fov_clipping; kept for vpMbTracker::getClipping(), lines are always clipped.
  double goodRatio = 0.4;   //!< See vpMbMultiCueTracker::setGoodMovingEdgesRatioThreshold(), [0, 1].
  //! How much cues count, by vpMbMultiCueTracker::vpTrackerType, (0, 1e6]; 1 for those that are not in it. See
  //! vpMbMultiCueTracker::setFeatureFactors().
  std::map<int, double> factors;
  bool predictsRange = false; //!< See vpMbMultiCueTracker::setPredictedRange().
  vpEstimationSettings estimation;
  vpModelRenderer::Preference renderer = vpModelRenderer::AUTOMATIC; //!< What draws the depth that hides edges.
  bool throwsOnLoss = false;                                         //!< See vpMbMultiCueTracker::setThrowOnLoss().
  vpDisplaySettings display;
  vpModelOptions model;  //!< For the next vpMbMultiCueTracker::loadModel().
  std::string modelFile; //!< Loaded by vpMbMultiCueTracker::loadConfigFile() where there is no model yet; empty: none.

  //! What a tracker of edges starts with, the preset FAST: edges of the texture are used.
  vpMultiCueSettings() { view.textureEdges = true; }
  //! Sets cues, edge.candidates, hypotheses, particles, color, predicts, prediction, predictsRange, searches and
  //! frameDeadline as the preset has them. The others stay. \throw vpException where the preset is none of the known
  //! ones.
  void setPreset(vpMultiCuePreset preset);
  //! \throw vpException naming the first member out of range.
  void check() const;
};

/*!
  \ingroup group_multicue_settings
  Reads ViSP's XML files for model-based trackers, and JSON; writes JSON.

  What a file does not say keeps its default; a file that cannot be read as a whole changes nothing.

  **XML**: the file of vpMbGenericTracker, read by ViSP's vpMbtXmlGenericParser (camera, ecm, sample, klt, face, lod).
  The nodes of its depth trackers and projection_error are known and passed over. The moving-edge threshold is in ViSP's
  old scale, or in gray levels where the node edge_threshold_type of ViSP 3.6 is 1. A camera in the file has no
  distortion. The files of cameras (vpXmlParserCamera) are read too where they hold one camera; of its models, the one
  with distortion is taken. Other than ViSP's parser, this one refuses nodes that it does not know, text that is no
  number, and decimals that ViSP would cut off.

  **JSON**: all keys are optional, with the units and ranges of the members of the same name, and comments are allowed.
  - *preset*: one of "robust", "fast", "static", "teuliere2010" and "petit2014" (vpMultiCueSettings::setPreset()), which
    all other keys override wherever they stand.
  - *Features*, each of them true, false, or an object with its settings: edge, klt and color (the cues), hypotheses,
    particles, prediction, search, symmetries (true: they are found in the model's shape), lod. true and false are short
    for `{"enabled": true}` and `{"enabled": false}`; an object that does not say "enabled" leaves the feature on or off
    as it is.
  - *cues*: a list of one or more of "edge", "color" and "point", which are then all cues that there are.
  - *Objects*: camera, view, factors, estimation, model, display. *Values*: renderer, throwOnLoss.

  The JSON schema multicue-settings.schema.json, installed in share/visp-multicue, has every key with its type, range
  and unit; jsonSchema() is the same. A path in a file is meant from where the file is.

  Of the JSON files of vpMbGenericTracker (ViSP 3.6) and vpRBTracker (3.7) the camera, the moving edges, the points, the
  colours, the steps of the estimation, the model, the cues and what faces are seen is read. Of these and of XML files,
  vpConfigReport tells of each node what it was taken for, or why it was left.
*/
class VISP_EXPORT vpMultiCueSettingsReader
{
public:
  /*!
    \param file Path; .json is read as JSON, everything else as XML.
    \param defaults What the file does not say.
    \param verbose Print the settings that result, as JSON, and what of the file was left out.
    \return \e defaults with what the file says; they are checked.
    \throw vpException naming the file, and the line, node or key, where it is missing, no XML or JSON, has an unknown
    node or key, or a value out of range. What is known there, the nearest of it, or what is in range, is named too.
  */
  static vpMultiCueSettings read(const std::string &file, const vpMultiCueSettings &defaults, bool verbose = false);
  //! Likewise, and tells what of the file was taken. \param report What was taken and left; only where nothing throws.
  static vpMultiCueSettings read(const std::string &file, const vpMultiCueSettings &defaults, vpConfigReport &report);

  /*!
    Writes a JSON file from which read() gets the same settings, to the last digit.
    \param file Path, ends in .json.
    \param settings What to write, all but the details of its view; single settings, no preset.
    \throw vpException naming the file where it cannot be written, or the setting that is out of range.
  */
  static void write(const std::string &file, const vpMultiCueSettings &settings);

  //! \return The JSON schema (draft-07) of the files that read() takes, as text.
  static std::string jsonSchema();
};

END_VISP_NAMESPACE
#endif
