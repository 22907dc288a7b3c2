// SPDX-License-Identifier: GPL-2.0-or-later
#include <visp3/multicue/vpPoseHypotheses.h>

#include <visp3/core/vpException.h>

BEGIN_VISP_NAMESPACE

namespace {
void require(bool ok, const char *member, double value, const char *range)
{
  if (!ok) {
    throw vpException(vpException::badValue, "vpPoseHypothesisSettings::%s is %g, it must be %s", member, value, range);
  }
}
} // namespace

void vpPoseHypothesisSettings::check() const
{
  require(lambda >= 0. && lambda <= 100., "lambda", lambda, "in [0, 100]");
  require(draws >= 1 && draws <= 10000, "draws", draws, "in [1, 10000]");
  require(minimisations >= 1 && minimisations <= 1000, "minimisations", minimisations, "in [1, 1000]");
  require(mergeTolerance > 0. && mergeTolerance <= 100., "mergeTolerance", mergeTolerance, "in (0, 100] pixels");
  require(reach >= 1. && reach <= 10., "reach", reach, "in [1, 10]");
}

END_VISP_NAMESPACE
