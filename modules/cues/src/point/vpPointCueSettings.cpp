// SPDX-License-Identifier: GPL-2.0-or-later
#include <visp3/cues/vpPointCue.h>

#include <visp3/core/vpException.h>

BEGIN_VISP_NAMESPACE

namespace {
void require(bool ok, const char *member, double value, const char *range)
{
  if (!ok) {
    throw vpException(vpException::badValue, "vpPointCueSettings::%s is %g, it must be %s", member, value, range);
  }
}
} // namespace

void vpPointCueSettings::check() const
{
  require(maxFeatures >= 1 && maxFeatures <= 100000, "maxFeatures", maxFeatures, "in [1, 100000]");
  require(windowSize >= 3 && windowSize <= 63, "windowSize", windowSize, "in [3, 63] pixels");
  require(quality > 0. && quality <= 1., "quality", quality, "in (0, 1]");
  require(minDistance >= 0. && minDistance <= 1000., "minDistance", minDistance, "in [0, 1000] pixels");
  require(harris >= 0. && harris <= 1., "harris", harris, "in [0, 1]");
  require(blockSize >= 1 && blockSize <= 63, "blockSize", blockSize, "in [1, 63] pixels");
  require(pyramidLevels >= 0 && pyramidLevels <= 10, "pyramidLevels", pyramidLevels, "in [0, 10]");
  require(leastWeight >= 0. && leastWeight < 1., "leastWeight", leastWeight, "in [0, 1)");
  require(maskBorder <= 100, "maskBorder", maskBorder, "in [0, 100] pixels");
}

END_VISP_NAMESPACE
