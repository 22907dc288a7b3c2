// SPDX-License-Identifier: GPL-2.0-or-later
#include "config/settingsTable.h"

#include <visp3/multicue/vpMbMultiCueTracker.h>

#include <tuple>

BEGIN_VISP_NAMESPACE
namespace vpSettingsDetail {
CameraParts CameraParts::of(const vpCameraParameters &camera)
{
  CameraParts parts = {camera.get_px(), camera.get_py(), camera.get_u0(), camera.get_v0(), std::nullopt, std::nullopt};
  if (camera.get_projModel() != vpCameraParameters::perspectiveProjWithoutDistortion) {
    parts.kud = camera.get_kud();
    parts.kdu = camera.get_kdu();
  }
  return parts;
}

vpCameraParameters CameraParts::camera() const
{
  vpCameraParameters camera;
  if (kud || kdu) {
    camera.initPersProjWithDistortion(px, py, u0, v0, kud.value_or(0.), kdu.value_or(0.));
  } else {
    camera.initPersProjWithoutDistortion(px, py, u0, v0);
  }
  return camera;
}

bool CameraParts::operator==(const CameraParts &other) const
{
  return std::tie(px, py, u0, v0, kud, kdu) == std::tie(other.px, other.py, other.u0, other.v0, other.kud, other.kdu);
}

Draft::Draft(const vpMultiCueSettings &settings)
    : members(settings), camera(CameraParts::of(settings.camera)), cues{settings.cues}
{
}

namespace {
int switched(int sum, const std::optional<bool> &isOn, int type)
{
  return isOn ? (*isOn ? sum | type : sum & ~type) : sum;
}
} // namespace

vpMultiCueSettings Draft::settings() const
{
  vpMultiCueSettings settings = members;
  settings.cues = switched(cues.sum, usesEdges, vpMbMultiCueTracker::EDGE_TRACKER);
  settings.cues = switched(settings.cues, usesPoints, vpMbMultiCueTracker::KLT_TRACKER);
  settings.cues = switched(settings.cues, usesColors, vpMbMultiCueTracker::COLOR_TRACKER);
  if (!(camera == CameraParts::of(members.camera))) {
    settings.camera = camera.camera();
  }
  return settings;
}

void Draft::setPreset(vpMultiCuePreset chosen)
{
  members.setPreset(chosen);
  cues.sum = members.cues;
  preset = chosen;
}

void Draft::sayCuesBeside(vpMultiCuePreset other)
{
  vpMultiCueSettings fresh;
  fresh.setPreset(other);
  const auto say = [&](int type, std::optional<bool> &isOn) {
    if (((cues.sum ^ fresh.cues) & type) != 0) {
      isOn = (cues.sum & type) != 0;
    }
  };
  say(vpMbMultiCueTracker::EDGE_TRACKER, usesEdges);
  say(vpMbMultiCueTracker::KLT_TRACKER, usesPoints);
  say(vpMbMultiCueTracker::COLOR_TRACKER, usesColors);
}
} // namespace vpSettingsDetail
END_VISP_NAMESPACE
