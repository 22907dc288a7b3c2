// SPDX-License-Identifier: GPL-2.0-or-later
// Settings: their ranges, and JSON.
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

std::string withValue(const std::string &object, const std::string &key, const std::string &value)
{
  return "{\"" + object + "\": {\"" + key + "\": " + value + "}}";
}

struct Case
{
  std::string object, key;
  std::vector<std::string> accepted, refused;
};

// Both ends of every range, and a step beyond them.
const std::vector<Case> cases = {
    {"camera", "px", {"0.1", "1e6"}, {"0", "-1"}},
    {"camera", "py", {"0.1", "1e6"}, {"0", "-1"}},
    {"camera", "u0", {"-10", "1e6"}, {"\"a\""}},
    {"camera", "v0", {"-10", "1e6"}, {"true"}},
    {"camera", "kud", {"-0.1", "0"}, {"null"}},
    {"camera", "kdu", {"-0.1", "0"}, {"[0]"}},
    {"edge", "range", {"1", "100", "7.5"}, {"0.99", "100.01", "1e999"}},
    {"edge", "contrast", {"1e-9", "255"}, {"0", "255.01"}},
    {"edge", "mu1", {"0", "1"}, {"-0.01", "1.01"}},
    {"edge", "mu2", {"0", "1e9"}, {"-0.01"}},
    {"edge", "maskSize", {"3", "15"}, {"2", "16", "5.0", "-5", "4294967299"}},
    {"edge", "candidates", {"1", "8"}, {"0", "9", "1.5"}},
    {"hypotheses", "enabled", {"true", "false"}, {"1"}},
    {"hypotheses", "lambda", {"0", "100"}, {"-0.01", "100.01"}},
    {"hypotheses", "draws", {"1", "10000"}, {"0", "10001", "4294967297", "1.0"}},
    {"hypotheses", "minimisations", {"1", "1000"}, {"0", "1001", "2.5"}},
    {"hypotheses", "mergeTolerance", {"1e-9", "100"}, {"0", "100.01"}},
    {"hypotheses", "reach", {"1", "10"}, {"0.99", "10.01"}},
    {"hypotheses", "seed", {"0", "4294967295"}, {"-1", "4294967296", "1.0"}},
    {"particles", "enabled", {"true", "false"}, {"1"}},
    {"particles", "number", {"10", "10000"}, {"9", "10001", "10.0"}},
    {"particles", "leastNumber", {"10", "300"}, {"9", "10001"}},
    {"particles", "mostNumber", {"50", "10000"}, {"9", "10001"}},
    {"particles", "budget", {"0", "1000"}, {"-0.1", "1000.1"}},
    {"particles", "translationNoise", {"1e-9", "1"}, {"0", "1.01"}},
    {"particles", "rotationNoise", {"1e-9", "1"}, {"0", "1.01"}},
    {"particles", "motionNoise", {"0", "10"}, {"-0.1", "10.1"}},
    {"particles", "jumpShare", {"0", "0.9"}, {"-0.1", "0.91"}},
    {"particles", "jumpFactor", {"1", "100"}, {"0.99", "100.1"}},
    {"particles", "noiseFrame", {"\"object\"", "\"camera\""}, {"\"world\"", "0"}},
    {"particles", "motion", {"\"random walk\"", "\"velocity\""}, {"\"still\"", "1"}},
    {"particles", "lambda", {"0", "1000"}, {"-0.1", "1000.1"}},
    {"particles", "sharpness", {"0", "1000"}, {"-0.1", "1000.1"}},
    {"particles", "bestShare", {"0", "1"}, {"-0.01", "1.01"}},
    {"particles", "mostOptimised", {"0", "100"}, {"-1", "101", "1.5"}},
    {"particles", "output", {"\"mean\"", "\"best mode\""}, {"\"mode\"", "2"}},
    {"particles", "modeTranslation", {"1e-9", "10"}, {"0", "10.1"}},
    {"particles", "modeRotation", {"1e-9", "3"}, {"0", "3.1"}},
    {"particles", "seed", {"0", "4294967295"}, {"-1", "4294967296", "1.0"}},
    {"view", "sampleStep", {"0.5", "100"}, {"0.49"}},
    {"view", "appearAngle", {"1e-9", "89"}, {"0", "90.01"}},
    {"view", "disappearAngle", {"89", "90"}, {"0", "90.01"}},
    {"view", "nearDistance", {"1e-9", "10"}, {"0", "-1"}},
    {"view", "farDistance", {"0", "10"}, {"-1"}},
    {"view", "border", {"0", "50"}, {"-1"}},
    {"view", "visibilitySize", {"16", "4294967295"}, {"15", "4294967296", "1000.0", "-16"}},
    {"view", "textureEdges", {"true", "false"}, {"1", "\"true\""}},
    {"view", "clipToImage", {"true", "false"}, {"1", "\"true\""}},
    {"klt", "maxFeatures", {"1", "100000"}, {"0", "100001", "4294967297", "1.0"}},
    {"klt", "windowSize", {"3", "63"}, {"2", "64"}},
    {"klt", "quality", {"1e-9", "1"}, {"0", "1.01"}},
    {"klt", "minDistance", {"0", "1000"}, {"-1", "1001"}},
    {"klt", "harris", {"0", "1"}, {"-0.01", "1.01"}},
    {"klt", "blockSize", {"1", "63"}, {"0", "64"}},
    {"klt", "pyramidLevels", {"1", "10"}, {"0", "11"}},
    {"klt", "maskBorder", {"0", "100"}, {"-1", "101"}},
    {"color", "spacing", {"1", "100"}, {"0.99", "100.01"}},
    {"color", "lines", {"10", "5000"}, {"9", "5001", "10.0"}},
    {"color", "scales", {"[]", "[20,1]"}, {"[0]", "[21,1]", "3", "[1.5]", "[\"a\"]"}},
    {"color", "bands", {"[20,0.5]", "[1]"}, {"[0.49]", "[20.01]", "1.5"}},
    {"color", "length", {"3", "60"}, {"2.99", "60.01"}},
    {"color", "alpha", {"1e-9", "1"}, {"0", "1.01"}},
    {"color", "regularisation", {"1", "100"}, {"0.99", "100.01"}},
    {"color", "contourDeviation", {"0.05", "5"}, {"0.049", "5.01"}},
    {"color", "histogramLength", {"3", "60"}, {"2.99", "60.01"}},
    {"color", "learningRate", {"0", "1"}, {"-0.01", "1.01"}},
    {"color", "rows", {"\"lines\"", "\"pixels\""}, {"\"columns\"", "0"}},
    {"prediction", "enabled", {"true", "false"}, {"1"}},
    {"prediction", "frameInterval", {"1e-9", "10"}, {"0", "-1"}},
    {"prediction", "translationWander", {"1e-9", "10"}, {"0", "-1"}},
    {"prediction", "rotationWander", {"1e-9", "10"}, {"0", "-1"}},
    {"prediction", "startTranslation", {"1e-9", "10"}, {"0", "-1"}},
    {"prediction", "startRotation", {"1e-9", "10"}, {"0", "-1"}},
    {"prediction", "longestGap", {"1e-9", "10"}, {"0", "-1"}},
    {"prediction", "smooth", {"true", "false"}, {"\"yes\""}},
    {"symmetries", "from", {"\"none\"", "\"find\"", "\"models_info.json\"", "\"\""}, {"3", "true"}},
    {"symmetries", "object", {"0", "4294967295"}, {"-1", "4294967296", "1.0"}},
    {"lod", "use", {"true", "false"}, {"0"}},
    {"lod", "minLineLength", {"0", "50"}, {"-1"}},
    {"lod", "minPolygonArea", {"0", "50"}, {"-1"}},
};
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

