// SPDX-License-Identifier: GPL-2.0-or-later
// Settings from ViSP's XML files.
#include <catchMain.h>

#include "settingsFiles.h"

#include <visp3/core/vpIoTools.h>

#include <clocale>

namespace {
using settingsFiles::Folder;
using settingsFiles::unusual;

vpMultiCueSettings readXml(const std::string &nodes, const vpMultiCueSettings &defaults = vpMultiCueSettings())
{
  return settingsFiles::read("settings.xml", "<?xml version=\"1.0\"?>\n<conf>\n" + nodes + "\n</conf>\n", defaults);
}

// The nodes begin in line 3.
std::string refusedXml(const std::string &nodes)
{
  return settingsFiles::messageOf([&] { readXml(nodes); });
}

std::string contrastNodes(const std::string &nodes, const std::string &maskSize = "5")
{
  return "<ecm><contrast>" + nodes + "</contrast><mask><size>" + maskSize + "</size></mask></ecm>";
}

const std::string everything = R"(
  <ecm>
    <mask><size>7</size><nb_mask>180</nb_mask></mask>
    <range><tracking>9</tracking></range>
    <contrast><edge_threshold>21000</edge_threshold><mu1>0.25</mu1><mu2>0.75</mu2></contrast>
    <sample><step>6</step></sample>
  </ecm>
  <klt>
    <mask_border>4</mask_border><max_features>300</max_features><window_size>7</window_size><quality>0.015</quality>
    <min_distance>8.5</min_distance><harris>0.02</harris><size_block>5</size_block><pyramid_lvl>2</pyramid_lvl>
  </klt>
  <camera><width>640</width><height>480</height><u0>325.5</u0><v0>243.25</v0><px>839.125</px><py>838.5</py></camera>
  <face>
    <angle_appear>70</angle_appear><angle_disappear>80</angle_disappear>
    <near_clipping>0.125</near_clipping><far_clipping>8</far_clipping><fov_clipping>1</fov_clipping>
  </face>
  <lod><use_lod>1</use_lod><min_line_length_threshold>40</min_line_length_threshold>
    <min_polygon_area_threshold>1500</min_polygon_area_threshold></lod>)";

const std::string depthNodes = R"(
  <depth_normal>
    <feature_estimation_method>0</feature_estimation_method>
    <PCL_plane_estimation>
      <method>2</method><ransac_max_iter>200</ransac_max_iter><ransac_threshold>0.001</ransac_threshold>
    </PCL_plane_estimation>
    <sampling_step><step_X>2</step_X><step_Y>2</step_Y></sampling_step>
  </depth_normal>
  <depth_dense><sampling_step><step_X>4</step_X><step_Y>4</step_Y></sampling_step></depth_dense>
  <projection_error><sample_step>5</sample_step><kernel_size>5x5</kernel_size></projection_error>)";

vpMultiCueSettings everythingRead()
{
  vpMultiCueSettings settings;
  settings.edge.maskSize = 7;
  settings.edge.range = 9.;
  settings.edge.contrast = 5.; // 21000 / (2 * 100 * 7 * 3)
  settings.edge.mu1 = 0.25;
  settings.edge.mu2 = 0.75;
  settings.view.sampleStep = 6.;
  settings.view.appearAngle = 70.;
  settings.view.disappearAngle = 80.;
  settings.view.nearDistance = 0.125;
  settings.view.farDistance = 8.;
  settings.clipToImage = true;
  settings.klt = {300, 7, 0.015, 8.5, 0.02, 5, 2, 4};
  settings.camera.initPersProjWithoutDistortion(839.125, 838.5, 325.5, 243.25);
  settings.useLod = true;
  settings.minLineLength = 40.;
  settings.minPolygonArea = 1500.;
  return settings;
}
} // namespace

