// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpMultiCueSettings_h
#define vpMultiCueSettings_h

#include <visp3/core/vpCameraParameters.h>
#include <visp3/cues/vpColorCueSettings.h>
#include <visp3/cues/vpEdgeCue.h>
#include <visp3/cues/vpPointCue.h>
#include <visp3/model/vpModelView.h>
#include <visp3/multicue/vpMultiCuePreset.h>
#include <visp3/multicue/vpParticleSettings.h>
#include <visp3/multicue/vpPoseHypotheses.h>
#include <visp3/se3/vpPoseKalmanFilter.h>

#include <string>

BEGIN_VISP_NAMESPACE

/*! \ingroup group_multicue_settings Everything that a configuration file can say. */
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
  double searchBudget = 0.;        //!< See vpMbMultiCueTracker::setSearchBudget(), milliseconds, [0, 10000].
  //! Poses that look alike: "none", "find" (vpFindSymmetries()) or the path of a models_info.json; empty: as
  //! vpMbMultiCueTracker::setSymmetries() says.
  std::string symmetries;
  unsigned int symmetricObject = 0; //!< Its number in models_info.json; 0 for the only one.
  bool useLod = false;              //!< Leave out what is small in the image, see vpMbTracker::setLod().
  double minLineLength = 50.;       //!< With useLod: shortest line, pixels, >= 0.
  double minPolygonArea = 2500.;    //!< With useLod: smallest face, square pixels, >= 0.
  bool clipToImage = false; //!< ViSP's fov_clipping; kept for vpMbTracker::getClipping(), lines are always clipped.

  //! What a tracker of edges starts with, the preset FAST: edges of the texture are used.
  vpMultiCueSettings() { view.textureEdges = true; }
  //! Sets cues, edge.candidates, hypotheses, particles, color, predicts, prediction, searches and searchBudget as the
  //! preset has them. The others stay. \throw vpException where the preset is none of the known ones.
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

  **JSON**: *preset*, one of "robust", "fast", "static", "teuliere2010" and "petit2014"
  (vpMultiCueSettings::setPreset()), which all other keys override wherever they stand; the list *cues* of one or more
  of "edge", "color" and "point", and an object, or what is said, for each of
  - camera: px, py, u0, v0 and, where there is distortion, kud, kdu; a camera without both has none;
  - edge: range, contrast, mu1, mu2, maskSize, candidates;
  - hypotheses: enabled, lambda, draws, minimisations, mergeTolerance, reach, seed;
  - particles: enabled, number, leastNumber, mostNumber, budget, translationNoise, rotationNoise, motionNoise,
    jumpShare, jumpFactor, noiseFrame ("object" or "camera"), motion ("random walk" or "velocity"), lambda, sharpness,
    bestShare, mostOptimised, output ("mean" or "best mode"), modeTranslation, modeRotation, seed;
  - view: sampleStep, appearAngle, disappearAngle, nearDistance, farDistance, border, visibilitySize, textureEdges,
    clipToImage;
  - klt: maxFeatures, windowSize, quality, minDistance, harris, blockSize, pyramidLevels, maskBorder;
  - color: spacing, lines, scales, bands, length, alpha, regularisation, contourDeviation, histogramLength,
    learningRate, rows ("lines" or "pixels"); scales and bands are lists of numbers;
  - prediction: enabled, frameInterval, translationWander, rotationWander, startTranslation, startRotation, longestGap,
    smooth;
  - search: true or false, no object;
  - searchBudget: a number, no object;
  - symmetries: from ("none", "find", or the path of a models_info.json, from the folder of the settings' file), object;
  - lod: use, minLineLength, minPolygonArea,

  all of them optional, with the units and ranges of the members of the same name. Comments are allowed. Of the JSON
  files of vpMbGenericTracker (ViSP 3.6) and vpRBTracker (3.7) the camera, the moving edges, the points, the cues and
  what faces are seen is read; what there is nothing like here is printed.
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
    node or key, or a value out of range. What is known there, or in range, is named too.
  */
  static vpMultiCueSettings read(const std::string &file, const vpMultiCueSettings &defaults, bool verbose = false);

  /*!
    Writes a JSON file from which read() gets the same settings, to the last digit.
    \param file Path, ends in .json.
    \param settings What to write, all but the details of its view; single settings, no preset.
    \throw vpException naming the file where it cannot be written, or the setting that is out of range.
  */
  static void write(const std::string &file, const vpMultiCueSettings &settings);
};

END_VISP_NAMESPACE
#endif
