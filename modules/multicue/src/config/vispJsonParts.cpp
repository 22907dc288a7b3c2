// SPDX-License-Identifier: GPL-2.0-or-later
#include "config/vispJsonParts.h"

#include <visp3/core/vpException.h>
#include <visp3/cues/vpEdgeCue.h>

BEGIN_VISP_NAMESPACE
namespace vpSettingsDetail {
namespace {
using Json = VispJsonCarrier::Json;

[[noreturn]] void refuse(const std::string &reason)
{
  throw vpException(vpException::badValue, reason);
}

// ViSP's own name of the model, or the older one with "Proj" in it.
bool isDistorted(const std::string &model)
{
  const bool with = model == "perspectiveWithDistortion" || model == "perspectiveProjWithDistortion";
  if (!with && model != "perspectiveWithoutDistortion" && model != "perspectiveProjWithoutDistortion") {
    refuse("the camera model '" + model +
           "' is not known: perspectiveWithoutDistortion and perspectiveWithDistortion are; undistort the images of "
           "other cameras first");
  }
  return with;
}

void takeThreshold(const std::string &place, const Json &edge, VispJsonCarrier &carrier)
{
  const Json maskSize = edge.value("maskSize", Json(vpEdgeCueSettings().maskSize));
  const Json &threshold = edge.at("threshold");
  constexpr double largestMask = 100.; // Beyond any, and with room in an unsigned int.
  if (!threshold.is_number() || !maskSize.is_number_unsigned() || maskSize.get<double>() > largestMask) {
    refuse("'threshold' and 'maskSize' of the edges are to be numbers");
  }
  const bool inGrayLevels = edge.value("thresholdType", std::string("old")) == "normalized";
  const double contrast = vpEdgeCueSettings::toContrast(
      threshold.get<double>(), inGrayLevels ? vpEdgeCueSettings::CONTRAST : vpEdgeCueSettings::LIKELIHOOD,
      maskSize.get<unsigned int>());
  carrier.takeAs(place + "/threshold", "edge.contrast", contrast, "in gray levels");
  carrier.note(place + "/thresholdType", "edge.contrast", "the scale of the threshold");
}
} // namespace

void takeCamera(const std::string &place, VispJsonCarrier &carrier)
{
  const Json &camera = carrier.objectAt(place);
  if (camera.empty()) {
    return;
  }
  const bool distorted = isDistorted(camera.value("model", std::string("perspectiveWithoutDistortion")));
  for (const std::string name : {"px", "py", "u0", "v0", "kud", "kdu"}) {
    const bool isDistortion = name[0] == 'k';
    if (!camera.contains(name) && (distorted || !isDistortion)) {
      refuse("the camera has no '" + name + "'");
    }
    if (distorted || !isDistortion) {
      carrier.take(place + '/' + name, "camera." + name);
    }
  }
  carrier.leave(place, "a camera without distortion has no such value");
  carrier.note(place + "/model", "camera.px", "it says which of the values there are");
}

void takeEdges(const std::string &place, VispJsonCarrier &carrier)
{
  const Json &edge = carrier.objectAt(place);
  carrier.take(place + "/maskSize", "edge.maskSize");
  carrier.take(place + "/range", "edge.range");
  carrier.take(place + "/sampleStep", "view.sampleStep");
  if (edge.contains("mu")) {
    const Json &mu = edge["mu"];
    if (!mu.is_array() || mu.size() != 2) {
      refuse("'mu' of the edges is to be a list of two numbers");
    }
    carrier.set("edge.mu2", mu[1]);
    carrier.takeAs(place + "/mu", "edge.mu1", mu[0], "and edge.mu2");
  }
  if (edge.contains("threshold")) {
    takeThreshold(place, edge, carrier);
  }
  for (const char *name : {"/nMask", "/angleStep", "/maskSign", "/strip"}) {
    carrier.leave(place + name, "masks are made for each edge's own direction");
  }
  for (const char *name : {"/thresholdMarginRatio", "/minThreshold"}) {
    carrier.leave(place + name, "the threshold adapts itself to the light");
  }
  for (const char *name : {"/minSampleStep", "/ntotalSample", "/pointsToTrack"}) {
    carrier.leave(place + name, "the step between control points tells how many there are");
  }
  carrier.leave(place + "/initRange", "a start looks as far as it has to");
}

void takePoints(const std::string &place, VispJsonCarrier &carrier)
{
  carrier.objectAt(place);
  for (const std::string name :
       {"maxFeatures", "windowSize", "quality", "minDistance", "harris", "blockSize", "pyramidLevels", "maskBorder"}) {
    carrier.take(place + '/' + name, "klt." + name);
  }
  const Json &useHarris = carrier.at(place + "/useHarris"); // ViSP writes a number.
  carrier.takeAs(place + "/useHarris", "klt.useHarris",
                 useHarris.is_number() ? Json(useHarris.get<double>() > 0.) : useHarris);
}
} // namespace vpSettingsDetail
END_VISP_NAMESPACE
