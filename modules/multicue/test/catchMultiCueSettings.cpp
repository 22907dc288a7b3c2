// SPDX-License-Identifier: GPL-2.0-or-later
// Settings in programs and in JSON files.
#include <catchMain.h>

#include "settingsFiles.h"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <limits>
#include <sstream>
#include <vector>

namespace {
using settingsFiles::Folder;
using settingsFiles::messageOf;
using settingsFiles::refusal;
using settingsFiles::unusual;

vpMultiCueSettings readJson(const std::string &text, const vpMultiCueSettings &defaults = vpMultiCueSettings())
{
  return settingsFiles::read("settings.json", text, defaults);
}

std::string refusedJson(const std::string &text)
{
  return refusal("settings.json", text);
}

} // namespace

TEST_CASE("The defaults are within their ranges")
{
  CHECK_NOTHROW(vpMultiCueSettings().check());
  CHECK_NOTHROW(unusual().check());
}

TEST_CASE("check() names the member that is out of range")
{
  vpMultiCueSettings settings;
  settings.klt.quality = std::nan("");
  CHECK_THAT(messageOf([&] { settings.check(); }),
             ContainsSubstring("klt.quality is nan") && ContainsSubstring("(0, 1]"));
  settings = vpMultiCueSettings();
  settings.klt.windowSize = 64;
  CHECK_THAT(messageOf([&] { settings.check(); }),
             ContainsSubstring("klt.windowSize is 64, it must be a whole number in [3, 63] pixels"));
  settings = vpMultiCueSettings();
  settings.minLineLength = -1.;
  CHECK_THAT(messageOf([&] { settings.check(); }), ContainsSubstring("lod.minLineLength"));
  settings = vpMultiCueSettings();
  settings.edge.candidates = 9;
  CHECK_THAT(messageOf([&] { settings.check(); }), ContainsSubstring("edge.candidates is 9"));
  settings = vpMultiCueSettings();
  settings.view.farDistance = settings.view.nearDistance / 2.;
  CHECK_THAT(messageOf([&] { settings.check(); }), ContainsSubstring("farDistance"));
  settings = vpMultiCueSettings();
  settings.view.border = std::numeric_limits<double>::infinity();
  CHECK_THAT(messageOf([&] { settings.check(); }), ContainsSubstring("view.border is inf"));
}

TEST_CASE("A camera that is no perspective projection is refused")
{
  vpMultiCueSettings settings;
  settings.camera.initProjWithKannalaBrandtDistortion(600., 600., 320., 240., {0.1, 0.1, 0.1, 0.1, 0.1});
  CHECK_THAT(messageOf([&] { settings.check(); }), ContainsSubstring("camera"));
}

TEST_CASE("Values come where they belong")
{
  const vpMultiCueSettings settings = readJson(R"({ // a comment
    "edge": {"range": 12.5, "candidates": 2}, /* and another */
    "klt": {"maxFeatures": 200},
    "lod": {"use": true}
  })");
  vpMultiCueSettings expected;
  expected.edge.range = 12.5;
  expected.edge.candidates = 2;
  expected.klt.maxFeatures = 200;
  expected.useLod = true;
  CHECK(settings == expected);
}

TEST_CASE("Cues are a list of names")
{
  CHECK(readJson(R"({"cues": ["edge"]})", unusual()).cues == 1);
  CHECK(readJson(R"({"cues": ["point", "edge"]})").cues == 3);
  CHECK(readJson(R"({"cues": ["edge", "color", "point"]})").cues == 19);
  for (const std::string value : {"[]", R"(["edges"])", R"("edge")", "3", R"([1])", "{}"}) {
    CHECK_THAT(refusedJson("{\"cues\": " + value + "}"),
               ContainsSubstring("settings.json") && ContainsSubstring("cues is " + value + ", it must be a list of") &&
                   ContainsSubstring("edge, color, point"));
  }
  vpMultiCueSettings settings;
  settings.cues = 4;
  CHECK_THAT(messageOf([&] { settings.check(); }), ContainsSubstring("cues is 4"));
}