TEST_CASE("Every node comes where it belongs")
{
  CHECK(readXml(everything) == everythingRead());
  vpMultiCueSettings keptOnly = everythingRead();
  keptOnly.edge.candidates = unusual().edge.candidates;
  keptOnly.hypotheses = unusual().hypotheses;
  keptOnly.particles = unusual().particles;
  keptOnly.cues = unusual().cues;
  keptOnly.color = unusual().color;
  keptOnly.predicts = unusual().predicts;
  keptOnly.prediction = unusual().prediction;
  keptOnly.frameInterval = unusual().frameInterval;
  keptOnly.searches = unusual().searches;
  keptOnly.frameDeadline = unusual().frameDeadline;
  keptOnly.symmetries = unusual().symmetries;
  keptOnly.symmetricObject = unusual().symmetricObject;
  keptOnly.view.border = unusual().view.border;
  keptOnly.view.visibilitySize = unusual().view.visibilitySize;
  keptOnly.view.textureEdges = unusual().view.textureEdges;
  keptOnly.klt.useHarris = unusual().klt.useHarris;
  keptOnly.klt.leastWeight = unusual().klt.leastWeight;
  keptOnly.goodRatio = unusual().goodRatio;
  keptOnly.factors = unusual().factors;
  keptOnly.predictsRange = unusual().predictsRange;
  keptOnly.estimation = unusual().estimation;
  keptOnly.renderer = unusual().renderer;
  keptOnly.throwsOnLoss = unusual().throwsOnLoss;
  keptOnly.display = unusual().display;
  keptOnly.model = unusual().model;
  keptOnly.modelFile = unusual().modelFile;
  CHECK(readXml(everything, unusual()) == keptOnly);
}

TEST_CASE("What the XML file does not say keeps its default")
{
  CHECK(readXml("", unusual()) == unusual());
  CHECK(readXml(depthNodes, unusual()) == unusual());
  CHECK(readXml("<!-- <ecm/> --><ecm><mask/><sample></sample></ecm><klt/><lod/><face/>", unusual()) == unusual());

  vpMultiCueSettings expected = unusual();
  expected.edge.maskSize = 9; // The contrast, which is in gray levels here, does not change with it.
  expected.edge.mu2 = 0.5;
  expected.klt.blockSize = 4;
  expected.useLod = false;
  expected.clipToImage = false;
  CHECK(readXml("<ecm><mask><size>9</size></mask><contrast><mu2>.5</mu2></contrast></ecm><klt><size_block> 4\n"
                "</size_block></klt><lod><use_lod>0</use_lod></lod><face><fov_clipping>0</fov_clipping></face>",
                unusual()) == expected);
}

TEST_CASE("A camera in the file has no distortion")
{
  const vpCameraParameters before = unusual().camera;
  vpCameraParameters expected;
  expected.initPersProjWithoutDistortion(before.get_px(), 700.5, before.get_u0(), before.get_v0());
  CHECK(sameCamera(readXml("<camera><py>700.5</py></camera>", unusual()).camera, expected));
}

TEST_CASE("The threshold is in the scale that the file names")
{
  const auto contrast = [](const std::string &nodes, const std::string &maskSize = "5") {
    return readXml(contrastNodes(nodes, maskSize), unusual()).edge.contrast;
  };
  CHECK(contrast("<edge_threshold>10000</edge_threshold>") == Approx(5.));
  CHECK(contrast("<edge_threshold>10000</edge_threshold>", "3") == Approx(10000. / 600.));
  CHECK(contrast("<edge_threshold_type>0</edge_threshold_type><edge_threshold>10000</edge_threshold>") == Approx(5.));
  CHECK(contrast("<edge_threshold_type>1</edge_threshold_type><edge_threshold>20.5</edge_threshold>") == Approx(20.5));
  CHECK(contrast("<edge_threshold>20.5</edge_threshold><edge_threshold_type>1</edge_threshold_type>", "3") ==
        Approx(20.5));
  CHECK(contrast("<edge_threshold_type>1</edge_threshold_type>") == exactly(unusual().edge.contrast));
}

TEST_CASE("Deprecated nodes are read")
{
  CHECK(readXml("<sample><step>5</step><nb_sample>250</nb_sample></sample>").view.sampleStep == exactly(5.));
}

