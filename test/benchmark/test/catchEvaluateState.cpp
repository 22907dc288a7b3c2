// SPDX-License-Identifier: GPL-2.0-or-later
#include <catchMain.h>

#include "evaluate/stateTables.h"

#include <algorithm>
#include <cmath>

#ifdef ENABLE_VISP_NAMESPACE
using namespace VISP_NAMESPACE_NAME;
#endif

namespace {
using bench::FrameRecord;
using bench::Protocol;
using bench::Recovery;

// 'r': right, 'w': wrong, 'h', 'H': hidden, with a pose that is wrong or right, '?': without truth.
std::vector<FrameRecord> records(const std::string &pattern)
{
  std::vector<FrameRecord> result;
  for (std::size_t i = 0; i < pattern.size(); ++i) {
    FrameRecord record;
    record.frame = static_cast<int>(i) + 1;
    record.known = pattern[i] != '?';
    record.counted = pattern[i] == 'r' || pattern[i] == 'w';
    record.right = record.success = pattern[i] == 'r' || pattern[i] == 'H';
    record.answer.state = vpTrackingState::TRACKING;
    result.push_back(record);
  }
  return result;
}

// Frame, length, and whether it was hidden, of each.
std::string recoveries(const std::string &pattern)
{
  std::string text;
  for (const Recovery &recovery : bench::findRecoveries(records(pattern))) {
    text += (text.empty() ? "" : " ") + std::to_string(recovery.frame) + ":" + std::to_string(recovery.frames) +
            (recovery.hidden ? "h" : "");
  }
  return text;
}

bench::RunResult run(const std::string &scene, const std::string &tracker, Protocol protocol, int step,
                     const std::vector<FrameRecord> &frames)
{
  bench::RunResult result;
  result.records = frames;
  result.summary = bench::summarise({scene, tracker, protocol, step}, frames, 0.2, false, {});
  return result;
}
} // namespace

TEST_CASE("The area under the ROC curve is the share of pairs in order, and equal scores are half in order",
          "[evaluate]")
{
  using Poses = std::vector<bench::ScoredPose>;
  CHECK(bench::rocArea({{0.9, true}, {0.8, true}, {0.1, false}}) == exactly(1.));
  CHECK(bench::rocArea({{0.1, true}, {0.9, false}}) == exactly(0.));
  CHECK(bench::rocArea({{0.5, true}, {0.5, false}, {0.5, false}}) == exactly(0.5));
  // Six pairs: 0.9 > 0.5, 0.9 > 0.2; 0.5 = 0.5, 0.5 > 0.2; 0.1 is below both. 3.5 of 6.
  CHECK(bench::rocArea({{0.9, true}, {0.5, true}, {0.1, true}, {0.5, false}, {0.2, false}}) == Approx(3.5 / 6.));
  CHECK(std::isnan(bench::rocArea(Poses{{0.5, true}})));
  CHECK(std::isnan(bench::rocArea(Poses{{0.5, false}})));
  CHECK(std::isnan(bench::rocArea({})));
}

TEST_CASE("The ROC curve has a point for each score", "[evaluate]")
{
  const std::vector<bench::ScoredPose> poses = {{0.9, true}, {0.5, true}, {0.1, true}, {0.5, false}, {0.2, false}};
  const std::vector<bench::RocPoint> curve = bench::rocCurve(poses);
  REQUIRE(curve.size() == 5);
  const double wrong[] = {0., 0., 0.5, 1., 1.};
  const double right[] = {0., 1. / 3., 2. / 3., 2. / 3., 1.};
  for (std::size_t i = 0; i < curve.size(); ++i) {
    CHECK(curve[i].wrong == Approx(wrong[i]));
    CHECK(curve[i].right == Approx(right[i]));
  }
  CHECK(bench::rocCurve({{0.5, true}}).empty());

  std::vector<bench::ScoredPose> many;
  for (int i = 0; i < 1000; ++i) {
    many.push_back({1e-3 * i, i % 3 == 0});
  }
  const std::vector<bench::RocPoint> thinned = bench::rocCurve(many, 50);
  CHECK(thinned.size() <= 50);
  CHECK(thinned.back().wrong == exactly(1.));
  CHECK(thinned.back().right == exactly(1.));
}

