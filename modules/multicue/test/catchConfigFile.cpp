// SPDX-License-Identifier: GPL-2.0-or-later
// A tracker's configuration as a whole: what is saved is what is in force.
#include <catchMain.h>

#include "renderedBox.h"
#include "settingsFiles.h"

#include <visp3/cues/vpPointCue.h>
#include <visp3/multicue/vpMbMultiCueTracker.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <vector>

namespace {
using settingsFiles::Folder;
using settingsFiles::messageOf;
using settingsFiles::textOf;
using settingsFiles::unusual;
using Json = nlohmann::ordered_json;

// What a tracker writes, with and without an object that presets say differently.
Json saved(const vpMbMultiCueTracker &tracker)
{
  const Folder folder;
  tracker.saveConfigFile(folder.path("saved.json"));
  return Json::parse(textOf(folder.path("saved.json")));
}

void load(vpMbMultiCueTracker &tracker, const Json &json)
{
  const Folder folder;
  tracker.loadConfigFile(folder.write("config.json", json.dump()), false);
}

// All keys with other values than the defaults, and with none that says what a tracker cannot have without a model.
Json unusualJson()
{
  const Folder folder;
  vpMultiCueSettings settings = unusual();
  settings.symmetries = "none";
  settings.modelFile.clear();
  vpMultiCueSettingsReader::write(folder.path("unusual.json"), settings);
  return Json::parse(textOf(folder.path("unusual.json")));
}

std::vector<vpHomogeneousMatrix> follow(vpMbMultiCueTracker &tracker)
{
  renderedBox box;
  tracker.loadModel(renderedBox::writeCao(meshFiles::temporaryFile("saved-box.cao")));
  const auto poseAt = [](int i) {
    return renderedBox::pose() * vpHomogeneousMatrix(0.002 * i, 0., 0.001 * i, 0., 0.01 * i, 0.);
  };
  tracker.initFromPose(box.draw(poseAt(0)), poseAt(0));
  std::vector<vpHomogeneousMatrix> poses;
  for (int i = 1; i < 6; ++i) {
    tracker.track(box.draw(poseAt(i)));
    poses.push_back(tracker.getPose());
  }
  return poses;
}

bool areSame(const vpHomogeneousMatrix &a, const vpHomogeneousMatrix &b)
{
  return std::equal(a.data, a.data + 16, b.data, vpIsSame);
}
} // namespace

TEST_CASE("Every key that was loaded is saved again, with every preset", "[config]")
{
  const Json changed = unusualJson();
  for (const std::string &preset : vpMultiCuePresetNames()) {
    for (const auto &[object, value] : changed.items()) {
      if (object == "cues") {
        continue;
      }
      INFO(preset << ", " << object << ": " << value);
      vpMbMultiCueTracker tracker, again(1, vpMbMultiCueTracker::COLOR_TRACKER);
      load(tracker, {{"preset", preset}, {object, value}});
      const Json first = saved(tracker);
      CHECK(first["preset"] == preset);
      CHECK(first[object] == value);
      load(again, first);
      CHECK(saved(again) == first);
      CHECK(again.getPreset() == vpMultiCuePresetFromString(preset));
      CHECK(again.getTrackerType() == tracker.getTrackerType());
    }
  }
}

TEST_CASE("All keys at once are saved again without a preset", "[config]")
{
  vpMbMultiCueTracker tracker, again;
  const Json all = unusualJson();
  load(tracker, all);
  CHECK_FALSE(tracker.getPreset());
  CHECK(saved(tracker) == all);
  load(again, saved(tracker));
  CHECK_FALSE(again.getPreset());
  CHECK(saved(again) == all);
}

TEST_CASE("What setters changed is saved", "[config]")
{
  vpMbMultiCueTracker tracker;
  tracker.setCameraParameters(vpCameraParameters(600., 601., 320., 240.));
  tracker.setFeatureFactors({{vpMbMultiCueTracker::COLOR_TRACKER, 0.5}});
  tracker.setPredictedRange(true);
  tracker.setGoodMovingEdgesRatioThreshold(0.3);
  tracker.setKltThresholdAcceptation(0.2);
  tracker.setRenderer(vpModelRenderer::CPU);
  tracker.setThrowOnLoss(true);
  tracker.setDisplayParticles(true);
  tracker.setModelUnit(0.001);
  tracker.setMaxIter(11);
  tracker.setLambda(0.7);
  tracker.setOptimizationMethod(vpMbTracker::LEVENBERG_MARQUARDT_OPT);
  tracker.setCovarianceComputation(true);
  vpColVector motions(6, 1.);
  motions[2] = 0.;
  tracker.setEstimatedDoF(motions);
  const Json json = saved(tracker);
  CHECK(json["camera"]["py"] == 601.);
  CHECK(json["factors"]["color"] == 0.5);
  CHECK(json["prediction"]["range"] == true);
  CHECK(json["edge"]["goodRatio"] == 0.3);
  CHECK(json["klt"]["leastWeight"] == 0.2);
  CHECK(json["renderer"] == "cpu");
  CHECK(json["throwOnLoss"] == true);
  CHECK(json["display"]["particles"] == true);
  CHECK(json["model"]["unit"] == 0.001);
  CHECK(json["estimation"]["maxIterations"] == 11);
  CHECK(json["estimation"]["method"] == "levenberg marquardt");
  CHECK(json["estimation"]["motions"] == Json({1, 1, 0, 1, 1, 1}));
  vpMbMultiCueTracker again;
  load(again, json);
  CHECK(saved(again) == json);
  CHECK(again.getMaxIter() == 11);
  CHECK(again.getOptimizationMethod() == vpMbTracker::LEVENBERG_MARQUARDT_OPT);
  CHECK(vpIsSame(again.getEstimatedDoF()[2], 0.));
  CHECK(vpIsSame(again.getModelOptions().unit, 0.001));
}

