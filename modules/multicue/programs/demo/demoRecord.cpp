// SPDX-License-Identifier: GPL-2.0-or-later
#include "demo/demoRecord.h"

#include <visp3/core/vpMath.h>
#include <visp3/core/vpThetaUVector.h>

#include <algorithm>
#include <cmath>

namespace programs {
namespace {
// As multicue-evaluate has it for its protocol "run".
const double rightShare = 0.1; // Of the object's diameter.
const double rightDegrees = 10.;
const int onEnd = 5; // Images.
const double leastShown = 0.2;

double median(std::vector<double> values)
{
  if (values.empty()) {
    return 0.;
  }
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

template <typename Value> std::vector<double> collect(const std::vector<DemoRecord::Frame> &frames, const Value &value)
{
  std::vector<double> values;
  for (const DemoRecord::Frame &frame : frames) {
    values.push_back(value(frame));
  }
  return values;
}
} // namespace

const DemoRecord::Frame &DemoRecord::add(int number, const DemoAnswer &answer, double projectionError)
{
  Frame frame;
  frame.number = number;
  frame.state = answer.state;
  frame.milliseconds = answer.milliseconds;
  frame.projectionError = projectionError;
  const auto truth = m_sequence.truth.find(number);
  if (truth != m_sequence.truth.end()) {
    const vpHomogeneousMatrix error = truth->second.cMo.inverse() * answer.cMo;
    frame.isShown = truth->second.visibility >= leastShown;
    frame.translation = std::sqrt(error.getTranslationVector().sumSquare());
    frame.rotation = vpMath::deg(std::sqrt(vpThetaUVector(error).sumSquare()));
    frame.isRight = frame.translation < rightShare * m_sequence.diameter && frame.rotation < rightDegrees;
  }
  m_frames.push_back(frame);
  return m_frames.back();
}

int DemoRecord::firstLost() const
{
  int wrong = 0;
  int first = -1;
  for (const Frame &frame : m_frames) {
    if (!frame.isShown) {
      continue;
    }
    first = frame.isRight ? -1 : wrong == 0 ? frame.number : first;
    wrong = frame.isRight ? 0 : wrong + 1;
    if (wrong == onEnd) {
      return first;
    }
  }
  return -1;
}

int DemoRecord::foundAgain(int lost) const
{
  int right = 0;
  int first = -1;
  for (const Frame &frame : m_frames) {
    if (frame.number <= lost || !frame.isShown) {
      continue;
    }
    first = !frame.isRight ? -1 : right == 0 ? frame.number : first;
    right = frame.isRight ? right + 1 : 0;
    if (right == onEnd) {
      return first;
    }
  }
  return -1;
}

std::vector<std::string> DemoRecord::truthLines() const
{
  int shown = 0, right = 0, falsely = 0;
  std::vector<double> translations, rotations;
  for (const Frame &frame : m_frames) {
    falsely += frame.state == vpTrackingState::TRACKING && !frame.isRight ? 1 : 0;
    if (frame.isShown) {
      ++shown;
      right += frame.isRight ? 1 : 0;
    }
    if (frame.isShown && frame.isRight) {
      translations.push_back(1000. * frame.translation);
      rotations.push_back(frame.rotation);
    }
  }
  const int lost = firstLost();
  const int again = lost < 0 ? -1 : foundAgain(lost);
  const std::string hold = lost < 0    ? "held to the end"
                           : again < 0 ? cv::format("held to image %d, not found again", lost - 1)
                                       : cv::format("held to image %d, found again in image %d", lost - 1, again);
  return {cv::format("pose right in %d of the %d images that show the object: ", right, shown) + hold,
          cv::format("error where right, median: %.1f mm, %.2f degrees", median(translations), median(rotations)),
          cv::format("said to be TRACKING though the pose was wrong: %d images", falsely)};
}

std::vector<std::string> DemoRecord::summary() const
{
  const auto tracking = std::count_if(m_frames.begin(), m_frames.end(),
                                      [](const Frame &frame) { return frame.state == vpTrackingState::TRACKING; });
  const std::vector<double> milliseconds = collect(m_frames, [](const Frame &frame) { return frame.milliseconds; });
  std::vector<std::string> lines = {
      cv::format("%d of %d images TRACKING, median time %.1f ms, longest %.0f ms", static_cast<int>(tracking),
                 static_cast<int>(m_frames.size()), median(milliseconds),
                 milliseconds.empty() ? 0. : *std::max_element(milliseconds.begin(), milliseconds.end()))};
  if (m_sequence.truth.empty()) {
    const double error = median(collect(m_frames, [](const Frame &frame) { return frame.projectionError; }));
    lines.push_back(cv::format("projection error, median: %.1f degrees", error));
    return lines;
  }
  const std::vector<std::string> more = truthLines();
  lines.insert(lines.end(), more.begin(), more.end());
  return lines;
}

} // namespace programs
