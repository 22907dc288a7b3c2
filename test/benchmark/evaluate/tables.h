// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef benchTables_h
#define benchTables_h

#include "evaluate/evaluation.h"

#include <algorithm>

namespace bench {

//! summary.csv: one line per run, shares in [0, 1], empty where there is no value.
std::string toCsv(const Evaluation &evaluation);

//! Tables for reading, shares in percent: the runs, success by step and tracker over all scenes, times by stage.
std::string toMarkdown(const Evaluation &evaluation);

//! Mean of RunSummary::success over the scenes, for one tracker, protocol and step; not a number where nothing ran.
double meanSuccess(const Evaluation &evaluation, const std::string &tracker, Protocol protocol, int step);

//! Different values of what \e choose takes from the runs, in the order of their first appearance.
template <typename Value, typename Choose>
std::vector<Value> distinct(const Evaluation &evaluation, const Choose &choose)
{
  std::vector<Value> result;
  for (const RunResult &run : evaluation.runs) {
    const Value value = choose(run.summary.key);
    if (std::find(result.begin(), result.end(), value) == result.end()) {
      result.push_back(value);
    }
  }
  return result;
}

inline std::vector<std::string> trackersOf(const Evaluation &evaluation)
{
  return distinct<std::string>(evaluation, [](const RunKey &key) { return key.tracker; });
}

inline std::vector<int> stepsOf(const Evaluation &evaluation)
{
  return distinct<int>(evaluation, [](const RunKey &key) { return key.step; });
}

inline std::vector<Protocol> protocolsOf(const Evaluation &evaluation)
{
  return distinct<Protocol>(evaluation, [](const RunKey &key) { return key.protocol; });
}

} // namespace bench
#endif
