// SPDX-License-Identifier: GPL-2.0-or-later
/*!
  \file multicue-soak.cpp
  Lets one process track for as long as a robot would: objects that move, leave and come back, new starts at random
  poses, other models, presets, cues and settings while it runs. Prints the memory, the open files and the time of a
  frame every so many frames; ends with 1 where memory or files grow.
*/
#include "program/commandLine.h"
#include "program/runProgram.h"
#include "soak/soakReport.h"
#include "soak/soakSession.h"

#include <iostream>

int main(int argc, const char *argv[])
{
  return programs::runProgram([&] {
    int frames = 20000;
    int every = 2000;
    int seed = 1;
    programs::CommandLine line("Tracks for long, with everything changed on the way, and watches memory and time.");
    line.add("--frames", "how many images", frames, 1);
    line.add("--every", "images from one line of figures to the next", every, 1);
    line.add("--seed", "of all that is drawn", seed, 0);
    if (!line.read(argc, argv)) {
      return 0;
    }
    bench::SoakSession session(static_cast<std::uint64_t>(seed));
    bench::SoakReport report;
    for (int i = 1; i <= frames; ++i) {
      session.step();
      if (i % every == 0) {
        report.add(i, session.takeCounts());
        std::cout << report.lastLine() << std::endl;
      }
    }
    std::cout << report.growth() << std::endl;
    return report.grows() ? 1 : 0;
  });
}
