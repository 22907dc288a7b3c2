// SPDX-License-Identifier: GPL-2.0-or-later
#include <catchMain.h>

#include "generate/scene.h"
#include "starts/startTrials.h"

#include <meshFiles.h>

#include <visp3/core/vpException.h>
#include <visp3/core/vpMath.h>

#include <filesystem>
#include <set>

namespace {
namespace fs = std::filesystem;
using bench::StartOptions;
using bench::StartOutcome;
using bench::StartRecord;
using bench::WrongStart;

Eigen::Vector3d placeOf(const vpHomogeneousMatrix &cMo, const Eigen::Vector3d &X)
{
  const vpHomogeneousMatrix cMx = cMo * vpHomogeneousMatrix(X.x(), X.y(), X.z(), 0., 0., 0.);
  return {cMx[0][3], cMx[1][3], cMx[2][3]};
}

double angleBetween(const vpHomogeneousMatrix &a, const vpHomogeneousMatrix &b)
{
  return vpThetaUVector(a.getRotationMatrix() * b.getRotationMatrix().t()).getTheta();
}

// Two objects on plain backgrounds, rendered once.
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
    options.frames = 6;
    for (const char *object : {"box", "figurine"}) {
      options.object = object;
      bench::generateScene(options);
    }
    done = true;
  }
  return folder;
}

StartOptions optionsFor(const meshFiles::TemporaryFolder &out)
{
  StartOptions options;
  options.dataset = rendered().path("set");
  options.scenes = {"all"};
  options.trackers = {"edge"};
  options.trials = 6;
  options.frames = 3;
  options.out = out.path("out");
  return options;
}

StartRecord record(const std::string &object, StartOutcome outcome, bool right, double angle = 15.)
{
  StartRecord result;
  result.tracker = "edge";
  result.object = result.model = object;
  result.deviation.angle = angle;
  result.outcome = outcome;
  result.right = right;
  return result;
}
} // namespace

TEST_CASE("A start is off by exactly the turn and the shift that were asked for", "[starts]")
{
  const vpHomogeneousMatrix cMo(0.1, -0.2, 0.8, 0.4, -0.9, 1.3);
  const Eigen::Vector3d centre(0.03, 0.2, -0.1);
  Eigen::Vector3d axes = Eigen::Vector3d::Zero();
  for (std::uint64_t i = 0; i < 400; ++i) {
    vpPoseRandom random(7, {i});
    const bench::StartDirection direction = bench::drawDirection(random);
    const vpHomogeneousMatrix start = bench::deviate(cMo, centre, direction, vpMath::rad(15.), 0.02);
    CHECK(vpMath::deg(angleBetween(start, cMo)) == Approx(15.));
    CHECK((placeOf(start, centre) - placeOf(cMo, centre)).norm() == Approx(0.02));
    axes += direction.axis;
  }
  CHECK(axes.norm() < 60.); // All directions: a sum of 400 unit vectors is some 20 long.
}

TEST_CASE("Trials depend on seed, object and number alone", "[starts]")
{
  const meshFiles::TemporaryFolder out;
  StartOptions options = optionsFor(out);
  options.trials = 20;
  const bench::StartScenes scenes = bench::openScenes(options);
  REQUIRE(scenes.objects.size() == 2);
  const std::vector<bench::StartTrial> trials = bench::planTrials(options, scenes, 1);
  options.trials = 5;
  options.deviation.angle = 40.;
  const std::vector<bench::StartTrial> fewer = bench::planTrials(options, scenes, 1);
  std::set<std::size_t> frames;
  for (std::size_t i = 0; i < trials.size(); ++i) {
    CHECK(trials[i].frame <= 3); // Three images are tracked of six.
    CHECK(trials[i].scene == scenes.objects[1].scenes[0]);
    CHECK(trials[i].imageScene == trials[i].scene);
    frames.insert(trials[i].frame);
    if (i < fewer.size()) {
      CHECK(fewer[i].frame == trials[i].frame);
      CHECK(fewer[i].direction.axis == trials[i].direction.axis);
    }
  }
  CHECK(frames.size() == 4);
  options.seed = 2;
  CHECK(bench::planTrials(options, scenes, 1)[0].direction.axis != trials[0].direction.axis);
  options.seed = 1;
  options.frames = 7;
  CHECK_THROWS_WITH(bench::planTrials(options, scenes, 1), ContainsSubstring("7 frames"));
}

TEST_CASE("Wrong trials have another model or another scene", "[starts]")
{
  const meshFiles::TemporaryFolder out;
  StartOptions options = optionsFor(out);
  const bench::StartScenes scenes = bench::openScenes(options);
  options.wrong = WrongStart::MODEL;
  for (const bench::StartTrial &trial : bench::planTrials(options, scenes, 0)) {
    CHECK(trial.model == 1);
    CHECK(trial.imageScene == trial.scene);
  }
  options.wrong = WrongStart::SCENE;
  for (const bench::StartTrial &trial : bench::planTrials(options, scenes, 0)) {
    CHECK(trial.model == 0);
    CHECK(trial.scene == scenes.objects[0].scenes[0]);
    CHECK(trial.imageScene == scenes.objects[1].scenes[0]);
  }
  const bench::SequenceObject scaled = bench::scaledTo(scenes.objects[0].files, scenes.objects[1].files);
  CHECK(scaled.diameter == Approx(scenes.objects[1].files.diameter));

  options.scenes = {"box_regular"};
  CHECK_THROWS_WITH(bench::openScenes(options), ContainsSubstring("--wrong"));
}

