// SPDX-License-Identifier: GPL-2.0-or-later
#include "evaluate/stateTables.h"

#include "evaluate/numberText.h"
#include "evaluate/tables.h"

namespace bench {

namespace {
const char *const all = "all";

StateGroup group(const Evaluation &evaluation, const std::string &tracker, const std::string &protocol,
                 const std::string &step)
{
  StateGroup result;
  result.tracker = tracker;
  result.protocol = protocol;
  result.step = step;
  StatePool pool;
  for (const RunResult &run : evaluation.runs) {
    const RunKey &key = run.summary.key;
    if (key.tracker == tracker && (protocol == all || toString(key.protocol) == protocol) &&
        (step == all || std::to_string(key.step) == step)) {
      pool.add(key.scene, key.protocol, run.records);
      ++result.runs;
    }
  }
  result.figures = pool.figures();
  return result;
}

std::string name(const StateGroup &group)
{
  return "| " + group.tracker + " | " + group.protocol + " | " + group.step + " |";
}

std::string reliabilityTable(const std::vector<StateGroup> &groups)
{
  std::ostringstream text;
  text << "\nRight poses in percent, by the score that the tracker gave them (number of frames):\n\n"
       << "| tracker | protocol | step |";
  for (std::size_t bin = 0; bin < reliabilityBins; ++bin) {
    text << " " << 0.1 * static_cast<double>(bin) << " to " << 0.1 * static_cast<double>(bin + 1) << " |";
  }
  text << "\n|---|---|--:|";
  for (std::size_t bin = 0; bin < reliabilityBins; ++bin) {
    text << "--:|";
  }
  text << "\n";
  for (const StateGroup &group : groups) {
    text << name(group);
    for (const ReliabilityBin &bin : group.figures.bins) {
      text << " " << (bin.count == 0 ? "" : percent(bin.right) + " (" + std::to_string(bin.count) + ")") << " |";
    }
    text << "\n";
  }
  return text.str();
}
} // namespace

std::vector<StateGroup> stateGroups(const Evaluation &evaluation)
{
  std::vector<StateGroup> groups;
  for (const std::string &tracker : trackersOf(evaluation)) {
    for (const Protocol protocol : protocolsOf(evaluation)) {
      for (const int step : stepsOf(evaluation)) {
        StateGroup one = group(evaluation, tracker, toString(protocol), std::to_string(step));
        if (one.runs > 0) {
          groups.push_back(std::move(one));
        }
      }
    }
    groups.push_back(group(evaluation, tracker, all, all));
  }
  return groups;
}

std::string stateColumns()
{
  return ",false_tracking_known,lost_while_right,roc_area,calibration_error,roc_area_known,calibration_error_known,"
         "recoveries,recovered,recovered_in_10,recovery_frames_median,held_throughout";
}

std::string stateFields(const StateFigures &figures)
{
  std::ostringstream text;
  for (const double value : {figures.known.falseTracking, figures.lostWhileRight, figures.counted.rocArea,
                             figures.counted.calibrationError, figures.known.rocArea, figures.known.calibrationError}) {
    text << "," << number(value, 6);
  }
  text << "," << figures.recoveries;
  for (const double value : {figures.recovered, figures.recoveredSoon}) {
    text << "," << number(value, 6);
  }
  text << "," << number(figures.recoveryFrames, 0) << "," << number(figures.heldThroughout, 6);
  return text.str();
}

std::string stateCsv(const std::vector<StateGroup> &groups)
{
  std::ostringstream text;
  text << "tracker,protocol,step,runs,frames,frames_known,occlusion_runs,false_tracking" << stateColumns() << "\n";
  for (const StateGroup &group : groups) {
    const StateFigures &f = group.figures;
    text << field(group.tracker) << "," << group.protocol << "," << group.step << "," << group.runs << ","
         << f.counted.count << "," << f.known.count << "," << f.occlusions << "," << number(f.counted.falseTracking, 6)
         << stateFields(f) << "\n";
  }
  return text.str();
}

std::string reliabilityCsv(const std::vector<StateGroup> &groups)
{
  std::ostringstream text;
  text << "tracker,protocol,step,score_from,score_to,frames,score_mean,right\n";
  for (const StateGroup &group : groups) {
    for (std::size_t i = 0; i < reliabilityBins; ++i) {
      const ReliabilityBin &bin = group.figures.bins[i];
      text << field(group.tracker) << "," << group.protocol << "," << group.step << ","
           << number(0.1 * static_cast<double>(i), 1) << "," << number(0.1 * static_cast<double>(i + 1), 1) << ","
           << bin.count << "," << number(bin.score, 6) << "," << number(bin.right, 6) << "\n";
    }
  }
  return text.str();
}

std::string stateMarkdown(const std::vector<StateGroup> &groups)
{
  std::ostringstream text;
  text << "| tracker | protocol | step | runs | frames | false tracking % | hidden too % | lost while right % | "
          "ROC area | hidden too | calibration error | hidden too | recoveries | recovered % | in "
       << soonFrames << " frames % | frames, median | occlusions held % |\n"
       << "|---|---|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|\n";
  for (const StateGroup &group : groups) {
    const StateFigures &f = group.figures;
    text << name(group) << " " << group.runs << " | " << f.counted.count << " | " << percent(f.counted.falseTracking)
         << " | " << percent(f.known.falseTracking) << " | " << percent(f.lostWhileRight) << " | "
         << number(f.counted.rocArea, 3) << " | " << number(f.known.rocArea, 3) << " | "
         << number(f.counted.calibrationError, 3) << " | " << number(f.known.calibrationError, 3) << " | "
         << f.recoveries << " | " << percent(f.recovered) << " | " << percent(f.recoveredSoon) << " | "
         << number(f.recoveryFrames, 0) << " | " << percent(f.heldThroughout) << " |\n";
  }
  text << reliabilityTable(groups)
       << "\nFalse tracking: the state is TRACKING and the pose is not right; \"hidden too\" takes in the frames that "
          "hardly show the object.\n";
  return text.str();
}

} // namespace bench
