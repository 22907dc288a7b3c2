// SPDX-License-Identifier: GPL-2.0-or-later
#include "evaluate/stateFigures.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace bench {

namespace {
const double none = std::numeric_limits<double>::quiet_NaN();

// Poses of one score: they pass a threshold together.
struct Step
{
  std::size_t right = 0;
  std::size_t wrong = 0;
};

// From the largest score to the smallest.
std::vector<Step> steps(std::vector<ScoredPose> &poses)
{
  std::sort(poses.begin(), poses.end(), [](const ScoredPose &a, const ScoredPose &b) { return a.score > b.score; });
  std::vector<Step> result;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    if (i == 0 || poses[i].score < poses[i - 1].score) {
      result.emplace_back();
    }
    ++(poses[i].right ? result.back().right : result.back().wrong);
  }
  return result;
}

Step total(const std::vector<Step> &steps)
{
  Step sum;
  for (const Step &step : steps) {
    sum.right += step.right;
    sum.wrong += step.wrong;
  }
  return sum;
}
} // namespace

double rocArea(std::vector<ScoredPose> poses)
{
  const std::vector<Step> all = steps(poses);
  const Step sum = total(all);
  double pairs = 0.; // Of a right pose and a wrong one with a smaller score; equal ones are half a pair.
  double above = 0.;
  for (const Step &step : all) {
    const double right = static_cast<double>(step.right);
    pairs += (above + 0.5 * right) * static_cast<double>(step.wrong);
    above += right;
  }
  const double most = static_cast<double>(sum.right) * static_cast<double>(sum.wrong);
  return most > 0. ? pairs / most : none;
}

std::vector<RocPoint> rocCurve(std::vector<ScoredPose> poses, std::size_t most)
{
  const std::vector<Step> all = steps(poses);
  const Step sum = total(all);
  std::vector<RocPoint> curve;
  if (sum.right == 0 || sum.wrong == 0) {
    return curve;
  }
  curve.push_back({0., 0.});
  const std::size_t distance = 1 + all.size() / std::max<std::size_t>(most - 1, 1);
  Step passed;
  for (std::size_t i = 0; i < all.size(); ++i) {
    passed.right += all[i].right;
    passed.wrong += all[i].wrong;
    if ((i + 1) % distance == 0 || i + 1 == all.size()) {
      curve.push_back({static_cast<double>(passed.wrong) / static_cast<double>(sum.wrong),
                       static_cast<double>(passed.right) / static_cast<double>(sum.right)});
    }
  }
  return curve;
}

Reliability reliability(const std::vector<ScoredPose> &poses)
{
  Reliability bins;
  for (const ScoredPose &pose : poses) {
    const double place = std::floor(pose.score * static_cast<double>(reliabilityBins));
    const double last = static_cast<double>(reliabilityBins - 1);
    ReliabilityBin &bin = bins[static_cast<std::size_t>(std::clamp(place, 0., last))];
    ++bin.count;
    bin.score += pose.score;
    bin.right += pose.right ? 1. : 0.;
  }
  for (ReliabilityBin &bin : bins) {
    const double count = static_cast<double>(bin.count);
    bin.score = bin.count > 0 ? bin.score / count : none;
    bin.right = bin.count > 0 ? bin.right / count : none;
  }
  return bins;
}

double calibrationError(const Reliability &bins)
{
  double sum = 0.;
  double count = 0.;
  for (const ReliabilityBin &bin : bins) {
    if (bin.count > 0) {
      sum += static_cast<double>(bin.count) * std::fabs(bin.score - bin.right);
      count += static_cast<double>(bin.count);
    }
  }
  return count > 0. ? sum / count : none;
}

} // namespace bench
