// SPDX-License-Identifier: GPL-2.0-or-later
#include "memory/vpSurfacePatches.h"

#include <algorithm>
#include <limits>

BEGIN_VISP_NAMESPACE

namespace {
// Squared; normals that are opposite count as far apart as the whole object.
float distance(const vpSurfaceSample &a, const vpSurfaceSample &b, float size)
{
  return (a.position - b.position).squaredNorm() / (size * size) + 0.25F * (a.normal - b.normal).squaredNorm();
}

float sizeOf(const std::vector<vpSurfaceSample> &samples)
{
  Eigen::Vector3f low = samples.front().position;
  Eigen::Vector3f high = low;
  for (const vpSurfaceSample &sample : samples) {
    low = low.cwiseMin(sample.position);
    high = high.cwiseMax(sample.position);
  }
  return std::max((high - low).norm(), std::numeric_limits<float>::min());
}
} // namespace

// Each seed is the place that is farthest from all seeds before it.
std::vector<std::uint8_t> vpGroupIntoPatches(const std::vector<vpSurfaceSample> &samples, std::size_t most)
{
  std::vector<std::uint8_t> patch(samples.size(), 0);
  if (samples.empty()) {
    return patch;
  }
  const float size = sizeOf(samples);
  std::vector<float> nearest(samples.size(), std::numeric_limits<float>::max());
  std::size_t seed = 0;
  for (std::size_t number = 0; number < most; ++number) {
    for (std::size_t i = 0; i < samples.size(); ++i) {
      const float d = distance(samples[i], samples[seed], size);
      if (d < nearest[i]) {
        nearest[i] = d;
        patch[i] = static_cast<std::uint8_t>(number);
      }
    }
    seed = static_cast<std::size_t>(std::max_element(nearest.begin(), nearest.end()) - nearest.begin());
  }
  return patch;
}

END_VISP_NAMESPACE