TEST_CASE("The calibration error weighs bins of the score by their frames", "[evaluate]")
{
  // Three in the first bin, mean 0.04, one of them right; one in the last, which has the score 1 in it.
  const bench::Reliability bins = bench::reliability({{0., false}, {0.03, true}, {0.09, false}, {1., true}});
  CHECK(bins[0].count == 3);
  CHECK(bins[0].score == Approx(0.04));
  CHECK(bins[0].right == Approx(1. / 3.));
  CHECK(bins[5].count == 0);
  CHECK(std::isnan(bins[5].score));
  CHECK(bins[9].count == 1);
  CHECK(bench::calibrationError(bins) == Approx(0.75 * (1. / 3. - 0.04)));
  CHECK(std::isnan(bench::calibrationError(bench::reliability({}))));
}

TEST_CASE("Recoveries count the frames until the first of five right ones", "[evaluate]")
{
  CHECK(recoveries("rrrrrrrr").empty());
  CHECK(recoveries("rrwwwwrrr").empty());               // No loss yet.
  CHECK(recoveries("rrhhrrrrr") == "5:0h");             // Held.
  CHECK(recoveries("rrHHwwrwrrrrr") == "5:4h");         // One right frame is no recovery.
  CHECK(recoveries("rwwwwwwrrrrrr") == "2:6");          // Lost in full view.
  CHECK(recoveries("rwwwwwwhhwrrrrr") == "2:-1 10:1h"); // It was not found before it was hidden.
  CHECK(recoveries("rhwwhwrrrrr") == "6:1h");           // Two frames are too few to say.
  CHECK(recoveries("rhwwwwww") == "3:-1h");             // Never.
  CHECK(recoveries("rhwwwwwrrrr").empty());             // The images end too soon.
  CHECK(recoveries("rrhhh").empty());                   // Not seen again.
  CHECK(recoveries("rhrrrrrwwwwwrrrrrhrrrrr") == "3:0h 8:5 19:0h");
  CHECK(recoveries("r?rrrrr") == "3:0h"); // Without truth as if hidden.
}

TEST_CASE("States are compared with the truth, on hidden frames too", "[evaluate]")
{
  std::vector<FrameRecord> frames = records("rrrwwhhH?");
  frames[1].answer.state = vpTrackingState::LOST; // Right.
  frames[4].answer.state = vpTrackingState::LOST; // Wrong.
  frames[5].answer.state = vpTrackingState::UNCERTAIN;
  bench::StatePool pool;
  pool.add("box_regular", Protocol::RUN, frames);
  const bench::StateFigures figures = pool.figures();
  CHECK(figures.counted.count == 5);
  CHECK(figures.counted.falseTracking == Approx(1. / 5.));
  CHECK(figures.lostWhileRight == Approx(1. / 5.));
  CHECK(figures.known.count == 8);
  CHECK(figures.known.falseTracking == Approx(2. / 8.));
  CHECK(std::isnan(figures.counted.rocArea)); // No score.
  CHECK(std::isnan(figures.heldThroughout));  // No occlusion.
}

TEST_CASE("Scores count where the tracker has one", "[evaluate]")
{
  std::vector<FrameRecord> frames = records("rwrhw");
  const double scores[] = {0.9, 0.3, std::nan(""), 0.95, 0.25};
  for (std::size_t i = 0; i < frames.size(); ++i) {
    frames[i].answer.score = scores[i];
  }
  bench::StatePool pool;
  pool.add("box_regular", Protocol::RBOT, frames);
  const bench::StateFigures figures = pool.figures();
  CHECK(figures.counted.rocArea == exactly(1.));
  CHECK(figures.known.rocArea == Approx(2. / 3.)); // The hidden object was believed in most.
  CHECK(figures.counted.calibrationError == Approx((0.1 + 0.3 + 0.25) / 3.));
  CHECK(figures.bins[9].count == 1);
}

