// SPDX-License-Identifier: GPL-2.0-or-later
/*!
  \file multicue-starts.cpp
  Starts trackers at poses that are off the truth, or where the object is not, and tells how often they find it and how
  often they say so.
*/
#include "program/runProgram.h"
#include "starts/startTrials.h"

#include <visp3/model/vpWholeFile.h>

#include <iostream>

int main(int argc, const char *argv[])
{
  return programs::runProgram([&] {
    bench::StartOptions options;
    if (!options.read(argc, argv)) {
      return 0;
    }
    const bench::StartResults results = bench::runStarts(options);
    if (!results.records.empty()) {
      const std::vector<bench::StartSummary> summaries = bench::summariseStarts(results.records);
      const std::string table = bench::startMarkdown(summaries);
      vpWholeFile::write(options.out + "/starts.csv", bench::startsCsv(results.records));
      vpWholeFile::write(options.out + "/summary.csv", bench::startSummaryCsv(summaries));
      vpWholeFile::write(options.out + "/summary.md", table);
      std::cout << table << "\nEvery trial is in " << options.out << "/starts.csv" << std::endl;
    }
    for (const std::string &failure : results.failures) {
      std::cerr << "FAILED: " << failure << "\n";
    }
    return results.failures.empty() && !results.records.empty() ? 0 : 1;
  });
}
