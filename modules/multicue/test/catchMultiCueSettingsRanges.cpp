// SPDX-License-Identifier: GPL-2.0-or-later
// The range of every key of a JSON file.
#include <catchMain.h>

#include "settingsFiles.h"

#include <algorithm>
#include <vector>

namespace {
using settingsFiles::Folder;
using settingsFiles::unusual;

std::string refusedJson(const std::string &text)
{
  return settingsFiles::refusal("settings.json", text);
}

std::string withValue(const std::string &object, const std::string &key, const std::string &value)
{
  return "{\"" + object + "\": " + (key.empty() ? value : "{\"" + key + "\": " + value + "}") + "}";
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
    {"edge", "enabled", {"true"}, {"1", "\"on\"", "null"}},
    {"edge", "goodRatio", {"0", "1"}, {"-0.01", "1.01"}},
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
    {"klt", "enabled", {"true", "false"}, {"1"}},
    {"klt", "useHarris", {"true", "false"}, {"1"}},
    {"klt", "leastWeight", {"0", "0.999"}, {"-0.01", "1"}},
    {"klt", "maxFeatures", {"1", "100000"}, {"0", "100001", "4294967297", "1.0"}},
    {"klt", "windowSize", {"3", "63"}, {"2", "64"}},
    {"klt", "quality", {"1e-9", "1"}, {"0", "1.01"}},
    {"klt", "minDistance", {"0", "1000"}, {"-1", "1001"}},
    {"klt", "harris", {"0", "1"}, {"-0.01", "1.01"}},
    {"klt", "blockSize", {"1", "63"}, {"0", "64"}},
    {"klt", "pyramidLevels", {"1", "10"}, {"0", "11"}},
    {"klt", "maskBorder", {"0", "100"}, {"-1", "101"}},
    {"color", "enabled", {"true", "false"}, {"1"}},
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
    {"prediction", "range", {"true", "false"}, {"1"}},
    {"search", "enabled", {"true", "false"}, {"1"}},
    {"frameDeadline", "", {"0", "10000"}, {"-0.1", "10000.1"}},
    {"symmetries", "from", {"\"none\"", "\"find\"", "\"models_info.json\"", "\"\""}, {"3", "true"}},
    {"symmetries", "object", {"0", "4294967295"}, {"-1", "4294967296", "1.0"}},
    {"lod", "enabled", {"true", "false"}, {"0"}},
    {"lod", "minLineLength", {"0", "50"}, {"-1"}},
    {"lod", "minPolygonArea", {"0", "50"}, {"-1"}},
    {"estimation", "method", {"\"gauss newton\"", "\"levenberg marquardt\""}, {"\"newton\"", "0"}},
    {"estimation", "gain", {"1e-9", "10"}, {"0", "10.1"}},
    {"estimation", "maxIterations", {"1", "10000"}, {"0", "10001", "1.5"}},
    {"estimation", "initialMu", {"0", "1e9"}, {"-1"}},
    {"estimation", "convergence", {"0", "1"}, {"-1"}},
    {"estimation", "covariance", {"true", "false"}, {"1"}},
    {"estimation", "projectionError", {"true", "false"}, {"1"}},
    {"estimation", "motions", {"[0,0,0,0,0,0]", "[1,1,1,1,1,1]"}, {"[2,1,1,1,1,1]", "[true]", "1"}},
    {"model", "file", {"\"box.obj\"", "\"\""}, {"3", "true"}},
    {"model", "unit", {"1e-9", "1000"}, {"0", "-1"}},
    {"model", "creaseAngle", {"1e-9", "179.999"}, {"0", "180"}},
    {"model", "weldTolerance", {"0", "0.01"}, {"-1.0", "0.011"}},
    {"model", "minSize", {"1e-9", "1"}, {"0"}},
    {"model", "maxSize", {"0.1", "1e9"}, {"0"}},
    {"display", "features", {"true", "false"}, {"1"}},
    {"display", "hypotheses", {"true", "false"}, {"1"}},
    {"display", "particles", {"true", "false"}, {"1"}},
};
} // namespace

TEST_CASE("Every key takes the values of its range, and no others")
{
  for (const Case &one : cases) {
    const std::string name = one.key.empty() ? one.object : one.object + '.' + one.key;
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
  // The cues are said by their list. Fourteen objects, cues, renderer, throwOnLoss, and the three keys of the factors.
  CHECK(colons == cases.size() - 3 + 14 + 3 + 1 + 3);
}
