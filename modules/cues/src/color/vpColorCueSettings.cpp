// SPDX-License-Identifier: GPL-2.0-or-later
#include <visp3/cues/vpColorCueSettings.h>

#include <visp3/core/vpException.h>

BEGIN_VISP_NAMESPACE

namespace {
void require(bool ok, const char *member, double value, const char *range)
{
  if (!ok) {
    throw vpException(vpException::badValue, "vpColorCueSettings::%s is %g, it must be %s", member, value, range);
  }
}

// A not-a-number is not in the range either.
bool isWithin(double value, double low, double high)
{
  return value >= low && value <= high;
}

template <typename T> void requireFalling(const std::vector<T> &values, const char *member)
{
  for (std::size_t i = 1; i < values.size(); ++i) {
    require(values[i] < values[i - 1], member, static_cast<double>(values[i]), "below the one of the level before it");
  }
}
} // namespace

void vpColorCueSettings::check() const
{
  require(isWithin(spacing, 1., 100.), "spacing", spacing, "in [1, 100] pixels");
  require(lines >= 10 && lines <= 5000, "lines", lines, "in [10, 5000]");
  require(scales.size() <= 8, "scales.size()", static_cast<double>(scales.size()), "at most 8");
  for (const unsigned int scale : scales) {
    require(scale >= 1 && scale <= 20, "scales", scale, "in [1, 20] pixels");
  }
  requireFalling(scales, "scales");
  require(!bands.empty() && bands.size() <= 8, "bands.size()", static_cast<double>(bands.size()), "in [1, 8]");
  for (const double band : bands) {
    require(isWithin(band, 0.5, 20.), "bands", band, "in [0.5, 20] pixels");
  }
  requireFalling(bands, "bands");
  require(isWithin(length, 3., 60.), "length", length, "in [3, 60] pixels");
  require(alpha > 0. && alpha <= 1., "alpha", alpha, "in (0, 1]");
  require(isWithin(regularisation, 1., 100.), "regularisation", regularisation, "in [1, 100] gray levels");
  require(isWithin(contourDeviation, 0.05, 5.), "contourDeviation", contourDeviation, "in [0.05, 5] pixels");
  require(isWithin(histogramLength, 3., 60.), "histogramLength", histogramLength, "in [3, 60] pixels");
  require(isWithin(learningRate, 0., 1.), "learningRate", learningRate, "in [0, 1]");
}

END_VISP_NAMESPACE