TEST_CASE("Nodes that are not known are named with file, line, parent and what is known there")
{
  CHECK_THAT(refusedXml("<ecm>\n<range>\n<traking>8</traking></range></ecm>"),
             ContainsSubstring("settings.xml', line 5: <traking> is not known in <range>; the nearest is <tracking>, "
                               "known there are tracking"));
  CHECK_THAT(refusedXml("<edge/>"), ContainsSubstring("line 3: <edge> is not known in <conf>; the nearest is <ecm>, "
                                                      "known there are ecm, sample, klt, camera, face, "
                                                      "lod, depth_normal, depth_dense, projection_error"));
  CHECK_THAT(refusedXml("<camera><pz>1</pz></camera>"),
             ContainsSubstring("<pz> is not known in <camera>") && ContainsSubstring("px, py, u0, v0"));
  // Known, but elsewhere.
  CHECK_THAT(
      refusedXml("<ecm><mask><tracking>8</tracking></mask></ecm>"),
      ContainsSubstring("<tracking> is not known in <mask>; the nearest is <size>, known there are size, nb_mask"));
  CHECK_THAT(refusedXml("<klt><quality><harris>1</harris></quality></klt>"),
             ContainsSubstring("<harris> is not known in <quality>"));
}

TEST_CASE("Text that is no number is refused with line and node")
{
  CHECK_THAT(
      refusedXml("<face>\n<angle_appear>seventy</angle_appear></face>"),
      ContainsSubstring("line 4: <angle_appear> in <face> is 'seventy', it must be a number in (0, 90] degrees"));
  for (const char *text : {"", "1,5", "1.5.2", "0.5x", "nan", "inf", "0x1"}) {
    INFO(text);
    CHECK_THAT(refusedXml(std::string("<klt><quality>") + text + "</quality></klt>"), ContainsSubstring("<quality>"));
  }
  for (const char *text : {"4.5", "1e1", "-4", "99999999999999999999", "true"}) {
    INFO(text);
    CHECK_THAT(refusedXml(std::string("<ecm><sample><step>") + text + "</step></sample></ecm>"),
               ContainsSubstring("<step> in <sample> is '" + std::string(text) + "', it must be a whole number"));
  }
  CHECK_THAT(refusedXml("<camera>839 839 325 243</camera>"),
             ContainsSubstring("<camera> holds the text '839 839 325 243'"));
}

TEST_CASE("Values out of range are refused with line and node")
{
  CHECK_THAT(refusedXml("<face><angle_disappear>90.5</angle_disappear></face>"),
             ContainsSubstring("line 3: <angle_disappear>"));
  CHECK_THAT(refusedXml("<face><angle_appear>-5</angle_appear></face>"),
             ContainsSubstring("<angle_appear> in <face> is '-5'"));
  CHECK_THAT(refusedXml("<camera><px>0</px></camera>"), ContainsSubstring("<px>"));
  CHECK_THAT(refusedXml("<klt><max_features>4294967297</max_features></klt>"), ContainsSubstring("<max_features>"));
  // ViSP would make masks of these sizes first.
  CHECK_THAT(refusedXml("<ecm><mask><size>1000000</size></mask></ecm>"), ContainsSubstring("<size> in <mask>"));
  CHECK_THAT(refusedXml("<ecm><mask><nb_mask>0</nb_mask></mask></ecm>"), ContainsSubstring("<nb_mask> in <mask>"));
  CHECK_THAT(refusedXml(contrastNodes("<edge_threshold_type>2</edge_threshold_type>")),
             ContainsSubstring("<edge_threshold_type>"));
  CHECK_THAT(refusedXml(contrastNodes("<edge_threshold>0</edge_threshold>")),
             ContainsSubstring("line 3: <edge_threshold>"));
  CHECK_THAT(
      refusedXml(contrastNodes("<edge_threshold_type>1</edge_threshold_type><edge_threshold>5000</edge_threshold>")),
      ContainsSubstring("<edge_threshold> in <contrast> is 5000 gray levels") && ContainsSubstring("old scale"));
  CHECK_THAT(refusedXml("<face><angle_appear>80</angle_appear><angle_disappear>70</angle_disappear></face>"),
             ContainsSubstring("settings.xml") && ContainsSubstring("disappearAngle is 70"));
}

