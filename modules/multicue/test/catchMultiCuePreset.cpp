// SPDX-License-Identifier: GPL-2.0-or-later
// Presets: their names and settings, in programs and in files.
#include <catchMain.h>

#include "renderedBox.h"
#include "settingsFiles.h"

#include <visp3/cues/vpPointCue.h>
#include <visp3/multicue/vpMbMultiCueTracker.h>

#include <algorithm>
#include <vector>

namespace {
using settingsFiles::Folder;
using settingsFiles::messageOf;
using settingsFiles::unusual;
using Preset = vpMbMultiCueTracker::Preset;

constexpr int edge = vpMbMultiCueTracker::EDGE_TRACKER;
constexpr int color = vpMbMultiCueTracker::COLOR_TRACKER;
const int all = edge | color | (vpPointCue::isAvailable() ? vpMbMultiCueTracker::KLT_TRACKER : 0);

const std::vector<std::pair<Preset, std::string>> names = {{Preset::ROBUST, "robust"},
                                                           {Preset::FAST, "fast"},
                                                           {Preset::STATIC, "static"},
                                                           {Preset::TEULIERE2010, "teuliere2010"},
                                                           {Preset::PETIT2014, "petit2014"}};

vpMultiCueSettings settingsOf(Preset preset, const vpMultiCueSettings &before = vpMultiCueSettings())
{
  vpMultiCueSettings settings = before;
  settings.setPreset(preset);
  return settings;
}

void load(vpMbMultiCueTracker &tracker, const std::string &name, const std::string &text)
{
  const Folder folder;
  tracker.loadConfigFile(folder.write(name, text), false);
}

vpMultiCueSettings readJson(const std::string &text, const vpMultiCueSettings &defaults = vpMultiCueSettings())
{
  return settingsFiles::read("settings.json", text, defaults);
}

std::vector<vpHomogeneousMatrix> follow(vpMbMultiCueTracker &tracker)
{
  renderedBox box;
  tracker.setCameraParameters(renderedBox::camera());
  tracker.loadModel(renderedBox::writeCao(meshFiles::temporaryFile("preset-box.cao")));
  const auto poseAt = [](int i) {
    return renderedBox::pose() * vpHomogeneousMatrix(0.002 * i, 0., 0.001 * i, 0., 0.01 * i, 0.);
  };
  tracker.initFromPose(box.draw(poseAt(0)), poseAt(0));
  std::vector<vpHomogeneousMatrix> poses;
  for (int i = 1; i < 8; ++i) {
    tracker.track(box.draw(poseAt(i)));
    poses.push_back(tracker.getPose());
    CHECK(tracker.getTrackingState() == vpTrackingState::TRACKING);
    CHECK((poses.back().getTranslationVector() - poseAt(i).getTranslationVector()).frobeniusNorm() < 0.003);
  }
  return poses;
}

// Whatever a tracker does not tell of its settings shows in what it does.
void checkSame(vpMbMultiCueTracker &a, vpMbMultiCueTracker &b)
{
  CHECK(a.getTrackerType() == b.getTrackerType());
  CHECK(a.getFrameDeadline() == exactly(b.getFrameDeadline()));
  const std::vector<vpHomogeneousMatrix> posesOfA = follow(a);
  const std::vector<vpHomogeneousMatrix> posesOfB = follow(b);
  for (std::size_t i = 0; i < posesOfA.size(); ++i) {
    CHECK(std::equal(posesOfA[i].data, posesOfA[i].data + 16, posesOfB[i].data));
  }
}
} // namespace

TEST_CASE("Names of presets are read as they are written", "[preset]")
{
  std::vector<std::string> known;
  for (const auto &[preset, name] : names) {
    CHECK(toString(preset) == name);
    CHECK(vpMultiCuePresetFromString(name) == preset);
    known.push_back(name);
  }
  CHECK(vpMultiCuePresetNames() == known);
}

TEST_CASE("An unknown preset is refused with the names of the known ones", "[preset]")
{
  for (const std::string name : {"quick", "Robust", "", "robust "}) {
    CHECK_THAT(messageOf([&] { vpMultiCuePresetFromString(name); }),
               ContainsSubstring("'" + name + "' is not known") &&
                   ContainsSubstring("robust, fast, static, teuliere2010, petit2014"));
  }
  CHECK_THAT(messageOf([] { vpMultiCueSettings().setPreset(static_cast<Preset>(7)); }), ContainsSubstring("7"));
}

