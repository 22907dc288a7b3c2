// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpSurfacePatches_h
#define vpSurfacePatches_h

#include <visp3/model/vpSurfaceSamples.h>

#include <cstdint>

BEGIN_VISP_NAMESPACE

// Puts places that are near to each other and look the same way into patches. most: of patches.
// Returns the patch of each place.
std::vector<std::uint8_t> vpGroupIntoPatches(const std::vector<vpSurfaceSample> &samples, std::size_t most);

END_VISP_NAMESPACE
#endif
