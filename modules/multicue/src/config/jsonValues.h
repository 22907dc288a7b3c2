// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef jsonValues_h
#define jsonValues_h

#include "config/settingsTable.h"

#include <nlohmann/json.hpp>

BEGIN_VISP_NAMESPACE
namespace vpSettingsDetail {
using Json = nlohmann::ordered_json; // In the order of the table.

//! \return False where the value is none that the setting can have; the draft then is undefined.
bool readPlace(const Entry &entry, const Json &given, Draft &draft);
//! \return The value of a setting that is set.
Json placeAsJson(const Entry &entry, Draft &draft);
} // namespace vpSettingsDetail
END_VISP_NAMESPACE
#endif
