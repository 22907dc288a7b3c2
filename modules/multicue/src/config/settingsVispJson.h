// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef settingsVispJson_h
#define settingsVispJson_h

#include <visp3/multicue/vpConfigReport.h>

#include <nlohmann/json.hpp>

BEGIN_VISP_NAMESPACE
namespace vpSettingsDetail {
//! A configuration of another tracker of ViSP in the words of this one.
struct VispJson
{
  nlohmann::ordered_json known; //!< What there is here too.
  vpConfigReport report;        //!< Its format is NONE where the file is none of ViSP's.
};

//! Reads the JSON files of vpMbGenericTracker (ViSP 3.6) and vpRBTracker (3.7). \throw vpException without the file's
//! name where it is one of them and broken.
VispJson readVispJson(const nlohmann::ordered_json &json);
} // namespace vpSettingsDetail
END_VISP_NAMESPACE
#endif
