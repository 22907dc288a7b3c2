// SPDX-License-Identifier: GPL-2.0-or-later
#include <visp3/multicue/vpParticleSettings.h>

#include <visp3/core/vpException.h>

BEGIN_VISP_NAMESPACE

namespace {
void require(bool ok, const char *member, double value, const char *range)
{
  if (!ok) {
    throw vpException(vpException::badValue, "vpParticleSettings::%s is %g, it must be %s", member, value, range);
  }
}

void requireNumber(unsigned int value, const char *member)
{
  require(value >= 10 && value <= 10000, member, value, "in [10, 10000]");
}
} // namespace

void vpParticleSettings::check() const
{
  requireNumber(number, "number");
  requireNumber(leastNumber, "leastNumber");
  requireNumber(mostNumber, "mostNumber");
  require(mostNumber >= leastNumber, "mostNumber", mostNumber, "at least leastNumber");
  require(budget >= 0. && budget <= 1000., "budget", budget, "in [0, 1000] milliseconds");
  require(translationNoise > 0. && translationNoise <= 1., "translationNoise", translationNoise,
          "in (0, 1] diameters of the object");
  require(rotationNoise > 0. && rotationNoise <= 1., "rotationNoise", rotationNoise, "in (0, 1] radians");
  require(motionNoise >= 0. && motionNoise <= 10., "motionNoise", motionNoise, "in [0, 10]");
  require(jumpShare >= 0. && jumpShare <= 0.9, "jumpShare", jumpShare, "in [0, 0.9]");
  require(jumpFactor >= 1. && jumpFactor <= 100., "jumpFactor", jumpFactor, "in [1, 100]");
  require(noiseFrame == OBJECT || noiseFrame == CAMERA, "noiseFrame", noiseFrame, "OBJECT or CAMERA");
  require(motion == RANDOM_WALK || motion == VELOCITY, "motion", motion, "RANDOM_WALK or VELOCITY");
  require(lambda >= 0. && lambda <= 1000., "lambda", lambda, "in [0, 1000]");
  require(sharpness >= 0. && sharpness <= 1000., "sharpness", sharpness, "in [0, 1000]");
  require(bestShare >= 0. && bestShare <= 1., "bestShare", bestShare, "in [0, 1]");
  require(mostOptimised <= 100, "mostOptimised", mostOptimised, "in [0, 100]");
  require(output == MEAN || output == BEST_MODE, "output", output, "MEAN or BEST_MODE");
  require(modeTranslation > 0. && modeTranslation <= 10., "modeTranslation", modeTranslation,
          "in (0, 10] diameters of the object");
  require(modeRotation > 0. && modeRotation <= 3., "modeRotation", modeRotation, "in (0, 3] radians");
}

END_VISP_NAMESPACE
