// SPDX-License-Identifier: GPL-2.0-or-later
#include <catchMain.h>

#include "settingsFiles.h"

#include <iostream>
#include <sstream>

// Configurations and cameras that ViSP's own trackers and programs write.

namespace {
const std::string camera = "<camera><width>640</width><height>480</height><u0>320</u0><v0>240</v0><px>600</px>"
                           "<py>601</py></camera>";

// What reading prints.
std::string printed(const std::string &name, const std::string &content)
{
  std::ostringstream text;
  std::streambuf *const before = std::cout.rdbuf(text.rdbuf());
  const settingsFiles::Folder folder;
  const std::string file = folder.write(name, content);
  try {
    vpMultiCueSettingsReader::read(file, vpMultiCueSettings(), true);
  } catch (...) {
    std::cout.rdbuf(before);
    throw;
  }
  std::cout.rdbuf(before);
  return text.str();
}

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

const std::string jsonCamera =
    R"({"model": "perspectiveWithoutDistortion", "px": 614.9, "py": 615, "u0": 320.2, "v0": 241.5})";
} // namespace

TEST_CASE("Of a calibration with two models the one with distortion is taken", "[files]")
{
  for (const std::string &models : {plain + distorted, distorted + plain}) {
    const std::string content = "<root>" + calibration(models) + "</root>";
    const vpCameraParameters cam = read("two.xml", content).camera;
    CHECK(cam.get_px() == 537.);
    CHECK(cam.get_py() == 537.5);
    CHECK(cam.get_u0() == 344.);
    CHECK(cam.get_v0() == 235.);
    CHECK(cam.get_kud() == -0.267);
    CHECK(cam.get_kdu() == 0.308);
    CHECK_THAT(printed("two.xml", content),
               ContainsSubstring("Left out") && ContainsSubstring("perspectiveProjWithoutDistortion"));
  }
  CHECK_THAT(settingsFiles::refusal("cams.xml",
                                    "<root>" + calibration(plain, "left") + calibration(plain, "right") + "</root>"),
             ContainsSubstring("2 cameras") && ContainsSubstring("'left' 640 x 480") && ContainsSubstring("delete"));
  CHECK_THAT(settingsFiles::refusal("twice.xml", "<root>" + calibration(plain + plain) + "</root>"),
             ContainsSubstring("two <model>"));
}

TEST_CASE("Nodes that ViSP 3.7 added are known", "[files]")
{
  const std::string content =
      "<conf><ecm><mask><size>5</size></mask><range><tracking>7</tracking><init_range>10</init_range></range><contrast>"
      "<edge_threshold_type>1</edge_threshold_type><edge_threshold_margin_ratio>0.5</edge_threshold_margin_ratio>"
      "<edge_min_threshold>10</edge_min_threshold><mu1>0.5</mu1><mu2>0.5</mu2></contrast></ecm>" +
      camera + "</conf>";
  const vpMultiCueSettings settings = read("new.xml", content);
  CHECK(settings.camera.get_px() == 600.);
  CHECK(settings.camera.get_py() == 601.);
  CHECK(settings.edge.range == 7);
  CHECK(settings.edge.mu1 == 0.5);
  CHECK_THAT(printed("new.xml", content), ContainsSubstring("<ecm/range/init_range>") &&
                                              ContainsSubstring("edge_min_threshold") &&
                                              ContainsSubstring("edge_threshold_margin_ratio"));
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
  CHECK(settings.camera.get_px() == 614.9);
  CHECK(settings.camera.get_v0() == 241.5);
  CHECK(settings.edge.range == 9);
  CHECK(settings.edge.contrast == 20.);
  CHECK(settings.edge.mu2 == 0.6);
  CHECK(settings.view.sampleStep == 3.);
  CHECK(settings.view.farDistance == 0.9);
  CHECK(settings.view.nearDistance == vpMultiCueSettings().view.nearDistance);
  CHECK(settings.view.disappearAngle == 75.);
  CHECK(settings.klt.maxFeatures == 200);
  CHECK(settings.cues == 3);
  CHECK_THAT(printed("generic.json", content), ContainsSubstring("vpMbGenericTracker") &&
                                                   ContainsSubstring("depthDense") && ContainsSubstring("dense") &&
                                                   ContainsSubstring("edge.nMask"));
}

TEST_CASE("The JSON of vpRBTracker is read as far as it has the same settings", "[files]")
{
  const std::string content =
      R"({"camera": {"intrinsics": )" + jsonCamera + R"(, "height": 480, "width": 640}, "vvs": {"gain": 1.0},
      "model": "box.obj", "features": [{"type": "silhouetteMe", "weight": 0.5, "numCandidates": 3, "movingEdge":
      {"maskSize": 5, "range": 5, "threshold": 20, "thresholdType": "normalized"}}, {"type": "silhouetteColor"},
      {"type": "depth"}]})";
  const vpMultiCueSettings settings = read("rbt.json", content);
  CHECK(settings.camera.get_px() == 614.9);
  CHECK(settings.edge.range == 5);
  CHECK(settings.edge.candidates == 3);
  CHECK(settings.cues == 17);
  CHECK_THAT(printed("rbt.json", content), ContainsSubstring("vpRBTracker") && ContainsSubstring("model") &&
                                               ContainsSubstring("vvs") && ContainsSubstring("'depth'"));
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
