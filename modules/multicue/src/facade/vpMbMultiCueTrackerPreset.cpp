// SPDX-License-Identifier: GPL-2.0-or-later
#include <visp3/multicue/vpMbMultiCueTracker.h>

#include "config/settingsFile.h"
#include "facade/vpTrackerImpl.h"

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
  setPredictedRange(false);
  setSearch(settings.searches);
  setSearchBudget(settings.searchBudget);
  m_impl->choice = vpPresetChoice();
  m_impl->choice.preset = preset;
}

std::optional<vpMbMultiCueTracker::Preset> vpMbMultiCueTracker::getPreset() const
{
  return m_impl->choice.preset;
}

void vpMbMultiCueTracker::loadConfigFile(const std::string &configFile, bool verbose)
{
  vpSettingsDetail::FileSettings file = vpSettingsDetail::readSettings(configFile, m_impl->settings());
  vpPresetChoice choice = m_impl->choice;
  choice.keepsPrediction = choice.keepsPrediction || file.says("prediction.enabled");
  choice.keepsSearch = choice.keepsSearch || file.says("search");
  choice.keepsBudget = choice.keepsBudget || file.says("searchBudget");
  if (file.preset) {
    choice = vpPresetChoice();
    choice.preset = file.preset;
  }
  if (file.says("cues")) {
    choice.takeCues(file.settings.predicts, file.settings.searches, file.settings.searchBudget);
  }
  if (verbose) {
    vpSettingsDetail::printSettings(configFile, file);
  }
  m_impl->apply(file.settings);
  if (file.preset) {
    setPredictedRange(false);
  }
  m_impl->choice = choice;
}

END_VISP_NAMESPACE
