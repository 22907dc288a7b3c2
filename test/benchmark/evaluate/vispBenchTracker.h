// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef benchVispBenchTracker_h
#define benchVispBenchTracker_h

#include "evaluate/benchTracker.h"

namespace bench {

//! "visp-edge" and, where ViSP was built with OpenCV, "visp-klt" and "visp-edge-klt".
std::vector<std::string> vispTrackers();

//! vpMbGenericTracker with one camera, see makeTracker().
std::unique_ptr<BenchTracker> makeVispTracker(const std::string &name, const SequenceObject &object,
                                              const vpCameraParameters &cam, const std::string &config);

} // namespace bench
#endif
