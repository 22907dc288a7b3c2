// SPDX-License-Identifier: GPL-2.0-or-later
#include <catchMain.h>

#include "evaluate/runFiles.h"
#include "evaluate/tables.h"

#include <meshFiles.h>

#include <cmath>
#include <fstream>
#include <sstream>

#ifdef ENABLE_VISP_NAMESPACE
using namespace VISP_NAMESPACE_NAME;
#endif

namespace {
using bench::FrameRecord;
using bench::Loss;

// 'r': right, 'w': wrong, '-': does not count.
std::vector<FrameRecord> records(const std::string &pattern)
{
  std::vector<FrameRecord> result;
  for (std::size_t i = 0; i < pattern.size(); ++i) {
    FrameRecord record;
    record.frame = static_cast<int>(i) + 1;
    record.known = true;
    record.counted = pattern[i] != '-';
    record.right = record.success = pattern[i] == 'r';
    record.error.translation = record.right ? 0.002 : 0.3;
    record.error.add = record.error.translation;
    record.error.adds = 0.5 * record.error.add;
    record.answer.state = vpTrackingState::TRACKING;
    record.answer.stages = {1., static_cast<double>(i)};
    record.ms = static_cast<double>(i);
    result.push_back(record);
  }
  return result;
}

std::string readAll(const std::string &file)
{
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

const bench::RunKey key = {"test/000001", "edge", bench::Protocol::RUN, 2};
} // namespace

TEST_CASE("A loss begins and ends with five frames on end", "[evaluate]")
{
  CHECK(bench::findLosses(records("rrrrrrrrr")).empty());
  CHECK(bench::findLosses(records("rrwwwwrrwwww")).empty());

  const std::vector<Loss> lost = bench::findLosses(records("rrwwwwwrrrrwrrrrrr"));
  REQUIRE(lost.size() == 1);
  CHECK(lost[0].lost == 3);
  CHECK(lost[0].back == 13);

  const std::vector<Loss> gone = bench::findLosses(records("rw-w-ww--wrrrr"));
  REQUIRE(gone.size() == 1);
  CHECK(gone[0].lost == 2); // Frames that do not count interrupt nothing.
  CHECK(gone[0].back == -1);

  CHECK(bench::findLosses(records("wwwwwrrrrrrwwwwwrrrrr")).size() == 2);
}

TEST_CASE("A summary counts the frames that show the object", "[evaluate]")
{
  const bench::RunSummary summary = bench::summarise(key, records("rrr-----rww"), 0.2, false, {"first", "second"});
  CHECK(summary.frames == 6);
  CHECK(summary.success == Approx(4. / 6.));
  CHECK(summary.right == Approx(4. / 6.));
  CHECK(summary.falseTracking == Approx(2. / 6.));
  CHECK(summary.translationMedian == Approx(2.)); // Of the successful ones, mm.
  CHECK(summary.translation95 == Approx(2.));
  CHECK(summary.addAuc == Approx(4. / 6. * 0.9)); // 2 mm of 20 mm.
  CHECK(summary.addsAuc == Approx(4. / 6. * 0.95));
  CHECK(summary.msMedian == Approx(5.)); // Of all 11.
  REQUIRE(summary.stages.size() == 2);
  CHECK(summary.stages[1].first == "second");
  CHECK(summary.stages[1].second == Approx(5.));

  CHECK(bench::summarise(key, records("rrr"), 0.2, true, {}).addAuc == Approx(0.95)); // ADD-S where it is symmetric.
}

TEST_CASE("Minimisations are those of a frame in the mean, whether it counts or not", "[evaluate]")
{
  bench::Evaluation evaluation;
  bench::RunResult run;
  run.records = records("rr-w");
  for (std::size_t i = 0; i < run.records.size(); ++i) {
    run.records[i].answer.minimisations = i < 3 ? 1. : 7.;
  }
  run.summary = bench::summarise(key, run.records, 0.2, false, {});
  CHECK(run.summary.minimisations == Approx(2.5));
  evaluation.runs.push_back(run);
  const std::string csv = bench::toCsv(evaluation);
  CHECK(csv.find(",2.5000,") != std::string::npos);
}

TEST_CASE("A run that nothing counts in has no shares", "[evaluate]")
{
  const bench::RunSummary summary = bench::summarise(key, records("---"), 0.2, false, {});
  CHECK(summary.frames == 0);
  CHECK(std::isnan(summary.success));
  CHECK(std::isnan(summary.translationMedian));
}

TEST_CASE("A run is written and read again", "[evaluate]")
{
  const meshFiles::TemporaryFolder folder;
  bench::RunResult run;
  run.records = records("rrw");
  run.records[1].answer.cMo = vpHomogeneousMatrix(0.1, 0.2, 0.3, 0.4, 0.5, 0.6);
  run.records[2].answer.cMo[0][3] = std::nan("");
  run.records[2].error.translation = HUGE_VAL;
  run.records[2].reset = true;
  run.records[2].answer.minimisations = 3.;
  run.summary = bench::summarise(key, run.records, 0.2, false, {"first", "second"});
  bench::writeRun(folder.path(""), run, "print");

  std::istringstream csv(readAll(folder.path(key.fileName() + ".csv")));
  std::string line;
  std::getline(csv, line);
  CHECK(line == "frame,r11,r12,r13,tx,r21,r22,r23,ty,r31,r32,r33,tz,ms,reset,state,score,minimisations");
  std::getline(csv, line);
  CHECK(line == "1,1,0,0,0,0,1,0,0,0,0,1,0,0,0,TRACKING,,");

  bench::RunResult again;
  REQUIRE(bench::readRun(folder.path(""), key, "print", 0.2, false, again));
  CHECK(again.summary.success == Approx(2. / 3.));
  CHECK(again.summary.stages.size() == 2);
  CHECK(again.records[1].answer.cMo[1][3] == exactly(run.records[1].answer.cMo[1][3]));
  CHECK(std::isnan(again.records[2].answer.cMo[0][3]));
  CHECK(std::isinf(again.records[2].error.translation));
  CHECK(again.records[2].reset);
  CHECK(again.records[2].answer.minimisations == exactly(3.));
  CHECK(std::isnan(again.records[1].answer.minimisations));
  CHECK(again.records[1].known);

  SECTION("not where it was made with other options")
  {
    CHECK_FALSE(bench::readRun(folder.path(""), key, "other", 0.2, false, again));
  }
  SECTION("not where it was cut off")
  {
    const std::string file = folder.path(key.fileName() + ".json");
    const std::string text = readAll(file);
    std::ofstream(file) << text.substr(0, text.size() / 2);
    CHECK_FALSE(bench::readRun(folder.path(""), key, "print", 0.2, false, again));
  }
  SECTION("not where an earlier version wrote it")
  {
    const std::string file = folder.path(key.fileName() + ".json");
    const std::string text = readAll(file);
    const std::string format = "\"format\":";
    const std::size_t place = text.find(format);
    REQUIRE(place != std::string::npos);
    std::ofstream(file) << std::string(text).replace(place, format.size(), "\"formerly\":");
    CHECK_FALSE(bench::readRun(folder.path(""), key, "print", 0.2, false, again));
  }
  SECTION("not where it is not there")
  {
    CHECK_FALSE(bench::readRun(folder.path("nowhere"), key, "print", 0.2, false, again));
  }
}

TEST_CASE("The summary has the columns that it promises, in shares, and tables in percent", "[evaluate]")
{
  bench::Evaluation evaluation;
  bench::RunResult run;
  run.records = records("rrrwwwwww-");
  run.summary = bench::summarise(key, run.records, 0.2, false, {"first", "second"});
  evaluation.runs.push_back(run);
  std::istringstream csv(bench::toCsv(evaluation));
  std::string line;
  std::getline(csv, line);
  CHECK(line == "scene,tracker,protocol,step,frames,success,right,first_lost,back,false_tracking,t_mm_median,t_mm_p95,"
                "r_deg_median,r_deg_p95,px_median,add_auc,ms_median,ms_p95,minimisations,false_tracking_known,"
                "lost_while_right,roc_area,calibration_error,roc_area_known,calibration_error_known,recoveries,"
                "recovered,recovered_in_10,recovery_frames_median,held_throughout");
  std::getline(csv, line);
  CHECK(line.rfind("test/000001,edge,run,2,9,0.333333,0.333333,4,,0.666667,2.0000,2.0000,", 0) == 0);
  // The tracker has no number of minimisations, and no score; it was lost once and did not come back.
  CHECK(line.find(",,0.700000,0.000000,,,,,1,0.000000,0.000000,,") != std::string::npos);
  CHECK(bench::toMarkdown(evaluation).find("| test/000001 | edge | run | 2 | 9 | 33.3 | 33.3 | 4 |  | 66.7 |") !=
        std::string::npos);
}