TEST_CASE("A frame has a deadline")
{
  CHECK(vpIsSame(readJson(R"({"frameDeadline": 33.5})").frameDeadline, 33.5));
  // As older files have it.
  CHECK(vpIsSame(readJson(R"({"search": {"budget": 33.5}})").frameDeadline, 33.5));
  CHECK(vpIsSame(readJson(R"({"searchBudget": 33.5})").frameDeadline, 33.5));
  CHECK(readJson("{}", unusual()).frameDeadline == exactly(unusual().frameDeadline));
  for (const std::string value : {"-1", "10001", R"("33")", "null", "{}"}) {
    CHECK_THAT(refusedJson("{\"frameDeadline\": " + value + "}"), ContainsSubstring("frameDeadline"));
  }
}

TEST_CASE("Every feature is true, false or an object")
{
  const vpMultiCueSettings on = readJson(
      R"({"hypotheses": true, "particles": true, "prediction": true, "search": true, "symmetries": true, "lod": true,
      "edge": true, "klt": true, "color": true})");
  CHECK((on.hypotheses.enabled && on.particles.enabled && on.predicts && on.searches && on.useLod));
  CHECK(on.symmetries == "find");
  CHECK(on.cues == 19);
  const vpMultiCueSettings off = readJson(
      R"({"hypotheses": false, "particles": false, "prediction": false, "search": false, "symmetries": false,
      "lod": false, "edge": true, "klt": false, "color": false})",
      unusual());
  CHECK_FALSE((off.hypotheses.enabled || off.particles.enabled || off.predicts || off.searches || off.useLod));
  CHECK(off.symmetries == "none");
  CHECK(off.cues == 1);
  CHECK(off.particles.number == unusual().particles.number);
  for (const std::string feature :
       {"edge", "klt", "color", "hypotheses", "particles", "prediction", "search", "symmetries", "lod"}) {
    CHECK(readJson("{\"" + feature + "\": {}}", unusual()) == unusual());
    for (const std::string value : {"1", R"("true")", "null", "[true]"}) {
      CHECK_THAT(refusedJson("{\"" + feature + "\": " + value + "}"),
                 ContainsSubstring("settings.json") &&
                     ContainsSubstring("'" + feature + "' is " + value + ", it must be true, false or an object"));
    }
  }
  for (const std::string object : {"camera", "view", "estimation", "model", "display"}) {
    CHECK_THAT(refusedJson("{\"" + object + "\": true}"),
               ContainsSubstring("'" + object + "' is true, it must be an object"));
  }
}

TEST_CASE("A cue is switched by its object, beside a preset's or in place of the list")
{
  CHECK(readJson(R"({"preset": "robust", "color": false})").cues == 3);
  CHECK(readJson(R"({"color": {"enabled": true, "lines": 100}, "preset": "fast"})").cues == 17);
  CHECK(readJson(R"({"point": {"enabled": true, "maxFeatures": 70}})").klt.maxFeatures == 70);
  CHECK(readJson(R"({"cues": ["edge", "color"], "color": true})").cues == 17);
  CHECK_THAT(refusedJson(R"({"cues": ["edge"], "color": true})"),
             ContainsSubstring("'color' is on, but 'cues' has no color"));
  CHECK_THAT(refusedJson(R"({"klt": false, "cues": ["edge", "point"]})"),
             ContainsSubstring("'klt' is off, but 'cues' has point"));
  CHECK_THAT(refusedJson(R"({"edge": false})"), ContainsSubstring("cues is 0"));
}

