// SPDX-License-Identifier: GPL-2.0-or-later
#include <visp3/multicue/vpMultiCueSettings.h>

#include "config/settingsTable.h"
#include "config/settingsText.h"

#include <visp3/core/vpException.h>
#include <visp3/multicue/vpCueKind.h>

BEGIN_VISP_NAMESPACE
using namespace vpSettingsDetail;

void vpMultiCueSettings::check() const
{
  if (camera.get_projModel() != vpCameraParameters::perspectiveProjWithoutDistortion &&
      camera.get_projModel() != vpCameraParameters::perspectiveProjWithDistortion) {
    throw vpException(vpException::badValue, "vpMultiCueSettings::camera must be a perspective projection, with or "
                                             "without distortion; undistort the images of other cameras first");
  }
  Draft draft(*this);
  for (const Entry &entry : settingsTable()) {
    for (const double value : entry.values(draft)) {
      if (!entry.range.contains(value)) {
        throw vpException(vpException::badValue, "vpMultiCueSettings: " + entry.name() + " is " + numberText(value) +
                                                     ", it must be " + entry.describe());
      }
    }
  }
  if (cues <= 0 || (cues & ~vpCueKinds::allTypes()) != 0) {
    throw vpException(vpException::badValue,
                      "vpMultiCueSettings::cues is %d, it must be a sum of vpMbMultiCueTracker's %s", cues,
                      vpCueKinds::listText().c_str());
  }
  for (const auto &[type, factor] : factors) {
    if (vpCueKinds::find(type) == nullptr) {
      throw vpException(vpException::badValue, "vpMultiCueSettings::factors has one of cue %d, there are %s", type,
                        vpCueKinds::listText().c_str());
    }
  }
  constexpr std::size_t sixMotions = 6;
  if (estimation.motions.size() != sixMotions) {
    throw vpException(vpException::badValue, "vpMultiCueSettings: estimation.motions has %d values, it must have six",
                      static_cast<int>(estimation.motions.size()));
  }
  // What members have to do with each other.
  edge.check();
  hypotheses.check();
  particles.check();
  color.check();
  prediction.check();
  view.check();
  klt.check();
  model.check();
}

END_VISP_NAMESPACE
