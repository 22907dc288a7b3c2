// SPDX-License-Identifier: GPL-2.0-or-later
/*!
  \file multicue-track.cpp
  Tracks an object in a video, in images or with a camera, and shows and records what the tracker says.
*/
#include "program/runProgram.h"
#include "track/trackRun.h"

#include <csignal>

int main(int argc, const char *argv[])
{
  // Ctrl-C ends the loop, so that the video, the poses and the recording are complete.
  std::signal(SIGINT, [](int) { programs::TrackRun::stop(); });
  return programs::runProgram([&] {
    programs::TrackOptions options;
    if (options.read(argc, argv)) {
      programs::TrackRun(options).run();
    }
    return 0;
  });
}