TEST_CASE("A tracker with a saved configuration tracks to the last bit as the one that saved it", "[config]")
{
  for (const std::string &preset : vpMultiCuePresetNames()) {
    INFO(preset);
    vpMbMultiCueTracker tracker, again(1, vpMbMultiCueTracker::EDGE_TRACKER);
    tracker.setCameraParameters(renderedBox::camera());
    tracker.setPreset(vpMultiCuePresetFromString(preset));
    tracker.setFrameDeadline(0.); // Time would decide otherwise.
    vpEdgeCueSettings edges = tracker.getEdgeSettings();
    edges.range = 11.;
    tracker.setEdgeSettings(edges);
    tracker.setLambda(0.9);
    load(again, saved(tracker));
    const std::vector<vpHomogeneousMatrix> expected = follow(tracker), found = follow(again);
    CHECK(std::equal(expected.begin(), expected.end(), found.begin(), found.end(), areSame));
    CHECK(again.getTrackingState() == vpTrackingState::TRACKING);
    vpMbMultiCueTracker other; // The camera has a part in it: the comparison can fail.
    other.setCameraParameters(vpCameraParameters(610., 610., 320., 240.));
    CHECK_FALSE(areSame(follow(other).back(), expected.back()));
  }
}

TEST_CASE("A preset's cues are saved as what differs from it", "[config]")
{
  vpMbMultiCueTracker tracker, again;
  load(tracker, {{"preset", "robust"}, {"color", false}});
  const Json json = saved(tracker);
  CHECK(json["color"]["enabled"] == false);
  CHECK_FALSE(json["edge"].contains("enabled"));
  CHECK_FALSE(json.contains("cues"));
  load(again, json);
  CHECK(again.getTrackerType() == tracker.getTrackerType());
  CHECK((again.getTrackerType() & vpMbMultiCueTracker::COLOR_TRACKER) == 0);
}

TEST_CASE("A model that the file says is loaded once", "[config]")
{
  const Folder folder;
  renderedBox::writeCao(folder.path("box.cao"));
  const std::string file = folder.write("config.json", R"({"model": {"file": "box.cao"}, "edge": {"range": 9}})");
  vpMbMultiCueTracker tracker;
  tracker.loadConfigFile(file, false);
  REQUIRE(tracker.getModel());
  const std::size_t faces = tracker.getModel()->faces().size();
  CHECK(saved(tracker)["model"]["file"] == folder.path("box.cao"));
  tracker.loadConfigFile(file, false);
  CHECK(tracker.getModel()->faces().size() == faces);
  tracker.resetTracker();
  CHECK(saved(tracker)["model"]["file"] == "");

  vpMbMultiCueTracker other;
  other.loadModel(folder.path("box.cao"));
  other.loadConfigFile(file, false);
  CHECK(other.getModel()->faces().size() == faces);
  REQUIRE(other.getConfigReport().left.size() == 1);
  CHECK(other.getConfigReport().left[0].name == "model.file");
  CHECK(vpIsSame(other.getEdgeSettings().range, 9.));
}

TEST_CASE("A file whose model is missing changes nothing", "[config]")
{
  const Folder folder;
  vpMbMultiCueTracker tracker;
  const Json before = saved(tracker);
  const std::string file = folder.write("config.json", R"({"preset": "fast", "model": {"file": "none.obj"}})");
  CHECK_THAT(messageOf([&] { tracker.loadConfigFile(file, false); }),
             ContainsSubstring("config.json") && ContainsSubstring("none.obj"));
  CHECK(saved(tracker) == before);
  CHECK(tracker.getPreset() == vpMultiCuePreset::ROBUST);
  CHECK(tracker.getConfigReport().format == vpConfigReport::Format::NONE);
  CHECK_THAT(messageOf([&] { tracker.saveConfigFile(folder.path("config.xml")); }), ContainsSubstring(".json"));
  CHECK_THAT(messageOf([&] { tracker.saveConfigFile(folder.path("none/config.json")); }),
             ContainsSubstring("cannot be written"));
}

TEST_CASE("The tracker tells what it took of a file of ViSP", "[config]")
{
  const Folder folder;
  vpMbMultiCueTracker tracker;
  tracker.loadConfigFile(
      folder.write("a.xml", "<conf><ecm><mask><size>5</size><nb_mask>180</nb_mask></mask></ecm></conf>"), false);
  const vpConfigReport &report = tracker.getConfigReport();
  CHECK(report.format == vpConfigReport::Format::GENERIC_XML);
  REQUIRE(report.taken.size() == 1);
  CHECK(report.taken[0].setting == "edge.maskSize");
  REQUIRE(report.left.size() == 1);
  CHECK(report.left[0].name == "ecm/mask/nb_mask");
}