TEST_CASE("Factors are by cue")
{
  const vpMultiCueSettings settings = readJson(R"({"factors": {"edge": 2, "point": 0.5}})");
  CHECK(vpNumbersOf(settings.factors) == vpNumbers{2., 0.5, 1.});
  for (const std::string value : {R"({"edge":0})", R"({"edges":1})", R"({"edge":1000001})", "2", "[1]"}) {
    CHECK_THAT(refusedJson("{\"factors\": " + value + "}"), ContainsSubstring("factors is " + value));
  }
  vpMultiCueSettings wrong;
  wrong.factors[4] = 1.;
  CHECK_THAT(messageOf([&] { wrong.check(); }), ContainsSubstring("factors has one of cue 4"));
  wrong = vpMultiCueSettings();
  wrong.estimation.motions = {1, 1};
  CHECK_THAT(messageOf([&] { wrong.check(); }), ContainsSubstring("motions has 2 values"));
}

TEST_CASE("Levels of the colours fall")
{
  CHECK_THAT(refusedJson(R"({"color": {"bands": [1, 2]}})"),
             ContainsSubstring("settings.json") && ContainsSubstring("bands is 2"));
  CHECK_THAT(refusedJson(R"({"color": {"bands": []}})"), ContainsSubstring("bands"));
}

TEST_CASE("What the JSON file does not say keeps its default")
{
  CHECK(readJson("{}", unusual()) == unusual());
  vpMultiCueSettings expected = unusual();
  expected.view.border = 3.;
  CHECK(readJson(R"({"view": {"border": 3}, "lod": {}})", unusual()) == expected);
}

TEST_CASE("A camera in the file has the distortion that the file says")
{
  vpCameraParameters camera;
  const vpCameraParameters before = unusual().camera;
  camera.initPersProjWithoutDistortion(700., before.get_py(), before.get_u0(), before.get_v0());
  CHECK(sameCamera(readJson(R"({"camera": {"px": 700}})", unusual()).camera, camera));
  camera.initPersProjWithDistortion(600., 600., 1., 2., -0.2, 0.);
  CHECK(sameCamera(readJson(R"({"camera": {"px": 600, "py": 600, "u0": 1, "v0": 2, "kud": -0.2}})").camera, camera));
}

TEST_CASE("What was written is read again to the last digit, whatever the defaults")
{
  const Folder folder;
  const std::string file = folder.path("settings.json");
  vpMultiCueSettings withZeroDistortion;
  withZeroDistortion.camera.initPersProjWithDistortion(600., 600., 320., 240., 0., 0.);
  for (const vpMultiCueSettings &settings : {vpMultiCueSettings(), unusual(), withZeroDistortion}) {
    vpMultiCueSettingsReader::write(file, settings);
    CHECK(vpMultiCueSettingsReader::read(file, vpMultiCueSettings()) == settings);
    CHECK(vpMultiCueSettingsReader::read(file, unusual()) == settings);
  }
}

TEST_CASE("What is not known is named, with what is")
{
  CHECK_THAT(refusedJson(R"({"edges": {}})"),
             ContainsSubstring("settings.json") && ContainsSubstring("'edges'") &&
                 ContainsSubstring("the nearest is 'edge'") &&
                 ContainsSubstring(
                     "preset, cues, camera, edge, hypotheses, particles, view, klt, color, prediction, frameDeadline, "
                     "search, symmetries, lod, factors, estimation, model, display, renderer, "
                     "throwOnLoss"));
  CHECK_THAT(refusedJson(R"({"edge": {"Range": 3}})"),
             ContainsSubstring("'Range' is not known in 'edge'") && ContainsSubstring("the nearest is 'range'") &&
                 ContainsSubstring("range, contrast, mu1, mu2, maskSize, candidates"));
  CHECK_THAT(refusedJson(R"({"prediction": {"frameIntervall": 1}})"), ContainsSubstring("nearest is 'frameInterval'"));
  CHECK_THAT(refusedJson(R"({"paritcles": true})"), ContainsSubstring("the nearest is 'particles'"));
  CHECK_THAT(refusedJson(R"({"klt": {"maskSize": 5}})"), ContainsSubstring("it belongs to 'edge'"));
  CHECK_THAT(refusedJson(R"({"preset": "robus"})"), ContainsSubstring("the nearest is 'robust'"));
  CHECK_THAT(refusedJson(R"({"particles": {"noiseFrame": "objects"}})"), ContainsSubstring("the nearest is 'object'"));
  const std::string endless(100000, 'x');
  CHECK_THAT(refusedJson("{\"" + endless + "\": 1}"), ContainsSubstring("is not known as an object"));
  CHECK_THAT(refusedJson(R"({"edge": 3})"), ContainsSubstring("'edge' is 3, it must be true, false or an object"));
  CHECK_THAT(refusedJson("[]"), ContainsSubstring("must be an object"));
}

