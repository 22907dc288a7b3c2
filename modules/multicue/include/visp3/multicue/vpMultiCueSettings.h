// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpMultiCueSettings_h
#define vpMultiCueSettings_h

#include <visp3/core/vpCameraParameters.h>
#include <visp3/cues/vpEdgeCue.h>
#include <visp3/model/vpModelView.h>

#include <string>

BEGIN_VISP_NAMESPACE

/*! \ingroup group_multicue_settings Parameters of ViSP's KLT tracker, with the defaults of vpMbGenericTracker. */
struct VISP_EXPORT vpKltSettings
{
  int maxFeatures = 10000;     //!< Largest number of points, [1, 100000].
  int windowSize = 5;          //!< Side of the window that is compared, pixels, [3, 63].
  double quality = 0.01;       //!< Corners below this share of the best one's strength are left out, (0, 1].
  double minDistance = 5.;     //!< Of two points, pixels, [0, 1000].
  double harris = 0.01;        //!< Free parameter of Harris' detector, [0, 1].
  int blockSize = 3;           //!< Side of the window for the corner's strength, pixels, [1, 63].
  int pyramidLevels = 3;       //!< Levels of the image pyramid, [1, 10].
  unsigned int maskBorder = 5; //!< Points closer to the border of their face are left out, pixels, [0, 100].
};

/*! \ingroup group_multicue_settings Everything that a configuration file can say. */
struct VISP_EXPORT vpMultiCueSettings
{
  vpCameraParameters camera;
  vpEdgeCueSettings edge;
  vpModelViewOptions view; //!< Its details are set by the tracker, from the three members below.
  vpKltSettings klt;
  bool useLod = false;           //!< Leave out what is small in the image, see vpMbTracker::setLod().
  double minLineLength = 50.;    //!< With useLod: shortest line, pixels, >= 0.
  double minPolygonArea = 2500.; //!< With useLod: smallest face, square pixels, >= 0.
  bool clipToImage = false; //!< ViSP's fov_clipping; kept for vpMbTracker::getClipping(), lines are always clipped.

  //! \throw vpException naming the first member out of range.
  void check() const;
};

/*!
  \ingroup group_multicue_settings
  Reads ViSP's XML files for model-based trackers, and JSON.

  The XML file is the one of vpMbGenericTracker (camera, ecm, klt, face, lod; its depth and projection_error nodes are
  known and passed over); its moving-edge threshold is in the old scale, or in gray levels where the node
  edge_threshold_type of ViSP 3.6 says so. The JSON file has an object for each of camera, edge, view, klt and lod,
  whose keys are the members' names.
*/
class VISP_EXPORT vpMultiCueSettingsReader
{
public:
  /*!
    \param file Path; .json is read as JSON, everything else as XML.
    \param defaults What the file does not say.
    \param verbose Print what was read.
    \throw vpException naming the file, and the line, node or key, where it is missing, no XML or JSON, has an unknown
    node or key, or a value out of range.
  */
  static vpMultiCueSettings read(const std::string &file, const vpMultiCueSettings &defaults, bool verbose = false);

  /*!
    Writes a JSON file that read() understands.
    \throw vpException naming the file where it cannot be written.
  */
  static void write(const std::string &file, const vpMultiCueSettings &settings);
};

END_VISP_NAMESPACE
#endif
