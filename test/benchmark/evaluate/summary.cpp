// SPDX-License-Identifier: GPL-2.0-or-later
#include "evaluate/summary.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>

namespace bench {

namespace {
using Records = std::vector<FrameRecord>;

template <typename Choose, typename Value>
std::vector<double> values(const Records &records, const Choose &choose, const Value &value)
{
  std::vector<double> result;
  for (const FrameRecord &record : records) {
    if (choose(record)) {
      result.push_back(value(record));
    }
  }
  return result;
}

bool counts(const FrameRecord &record)
{
  return record.counted;
}

bool succeeds(const FrameRecord &record)
{
  return record.counted && record.success;
}

double mean(const std::vector<double> &numbers)
{
  double sum = 0.;
  for (const double number : numbers) {
    sum += number;
  }
  return numbers.empty() ? std::numeric_limits<double>::quiet_NaN() : sum / static_cast<double>(numbers.size());
}

// Area under the curve of the share of frames with less than an error, for errors up to a tenth of the diameter.
double areaUnderCurve(const Records &records, double PoseError::*member, double diameter)
{
  return mean(values(records, counts, [member, diameter](const FrameRecord &record) {
    return std::max(0., 1. - record.error.*member / (0.1 * diameter));
  }));
}

std::vector<std::pair<std::string, double>> stageMedians(const Records &records, const std::vector<std::string> &names)
{
  std::vector<std::pair<std::string, double>> result;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const auto hasStage = [i](const FrameRecord &record) { return i < record.answer.stages.size(); };
    const std::vector<double> ms =
        values(records, hasStage, [i](const FrameRecord &record) { return record.answer.stages[i]; });
    result.emplace_back(names[i], quantile(ms, 0.5));
  }
  return result;
}
} // namespace

std::string RunKey::fileName() const
{
  std::string name = scene + "_" + tracker + "_" + toString(protocol) + "_step" + std::to_string(step);
  std::replace_if(
      name.begin(), name.end(),
      [](unsigned char c) { return std::isalnum(c) == 0 && c != '-' && c != '_' && c != '.'; }, '-');
  return name;
}

double quantile(std::vector<double> values, double q)
{
  if (values.empty()) {
    return std::numeric_limits<double>::quiet_NaN();
  }
  const auto nth =
      values.begin() + static_cast<std::ptrdiff_t>(std::lround(q * static_cast<double>(values.size() - 1)));
  std::nth_element(values.begin(), nth, values.end());
  return *nth;
}

std::vector<Loss> findLosses(const Records &records)
{
  const int enough = 5;
  std::vector<Loss> losses;
  bool lost = false;
  int length = 0; // Of the counted frames on end that speak for a change.
  int first = -1;
  for (const FrameRecord &record : records) {
    if (!record.counted) {
      continue;
    }
    if (record.right != lost) {
      length = 0;
      continue;
    }
    first = length == 0 ? record.frame : first;
    if (++length == enough) {
      if (lost) {
        losses.back().back = first;
      } else {
        losses.push_back({first, -1});
      }
      lost = !lost;
      length = 0;
    }
  }
  return losses;
}

RunSummary summarise(const RunKey &key, const Records &records, double diameter, bool symmetric,
                     const std::vector<std::string> &stages)
{
  const auto translation = [](const FrameRecord &record) { return 1e3 * record.error.translation; };
  const auto rotation = [](const FrameRecord &record) { return record.error.rotation; };
  const auto everywhere = [](const FrameRecord &) { return true; };
  const auto ms = [](const FrameRecord &record) { return record.ms; };

  RunSummary summary;
  summary.key = key;
  summary.frames = static_cast<std::size_t>(std::count_if(records.begin(), records.end(), counts));
  summary.success = mean(values(records, counts, [](const FrameRecord &record) { return record.success ? 1. : 0.; }));
  summary.right = mean(values(records, counts, [](const FrameRecord &record) { return record.right ? 1. : 0.; }));
  summary.falseTracking = mean(values(records, counts, [](const FrameRecord &record) {
    return !record.right && record.answer.state == vpTrackingState::TRACKING ? 1. : 0.;
  }));
  summary.losses = findLosses(records);
  if (!summary.losses.empty()) {
    summary.firstLost = summary.losses.front().lost;
    summary.back = summary.losses.front().back;
  }
  summary.translationMedian = quantile(values(records, succeeds, translation), 0.5);
  summary.translation95 = quantile(values(records, succeeds, translation), 0.95);
  summary.rotationMedian = quantile(values(records, succeeds, rotation), 0.5);
  summary.rotation95 = quantile(values(records, succeeds, rotation), 0.95);
  summary.pixelsMedian =
      quantile(values(records, succeeds, [](const FrameRecord &record) { return record.error.pixels; }), 0.5);
  summary.addsAuc = areaUnderCurve(records, &PoseError::adds, diameter);
  summary.addAuc = symmetric ? summary.addsAuc : areaUnderCurve(records, &PoseError::add, diameter);
  summary.msMedian = quantile(values(records, everywhere, ms), 0.5);
  summary.ms95 = quantile(values(records, everywhere, ms), 0.95);
  summary.minimisations =
      mean(values(records, everywhere, [](const FrameRecord &record) { return record.answer.minimisations; }));
  summary.stages = stageMedians(records, stages);
  StatePool pool;
  pool.add(key.scene, key.protocol, records);
  summary.state = pool.figures();
  return summary;
}

} // namespace bench