TEST_CASE("Runs of a tracker, protocol and step are pooled, and those of a tracker", "[evaluate]")
{
  bench::Evaluation evaluation;
  evaluation.runs.push_back(run("box_occlusion", "edge", Protocol::RUN, 1, records("rrrrrrrr")));
  evaluation.runs.push_back(run("bands_occlusion", "edge", Protocol::RUN, 1, records("rwwwwwrrrrrr")));
  evaluation.runs.push_back(run("bands_exit", "edge", Protocol::RUN, 2, records("rhwwwwwwwwwwwrrrrr")));
  evaluation.runs.push_back(run("bands_exit", "edge", Protocol::RBOT, 1, records("rhwwwwwwwwwwwrrrrr")));
  evaluation.runs.push_back(run("bands_exit", "other, one", Protocol::RUN, 1, records("rhrrrrr")));
  const std::vector<bench::StateGroup> groups = bench::stateGroups(evaluation);
  REQUIRE(groups.size() == 6);
  CHECK(groups[0].protocol == "run");
  CHECK(groups[0].runs == 2);
  CHECK(groups[0].figures.counted.count == 20);
  CHECK(groups[0].figures.counted.falseTracking == Approx(5. / 20.)); // Not the mean of 0 and 5/12.
  CHECK(groups[0].figures.occlusions == 2);
  CHECK(groups[0].figures.heldThroughout == exactly(0.5));
  CHECK(groups[1].figures.recoveries == 1);
  CHECK(groups[1].figures.recovered == exactly(1.));
  CHECK(groups[1].figures.recoveredSoon == exactly(0.)); // After 11 frames.
  CHECK(groups[2].protocol == "rbot");
  CHECK(groups[2].figures.recoveries == 0); // It was started again.
  CHECK(std::isnan(groups[2].figures.recovered));
  CHECK(groups[3].protocol == "all");
  CHECK(groups[3].runs == 4);
  CHECK(groups[3].figures.recoveries == 2);
  CHECK(groups[3].figures.recoveredSoon == exactly(0.5));
  CHECK(groups[4].tracker == "other, one");

  const std::string csv = bench::stateCsv(groups);
  CHECK(csv.find("\nedge,run,1,2,20,20,2,0.250000,0.250000,0.000000,,,,,1,1.000000,1.000000,5,0.500000\n") !=
        std::string::npos);
  CHECK(csv.find("\n\"other, one\",all,all,1,") != std::string::npos);
  const std::string head = csv.substr(0, csv.find('\n'));
  CHECK(std::count(head.begin(), head.end(), ',') == 18);
  const std::string bins = bench::reliabilityCsv(groups);
  CHECK(std::count(bins.begin(), bins.end(), '\n') == 61);
}

TEST_CASE("The report shows curves of each tracker", "[evaluate]")
{
  bench::Evaluation evaluation;
  std::vector<FrameRecord> frames = records("rwrw");
  for (std::size_t i = 0; i < frames.size(); ++i) {
    frames[i].answer.score = 0.9 - 0.2 * static_cast<double>(i);
  }
  evaluation.runs.push_back(run("box_regular", "edge", Protocol::RUN, 1, frames));
  const std::vector<bench::StateGroup> groups = bench::stateGroups(evaluation);
  const std::string html = bench::statePlots(groups);
  CHECK(html.find("edge: ROC curve") != std::string::npos);
  CHECK(html.find("edge: reliability") != std::string::npos);
  CHECK(html.find("<polyline") != std::string::npos);
  CHECK(bench::stateMarkdown(groups).find(" 100.0 (1) |") != std::string::npos); // Of the reliability table.
}
