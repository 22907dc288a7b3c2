// SPDX-License-Identifier: GPL-2.0-or-later
#include <visp3/se3/vpPoseResampling.h>

#include <visp3/core/vpException.h>

#include <algorithm>
#include <cmath>
#include <limits>

BEGIN_VISP_NAMESPACE

namespace {
double checkedSum(const std::vector<double> &weights)
{
  double sum = 0.;
  for (const double weight : weights) {
    if (!(weight >= 0.)) {
      throw vpException(vpException::badValue, "A weight to resample by is %g, but weights have to be >= 0", weight);
    }
    sum += weight;
  }
  if (!(sum > 0.) || !std::isfinite(sum)) {
    throw vpException(vpException::badValue,
                      "The weights to resample by sum up to %g: at least one has to be > 0, and all finite", sum);
  }
  return sum;
}
} // namespace

double vpPoseResampling::normalise(const std::vector<double> &logWeights, std::vector<double> &weights)
{
  const double nothing = -std::numeric_limits<double>::infinity();
  double largest = nothing;
  for (const double logWeight : logWeights) {
    if (std::isfinite(logWeight)) {
      largest = std::max(largest, logWeight);
    }
  }
  if (!std::isfinite(largest)) {
    weights.assign(logWeights.size(), 1. / static_cast<double>(std::max<std::size_t>(logWeights.size(), 1)));
    return nothing;
  }
  weights.resize(logWeights.size());
  double sum = 0.;
  for (std::size_t i = 0; i < weights.size(); i++) {
    weights[i] = std::isfinite(logWeights[i]) ? std::exp(logWeights[i] - largest) : 0.;
    sum += weights[i];
  }
  for (double &weight : weights) {
    weight /= sum;
  }
  return largest + std::log(sum);
}

double vpPoseResampling::effectiveSize(const std::vector<double> &weights)
{
  // In units of the largest weight, whose square may underflow.
  const double largest = weights.empty() ? 0. : *std::max_element(weights.begin(), weights.end());
  if (!(largest > 0.)) {
    return 0.;
  }
  double sum = 0.;
  double squares = 0.;
  for (const double weight : weights) {
    sum += weight / largest;
    squares += (weight / largest) * (weight / largest);
  }
  return sum * sum / squares;
}

void vpPoseResampling::systematic(const std::vector<double> &weights, std::size_t count, double shift,
                                  std::vector<std::size_t> &picks)
{
  if (!(shift >= 0. && shift < 1.)) {
    throw vpException(vpException::badValue, "The shift of systematic resampling is %g: give one of [0, 1)", shift);
  }
  const double step = checkedSum(weights) / static_cast<double>(count);
  // Rounding may leave the last picks beyond the sum: they belong to the last weight that is not 0.
  std::size_t last = weights.size() - 1;
  while (!(weights[last] > 0.)) {
    last--;
  }
  picks.resize(count);
  std::size_t index = 0;
  double cumulated = weights[0];
  for (std::size_t i = 0; i < count; i++) {
    const double position = (static_cast<double>(i) + shift) * step;
    while (index < last && !(position < cumulated)) {
      cumulated += weights[++index];
    }
    picks[i] = index;
  }
}

END_VISP_NAMESPACE