TEST_CASE("Each preset has its settings", "[preset]")
{
  vpMultiCueSettings expected;
  expected.frameDeadline = 33.;
  CHECK(settingsOf(Preset::FAST) == expected);

  expected.frameDeadline = 0.;
  expected.cues = all;
  expected.predicts = true;
  CHECK(settingsOf(Preset::PETIT2014) == expected);

  expected.searches = true;
  expected.frameDeadline = 33.;
  CHECK(settingsOf(Preset::ROBUST) == expected);
  CHECK(settingsOf(Preset::STATIC).cues == all);
  CHECK(settingsOf(Preset::STATIC).predicts);
  CHECK(settingsOf(Preset::STATIC).searches);

  expected = vpMultiCueSettings();
  expected.edge.candidates = 5;
  expected.hypotheses.enabled = true;
  expected.particles.enabled = true;
  expected.searches = true;
  CHECK(settingsOf(Preset::TEULIERE2010) == expected);
  for (const auto &[preset, name] : names) {
    CHECK_NOTHROW(settingsOf(preset).check());
  }
}

TEST_CASE("A preset leaves camera, moving edges, model, clipping and the rest as they are", "[preset]")
{
  for (const auto &[preset, name] : names) {
    INFO(name);
    vpMultiCueSettings expected = unusual();
    const vpMultiCueSettings fresh = settingsOf(preset);
    expected.cues = fresh.cues;
    expected.edge.candidates = fresh.edge.candidates;
    expected.hypotheses = fresh.hypotheses;
    expected.particles = fresh.particles;
    expected.color = fresh.color;
    expected.predicts = fresh.predicts;
    expected.prediction = fresh.prediction;
    expected.predictsRange = false;
    expected.searches = fresh.searches;
    expected.frameDeadline = fresh.frameDeadline;
    CHECK(settingsOf(preset, unusual()) == expected);
  }
}

TEST_CASE("Keys of a file override its preset, before and after it", "[preset]")
{
  vpMultiCueSettings expected = settingsOf(Preset::TEULIERE2010, unusual());
  expected.cues = edge | color;
  expected.edge.candidates = 2;
  expected.edge.range = 9.;
  expected.particles.number = 50;
  expected.searches = false;
  const std::string preset = R"("preset": "teuliere2010")";
  const std::string keys =
      R"("cues": ["color", "edge"], "edge": {"candidates": 2, "range": 9}, "particles": {"number": 50}, "search": false)";
  CHECK(readJson("{" + preset + ", " + keys + "}", unusual()) == expected);
  CHECK(readJson("{" + keys + ", " + preset + "}", unusual()) == expected);
  for (const auto &[known, name] : names) {
    CHECK(readJson("{\"preset\": \"" + name + "\"}") == settingsOf(known));
  }
}

TEST_CASE("A file with an unknown preset is refused and changes nothing", "[preset]")
{
  vpMbMultiCueTracker tracker;
  for (const std::string value : {R"("quick")", "3", "null", R"(["fast"])", "{}"}) {
    const std::string message = messageOf([&] { load(tracker, "settings.json", "{\"preset\": " + value + "}"); });
    CHECK_THAT(message, ContainsSubstring("settings.json") && ContainsSubstring("preset is " + value) &&
                            ContainsSubstring("one of robust, fast, static, teuliere2010, petit2014"));
  }
  CHECK(tracker.getPreset() == Preset::ROBUST);
  CHECK(tracker.getTrackerType() == all);
}

TEST_CASE("A tracker is robust by default, also with gray images", "[preset]")
{
  vpMbMultiCueTracker tracker;
  CHECK(tracker.getPreset() == Preset::ROBUST);
  CHECK(tracker.getTrackerType() == all);
  CHECK(tracker.getFrameDeadline() == exactly(33.));
  CHECK(tracker.getColorSettings() == vpColorCueSettings());
  CHECK_FALSE(tracker.getParticleSettings().enabled);
  follow(tracker);
  CHECK(tracker.getNbFeaturesEdge() > 0);
  CHECK(tracker.getNbFeaturesColor() > 0);
  tracker.setParticleSettings(unusual().particles);
  tracker.resetTracker();
  CHECK(tracker.getPreset() == Preset::ROBUST);
  CHECK(tracker.getTrackerType() == all);
  CHECK(tracker.getFrameDeadline() == exactly(33.));
  CHECK(tracker.getParticleSettings().enabled); // Settings stay.
  CHECK_NOTHROW(follow(tracker));
}

