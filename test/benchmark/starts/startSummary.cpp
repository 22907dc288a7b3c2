// SPDX-License-Identifier: GPL-2.0-or-later
#include "starts/startSummary.h"

#include "evaluate/numberText.h"
#include <visp3/se3/vpExactNumber.h>

#include <algorithm>
#include <map>
#include <set>
#include <tuple>

namespace bench {

namespace {
const char *const all = "all";

bool isSame(const StartSummary &a, const StartSummary &b)
{
  return a.tracker == b.tracker && a.object == b.object && a.model == b.model &&
         vpIsSame(a.deviation.angle, b.deviation.angle) && vpIsSame(a.deviation.offset, b.deviation.offset);
}

// Sums at first, shares in the end.
void add(const StartRecord &record, const std::string &object, const std::string &model,
         std::vector<StartSummary> &summaries)
{
  StartSummary kind;
  kind.tracker = record.tracker;
  kind.object = object;
  kind.model = model;
  kind.deviation = record.deviation;
  auto found = std::find_if(summaries.begin(), summaries.end(),
                            [&kind](const StartSummary &summary) { return isSame(summary, kind); });
  if (found == summaries.end()) {
    found = summaries.insert(summaries.end(), kind);
  }
  ++found->trials;
  found->right += record.outcome == StartOutcome::RIGHT ? 1. : 0.;
  found->wrong += record.outcome == StartOutcome::WRONG ? 1. : 0.;
  found->refused += record.outcome == StartOutcome::REFUSED ? 1. : 0.;
  found->poseRight += record.right ? 1. : 0.;
}

std::string plain(double value)
{
  std::ostringstream text;
  text << value;
  return text.str();
}

std::string listTable(const std::vector<StartSummary> &summaries)
{
  std::ostringstream text;
  text << "| tracker | object | model | angle | offset | trials | right % | wrong % | refused % | pose right % |\n"
       << "|---|---|---|--:|--:|--:|--:|--:|--:|--:|\n";
  for (const StartSummary &s : summaries) {
    text << "| " << s.tracker << " | " << s.object << " | " << s.model << " | " << s.deviation.angle << " | "
         << s.deviation.offset << " | " << s.trials << " | " << percent(s.right) << " | " << percent(s.wrong) << " | "
         << percent(s.refused) << " | " << percent(s.poseRight) << " |\n";
  }
  text << "\nRight and wrong: accepted, the state being TRACKING at the end.\n";
  return text.str();
}

// Rows are angles, columns offsets.
std::string grid(const std::vector<StartSummary> &kind, double StartSummary::*value)
{
  std::set<double> angles;
  std::set<double> offsets;
  for (const StartSummary &summary : kind) {
    angles.insert(summary.deviation.angle);
    offsets.insert(summary.deviation.offset);
  }
  std::ostringstream text;
  text << "| angle |";
  for (const double offset : offsets) {
    text << " " << plain(offset) << " |";
  }
  text << "\n|--:|";
  for (std::size_t i = 0; i < offsets.size(); ++i) {
    text << "--:|";
  }
  text << "\n";
  for (const double angle : angles) {
    text << "| " << plain(angle) << " |";
    for (const double offset : offsets) {
      const auto cell = std::find_if(kind.begin(), kind.end(), [angle, offset](const StartSummary &summary) {
        return vpIsSame(summary.deviation.angle, angle) && vpIsSame(summary.deviation.offset, offset);
      });
      text << " " << (cell == kind.end() ? "" : percent((*cell).*value)) << " |";
    }
    text << "\n";
  }
  return text.str();
}

std::string grids(const std::vector<StartSummary> &summaries)
{
  std::ostringstream text;
  std::set<std::tuple<std::string, std::string, std::string>> done;
  for (const StartSummary &first : summaries) {
    if (!done.emplace(first.tracker, first.object, first.model).second) {
      continue;
    }
    std::vector<StartSummary> kind;
    for (const StartSummary &summary : summaries) {
      if (summary.tracker == first.tracker && summary.object == first.object && summary.model == first.model) {
        kind.push_back(summary);
      }
    }
    text << first.tracker << ", object " << first.object << ", model " << first.model << ", " << first.trials
         << " trials each; percent by angle (degrees) and offset (diameters). Accepted and right:\n\n"
         << grid(kind, &StartSummary::right) << "\nAccepted and wrong:\n\n"
         << grid(kind, &StartSummary::wrong) << "\nPose right, accepted or not:\n\n"
         << grid(kind, &StartSummary::poseRight) << "\n";
  }
  return text.str();
}
} // namespace

std::string toString(StartOutcome outcome)
{
  return outcome == StartOutcome::RIGHT ? "right" : outcome == StartOutcome::WRONG ? "wrong" : "refused";
}

std::vector<StartSummary> summariseStarts(const std::vector<StartRecord> &records)
{
  std::vector<StartSummary> summaries;
  for (const StartRecord &record : records) {
    add(record, record.object, record.model, summaries);
  }
  std::map<std::string, std::set<std::string>> models; // By object.
  for (const StartRecord &record : records) {
    models[record.object].insert(record.model);
  }
  for (const StartRecord &record : records) {
    if (models[record.object].size() > 1) {
      add(record, record.object, all, summaries);
    }
  }
  for (const StartRecord &record : records) {
    if (models.size() > 1) {
      add(record, all, all, summaries);
    }
  }
  for (StartSummary &summary : summaries) {
    for (double *share : {&summary.right, &summary.wrong, &summary.refused, &summary.poseRight}) {
      *share /= static_cast<double>(summary.trials);
    }
  }
  return summaries;
}

std::string startsCsv(const std::vector<StartRecord> &records)
{
  std::ostringstream text;
  text << "tracker,object,model,scene,frame,image_scene,image_frame,angle,offset,outcome,state,score,pose_right,t_mm,"
          "r_deg\n";
  for (const StartRecord &r : records) {
    text << field(r.tracker) << "," << field(r.object) << "," << field(r.model) << "," << field(r.scene) << ","
         << r.frame << "," << field(r.imageScene) << "," << r.imageFrame << "," << plain(r.deviation.angle) << ","
         << plain(r.deviation.offset) << "," << toString(r.outcome) << "," << toString(r.state) << ","
         << number(r.score, 4) << "," << (r.right ? 1 : 0) << "," << number(1e3 * r.translation, 3) << ","
         << number(r.rotation, 3) << "\n";
  }
  return text.str();
}

std::string startSummaryCsv(const std::vector<StartSummary> &summaries)
{
  std::ostringstream text;
  text << "tracker,object,model,angle,offset,trials,right,wrong,refused,pose_right\n";
  for (const StartSummary &s : summaries) {
    text << field(s.tracker) << "," << field(s.object) << "," << field(s.model) << "," << plain(s.deviation.angle)
         << "," << plain(s.deviation.offset) << "," << s.trials << "," << number(s.right, 6) << ","
         << number(s.wrong, 6) << "," << number(s.refused, 6) << "," << number(s.poseRight, 6) << "\n";
  }
  return text.str();
}

std::string startMarkdown(const std::vector<StartSummary> &summaries)
{
  const bool isGrid = std::any_of(summaries.begin(), summaries.end(), [&summaries](const StartSummary &summary) {
    return vpIsOther(summary.deviation.angle, summaries.front().deviation.angle) ||
           vpIsOther(summary.deviation.offset, summaries.front().deviation.offset);
  });
  return isGrid ? grids(summaries) : listTable(summaries);
}

} // namespace bench
