// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpConfigReport_h
#define vpConfigReport_h

#include <visp3/se3/vpCompatibility.h>

#include <iosfwd>
#include <string>
#include <vector>

BEGIN_VISP_NAMESPACE

/*!
  \ingroup group_multicue_settings
  What vpMbMultiCueTracker::loadConfigFile() made of a file: every node and key in it that holds a value is either among
  those that were taken or among those that were left.
*/
struct VISP_EXPORT vpConfigReport
{
  //! Whose file it is.
  enum class Format
  {
    NONE,             //!< No file was read yet.
    MULTI_CUE_JSON,   //!< Of this tracker.
    GENERIC_XML,      //!< Of vpMbGenericTracker and ViSP's older model-based trackers.
    CALIBRATION_XML,  //!< Of a camera, vpXmlParserCamera.
    GENERIC_JSON,     //!< Of vpMbGenericTracker, from ViSP 3.6 on.
    RENDER_BASED_JSON //!< Of vpRBTracker, from ViSP 3.7 on.
  };

  //! A node or key.
  struct Item
  {
    std::string name;    //!< In the file: "ecm/mask/size", "features[0].movingEdge.range".
    std::string setting; //!< Here, where it was taken: "edge.maskSize".
    std::string reason;  //!< Why it was left, or in what it differs from what it was there; may be empty if taken.
  };

  std::string file; //!< As loadConfigFile() got it.
  Format format = Format::NONE;
  std::vector<Item> taken;
  std::vector<Item> left;
  //! Size of the images that the file's camera takes, pixels; 0 where the file does not say it.
  unsigned int imageWidth = 0;
  unsigned int imageHeight = 0; //!< Likewise.

  //! Moves what was taken as a setting to what was left. \param setting "model.file" for instance. \param reason Why.
  void leave(const std::string &setting, const std::string &reason);
};

//! \ingroup group_multicue_settings
//! \return For instance "vpRBTracker's JSON".
VISP_EXPORT const char *toString(vpConfigReport::Format format);

//! \ingroup group_multicue_settings
//! Writes the report, a line for each item.
VISP_EXPORT std::ostream &operator<<(std::ostream &stream, const vpConfigReport &report);

END_VISP_NAMESPACE
#endif
