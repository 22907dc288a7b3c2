// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef settingsJson_h
#define settingsJson_h

#include <visp3/multicue/vpMultiCueSettings.h>

#include <optional>
#include <string>

BEGIN_VISP_NAMESPACE
namespace vpSettingsDetail {
struct Draft;

//! Puts what a JSON file says into \e draft. \throw vpException naming the file, and the place where it is wrong.
void readJson(const std::string &file, Draft &draft);

/*!
  \param settings What to write. \param preset The one that they began with: it is said first, and of the cues only
  what differs from its own.
  \return The settings as JSON, one line for each, to the last digit.
*/
std::string jsonText(const vpMultiCueSettings &settings, std::optional<vpMultiCuePreset> preset = std::nullopt);

//! vpMultiCueSettingsReader::jsonSchema().
std::string jsonSchemaText();
} // namespace vpSettingsDetail
END_VISP_NAMESPACE
#endif