TEST_CASE("A preset in a program has the settings that it has in a file", "[preset]")
{
  for (const auto &[preset, name] : names) {
    INFO(name);
    vpMbMultiCueTracker tracker, configured(1, edge);
    vpEdgeCueSettings edges = tracker.getEdgeSettings();
    edges.range = 9.;
    edges.maskSize = 7;
    tracker.setEdgeSettings(edges);
    configured.setEdgeSettings(edges);
    tracker.setPreset(preset);
    load(configured, "settings.json", "{\"preset\": \"" + name + "\"}");
    for (const vpMbMultiCueTracker *one : {&tracker, &configured}) {
      const vpMultiCueSettings expected = settingsOf(preset);
      CHECK(one->getPreset() == preset);
      CHECK(one->getTrackerType() == expected.cues);
      edges.candidates = expected.edge.candidates;
      CHECK(one->getEdgeSettings() == edges);
      CHECK(one->getPoseHypothesisSettings() == expected.hypotheses);
      CHECK(one->getParticleSettings() == expected.particles);
      CHECK(one->getColorSettings() == expected.color);
      CHECK(one->getFrameDeadline() == exactly(expected.frameDeadline));
    }
    follow(tracker);
  }
}

TEST_CASE("Cues of a new tracker's own are those alone", "[preset]")
{
  vpMbMultiCueTracker chosen, given(1, edge | color);
  chosen.setTrackerType(edge | color);
  CHECK_FALSE(chosen.getPreset());
  CHECK_FALSE(given.getPreset());
  checkSame(chosen, given);
  vpMbMultiCueTracker configured, other(1, edge | color);
  load(configured, "settings.json", R"({"cues": ["edge", "color"]})");
  CHECK_FALSE(configured.getPreset());
  checkSame(configured, other);
  configured.resetTracker();
  CHECK(configured.getTrackerType() == (edge | color));
  CHECK(configured.getFrameDeadline() == exactly(0.));
}

TEST_CASE("What was asked for stays when a new tracker gets its cues", "[preset]")
{
  vpMbMultiCueTracker tracker;
  tracker.setFrameDeadline(40.);
  tracker.setTrackerType(edge);
  CHECK(tracker.getFrameDeadline() == exactly(40.));
  vpMbMultiCueTracker configured;
  load(configured, "settings.json", R"({"frameDeadline": 33, "search": true, "prediction": {"enabled": true}})");
  CHECK(configured.getPreset() == Preset::ROBUST);
  configured.setTrackerType(edge | color);
  CHECK(configured.getFrameDeadline() == exactly(33.));
  vpMbMultiCueTracker given(1, edge | color);
  given.setPrediction(true);
  given.setSearch(true);
  given.setFrameDeadline(33.);
  checkSame(configured, given);
}

TEST_CASE("Cues after a preset that was asked for change nothing else", "[preset]")
{
  vpMbMultiCueTracker tracker;
  tracker.setPreset(Preset::ROBUST);
  tracker.setTrackerType(edge);
  CHECK_FALSE(tracker.getPreset());
  CHECK(tracker.getTrackerType() == edge);
  CHECK(tracker.getFrameDeadline() == exactly(33.));
  tracker.setPreset(Preset::TEULIERE2010);
  tracker.setTrackerType(edge | color);
  CHECK(tracker.getPoseHypothesisSettings().enabled);
  CHECK(tracker.getParticleSettings().enabled);
  CHECK(tracker.getEdgeSettings().candidates == 5);
}

TEST_CASE("ViSP's files leave preset and cues as they are", "[preset]")
{
  const std::string xml = "<conf><ecm><range><tracking>9</tracking></range></ecm>"
                          "<klt><max_features>300</max_features></klt></conf>";
  vpMbMultiCueTracker tracker;
  load(tracker, "settings.xml", xml);
  CHECK(tracker.getPreset() == Preset::ROBUST);
  CHECK(tracker.getTrackerType() == all);
  CHECK(tracker.getFrameDeadline() == exactly(33.));
  CHECK(tracker.getEdgeSettings().range == exactly(9.));
  tracker.setTrackerType(edge);
  CHECK(tracker.getFrameDeadline() == exactly(0.));
  load(tracker, "settings.xml", xml);
  CHECK(tracker.getTrackerType() == edge);
  tracker.setPreset(Preset::TEULIERE2010);
  load(tracker, "settings.xml", xml);
  CHECK(tracker.getPreset() == Preset::TEULIERE2010);
  CHECK(tracker.getEdgeSettings().candidates == 5);
}

TEST_CASE("Presets may be changed between frames", "[preset]")
{
  renderedBox box;
  vpMbMultiCueTracker tracker;
  tracker.setCameraParameters(renderedBox::camera());
  tracker.loadModel(renderedBox::writeCao(meshFiles::temporaryFile("changing-box.cao")));
  const vpImage<unsigned char> I = box.draw(renderedBox::pose());
  tracker.initFromPose(I, renderedBox::pose());
  for (int round = 0; round < 2; ++round) {
    for (const auto &[preset, name] : names) {
      INFO(name);
      tracker.setPreset(preset);
      for (int i = 0; i < 2; ++i) {
        tracker.track(I);
        CHECK(tracker.getTrackingState() == vpTrackingState::TRACKING);
      }
    }
  }
}
