// SPDX-License-Identifier: GPL-2.0-or-later
#include <visp3/multicue/vpMbMultiCueTracker.h>

#include "config/settingsFile.h"
#include "facade/vpTrackerImpl.h"

#include <visp3/core/vpException.h>

BEGIN_VISP_NAMESPACE

vpMbMultiCueTracker::vpMbMultiCueTracker() : m_impl(std::make_unique<Impl>(*this))
{
  m_impl->assumePreset();
}

void vpMbMultiCueTracker::Impl::assumePreset()
{
  m_tracker.setPreset(Preset::ROBUST);
  choice.isAssumed = true;
}

void vpMbMultiCueTracker::setPreset(Preset preset)
{
  vpMultiCueSettings settings = m_impl->settings();
  settings.setPreset(preset);
  m_impl->engine().cues.edges().setSettings(settings.edge);
  setPoseHypothesisSettings(settings.hypotheses);
  setParticleSettings(settings.particles);
  setTrackerType(settings.cues);
  setColorSettings(settings.color);
  setPrediction(settings.predicts, settings.prediction);
  setPredictedRange(settings.predictsRange);
  setSearch(settings.searches);
  setFrameDeadline(settings.frameDeadline);
  m_impl->choice = vpPresetChoice();
  m_impl->choice.preset = preset;
}

std::optional<vpMbMultiCueTracker::Preset> vpMbMultiCueTracker::getPreset() const
{
  return m_impl->choice.preset;
}

namespace {
vpPresetChoice choiceWith(vpSettingsDetail::FileSettings &file, const vpPresetChoice &before)
{
  vpPresetChoice choice = before;
  choice.keepsPrediction = choice.keepsPrediction || file.says("prediction.enabled");
  choice.keepsSearch = choice.keepsSearch || file.says("search.enabled");
  choice.keepsDeadline = choice.keepsDeadline || file.says("frameDeadline");
  if (file.preset) {
    choice = vpPresetChoice();
    choice.preset = file.preset;
  }
  if (file.says("cues")) {
    choice.takeCues(file.settings.predicts, file.settings.searches, file.settings.frameDeadline);
  }
  return choice;
}
} // namespace

void vpMbMultiCueTracker::Impl::load(const std::string &configFile, bool verbose)
{
  const vpMultiCueSettings before = settings();
  vpSettingsDetail::FileSettings file = vpSettingsDetail::readSettings(configFile, before);
  const vpPresetChoice choiceBefore = choice;
  const vpPresetChoice choiceAfter = choiceWith(file, choice);
  const bool saysModel = !file.settings.modelFile.empty() && file.settings.modelFile != before.modelFile;
  apply(file.settings);
  choice = choiceAfter;
  if (saysModel && !parts) {
    try {
      m_tracker.loadModel(file.settings.modelFile, verbose);
      modelFile = file.settings.modelFile;
    } catch (const std::exception &e) {
      apply(before);
      choice = choiceBefore;
      throw vpException(vpException::badValue,
                        "Configuration file '" + configFile + "': its model cannot be loaded, " + e.what());
    }
  } else if (saysModel) {
    file.report.leave("model.file", "a model was loaded before");
  }
  if (verbose) {
    vpSettingsDetail::printSettings(file);
  }
  report = file.report;
}

void vpMbMultiCueTracker::loadConfigFile(const std::string &configFile, bool verbose)
{
  m_impl->load(configFile, verbose);
}

const vpConfigReport &vpMbMultiCueTracker::getConfigReport() const
{
  return m_impl->report;
}

void vpMbMultiCueTracker::saveConfigFile(const std::string &filename) const
{
  vpSettingsDetail::writeSettings(filename, m_impl->settings(), m_impl->choice.preset);
}

END_VISP_NAMESPACE
