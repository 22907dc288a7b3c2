// SPDX-License-Identifier: GPL-2.0-or-later
/*!
  \file multicue-disturb.cpp
  Starts trackers at poses that are off by some pixels, and shifts images under them: who finds the object, and who says
  that it was lost.
*/
#include "disturb/disturbTrials.h"
#include "program/runProgram.h"
#include "program/threads.h"

#include <cstdio>
#include <iostream>

namespace {
void print(const std::string &tracker, const std::string &what, const bench::DisturbCount &count)
{
  std::printf("| %s | %s | %d | %d | %d | %d | %.2f | %.1f | %.1f |\n", tracker.c_str(), what.c_str(), count.trials,
              count.right, count.rightTracking, count.wrongTracking, count.median(), count.medianMs(),
              count.medianStartMs());
  std::fflush(stdout);
}
} // namespace

int main(int argc, const char *argv[])
{
  return programs::runProgram([&] {
    bench::DisturbOptions options;
    if (!options.read(argc, argv)) {
      return 0;
    }
    bench::setThreads(1);
    const bench::Footage footage = bench::openFootage(options);
    const bench::DisturbTrials trials(options, footage);
    std::cout << "| tracker | disturbance | trials | right | right and TRACKING | wrong and TRACKING | median px | ms "
                 "| start ms |\n"
                 "|---|---|---|---|---|---|---|---|---|\n";
    for (const std::string &tracker : options.trackers) {
      for (const int offset : options.offsets) {
        print(tracker, "start " + std::to_string(offset) + " px off", trials.starts(tracker, offset));
      }
      if (!options.shifts.empty() && options.shifts.front() > 0) {
        print(tracker, "shift", trials.shifts(tracker));
      }
    }
    return 0;
  });
}
