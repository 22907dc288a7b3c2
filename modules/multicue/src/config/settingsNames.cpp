// SPDX-License-Identifier: GPL-2.0-or-later
#include "config/settingsNames.h"

#include "config/settingsTable.h"
#include "config/settingsText.h"

#include <algorithm>

BEGIN_VISP_NAMESPACE
namespace vpSettingsDetail {
const std::vector<OtherName> &otherNames()
{
  static const std::vector<OtherName> names = {
      {"point", "", "klt", ""},                  // As the cue is called in "cues".
      {"searchBudget", "", "frameDeadline", ""}, // As older files have it.
      {"search", "budget", "frameDeadline", ""}, // Likewise.
      {"lod", "use", "lod", enabledKey},
  };
  return names;
}

std::vector<std::string> objectNames()
{
  std::vector<std::string> names = {presetKey};
  for (const Entry &entry : settingsTable()) {
    if (names.back() != entry.object) {
      names.emplace_back(entry.object);
    }
  }
  return names;
}

std::vector<std::string> keysOf(const std::string &object)
{
  std::vector<std::string> keys;
  for (const Entry &entry : settingsTable()) {
    if (entry.object == object) {
      keys.emplace_back(entry.key);
    }
  }
  return keys;
}

bool isValue(const std::string &object)
{
  return keysOf(object) == std::vector<std::string>{""};
}

bool isFeature(const std::string &object)
{
  const std::vector<std::string> keys = keysOf(object);
  return object == "symmetries" || std::find(keys.begin(), keys.end(), enabledKey) != keys.end();
}

std::string unknownText(const std::string &what, const std::string &name, const std::vector<std::string> &known)
{
  return "'" + name + "' is not known " + what + "; the nearest is '" + nearestName(name, known) + "', known are " +
         listText(known);
}
} // namespace vpSettingsDetail
END_VISP_NAMESPACE
