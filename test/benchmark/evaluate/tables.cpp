// SPDX-License-Identifier: GPL-2.0-or-later
#include "evaluate/tables.h"

#include "evaluate/numberText.h"
#include "evaluate/stateTables.h"

#include <limits>

namespace bench {

namespace {
std::string frameNumber(int frame)
{
  return frame < 0 ? "" : std::to_string(frame);
}

void addRunTable(const Evaluation &evaluation, std::ostringstream &text)
{
  text << "| scene | tracker | protocol | step | frames | success % | right % | first lost | back | false tracking % | "
          "t mm | t 95 % | r deg | r 95 % | px | ADD AUC % | ADD-S AUC % | ms | ms 95 % | minimisations |\n"
       << "|---|---|---|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|\n";
  for (const RunResult &run : evaluation.runs) {
    const RunSummary &s = run.summary;
    text << "| " << s.key.scene << " | " << s.key.tracker << " | " << toString(s.key.protocol) << " | " << s.key.step
         << " | " << s.frames << " | " << percent(s.success) << " | " << percent(s.right) << " | "
         << frameNumber(s.firstLost) << " | " << frameNumber(s.back) << " | " << percent(s.falseTracking) << " | "
         << number(s.translationMedian, 2) << " | " << number(s.translation95, 2) << " | "
         << number(s.rotationMedian, 2) << " | " << number(s.rotation95, 2) << " | " << number(s.pixelsMedian, 2)
         << " | " << percent(s.addAuc) << " | " << percent(s.addsAuc) << " | " << number(s.msMedian, 2) << " | "
         << number(s.ms95, 2) << " | " << number(s.minimisations, 2) << " |\n";
  }
}

void addMeanTable(const Evaluation &evaluation, Protocol protocol, std::ostringstream &text)
{
  const std::vector<int> steps = stepsOf(evaluation);
  text << "\nSuccess in percent, protocol " << toString(protocol) << ", mean over the scenes, by step:\n\n| tracker |";
  for (const int step : steps) {
    text << " " << step << " |";
  }
  text << "\n|---|";
  for (std::size_t i = 0; i < steps.size(); ++i) {
    text << "--:|";
  }
  text << "\n";
  for (const std::string &tracker : trackersOf(evaluation)) {
    text << "| " << tracker << " |";
    for (const int step : steps) {
      text << " " << percent(meanSuccess(evaluation, tracker, protocol, step)) << " |";
    }
    text << "\n";
  }
}

void addStageTable(const Evaluation &evaluation, std::ostringstream &text)
{
  std::ostringstream rows;
  for (const RunResult &run : evaluation.runs) {
    if (run.summary.stages.empty()) {
      continue;
    }
    rows << "| " << run.summary.key.scene << " | " << run.summary.key.tracker << " | "
         << toString(run.summary.key.protocol) << " | " << run.summary.key.step << " |";
    for (const auto &stage : run.summary.stages) {
      rows << " " << stage.first << " " << number(stage.second, 3);
    }
    rows << " |\n";
  }
  if (!rows.str().empty()) {
    text << "\nMedian times by stage, ms:\n\n| scene | tracker | protocol | step | stages |\n|---|---|---|--:|---|\n"
         << rows.str();
  }
}
} // namespace

double meanSuccess(const Evaluation &evaluation, const std::string &tracker, Protocol protocol, int step)
{
  double sum = 0.;
  int count = 0;
  for (const RunResult &run : evaluation.runs) {
    const RunKey &key = run.summary.key;
    if (key.tracker == tracker && key.protocol == protocol && key.step == step && std::isfinite(run.summary.success)) {
      sum += run.summary.success;
      ++count;
    }
  }
  return count == 0 ? std::numeric_limits<double>::quiet_NaN() : sum / count;
}

std::string toCsv(const Evaluation &evaluation)
{
  std::ostringstream text;
  text << "scene,tracker,protocol,step,frames,success,right,first_lost,back,false_tracking,t_mm_median,t_mm_p95,"
          "r_deg_median,r_deg_p95,px_median,add_auc,ms_median,ms_p95,minimisations"
       << stateColumns() << "\n";
  for (const RunResult &run : evaluation.runs) {
    const RunSummary &s = run.summary;
    text << field(s.key.scene) << "," << s.key.tracker << "," << toString(s.key.protocol) << "," << s.key.step << ","
         << s.frames << "," << number(s.success, 6) << "," << number(s.right, 6) << "," << frameNumber(s.firstLost)
         << "," << frameNumber(s.back) << "," << number(s.falseTracking, 6) << "," << number(s.translationMedian, 4)
         << "," << number(s.translation95, 4) << "," << number(s.rotationMedian, 4) << "," << number(s.rotation95, 4)
         << "," << number(s.pixelsMedian, 4) << "," << number(s.addAuc, 6) << "," << number(s.msMedian, 4) << ","
         << number(s.ms95, 4) << "," << number(s.minimisations, 4) << stateFields(s.state) << "\n";
  }
  return text.str();
}

std::string toMarkdown(const Evaluation &evaluation)
{
  std::ostringstream text;
  addRunTable(evaluation, text);
  if (evaluation.sequences.size() > 1 || stepsOf(evaluation).size() > 1) {
    for (const Protocol protocol : protocolsOf(evaluation)) {
      addMeanTable(evaluation, protocol, text);
    }
  }
  addStageTable(evaluation, text);
  text << "\nErrors (t, r, px) are those of the frames that succeeded; ADD counts every frame.\n";
  return text.str();
}

} // namespace bench
