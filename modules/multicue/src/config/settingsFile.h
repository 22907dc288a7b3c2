// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef settingsFile_h
#define settingsFile_h

#include <visp3/multicue/vpMultiCueSettings.h>

#include <optional>
#include <set>
#include <string>
#include <vector>

BEGIN_VISP_NAMESPACE
namespace vpSettingsDetail {
//! What a configuration file makes of settings, and what of it the file itself says.
struct FileSettings
{
  vpMultiCueSettings settings;
  std::optional<vpMultiCuePreset> preset;
  std::set<std::string> said;    //!< Names of entries of settingsTable(); of a JSON file only.
  std::string tracker;           //!< The one of ViSP that a JSON file is written for, if it is not this one.
  std::vector<std::string> left; //!< What a file of another tracker of ViSP says and there is nothing like here.

  bool says(const std::string &name) const { return said.count(name) > 0; }
};

//! vpMultiCueSettingsReader::read() without printing.
FileSettings readSettings(const std::string &file, const vpMultiCueSettings &defaults);
void printSettings(const std::string &file, const FileSettings &settings);
} // namespace vpSettingsDetail
END_VISP_NAMESPACE
#endif
