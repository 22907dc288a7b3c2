// SPDX-License-Identifier: GPL-2.0-or-later
#include <catchMain.h>

#include "dataset/sequence.h"
#include "generateChecks.h"
#include "track/trackRun.h"

#include <diskLimit.h>

#include <visp3/core/vpException.h>
#include <visp3/core/vpExponentialMap.h>
#include <visp3/core/vpPoseVector.h>

#include <filesystem>
#include <set>

namespace {
const int frames = 12;

// A sequence of the printed box, and options that track it from its true pose.
class BoxScene
{
public:
  BoxScene()
  {
    bench::SceneOptions scene = generateChecks::options(m_folder.path("data"), "box", "regular", frames);
    scene.width = 320;
    scene.height = 240;
    m_truth = bench::generateScene(scene);
    m_cam = bench::Scene(scene).camera().cam;
    std::ofstream(m_folder.path("camera.json"))
        << "{\"camera\": {\"px\": " << m_cam.get_px() << ", \"py\": " << m_cam.get_py()
        << ", \"u0\": " << m_cam.get_u0() << ", \"v0\": " << m_cam.get_v0() << "}}";
    writePose("start.pos", m_truth.front().cMo);
  }

  std::string path(const std::string &name) const { return m_folder.path(name); }
  const vpHomogeneousMatrix &truth(int frame) const { return m_truth[static_cast<std::size_t>(frame)].cMo; }

  void writePose(const std::string &name, const vpHomogeneousMatrix &cMo) const
  {
    std::ofstream(m_folder.path(name)) << std::setprecision(12) << vpPoseVector(cMo).t();
  }

  programs::TrackOptions options() const
  {
    programs::TrackOptions options;
    options.source.images = path("data/box_regular/rgb/%06d.png");
    options.model = path("data/models/obj_000001.obj");
    options.config = path("camera.json");
    options.start.pose = path("start.pos");
    options.noDisplay = true;
    options.poses = path("poses.csv");
    return options;
  }

  //! Rows of the .csv of poses, without its title.
  std::vector<std::vector<std::string>> poses() const
  {
    std::ifstream file(path("poses.csv"));
    std::vector<std::vector<std::string>> rows;
    std::string line;
    for (std::getline(file, line); std::getline(file, line);) {
      std::istringstream text(line);
      rows.emplace_back();
      for (std::string cell; std::getline(text, cell, ',');) {
        rows.back().push_back(cell);
      }
    }
    return rows;
  }

private:
  meshFiles::TemporaryFolder m_folder;
  std::vector<programs::BopFrame> m_truth;
  vpCameraParameters m_cam;
};

double distance(const std::vector<std::string> &row, const vpHomogeneousMatrix &cMo)
{
  double sum = 0.;
  for (unsigned int i = 0; i < 3; ++i) {
    const double difference = std::stod(row[1 + 4 * i + 3]) - cMo[i][3];
    sum += difference * difference;
  }
  return std::sqrt(sum);
}

std::size_t filesIn(const std::string &folder)
{
  return static_cast<std::size_t>(std::distance(std::filesystem::directory_iterator(folder), {}));
}
} // namespace

TEST_CASE("A run tracks every image, and writes poses, pictures, summary and a data set")
{
  const BoxScene scene;
  programs::TrackOptions options = scene.options();
  std::filesystem::create_directory(scene.path("seen"));
  options.save = scene.path("seen/%03d.png");
  options.summary = scene.path("summary.txt");
  options.record = scene.path("recorded");
  programs::TrackRun(options).run();

  const std::vector<std::vector<std::string>> rows = scene.poses();
  REQUIRE(rows.size() == frames);
  for (int k = 0; k < frames; ++k) {
    const std::vector<std::string> &row = rows[static_cast<std::size_t>(k)];
    CHECK(row[0] == std::to_string(k));
    CHECK(distance(row, scene.truth(k)) < 0.005);
    CHECK(row[14] == "TRACKING");
  }
  CHECK(filesIn(scene.path("seen")) == frames);
  CHECK(generateChecks::bytesOf(scene.path("summary.txt")).find("TRACKING: 12 frames") != std::string::npos);

  const bench::Sequence recorded = bench::openSequence(scene.path("recorded"), "000001");
  REQUIRE(recorded.frames.size() == frames);
  CHECK(recorded.frames.back().hasTruth);
  CHECK(distance(rows.back(), recorded.frames.back().cMo) < 1e-6);
  CHECK(recorded.object.diameter == Approx(bench::openSequence(scene.path("data"), "box_regular").object.diameter));
}

TEST_CASE("What was tracked and recorded until an image cannot be read is kept")
{
  const BoxScene scene;
  programs::TrackOptions options = scene.options();
  options.record = scene.path("recorded");
  std::ofstream(scene.path("data/box_regular/rgb/000004.png")) << "no picture";
  CHECK_THROWS_WITH(programs::TrackRun(options).run(), ContainsSubstring("000004.png"));
  CHECK(scene.poses().size() == 4);
  CHECK(bench::openSequence(scene.path("recorded"), "000001").frames.size() == 4);
}