TEST_CASE("Every key takes the values of its range, and no others")
{
  for (const Case &one : cases) {
    const std::string name = one.object + '.' + one.key;
    for (const std::string &value : one.accepted) {
      INFO(name << " = " << value);
      CHECK(refusedJson(withValue(one.object, one.key, value)) == "");
    }
    for (const std::string &value : one.refused) {
      INFO(name << " = " << value);
      const std::string message = refusedJson(withValue(one.object, one.key, value));
      CHECK_THAT(message, ContainsSubstring("settings.json"));
      if (value != "1e999") { // No JSON: it has no such number.
        CHECK_THAT(message, ContainsSubstring(name + " is " + value) && ContainsSubstring("it must be "));
      }
    }
  }
}

TEST_CASE("The cases above are all keys that there are")
{
  const Folder folder;
  vpMultiCueSettingsReader::write(folder.path("all.json"), unusual());
  const std::string text = settingsFiles::textOf(folder.path("all.json"));
  const auto colons = static_cast<std::size_t>(std::count(text.begin(), text.end(), ':'));
  CHECK(colons == cases.size() + 10 + 3); // Ten objects, the cues, the search and its budget.
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

TEST_CASE("The search has a budget")
{
  CHECK(readJson(R"({"searchBudget": 33.5})").searchBudget == 33.5);
  CHECK(readJson("{}", unusual()).searchBudget == unusual().searchBudget);
  for (const std::string value : {"-1", "10001", R"("33")", "null", "{}"}) {
    CHECK_THAT(refusedJson("{\"searchBudget\": " + value + "}"), ContainsSubstring("searchBudget"));
  }
}

TEST_CASE("The search is on or off")
{
  CHECK(readJson(R"({"search": true})").searches);
  CHECK_FALSE(readJson(R"({"search": false})", unusual()).searches);
  CHECK_FALSE(readJson("{}").searches);
  for (const std::string value : {"1", R"("true")", "null", "{}", "[true]"}) {
    CHECK_THAT(refusedJson("{\"search\": " + value + "}"),
               ContainsSubstring("settings.json") &&
                   ContainsSubstring("search is " + value + ", it must be true or false"));
  }
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
                 ContainsSubstring("cues, camera, edge, hypotheses, particles, view, klt, color, prediction, search, "
                                   "searchBudget, symmetries, lod"));
  CHECK_THAT(refusedJson(R"({"edge": {"Range": 3}})"),
             ContainsSubstring("'Range' is not known in 'edge'") &&
                 ContainsSubstring("range, contrast, mu1, mu2, maskSize, candidates"));
  CHECK_THAT(refusedJson(R"({"edge": 3})"), ContainsSubstring("'edge' is 3, it must be an object"));
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
