// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpSurfaceTrust_h
#define vpSurfaceTrust_h

#include <visp3/se3/vpCompatibility.h>

#include <algorithm>

BEGIN_VISP_NAMESPACE

// What places of the surface that were never seen count for: no evidence for a pose, and little against it.
constexpr double vpUnknownCorrelation = 0.3;
// How much the surface counts beside the other cues; texture: see vpSurfaceMemory. [0, 1].
inline double vpSurfaceTrust(double texture)
{
  return std::min(1., 2. * texture);
}

END_VISP_NAMESPACE
#endif