TEST_CASE("A run that does not get to its first frame leaves the files of the one before")
{
  const BoxScene scene;
  programs::TrackOptions options = scene.options();
  std::ofstream(scene.path("poses.csv")) << "title\n1,2,3\n";
  options.start.pose = scene.path("none.pos");
  CHECK_THROWS_WITH(programs::TrackRun(options).run(), ContainsSubstring("none.pos"));
  CHECK(scene.poses() == std::vector<std::vector<std::string>>{{"1", "2", "3"}});
}

TEST_CASE("Where the disk is full a run names what cannot be written, and the poses of the one before stay")
{
  const BoxScene scene;
  programs::TrackOptions options = scene.options();
  std::ofstream(scene.path("poses.csv")) << "title\n1,2,3\n";
  const DiskLimit limit(200);
  if (!limit.isSet) {
    WARN("Left out: no limit of the size of files");
    return;
  }
  CHECK_THROWS_WITH(programs::TrackRun(options).run(), ContainsSubstring("poses.csv"));
  CHECK(scene.poses() == std::vector<std::vector<std::string>>{{"1", "2", "3"}});
}

TEST_CASE("A new recording takes the truth of an earlier one away before its images come")
{
  const BoxScene scene;
  programs::TrackOptions options = scene.options();
  options.record = scene.path("recorded");
  programs::TrackRun(options).run();
  REQUIRE_FALSE(bench::openSequence(scene.path("recorded"), "000001").frames.empty());
  const programs::BopSceneWriter begun(scene.path("recorded"), "000001", 1, vpCameraParameters());
  CHECK_THROWS_WITH(bench::openSequence(scene.path("recorded"), "000001"), ContainsSubstring("scene_"));
}

TEST_CASE("A rough start finds the object about a pose that is off, and a pose file does not")
{
  const BoxScene scene;
  programs::TrackOptions options = scene.options();
  vpColVector off(6, 0.);
  off[0] = 0.012;
  off[5] = 0.15;
  scene.writePose("rough.pos", scene.truth(0) * vpExponentialMap::direct(off));
  options.start.pose.clear();
  options.start.rough = scene.path("rough.pos");
  programs::TrackRun(options).run();
  const std::vector<std::vector<std::string>> rows = scene.poses();
  REQUIRE(rows.size() == frames);
  CHECK(distance(rows.back(), scene.truth(frames - 1)) < 0.005);
  CHECK(rows.back()[14] == "TRACKING");
}

TEST_CASE("A run says what it cannot open")
{
  const BoxScene scene;
  programs::TrackOptions options = scene.options();
  const auto run = [&options] { programs::TrackRun(options).run(); };
  SECTION("images")
  {
    options.source.images = scene.path("data/box_regular/rgb/%06d.jpg");
    CHECK_THROWS_WITH(run(), ContainsSubstring("%06d.jpg"));
  }
  SECTION("a folder for the video")
  {
    options.save = scene.path("nowhere/seen.mp4");
    CHECK_THROWS_WITH(run(), ContainsSubstring("--save") && ContainsSubstring("nowhere"));
  }
  SECTION("a start by clicks without a window")
  {
    std::ofstream(scene.path("box.init")) << "4\n0 0 0\n0.1 0 0\n0.1 0.1 0\n0 0.1 0\n";
    options.start.pose.clear();
    options.start.click = scene.path("box.init");
    CHECK_THROWS_WITH(run(), ContainsSubstring("--init-click needs a window"));
  }
  SECTION("a cue")
  {
    options.cues = {"edge", "smell"};
    CHECK_THROWS_WITH(run(), ContainsSubstring("'smell'"));
  }
  SECTION("a start that is not there")
  {
    options.start.pose = scene.path("none.pos");
    CHECK_THROWS_WITH(run(), ContainsSubstring("none.pos"));
  }
}

TEST_CASE("The configuration may say the model, and the command line another one", "[track]")
{
  const BoxScene scene;
  programs::TrackOptions options = scene.options();
  const auto run = [&options] { programs::TrackRun(options).run(); };
  options.model.clear();
  CHECK_THROWS_WITH(run(), ContainsSubstring("--model") && ContainsSubstring("camera.json"));

  const std::string camera = nlohmann::json::parse(std::ifstream(options.config)).at("camera").dump();
  options.config = scene.path("all.json");
  std::ofstream(options.config) << "{\"camera\": " << camera
                                << ", \"model\": {\"file\": \"data/models/obj_000001.ply\", \"unit\": 0.001}}";
  run();
  REQUIRE(scene.poses().size() == frames);
  CHECK(distance(scene.poses().back(), scene.truth(frames - 1)) < 0.005);

  options.model = scene.path("data/models/obj_000001.obj"); // Its unit is another one.
  run();
  CHECK(distance(scene.poses().back(), scene.truth(frames - 1)) < 0.005);
  std::ofstream(options.config) << "{\"camera\": " << camera << ", \"model\": {\"file\": \"none.obj\"}}";
  run();
  CHECK(distance(scene.poses().back(), scene.truth(frames - 1)) < 0.005);
}
