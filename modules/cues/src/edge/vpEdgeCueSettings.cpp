// SPDX-License-Identifier: GPL-2.0-or-later
#include <visp3/cues/vpEdgeCue.h>

#include <visp3/core/vpException.h>

BEGIN_VISP_NAMESPACE

namespace {
void require(bool ok, const char *member, double value, const char *range)
{
  if (!ok) {
    throw vpException(vpException::badValue, "vpEdgeCueSettings::%s is %g, it must be %s", member, value, range);
  }
}
} // namespace

double vpEdgeCueSettings::toLikelihood(double contrast, unsigned int maskSize)
{
  // ViSP's masks add up to 100 n floor(n / 2) on either side of the edge, and the likelihood is the sum of two
  // responses.
  return contrast * 2. * 100. * maskSize * static_cast<double>(maskSize / 2);
}

double vpEdgeCueSettings::toContrast(double threshold, ThresholdScale scale, unsigned int maskSize)
{
  return scale == CONTRAST ? threshold : threshold / toLikelihood(1., maskSize);
}

void vpEdgeCueSettings::set(const vpMe &me, ThresholdScale scale)
{
  vpEdgeCueSettings changed = *this;
  changed.range = me.getRange();
  changed.maskSize = me.getMaskSize();
  changed.contrast = toContrast(me.getThreshold(), scale, me.getMaskSize());
  changed.mu1 = me.getMu1();
  changed.mu2 = me.getMu2();
  changed.check();
  *this = changed;
}

void vpEdgeCueSettings::set(const vpMe &me)
{
  set(me, vpMeHasNormalizedThreshold(me) ? CONTRAST : LIKELIHOOD);
}

void vpEdgeCueSettings::check() const
{
  // First, because set() divides the threshold by it.
  require(maskSize >= 3 && maskSize <= 15, "maskSize", maskSize, "in [3, 15] pixels");
  require(range >= 1. && range <= maxRange, "range", range, "in [1, 100] pixels");
  require(contrast > 0. && contrast <= 255., "contrast", contrast, "in (0, 255] gray levels");
  require(mu1 >= 0. && mu1 <= 1., "mu1", mu1, "in [0, 1]");
  require(mu2 >= 0., "mu2", mu2, "at least 0");
  require(candidates >= 1 && candidates <= 8, "candidates", candidates, "in [1, 8]");
}

END_VISP_NAMESPACE