TEST_CASE("Starts near the truth are accepted, and the rest is told apart", "[starts]")
{
  const meshFiles::TemporaryFolder out;
  StartOptions options = optionsFor(out);
  options.deviation = {2., 0.01};
  const bench::StartResults near = bench::runStarts(options);
  CHECK(near.failures.empty());
  REQUIRE(near.records.size() == 12);
  for (const StartRecord &trial : near.records) {
    CHECK(trial.deviation.angle == exactly(2.));
    CHECK(trial.right == (trial.translation < 0.1 * 0.198 && trial.rotation < 10.));
    if (trial.object == "obj_000001") {
      CHECK(trial.outcome == StartOutcome::RIGHT);
    }
  }
  options.deviation = {180., 0.};
  for (const StartRecord &trial : bench::runStarts(options).records) {
    const StartOutcome ofTracked = trial.right ? StartOutcome::RIGHT : StartOutcome::WRONG;
    CHECK(trial.outcome == (trial.state == vpTrackingState::TRACKING ? ofTracked : StartOutcome::REFUSED));
  }
  options.wrong = WrongStart::SCENE;
  for (const StartRecord &trial : bench::runStarts(options).records) {
    CHECK(trial.imageScene != trial.scene);
    CHECK(trial.outcome != StartOutcome::RIGHT);
  }
  options.wrong = WrongStart::MODEL;
  for (const StartRecord &trial : bench::runStarts(options).records) {
    CHECK(trial.model != trial.object);
    CHECK_FALSE(trial.right);
  }
  CHECK_FALSE(fs::exists(options.out + "/edge_0.part"));
}

TEST_CASE("A summary counts trials by object", "[starts]")
{
  const std::vector<StartRecord> records = {
      record("box", StartOutcome::RIGHT, true), record("box", StartOutcome::RIGHT, true),
      record("box", StartOutcome::REFUSED, true), record("box", StartOutcome::WRONG, false),
      record("cup", StartOutcome::REFUSED, false)};
  const std::vector<bench::StartSummary> summaries = bench::summariseStarts(records);
  REQUIRE(summaries.size() == 3);
  CHECK(summaries[0].object == "box");
  CHECK(summaries[0].right == exactly(0.5));
  CHECK(summaries[0].wrong == exactly(0.25));
  CHECK(summaries[0].refused == exactly(0.25));
  CHECK(summaries[0].poseRight == exactly(0.75));
  CHECK(summaries[2].object == "all");
  CHECK(summaries[2].trials == 5);
  CHECK(summaries[2].refused == Approx(0.4));
  CHECK(bench::startSummaryCsv(summaries).find("\nedge,box,box,15,0.1,4,0.500000,0.250000,0.250000,0.750000\n") !=
        std::string::npos);
  CHECK(bench::startMarkdown(summaries).find("| edge | all | all | 15 | 0.1 | 5 | 40.0 | 20.0 | 40.0 | 60.0 |") !=
        std::string::npos);
}

TEST_CASE("Wrong models are counted one by one and together", "[starts]")
{
  std::vector<StartRecord> records;
  for (const char *model : {"cup", "bowl", "cup"}) {
    records.push_back(record("box", model == std::string("cup") ? StartOutcome::REFUSED : StartOutcome::WRONG, false));
    records.back().model = model;
  }
  const std::vector<bench::StartSummary> summaries = bench::summariseStarts(records);
  REQUIRE(summaries.size() == 3);
  CHECK(summaries[0].model == "cup");
  CHECK(summaries[0].trials == 2);
  CHECK(summaries[0].refused == exactly(1.));
  CHECK(summaries[1].refused == exactly(0.));
  CHECK(summaries[2].object == "box");
  CHECK(summaries[2].model == "all");
  CHECK(summaries[2].refused == Approx(2. / 3.));
}

TEST_CASE("Several deviations are a table of angle against offset", "[starts]")
{
  StartOptions options;
  options.basin = true;
  CHECK(options.deviations().size() == 42);
  const std::vector<StartRecord> records = {record("box", StartOutcome::RIGHT, true, 5.),
                                            record("box", StartOutcome::WRONG, false, 60.)};
  const std::string table = bench::startMarkdown(bench::summariseStarts(records));
  CHECK(table.find("| angle | 0.1 |\n|--:|--:|\n| 5 | 100.0 |\n| 60 | 0.0 |\n") != std::string::npos);
}

TEST_CASE("Options of starts are checked", "[starts]")
{
  const auto read = [](std::vector<const char *> arguments) {
    const std::vector<const char *> needed = {"multicue-starts", "--dataset", "set",   "--scene", "a",
                                              "--tracker",       "edge",      "--out", "x"};
    arguments.insert(arguments.begin(), needed.begin(), needed.end());
    StartOptions options;
    options.read(static_cast<int>(arguments.size()), arguments.data());
    return options;
  };
  CHECK(read({"--wrong", "scene"}).wrong == WrongStart::SCENE);
  CHECK(read({"--angle", "20"}).deviation.angle == exactly(20.));
  CHECK_THROWS_WITH(read({"--wrong", "light"}), ContainsSubstring("light"));
  CHECK_THROWS_WITH(read({"--angle", "-1"}), ContainsSubstring("--angle"));
  CHECK_THROWS_WITH(read({"--offset", "nan"}), ContainsSubstring("--offset"));
  CHECK_THROWS_WITH(read({"--tracker", "edgy"}), ContainsSubstring("edgy"));
}
