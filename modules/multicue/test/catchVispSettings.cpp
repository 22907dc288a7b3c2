// SPDX-License-Identifier: GPL-2.0-or-later
#include <catchMain.h>

#include "settingsFiles.h"

#include <algorithm>
#include <sstream>

// Configurations and cameras that ViSP's own trackers and programs write.

namespace {
const std::string camera = "<camera><width>640</width><height>480</height><u0>320</u0><v0>240</v0><px>600</px>"
                           "<py>601</py></camera>";

using settingsFiles::read;

std::string calibration(const std::string &models, const std::string &name = "cam")
{
  return "<camera><name>" + name + "</name><image_width>640</image_width><image_height>480</image_height>" + models +
         "<additional_information><date>today</date></additional_information></camera>";
}

const std::string plain = "<model><type>perspectiveProjWithoutDistortion</type><px>557</px><py>561</py><u0>360</u0>"
                          "<v0>235.5</v0></model>";
const std::string distorted = "<model><type>perspectiveProjWithDistortion</type><px>537</px><py>537.5</py><u0>344</u0>"
                              "<v0>235</v0><kud>-0.267</kud><kdu>0.308</kdu></model>";

// \param tracker Members of the one tracker.
std::string generic(const std::string &tracker)
{
  return R"({"referenceCameraName": "Color", "trackers": {"Color": {)" + tracker + R"(}}, "version": "1.0"})";
}

vpConfigReport reportOf(const std::string &name, const std::string &content)
{
  const settingsFiles::Folder folder;
  vpConfigReport report;
  vpMultiCueSettingsReader::read(folder.write(name, content), vpMultiCueSettings(), report);
  return report;
}

// "name as setting" of what was taken, "name" of what was left.
std::vector<std::string> namesOf(const std::vector<vpConfigReport::Item> &items)
{
  std::vector<std::string> names;
  for (const vpConfigReport::Item &item : items) {
    CHECK((!item.setting.empty() || !item.reason.empty()));
    names.push_back(item.name + (item.setting.empty() ? "" : " as " + item.setting));
  }
  std::sort(names.begin(), names.end());
  return names;
}

using Names = std::vector<std::string>;

const std::string jsonCamera =
    R"({"model": "perspectiveWithoutDistortion", "px": 614.9, "py": 615, "u0": 320.2, "v0": 241.5})";
} // namespace

TEST_CASE("Of a calibration with two models the one with distortion is taken", "[files]")
{
  for (const std::string &models : {plain + distorted, distorted + plain}) {
    const std::string content = "<root>" + calibration(models) + "</root>";
    const vpCameraParameters cam = read("two.xml", content).camera;
    CHECK(cam.get_px() == exactly(537.));
    CHECK(cam.get_py() == exactly(537.5));
    CHECK(cam.get_u0() == exactly(344.));
    CHECK(cam.get_v0() == exactly(235.));
    CHECK(cam.get_kud() == exactly(-0.267));
    CHECK(cam.get_kdu() == exactly(0.308));
    const vpConfigReport report = reportOf("two.xml", content);
    CHECK(report.format == vpConfigReport::Format::CALIBRATION_XML);
    CHECK((report.imageWidth == 640 && report.imageHeight == 480));
    CHECK(namesOf(report.taken) == Names{"camera/model/kdu as camera.kdu", "camera/model/kud as camera.kud",
                                         "camera/model/px as camera.px", "camera/model/py as camera.py",
                                         "camera/model/u0 as camera.u0", "camera/model/v0 as camera.v0"});
    CHECK(namesOf(report.left) == Names{"camera/additional_information", "camera/image_height", "camera/image_width",
                                        "camera/model perspectiveProjWithoutDistortion", "camera/model/type",
                                        "camera/name"});
  }
  CHECK_THAT(settingsFiles::refusal("cams.xml",
                                    "<root>" + calibration(plain, "left") + calibration(plain, "right") + "</root>"),
             ContainsSubstring("2 cameras") && ContainsSubstring("'left' 640 x 480") && ContainsSubstring("delete"));
  CHECK_THAT(settingsFiles::refusal("twice.xml", "<root>" + calibration(plain + plain) + "</root>"),
             ContainsSubstring("two <model>"));
}

