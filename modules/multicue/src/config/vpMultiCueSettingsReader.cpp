// SPDX-License-Identifier: GPL-2.0-or-later
#include <visp3/multicue/vpMultiCueSettings.h>

#include "config/settingsFile.h"
#include "config/settingsJson.h"
#include "config/settingsTable.h"
#include "config/settingsText.h"
#include "config/settingsXml.h"

#include <visp3/core/vpException.h>
#include <visp3/model/vpWholeFile.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
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

std::string besideFile(const std::string &file, const std::string &path)
{
  return std::filesystem::absolute(std::filesystem::path(file).parent_path() / path).lexically_normal().string();
}

// A path in a file is meant from where the file is, and stays right wherever it is written to.
void resolvePaths(const std::string &file, const vpMultiCueSettings &defaults, Draft &draft)
{
  std::string &from = draft.members.symmetries;
  if (!from.empty() && from != defaults.symmetries && from != "none" && from != "find") {
    from = besideFile(file, from);
  }
  std::string &model = draft.members.modelFile;
  if (model.empty() || model == defaults.modelFile) {
    return;
  }
  // vpRBTracker looks from where the program runs.
  std::error_code error;
  const bool isFromProgram =
      draft.report.format == vpConfigReport::Format::RENDER_BASED_JSON && std::filesystem::exists(model, error);
  model = isFromProgram ? std::filesystem::absolute(model).lexically_normal().string() : besideFile(file, model);
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
  resolvePaths(file, defaults, draft);
  draft.report.file = file;
  return {checkedSettings(file, draft), draft.preset, draft.said, draft.report};
}

void vpSettingsDetail::printSettings(const FileSettings &settings)
{
  std::cout << "Settings with '" << settings.report.file << "': " << jsonText(settings.settings);
  if (settings.report.format != vpConfigReport::Format::MULTI_CUE_JSON) {
    std::cout << settings.report;
  }
  std::cout << std::flush;
}

void vpSettingsDetail::writeSettings(const std::string &file, const vpMultiCueSettings &settings,
                                     std::optional<vpMultiCuePreset> preset)
{
  if (!isJson(file)) {
    throw vpException(vpException::badValue,
                      "Configuration file '" + file + "' is to be JSON: its name must end in .json");
  }
  settings.check();
  vpWholeFile::write(file, jsonText(settings, preset));
}

vpMultiCueSettings vpMultiCueSettingsReader::read(const std::string &file, const vpMultiCueSettings &defaults,
                                                  bool verbose)
{
  const FileSettings settings = readSettings(file, defaults);
  if (verbose) {
    printSettings(settings);
  }
  return settings.settings;
}

vpMultiCueSettings vpMultiCueSettingsReader::read(const std::string &file, const vpMultiCueSettings &defaults,
                                                  vpConfigReport &report)
{
  const FileSettings settings = readSettings(file, defaults);
  report = settings.report;
  return settings.settings;
}

void vpMultiCueSettingsReader::write(const std::string &file, const vpMultiCueSettings &settings)
{
  writeSettings(file, settings);
}

std::string vpMultiCueSettingsReader::jsonSchema()
{
  return jsonSchemaText();
}

END_VISP_NAMESPACE