TEST_CASE("A file that is no JSON is refused with the line")
{
  CHECK_THAT(refusedJson("{\n\"edge\": {\"range\": }\n}"),
             ContainsSubstring("settings.json") && ContainsSubstring("line 2"));
  CHECK_THAT(refusedJson(""), ContainsSubstring("no JSON"));
  CHECK_THAT(refusedJson("{} {}"), ContainsSubstring("no JSON"));
}

TEST_CASE("Members that do not fit each other are refused with the file")
{
  CHECK_THAT(refusedJson(R"({"view": {"appearAngle": 80, "disappearAngle": 70}})"),
             ContainsSubstring("settings.json") && ContainsSubstring("disappearAngle is 70"));
}

TEST_CASE("A missing file, a folder and a folder that is not there are named")
{
  const Folder folder;
  const auto reading = [&](const std::string &name) {
    return messageOf([&] { vpMultiCueSettingsReader::read(folder.path(name), vpMultiCueSettings()); });
  };
  CHECK_THAT(reading("missing.json"),
             ContainsSubstring(folder.path("missing.json")) && ContainsSubstring("does not exist"));
  CHECK_THAT(reading("missing.xml"),
             ContainsSubstring(folder.path("missing.xml")) && ContainsSubstring("does not exist"));
  CHECK_THAT(reading(""), ContainsSubstring("cannot be read"));
  const std::string unreachable = folder.path("none/settings.json");
  CHECK_THAT(messageOf([&] { vpMultiCueSettingsReader::write(unreachable, vpMultiCueSettings()); }),
             ContainsSubstring(unreachable) && ContainsSubstring("cannot be written"));
}

TEST_CASE("Settings that are out of range, and names that read() takes for XML, leave no file behind")
{
  const Folder folder;
  vpMultiCueSettings settings;
  settings.edge.mu2 = -1.;
  CHECK_THAT(messageOf([&] { vpMultiCueSettingsReader::write(folder.path("a.json"), settings); }),
             ContainsSubstring("mu2"));
  CHECK_FALSE(std::filesystem::exists(folder.path("a.json")));
  CHECK_THAT(messageOf([&] { vpMultiCueSettingsReader::write(folder.path("a.xml"), unusual()); }),
             ContainsSubstring(".json"));
  CHECK_FALSE(std::filesystem::exists(folder.path("a.xml")));
}

TEST_CASE("Nothing is printed unless asked for")
{
  const Folder folder;
  const std::string json = folder.write("a.JSON", R"({"edge": {"range": 33}})");
  const std::string xml = folder.write("a.xml", "<conf><ecm><range><tracking>33</tracking></range></ecm></conf>");
  for (const std::string &file : {json, xml}) {
    std::ostringstream captured;
    std::streambuf *before = std::cout.rdbuf(captured.rdbuf());
    vpMultiCueSettingsReader::read(file, vpMultiCueSettings());
    const std::string silent = captured.str();
    vpMultiCueSettingsReader::read(file, vpMultiCueSettings(), true);
    std::cout.rdbuf(before);
    CHECK(silent == "");
    CHECK_THAT(captured.str(), ContainsSubstring(file) && ContainsSubstring("\"range\": 33"));
  }
}