TEST_CASE("A calibration of a grabbed part of the image is read, a fish eye's is not", "[files]")
{
  const std::string full = "<subsampling_width>1</subsampling_width><subsampling_height>1</subsampling_height>"
                           "<full_width>640</full_width><full_height>480</full_height>";
  CHECK(vpIsSame(read("full.xml", "<root>" + calibration(full + plain) + "</root>").camera.get_px(), 557.));
  const std::string fishEye = "<model><type>ProjWithKannalaBrandtDistortion</type><px>557</px><py>561</py><u0>360</u0>"
                              "<v0>235.5</v0><k1>0.1</k1><k2>0</k2><k3>0</k3><k4>0</k4><k5>0</k5></model>";
  CHECK_THAT(settingsFiles::refusal("eye.xml", "<root>" + calibration(fishEye) + "</root>"),
             ContainsSubstring("eye.xml") && ContainsSubstring("undistorted first"));
  const std::string both = "<root>" + calibration(fishEye + plain) + "</root>";
  CHECK(vpIsSame(read("both.xml", both).camera.get_px(), 557.));
  const Names left = namesOf(reportOf("both.xml", both).left);
  CHECK(std::count(left.begin(), left.end(), "camera/model ProjWithKannalaBrandtDistortion") == 1);
}

TEST_CASE("Nodes that ViSP 3.7 added are known", "[files]")
{
  const std::string content =
      "<conf><ecm><mask><size>5</size></mask><range><tracking>7</tracking><init_range>10</init_range></range><contrast>"
      "<edge_threshold_type>1</edge_threshold_type><edge_threshold_margin_ratio>0.5</edge_threshold_margin_ratio>"
      "<edge_min_threshold>10</edge_min_threshold><mu1>0.5</mu1><mu2>0.5</mu2></contrast></ecm>" +
      camera + "</conf>";
  const vpMultiCueSettings settings = read("new.xml", content);
  CHECK(settings.camera.get_px() == exactly(600.));
  CHECK(settings.camera.get_py() == exactly(601.));
  CHECK(settings.edge.range == exactly(7));
  CHECK(settings.edge.mu1 == exactly(0.5));
  const vpConfigReport report = reportOf("new.xml", content);
  CHECK(report.format == vpConfigReport::Format::GENERIC_XML);
  CHECK(namesOf(report.left) == Names{"camera/height", "camera/width", "ecm/contrast/edge_min_threshold",
                                      "ecm/contrast/edge_threshold_margin_ratio", "ecm/range/init_range"});
}

TEST_CASE("The JSON of vpMbGenericTracker is read as far as it has the same settings", "[files]")
{
  const std::string content =
      generic(R"("camTref": {"cols": 4}, "camera": )" + jsonCamera +
              R"(, "clipping": {"far": 0.9, "flags": ["far"], "near": 0.1}, "type": ["edge", "klt", "depthDense"],
      "edge": {"maskSize": 5, "range": 9, "threshold": 20, "thresholdType": "normalized", "mu": [0.4, 0.6],
      "sampleStep": 3.0, "nMask": 180}, "klt": {"maxFeatures": 200, "quality": 0.02}, "dense": {"sampling": {}},
      "angleAppear": 65.0, "angleDisappear": 75.0)");
  const vpMultiCueSettings settings = read("generic.json", content);
  CHECK(settings.camera.get_px() == exactly(614.9));
  CHECK(settings.camera.get_v0() == exactly(241.5));
  CHECK(settings.edge.range == exactly(9));
  CHECK(settings.edge.contrast == exactly(20.));
  CHECK(settings.edge.mu2 == exactly(0.6));
  CHECK(settings.view.sampleStep == exactly(3.));
  CHECK(settings.view.farDistance == exactly(0.9));
  CHECK(settings.view.nearDistance == exactly(vpMultiCueSettings().view.nearDistance));
  CHECK(settings.view.disappearAngle == exactly(75.));
  CHECK(settings.klt.maxFeatures == 200);
  CHECK(settings.cues == 3);
  const vpConfigReport report = reportOf("generic.json", content);
  CHECK(report.format == vpConfigReport::Format::GENERIC_JSON);
  const std::string place = "trackers.Color.";
  CHECK(namesOf(report.left) == Names{"referenceCameraName", place + "camTref.cols", place + "clipping.near",
                                      place + "dense.sampling", place + "edge.nMask", place + "type[2]", "version"});
  CHECK(report.taken.size() == 19);
}

