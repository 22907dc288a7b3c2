// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef settingsNames_h
#define settingsNames_h

#include <visp3/se3/vpCompatibility.h>

#include <string>
#include <vector>

BEGIN_VISP_NAMESPACE
namespace vpSettingsDetail {
//! The key of a feature's object that switches it on and off.
constexpr const char *enabledKey = "enabled";
//! Keys of a JSON file that are no settings.
constexpr const char *presetKey = "preset";
constexpr const char *schemaKey = "$schema";

//! Another name that files may use for a setting or, where both keys are empty, for an object.
struct OtherName
{
  const char *object;
  const char *key;
  const char *knownObject;
  const char *knownKey;
};
const std::vector<OtherName> &otherNames();

//! \return Names of all objects, the preset among them, in the order of the table.
std::vector<std::string> objectNames();
//! \return Keys of an object; one that is empty where a value stands for the object.
std::vector<std::string> keysOf(const std::string &object);
//! \return True where the object is a value.
bool isValue(const std::string &object);
//! \return True where true and false stand for an object.
bool isFeature(const std::string &object);
//! \return That a name is not known, which known one is the nearest, and what is known.
std::string unknownText(const std::string &what, const std::string &name, const std::vector<std::string> &known);
} // namespace vpSettingsDetail
END_VISP_NAMESPACE
#endif