TEST_CASE("A file that is no XML is refused with the line")
{
  CHECK_THAT(refusedXml("<ecm>\n<mask>\n</ecm>"), ContainsSubstring("settings.xml', line 5: this is no XML: "));
  CHECK_THAT(settingsFiles::refusal("a.xml", ""), ContainsSubstring("no XML"));
  CHECK_THAT(settingsFiles::refusal("a.xml", "{\"edge\": {}}"), ContainsSubstring("no XML"));
}

TEST_CASE("A file of ViSP's camera parser gives the camera")
{
  const std::string start =
      "<root><camera><name>left</name><image_width>640</image_width><image_height>480</image_height>"
      "<additional_information><date>today</date></additional_information>";
  const std::string model = "<model><type>perspectiveProjWithDistortion</type><px>700</px><py>701</py><u0>320</u0>"
                            "<v0>240</v0><kud>-0.1</kud><kdu>0.2</kdu></model>";
  const std::string end = "</camera></root>";
  vpMultiCueSettings expected = unusual();
  expected.camera.initPersProjWithDistortion(700., 701., 320., 240., -0.1, 0.2);
  CHECK(settingsFiles::read("camera.xml", start + model + end, unusual()) == expected);

  CHECK_THAT(settingsFiles::refusal("camera.xml", start + model + model + end),
             ContainsSubstring("camera.xml', line 1: there are two <model>") && ContainsSubstring("delete one"));
  CHECK_THAT(settingsFiles::refusal("camera.xml", start + "<model><type>pinhole</type></model>" + end),
             ContainsSubstring("'pinhole', it must be perspectiveProj"));
  CHECK_THAT(
      settingsFiles::refusal("camera.xml",
                             start + "<model><type>perspectiveProjWithoutDistortion</type><px>700</px></model>" + end),
      ContainsSubstring("<py> is missing in <model>"));
}

TEST_CASE("Reading leaves the program's locale alone")
{
  const std::string before = std::setlocale(LC_ALL, nullptr);
  if (std::setlocale(LC_ALL, "C.UTF-8")) {
    const std::string chosen = std::setlocale(LC_ALL, nullptr);
    readXml(everything);
    CHECK(std::setlocale(LC_ALL, nullptr) == chosen);
    refusedXml("<edge/>");
    CHECK(std::setlocale(LC_ALL, nullptr) == chosen);
  }
  std::setlocale(LC_ALL, before.c_str());
}

TEST_CASE("The files that come with ViSP's images are read")
{
  const std::string images = vpIoTools::getViSPImagesDataPath();
  if (!vpIoTools::checkFilename(images + "/mbt/cube.xml")) {
    WARN("ViSP's images were not found; their configuration files are not tried");
    return;
  }
  const auto readImage = [&](const std::string &name) {
    return vpMultiCueSettingsReader::read(images + '/' + name, vpMultiCueSettings());
  };
  const vpMultiCueSettings cube = readImage("mbt/cube.xml");
  CHECK(cube.camera.get_px() == exactly(547.7367575));
  CHECK(cube.edge.range == exactly(7.));
  CHECK(cube.view.appearAngle == exactly(65.));
  CHECK(cube.view.farDistance == exactly(0.9));
  CHECK(cube.klt.maxFeatures == 300);
  const vpMultiCueSettings castle = readImage("mbt-depth/Castle-simu/Config/chateau.xml");
  CHECK(castle.view.sampleStep == exactly(5.));
  CHECK(castle.klt.harris == exactly(0.02));
  CHECK(castle.view.disappearAngle == exactly(89.));
  CHECK(readImage("mbt-depth/castel/chateau.xml").view.sampleStep == exactly(5.)); // A sample node at the top.
  vpMultiCueSettings depth;
  depth.camera.initPersProjWithoutDistortion(700., 700., 320., 240.);
  depth.view.appearAngle = 85.;
  depth.view.nearDistance = 0.01;
  depth.view.farDistance = 2.;
  depth.clipToImage = true;
  CHECK(readImage("mbt-depth/Castle-simu/Config/chateau_depth.xml") == depth);
  CHECK(readImage("mbt-depth/castel/chateau_depth.xml").view.disappearAngle == exactly(80.));
}