TEST_CASE("All that vpMbGenericTracker writes is taken or left with a reason", "[files]")
{
  // As ViSP 3.7 writes it, with a camera whose name is no JSON pointer.
  const std::string content =
      R"({"referenceCameraName": "a/b~c", "version": "1.0", "trackers": {"other": {"camera": {"px": 1}}, "a/b~c": {
      "camTref": {"cols": 4, "rows": 4, "data": [1, 0], "type": "vpHomogeneousMatrix"},
      "camera": {"model": "perspectiveWithDistortion", "px": 600.0, "py": 601.0, "u0": 192.0, "v0": 144.0, "kud": -0.2,
      "kdu": 0.2}, "type": ["edge", "klt", "depthNormal"], "angleAppear": 60.0, "angleDisappear": 70.0,
      "lod": {"useLod": true, "minLineLengthThresholdGeneral": 40.0, "minPolygonAreaThresholdGeneral": 2400.0},
      "display": {"features": true, "projectionError": false}, "visibilityTest": {"ogre": false, "scanline": true},
      "clipping": {"flags": ["all"], "near": 0.02, "far": 3.0}, "edge": {"thresholdType": "normalized",
      "threshold": 20.0, "thresholdMarginRatio": -1.0, "minThreshold": -1.0, "mu": [0.4, 0.5], "minSampleStep": 4.0,
      "sampleStep": 5.0, "initRange": 7, "range": 6, "ntotalSample": 0, "pointsToTrack": 500, "maskSize": 7,
      "nMask": 180, "maskSign": 0, "strip": 2}, "klt": {"maxFeatures": 300, "windowSize": 7, "quality": 0.02,
      "minDistance": 4.0, "useHarris": 0, "harris": 0.02, "blockSize": 5, "pyramidLevels": 2, "maskBorder": 6},
      "normals": {"featureEstimationMethod": "robust", "pcl": {"method": 2}, "sampling": {"x": 2, "y": 2}},
      "dense": {"sampling": {"x": 2, "y": 2}}}}})";
  const vpMultiCueSettings settings = read("generic.json", content);
  CHECK(vpIsSame(settings.camera.get_kud(), -0.2));
  CHECK((settings.useLod && settings.display.features && settings.clipToImage && !settings.klt.useHarris));
  CHECK(vpIsSame(settings.minPolygonArea, 2400.));
  CHECK(vpIsSame(settings.view.farDistance, 3.));
  CHECK(settings.klt.maskBorder == 6);
  CHECK(settings.cues == 3);
  const vpConfigReport report = reportOf("generic.json", content);
  CHECK(report.taken.size() == 33);
  CHECK(report.left.size() == 26);
}

TEST_CASE("A camera's model may be called by either of its names", "[files]")
{
  for (const std::string name : {"perspectiveProjWithoutDistortion", "perspectiveWithoutDistortion"}) {
    const std::string content =
        R"({"features": [], "camera": {"intrinsics": {"px": 600, "py": 601, "u0": 1, "v0": 2, "model": ")" + name +
        R"("}, "width": 640, "height": 480}})";
    CHECK(vpIsSame(read("rbt.json", content).camera.get_px(), 600.));
    CHECK(reportOf("rbt.json", content).imageWidth == 640);
  }
}

TEST_CASE("The JSON of vpRBTracker is read as far as it has the same settings", "[files]")
{
  const std::string content =
      R"({"camera": {"intrinsics": )" + jsonCamera + R"(, "height": 480, "width": 640}, "vvs": {"gain": 1.0},
      "model": "box.obj", "features": [{"type": "silhouetteMe", "weight": 0.5, "numCandidates": 3, "movingEdge":
      {"maskSize": 5, "range": 5, "threshold": 20, "thresholdType": "normalized"}}, {"type": "silhouetteColor"},
      {"type": "depth"}]})";
  const vpMultiCueSettings settings = read("rbt.json", content);
  CHECK(settings.camera.get_px() == exactly(614.9));
  CHECK(settings.edge.range == exactly(5));
  CHECK(settings.edge.candidates == 3);
  CHECK(settings.cues == 17);
  const vpConfigReport report = reportOf("rbt.json", content);
  CHECK(report.format == vpConfigReport::Format::RENDER_BASED_JSON);
  CHECK((report.imageWidth == 640 && report.imageHeight == 480));
  CHECK(namesOf(report.left) == Names{"camera.height", "camera.width", "features[0].weight", "features[2].type"});
}

