// SPDX-License-Identifier: GPL-2.0-or-later
#include "evaluate/stateTables.h"
#include "evaluate/svgPlot.h"

namespace bench {

namespace {
std::string lineName(const StateGroup &group)
{
  return group.protocol + (group.step == "all" ? "" : ", step " + group.step);
}

SvgPlot::Line rocLine(const StateGroup &group)
{
  SvgPlot::Line line{lineName(group), {}, {}};
  for (const RocPoint &point : group.figures.roc) {
    line.x.push_back(point.wrong);
    line.y.push_back(point.right);
  }
  return line;
}

SvgPlot::Line reliabilityLine(const StateGroup &group)
{
  SvgPlot::Line line{lineName(group), {}, {}};
  for (const ReliabilityBin &bin : group.figures.bins) {
    if (bin.count > 0) {
      line.x.push_back(bin.score);
      line.y.push_back(bin.right);
    }
  }
  return line;
}

// The lines of one tracker, and the diagonal after them, so that they keep their colours.
std::string plotOf(const std::vector<StateGroup> &groups, const std::string &tracker, SvgPlot plot,
                   SvgPlot::Line (*lineOf)(const StateGroup &), const std::string &diagonal)
{
  plot.setColumns({0., 0.25, 0.5, 0.75, 1.});
  for (const StateGroup &group : groups) {
    if (group.tracker == tracker) {
      plot.add(lineOf(group));
    }
  }
  plot.add({diagonal, {0., 1.}, {0., 1.}});
  return plot.svg();
}
} // namespace

std::string statePlots(const std::vector<StateGroup> &groups)
{
  std::string html;
  std::string before;
  for (const StateGroup &group : groups) {
    if (group.tracker == before) {
      continue;
    }
    before = group.tracker;
    html += "<div>" +
            plotOf(groups, before, SvgPlot(before + ": ROC curve", "share of the wrong poses", "of the right poses"),
                   &rocLine, "chance") +
            plotOf(groups, before, SvgPlot(before + ": reliability", "score, mean", "share right"), &reliabilityLine,
                   "ideal") +
            "</div>";
  }
  return html;
}

} // namespace bench
