// SPDX-License-Identifier: GPL-2.0-or-later
/*!
  \file multicue-evaluate.cpp
  Runs trackers, ours and ViSP's, on sequences with ground truth, and writes tables and pictures of who holds what.
*/
#include "evaluate/evaluation.h"
#include "evaluate/htmlReport.h"
#include "evaluate/stateTables.h"
#include "evaluate/tables.h"
#include "program/runProgram.h"

#include <visp3/model/vpWholeFile.h>

#include <iostream>

namespace {
void printFailures(const char *title, const std::vector<bench::Failure> &failures)
{
  for (const bench::Failure &failure : failures) {
    std::cerr << title << " " << failure.what << ": " << failure.why << "\n";
  }
}
} // namespace

int main(int argc, const char *argv[])
{
  return programs::runProgram([&] {
    bench::EvaluateOptions options;
    if (!options.read(argc, argv)) {
      return 0;
    }
    const bench::Evaluation evaluation = bench::evaluate(options);
    if (!evaluation.runs.empty()) {
      const std::vector<bench::StateGroup> groups = bench::stateGroups(evaluation);
      const std::string table = bench::toMarkdown(evaluation) + "\nState and score:\n\n" + bench::stateMarkdown(groups);
      vpWholeFile::write(options.out + "/summary.csv", bench::toCsv(evaluation));
      vpWholeFile::write(options.out + "/summary.md", table);
      vpWholeFile::write(options.out + "/state.csv", bench::stateCsv(groups));
      vpWholeFile::write(options.out + "/reliability.csv", bench::reliabilityCsv(groups));
      vpWholeFile::write(options.out + "/report.html", bench::toHtml(evaluation));
      std::cout << table << "\nMore in " << options.out << "/report.html and summary.csv" << std::endl;
    }
    printFailures("Left out:", evaluation.skipped);
    printFailures("FAILED:", evaluation.failures);
    return evaluation.failures.empty() && !evaluation.runs.empty() ? 0 : 1;
  });
}