TEST_CASE("A model of vpRBTracker that only its renderer reads is left", "[files]")
{
  const std::string content = R"({"camera": {"intrinsics": )" + jsonCamera + R"(}, "model": "data/dragon/dragon.bam"})";
  CHECK(read("rbt.json", content).modelFile.empty());
  CHECK(namesOf(reportOf("rbt.json", content).left) == Names{"model"});
}

TEST_CASE("vpRBTracker's points, colours, steps and model are taken", "[files]")
{
  const std::string content =
      R"({"vvs": {"gain": 0.9, "maxIterations": 12, "mu": 0.5, "muIterFactor": 0.1, "scaleInvariant": true},
      "model": "objects/box.obj", "verbose": {"enabled": true}, "features": [
      {"type": "klt", "weight": 1, "useMask": true, "minMaskConfidence": 0.5, "maxReprojectionErrorPixels": 5.0,
      "newPointsMinPixelDistance": 4, "minimumNumPoints": 20, "blockSize": 5, "useHarris": 0, "harris": 0.05,
      "maxFeatures": 500, "minDistance": 5.0, "pyramidLevels": 3, "quality": 0.01, "windowSize": 5},
      {"type": "silhouetteColor", "weight": 0.5, "convergenceThreshold": 0.1, "temporalSmoothing": 0.1,
      "maxNumPoints": 150, "ccd": {"h": 8, "delta_h": 1, "kappa": 0.5}}],
      "silhouetteExtractionSettings": {"threshold": {"type": "relative", "value": 0.1}, "sampling": {"numPoints": 128}},
      "mask": {"type": "histogram", "bins": 32}, "drift": {"type": "probabilistic"}})";
  const vpMultiCueSettings settings = read("rbt.json", content);
  CHECK(vpIsSame(settings.estimation.gain, 0.9));
  CHECK(settings.estimation.maxIterations == 12);
  CHECK(settings.klt.maxFeatures == 500);
  CHECK_FALSE(settings.klt.useHarris);
  CHECK(vpIsSame(settings.color.length, 8.));
  CHECK(settings.color.lines == 150);
  CHECK_THAT(settings.modelFile, ContainsSubstring("/objects/box.obj"));
  CHECK(settings.cues == 18);
  const vpConfigReport report = reportOf("rbt.json", content);
  CHECK(report.taken.size() == 15);
  CHECK(report.left.size() == 21);
  std::ostringstream text;
  text << report;
  CHECK_THAT(text.str(), ContainsSubstring("vpRBTracker's JSON") &&
                             ContainsSubstring("taken  features[0].maxFeatures as klt.maxFeatures") &&
                             ContainsSubstring("left   drift.type: state and score are always judged"));
}

TEST_CASE("A broken JSON of ViSP's trackers is refused by the tracker's name", "[files]")
{
  for (const std::string &content :
       {generic(""), generic(R"("camera": {"model": "kannalaBrandt"})"), generic(R"("camera": {"px": 1})"),
        generic(R"("edge": 3)"), generic(R"("edge": {"mu": [1]})"), generic(R"("edge": {"threshold": "many"})"),
        generic(R"("type": 3, "camera": {"model": 3})"), std::string(R"({"trackers": []})"),
        std::string(R"({"referenceCameraName": 3})")}) {
    CAPTURE(content);
    CHECK_THAT(settingsFiles::refusal("broken.json", content),
               ContainsSubstring("broken.json") && ContainsSubstring("vpMbGenericTracker"));
  }
  CHECK_THAT(settingsFiles::refusal("broken.json", generic(R"("edge": {"range": -4})")),
             ContainsSubstring("broken.json") && ContainsSubstring("edge.range"));
  CHECK_THAT(settingsFiles::refusal("broken.json", R"({"features": [{"type": 3}]})"),
             ContainsSubstring("broken.json") && ContainsSubstring("vpRBTracker"));
}

TEST_CASE("Settings that are nested without end are refused", "[files]")
{
  const std::string deep(100000, '[');
  CHECK_THAT(settingsFiles::refusal("deep.json", R"({"edge": {"range": )" + deep), ContainsSubstring("deep.json"));
  CHECK_THAT(settingsFiles::refusal("deep.json", R"({"edge": {"range": )" + deep + std::string(100000, ']') + "}}"),
             ContainsSubstring("nested"));
  std::string nodes;
  for (int i = 0; i < 100000; ++i) {
    nodes += "<ecm>";
  }
  CHECK_THAT(settingsFiles::refusal("deep.xml", "<conf>" + nodes), ContainsSubstring("deep.xml"));
}
