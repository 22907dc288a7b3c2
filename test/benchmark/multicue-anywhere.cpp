// SPDX-License-Identifier: GPL-2.0-or-later
/*!
  \file multicue-anywhere.cpp
  Starts a tracker without a pose, in single images with and without the object.
*/
#include "anywhere/anywhereTrials.h"
#include "program/runProgram.h"
#include "program/threads.h"

#include <iostream>

int main(int argc, const char *argv[])
{
  return programs::runProgram([&] {
    bench::AnywhereOptions options;
    if (!options.read(argc, argv)) {
      return 0;
    }
    bench::setThreads(1);
    const std::vector<bench::AnywhereCount> counts = bench::runAnywhere(options, std::cerr);
    std::cout << bench::anywhereMarkdown(counts, options.follow > 0);
    return 0;
  });
}
