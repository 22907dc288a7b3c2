// SPDX-License-Identifier: GPL-2.0-or-later
#include <visp3/multicue/vpMultiCueSettings.h>

#include "config/settingsFile.h"
#include "config/settingsJson.h"
#include "config/settingsTable.h"
#include "config/settingsText.h"
#include "config/settingsXml.h"

#include <visp3/core/vpException.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <iostream>

BEGIN_VISP_NAMESPACE
using namespace vpSettingsDetail;

namespace {
bool isJson(const std::string &file)
{
  std::string extension = std::filesystem::path(file).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension == ".json";
}

// A path in a file is meant from where the file is, and stays right wherever it is written to.
void resolveSymmetries(const std::string &file, const vpMultiCueSettings &defaults, vpMultiCueSettings &settings)
{
  std::string &from = settings.symmetries;
  if (!from.empty() && from != defaults.symmetries && from != "none" && from != "find") {
    from = std::filesystem::absolute(std::filesystem::path(file).parent_path() / from).lexically_normal().string();
  }
}

vpMultiCueSettings checkedSettings(const std::string &file, const Draft &draft)
{
  try {
    const vpMultiCueSettings settings = draft.settings();
    settings.check();
    return settings;
  } catch (const vpException &error) {
    throw vpException(vpException::badValue, "Configuration file '" + file + "': with it, " + error.what());
  }
}
} // namespace

FileSettings vpSettingsDetail::readSettings(const std::string &file, const vpMultiCueSettings &defaults)
{
  Draft draft(defaults);
  if (isJson(file)) {
    readJson(file, draft);
  } else {
    readXml(file, draft);
  }
  resolveSymmetries(file, defaults, draft.members);
  return {checkedSettings(file, draft), draft.preset, draft.said, draft.tracker, draft.left};
}

void vpSettingsDetail::printSettings(const std::string &file, const FileSettings &settings)
{
  std::cout << "Settings with '" << file << "': " << jsonText(settings.settings);
  if (!settings.tracker.empty()) {
    std::cout << "'" << file << "' is a configuration of " << settings.tracker
              << ", the above is what it has in common\n";
  }
  if (!settings.left.empty()) {
    std::cout << "Left out of '" << file << "', as there is nothing like it here: " << listText(settings.left) << "\n";
  }
  std::cout << std::flush;
}

vpMultiCueSettings vpMultiCueSettingsReader::read(const std::string &file, const vpMultiCueSettings &defaults,
                                                  bool verbose)
{
  const FileSettings settings = readSettings(file, defaults);
  if (verbose) {
    printSettings(file, settings);
  }
  return settings.settings;
}

void vpMultiCueSettingsReader::write(const std::string &file, const vpMultiCueSettings &settings)
{
  if (!isJson(file)) {
    throw vpException(vpException::badValue,
                      "Configuration file '" + file + "' is to be JSON: its name must end in .json");
  }
  settings.check();
  std::ofstream stream(file, std::ios::binary);
  stream << jsonText(settings);
  stream.close();
  if (!stream) {
    throw vpException(vpException::ioError, "Configuration file '" + file + "' cannot be written");
  }
}

END_VISP_NAMESPACE
