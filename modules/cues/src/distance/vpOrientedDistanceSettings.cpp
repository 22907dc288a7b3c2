// SPDX-License-Identifier: GPL-2.0-or-later
#include <visp3/cues/vpOrientedDistanceMap.h>

#include "distance/vpChamfer.h"

#include <visp3/core/vpException.h>

BEGIN_VISP_NAMESPACE

namespace {
void require(bool ok, const char *member, double value, const char *range)
{
  if (!ok) {
    throw vpException(vpException::badValue, "vpOrientedDistanceSettings::%s is %g, it must be %s", member, value,
                      range);
  }
}

// A not-a-number is not in the range either.
bool isWithin(double value, double low, double high)
{
  return value >= low && value <= high;
}
} // namespace

void vpOrientedDistanceSettings::check() const
{
  const bool isScale = isWithin(scale, 0.124, 1.) && std::fabs(1. / scale - std::round(1. / scale)) < 1e-6;
  require(isScale, "scale", scale, "1, 1 / 2, 1 / 3, ... or 1 / 8");
  require(isWithin(maxDistance, 1., vpChamfer::maxDistance / scale), "maxDistance", maxDistance,
          "at least 1 image pixel, and at most 23 / scale");
  require(isWithin(contrast, 1., 255.), "contrast", contrast, "in [1, 255] gray levels");
  require(isWithin(noiseFactor, 0., 20.), "noiseFactor", noiseFactor, "in [0, 20]");
  require(isWithin(clutterFactor, 0., 5.), "clutterFactor", clutterFactor, "in [0, 5]");
}

END_VISP_NAMESPACE
