// SPDX-License-Identifier: GPL-2.0-or-later
#include <catchMain.h>

#include "evaluate/evaluation.h"
#include "evaluate/htmlReport.h"
#include "evaluate/tables.h"
#include "generate/scene.h"

#include <meshFiles.h>

#include <filesystem>
#include <fstream>
#include <sstream>

namespace {
namespace fs = std::filesystem;
using bench::Evaluation;

// A small data set on a plain background, rendered once.
const meshFiles::TemporaryFolder &rendered()
{
  static const meshFiles::TemporaryFolder folder;
  static bool done = false;
  if (!done) {
    bench::SceneOptions options;
    options.dataset = folder.path("set");
    options.background = "plain";
    options.width = 320;
    options.height = 240;
    options.frames = 8;
    for (const char *variant : {"regular", "noise"}) {
      options.variant = variant;
      bench::generateScene(options);
    }
    done = true;
  }
  return folder;
}

// A copy that a test may break.
class DataSet
{
public:
  DataSet() { fs::copy(rendered().path("set"), m_folder.path("set"), fs::copy_options::recursive); }

  std::string path(const std::string &name) const { return m_folder.path("set/" + name); }

  bench::EvaluateOptions options() const
  {
    bench::EvaluateOptions options;
    options.dataset = m_folder.path("set");
    options.scenes = {"all"};
    options.trackers = {"edge", "visp-edge"};
    options.out = m_folder.path("out");
    return options;
  }

  std::string read(const std::string &name) const
  {
    std::ostringstream text;
    text << std::ifstream(path(name)).rdbuf();
    return text.str();
  }

private:
  meshFiles::TemporaryFolder m_folder;
};
} // namespace

TEST_CASE("Trackers are run on all scenes of a data set", "[evaluate]")
{
  const DataSet set;
  bench::EvaluateOptions options = set.options();
  options.protocols = {bench::Protocol::RBOT, bench::Protocol::RUN};
  options.steps = {1, 2};
  const Evaluation evaluation = bench::evaluate(options);
  CHECK(evaluation.failures.empty());
  REQUIRE(evaluation.runs.size() == 16);
  for (const bench::RunResult &run : evaluation.runs) {
    CHECK(run.records.size() == (run.summary.key.step == 1 ? 7 : 3));
    CHECK(fs::exists(set.options().out + "/runs/" + run.summary.key.fileName() + ".csv"));
  }
  CHECK(evaluation.runs[0].summary.key.scene == "box_noise");
  CHECK(evaluation.runs[8].summary.key.scene == "box_regular");
  CHECK(evaluation.runs[8].summary.success == Approx(1.)); // The regular box on a plain background, step 1.
  CHECK(evaluation.runs[8].summary.translationMedian < 5.);

  const std::string html = bench::toHtml(evaluation);
  CHECK(html.find("box_regular, rbot, step 1, frame") != std::string::npos);
  CHECK(html.find("<polyline") != std::string::npos);
  CHECK(html.find("<h2>State and score</h2>") != std::string::npos);
  CHECK(html.find("visp-edge: ROC curve") != std::string::npos);
  CHECK(html.find("data:image/jpeg;base64,") != std::string::npos);
}

TEST_CASE("A broken scene is named and does not keep the others from being run", "[evaluate]")
{
  const DataSet set;
  bench::EvaluateOptions options = set.options();
  options.jobs = 2;
  std::string culprit;
  std::size_t failures = 1; // Found on opening: once for all trackers.
  SECTION("a missing image")
  {
    culprit = "rgb/000003.png";
    fs::remove(set.path("box_noise/rgb/000003.png"));
  }
  SECTION("an image that is none")
  {
    culprit = "rgb/000003.png";
    std::ofstream(set.path("box_noise/rgb/000003.png")) << "no picture";
    failures = 2;
  }
  SECTION("a truncated file")
  {
    culprit = "scene_gt.json";
    const std::string text = set.read("box_noise/scene_gt.json");
    std::ofstream(set.path("box_noise/scene_gt.json")) << text.substr(0, text.size() / 2);
  }
  const Evaluation evaluation = bench::evaluate(options);
  REQUIRE(evaluation.failures.size() == failures);
  CHECK(evaluation.failures[0].what.find("box_noise") != std::string::npos);
  CHECK(evaluation.failures[0].why.find(culprit) != std::string::npos);
  REQUIRE(evaluation.runs.size() == 2);
  CHECK(evaluation.runs[0].summary.key.scene == "box_regular");
  CHECK(evaluation.runs[1].summary.frames == 7);
}

TEST_CASE("An unknown object or scene is named", "[evaluate]")
{
  const DataSet set;
  bench::EvaluateOptions options = set.options();
  SECTION("object")
  {
    options.object = 17;
    const Evaluation evaluation = bench::evaluate(options);
    REQUIRE(evaluation.failures.size() == 2);
    CHECK(evaluation.failures[0].why.find("17") != std::string::npos);
  }
  SECTION("scene")
  {
    options.scenes = {"box_nosie"};
    const Evaluation evaluation = bench::evaluate(options);
    REQUIRE(evaluation.failures.size() == 1);
    CHECK(evaluation.failures[0].why.find("box_nosie") != std::string::npos);
  }
}

TEST_CASE("A resumed evaluation keeps what is there", "[evaluate]")
{
  const DataSet set;
  bench::EvaluateOptions options = set.options();
  options.scenes = {"box_regular"};
  options.trackers = {"edge"};
  const Evaluation first = bench::evaluate(options);
  REQUIRE(first.runs.size() == 1);
  const std::string file = options.out + "/runs/" + first.runs[0].summary.key.fileName() + ".json";
  const fs::file_time_type written = fs::last_write_time(file);

  options.resume = true;
  options.steps = {1, 2};
  const Evaluation second = bench::evaluate(options);
  REQUIRE(second.runs.size() == 2);
  CHECK(fs::last_write_time(file) == written);
  CHECK(second.runs[0].summary.msMedian == exactly(first.runs[0].summary.msMedian));

  // Another question.
  SECTION("threads")
  {
    options.threads = 2;
  }
  SECTION("starts")
  {
    options.start.pixels = 4.;
  }
  bench::evaluate(options);
  CHECK(fs::last_write_time(file) != written);
}

TEST_CASE("A tracker without the model that it needs is left out", "[evaluate]")
{
  const DataSet set;
  fs::remove(set.path("models/obj_000001.cao"));
  const Evaluation evaluation = bench::evaluate(set.options());
  CHECK(evaluation.failures.empty());
  CHECK(evaluation.skipped.size() == 2);
  CHECK(evaluation.runs.size() == 2);
}
