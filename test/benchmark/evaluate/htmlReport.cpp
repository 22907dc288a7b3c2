// SPDX-License-Identifier: GPL-2.0-or-later
#include "evaluate/htmlReport.h"

#include "evaluate/overlays.h"
#include "evaluate/stateTables.h"
#include "evaluate/svgPlot.h"
#include "evaluate/tables.h"

#include <cmath>
#include <limits>
#include <sstream>

namespace bench {

namespace {
const std::size_t mostOverlays = 40;

const char *const head =
    "<!DOCTYPE html><html lang='en'><head><meta charset='utf-8'><title>Tracker evaluation</title><style>"
    "body{font:14px sans-serif;margin:24px;color:#222}table{border-collapse:collapse;font-size:12px}"
    "td,th{border:1px solid #ddd;padding:2px 6px;text-align:right}td:first-child,th:first-child{text-align:left}"
    "svg{font:11px sans-serif;margin:4px}figure{display:inline-block;margin:4px}figcaption{font-size:12px}"
    "h3{margin-bottom:2px}.wrong{color:#b00}</style></head><body><h1>Tracker evaluation</h1>";

// Rows of Markdown tables as rows of HTML; other lines as paragraphs.
std::string tablesToHtml(const std::string &markdown)
{
  std::ostringstream html;
  std::istringstream lines(markdown);
  bool inTable = false;
  for (std::string line; std::getline(lines, line);) {
    const bool isRow = !line.empty() && line.front() == '|';
    if (isRow != inTable) {
      html << (isRow ? "<table>" : "</table>");
    }
    const char *cell = isRow && !inTable ? "th" : "td";
    inTable = isRow;
    if (!isRow) {
      html << (line.empty() ? "" : "<p>" + escaped(line) + "</p>");
      continue;
    }
    if (line.compare(0, 4, "|---") == 0) {
      continue;
    }
    html << "<tr>";
    std::istringstream cells(line.substr(1));
    for (std::string text; std::getline(cells, text, '|');) {
      html << "<" << cell << ">" << escaped(text) << "</" << cell << ">";
    }
    html << "</tr>\n";
  }
  html << (inTable ? "</table>" : "");
  return html.str();
}

const RunResult *find(const Evaluation &evaluation, const RunKey &key)
{
  for (const RunResult &run : evaluation.runs) {
    if (run.summary.key.fileName() == key.fileName()) {
      return &run;
    }
  }
  return nullptr;
}

// Success against step: a curve for each tracker, on one scene, or their mean for an empty name.
std::string successPlot(const Evaluation &evaluation, const std::string &scene, Protocol protocol)
{
  SvgPlot plot((scene.empty() ? "mean over the scenes" : scene) + ", " + toString(protocol), "step", "success, %");
  plot.setRange(0., 100.);
  for (const std::string &tracker : trackersOf(evaluation)) {
    SvgPlot::Line line{tracker, {}, {}};
    for (const int step : stepsOf(evaluation)) {
      const RunResult *run = scene.empty() ? nullptr : find(evaluation, {scene, tracker, protocol, step});
      line.x.push_back(step);
      line.y.push_back(100. * (scene.empty() ? meanSuccess(evaluation, tracker, protocol, step)
                               : run         ? run->summary.success
                                             : std::numeric_limits<double>::quiet_NaN()));
    }
    plot.add(line);
  }
  return plot.svg();
}

std::string successPlots(const Evaluation &evaluation)
{
  std::string html;
  for (const Protocol protocol : protocolsOf(evaluation)) {
    html += "<div>" + (evaluation.sequences.size() > 1 ? successPlot(evaluation, "", protocol) : "");
    for (const Sequence &sequence : evaluation.sequences) {
      html += successPlot(evaluation, sequence.scene, protocol);
    }
    html += "</div>";
  }
  return html;
}

// Mean distance of the vertices over time, in percent of the diameter; frames that do not count leave a gap.
std::string errorPlot(const Evaluation &evaluation, const Sequence &sequence, Protocol protocol, int step)
{
  SvgPlot plot(sequence.scene + ", " + toString(protocol) + ", step " + std::to_string(step), "frame",
               "ADD, % of diameter", true);
  plot.setRange(0.1, 1000.);
  plot.addLimit(10.);
  for (const std::string &tracker : trackersOf(evaluation)) {
    SvgPlot::Line line{tracker, {}, {}};
    if (const RunResult *run = find(evaluation, {sequence.scene, tracker, protocol, step})) {
      for (const FrameRecord &record : run->records) {
        line.x.push_back(record.frame);
        line.y.push_back(record.counted ? 100. * record.error.add / sequence.object.diameter
                                        : std::numeric_limits<double>::quiet_NaN());
      }
    }
    plot.add(line);
  }
  return plot.svg();
}

std::string errorPlots(const Evaluation &evaluation)
{
  std::string html;
  for (const Sequence &sequence : evaluation.sequences) {
    html += "<div>";
    for (const Protocol protocol : protocolsOf(evaluation)) {
      for (const int step : stepsOf(evaluation)) {
        html += errorPlot(evaluation, sequence, protocol, step);
      }
    }
    html += "</div>";
  }
  return html;
}

std::string overlays(const Evaluation &evaluation)
{
  std::string html;
  for (const OverlayRow &row : worstFrames(evaluation, mostOverlays)) {
    html += "<h3>" + escaped(row.title) + "</h3><div>";
    for (const OverlayRow::Panel &panel : row.panels) {
      html += "<figure><img alt='' src='data:image/jpeg;base64," + panel.jpeg + "'><figcaption>" +
              escaped(panel.tracker + ": " + panel.caption) + "</figcaption></figure>";
    }
    html += "</div>";
  }
  return html;
}

std::string stateSection(const Evaluation &evaluation)
{
  const std::vector<StateGroup> groups = stateGroups(evaluation);
  return "<h2>State and score</h2>" + statePlots(groups) + tablesToHtml(stateMarkdown(groups));
}

std::string failureList(const Evaluation &evaluation)
{
  std::string html;
  for (const std::vector<Failure> *list : {&evaluation.failures, &evaluation.skipped}) {
    for (const Failure &failure : *list) {
      html += "<p class='wrong'>" + escaped(failure.what + ": " + failure.why) + "</p>";
    }
  }
  return html;
}
} // namespace

std::string toHtml(const Evaluation &evaluation)
{
  return head + failureList(evaluation) + "<h2>Success against step</h2>" + successPlots(evaluation) + "<h2>Runs</h2>" +
         tablesToHtml(toMarkdown(evaluation)) + stateSection(evaluation) + "<h2>Error over time</h2>" +
         errorPlots(evaluation) + "<h2>Worst frames</h2><p>Green: the truth; red: the tracker's pose.</p>" +
         overlays(evaluation) + "</body></html>\n";
}

} // namespace bench
