// SPDX-License-Identifier: GPL-2.0-or-later
#include <visp3/se3/vpPoseParticleSettings.h>

#include <visp3/core/vpException.h>

#include <cmath>

BEGIN_VISP_NAMESPACE

namespace {
void requirePositive(const char *member, double value)
{
  if (!(value > 0.) || !std::isfinite(value)) {
    throw vpException(vpException::badValue, "vpPoseParticleSettings::%s is %g, it must be finite and above 0", member,
                      value);
  }
}
} // namespace

void vpPoseParticleSettings::check() const
{
  requirePositive("number", static_cast<double>(number));
  requirePositive("translationNoise", translationNoise);
  requirePositive("rotationNoise", rotationNoise);
  requirePositive("noiseTime", noiseTime);
  requirePositive("proposalSpread", proposalSpread);
  if (!(noiseGrowth >= 0. && noiseGrowth <= 1.5)) {
    throw vpException(vpException::badValue, "vpPoseParticleSettings::noiseGrowth is %g, it must be from 0 to 1.5",
                      noiseGrowth);
  }
  if (!(jumpShare >= 0. && jumpShare <= 0.9)) {
    throw vpException(vpException::badValue, "vpPoseParticleSettings::jumpShare is %g, it must be from 0 to 0.9",
                      jumpShare);
  }
  if (!(jumpFactor >= 1. && jumpFactor <= 100.)) {
    throw vpException(vpException::badValue, "vpPoseParticleSettings::jumpFactor is %g, it must be from 1 to 100",
                      jumpFactor);
  }
}

END_VISP_NAMESPACE
