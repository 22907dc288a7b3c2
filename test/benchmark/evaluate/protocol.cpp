// SPDX-License-Identifier: GPL-2.0-or-later
#include "evaluate/protocol.h"

#include <visp3/core/vpException.h>

#include <algorithm>
#include <chrono>

namespace bench {

namespace {
double milliseconds(const std::function<void()> &work)
{
  const auto begin = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
}

void judge(const SequenceFrame &frame, const PoseErrorMeasure &measure, const Limits &limits, FrameRecord &record)
{
  if (!frame.hasTruth) {
    return;
  }
  record.known = true;
  record.error = measure(record.answer.cMo, frame.cMo, frame.cam);
  record.counted = frame.visibility >= leastVisibility;
  record.success =
      record.error.translation < limits.successTranslation && record.error.rotation < limits.successRotation;
  record.right = record.error.translation < limits.rightTranslation && record.error.rotation < limits.rightRotation;
}

vpHomogeneousMatrix startOf(const SequenceFrame &frame, const StartPose &startPose)
{
  return startPose ? startPose(frame) : frame.cMo;
}

// A pose that a tracker refuses (partly behind the camera, for instance) leaves it where it is.
bool restart(BenchTracker &tracker, const BenchImage &I, const vpHomogeneousMatrix &cMo)
{
  try {
    tracker.init(I, cMo);
    return true;
  } catch (const vpException &) {
    return false;
  }
}
} // namespace

std::string toString(Protocol protocol)
{
  return protocol == Protocol::RBOT ? "rbot" : "run";
}

Limits::Limits(double diameter)
    : successTranslation(std::max(0.05, 0.1 * diameter)), successRotation(5.), rightTranslation(0.1 * diameter),
      rightRotation(10.)
{
}

std::size_t trackedFrames(const Sequence &sequence, int step)
{
  return (sequence.frames.size() - 1) / static_cast<std::size_t>(step);
}

std::vector<FrameRecord> runProtocol(const Sequence &sequence, ImageStore &images, BenchTracker &tracker,
                                     const PoseErrorMeasure &measure, Protocol protocol, int step,
                                     const std::function<void()> &progress, const StartPose &startPose)
{
  const Limits limits(sequence.object.diameter);
  BenchImage I;
  images.get(0, I);
  tracker.init(I, startOf(sequence.frames.front(), startPose));

  std::vector<FrameRecord> records(trackedFrames(sequence, step));
  std::size_t index = 0;
  for (FrameRecord &record : records) {
    index += static_cast<std::size_t>(step);
    const SequenceFrame &frame = sequence.frames[index];
    images.get(index, I);
    record.frame = frame.id;
    record.ms = milliseconds([&tracker, &I] { tracker.track(I); });
    record.answer = tracker.answer();
    judge(frame, measure, limits, record);
    if (protocol == Protocol::RBOT && record.counted && !record.success) {
      record.reset = restart(tracker, I, startOf(frame, startPose));
    }
    progress();
  }
  return records;
}

} // namespace bench
