// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef benchMultiCueBenchTracker_h
#define benchMultiCueBenchTracker_h

#include "evaluate/benchTracker.h"

namespace bench {

//! Names of the presets of vpMbMultiCueTracker.
std::vector<std::string> multiCuePresets();

//! vpMbMultiCueTracker with one of its presets, see makeTracker().
std::unique_ptr<BenchTracker> makeMultiCueTracker(const std::string &preset, const SequenceObject &object,
                                                  const vpCameraParameters &cam, const std::string &config, int cues);

} // namespace bench
#endif
