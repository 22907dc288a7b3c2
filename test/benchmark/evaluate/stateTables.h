// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef benchStateTables_h
#define benchStateTables_h

#include "evaluate/evaluation.h"

namespace bench {

//! The runs of one tracker, protocol and step over all scenes, or all runs of a tracker.
struct StateGroup
{
  std::string tracker;
  std::string protocol; //!< "all" for all.
  std::string step;     //!< "all" for all.
  std::size_t runs = 0;
  StateFigures figures; //!< Over the frames of these runs together.
};

//! Groups in the order of the runs, the line over all of a tracker after its others.
std::vector<StateGroup> stateGroups(const Evaluation &evaluation);

//! state.csv: a line for each group, shares in [0, 1], empty where there is no value.
std::string stateCsv(const std::vector<StateGroup> &groups);
//! reliability.csv: a line for each group and bin of the score.
std::string reliabilityCsv(const std::vector<StateGroup> &groups);
//! Tables for reading, shares in percent.
std::string stateMarkdown(const std::vector<StateGroup> &groups);
//! ROC curve and reliability diagram of each tracker, as SVG.
std::string statePlots(const std::vector<StateGroup> &groups);

//! The columns of a run in summary.csv, and of a group in state.csv, that are about state and score, a comma before
//! each.
std::string stateColumns();
std::string stateFields(const StateFigures &figures);

} // namespace bench
#endif
