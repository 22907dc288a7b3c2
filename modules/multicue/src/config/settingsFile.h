// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef settingsFile_h
#define settingsFile_h

#include <visp3/multicue/vpMultiCueSettings.h>

#include <optional>
#include <set>
#include <string>

BEGIN_VISP_NAMESPACE
namespace vpSettingsDetail {
//! What a configuration file makes of settings, and what of it the file itself says.
struct FileSettings
{
  vpMultiCueSettings settings;
  std::optional<vpMultiCuePreset> preset;
  std::set<std::string> said; //!< Names of entries of settingsTable(); of a JSON file only.
  vpConfigReport report;

  bool says(const std::string &name) const { return said.count(name) > 0; }
};

//! vpMultiCueSettingsReader::read() without printing.
FileSettings readSettings(const std::string &file, const vpMultiCueSettings &defaults);
void printSettings(const FileSettings &settings);
//! Writes a file from which readSettings() gets the same. \param preset See jsonText().
void writeSettings(const std::string &file, const vpMultiCueSettings &settings,
                   std::optional<vpMultiCuePreset> preset = std::nullopt);
} // namespace vpSettingsDetail
END_VISP_NAMESPACE
#endif
