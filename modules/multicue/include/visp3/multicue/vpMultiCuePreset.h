// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpMultiCuePreset_h
#define vpMultiCuePreset_h

#include <visp3/se3/vpCompatibility.h>

#include <string>
#include <vector>

BEGIN_VISP_NAMESPACE

//! \ingroup group_multicue
//! Settings of vpMbMultiCueTracker that go together, by purpose: see \ref multicue_presets.
enum class vpMultiCuePreset
{
  ROBUST, //!< "robust": edges, points and colours, with a prediction and a search that takes 33 ms of a frame; what a
          //!< tracker starts with.
  FAST,   //!< "fast": edges alone, as vpMbMultiCueTracker(vpMbMultiCueTracker::EDGE_TRACKER).
  STATIC, //!< "static": for objects and cameras that rest: as ROBUST, with the least jitter.
  TEULIERE2010, //!< "teuliere2010": edges with several pose hypotheses, and particles, [T10]; and a search for what all
                //!< of them have lost, which the paper leaves open.
  PETIT2014     //!< "petit2014": edges, colours and points in one minimisation, with a Kalman filter, [P14].
};

//! \ingroup group_multicue
//! \return The preset's name, "robust" for instance.
VISP_EXPORT const char *toString(vpMultiCuePreset preset);

//! \ingroup group_multicue
//! \param name As toString() gives it. \throw vpException naming the known ones for others.
VISP_EXPORT vpMultiCuePreset vpMultiCuePresetFromString(const std::string &name);

//! \ingroup group_multicue
//! \return The names of all presets.
VISP_EXPORT std::vector<std::string> vpMultiCuePresetNames();

END_VISP_NAMESPACE
#endif
