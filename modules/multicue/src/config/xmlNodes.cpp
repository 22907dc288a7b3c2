// SPDX-License-Identifier: GPL-2.0-or-later
#include "config/xmlNodes.h"

#include <algorithm>

BEGIN_VISP_NAMESPACE
namespace vpSettingsDetail {
namespace {
using Values = XmlValues;
using Nodes = std::vector<XmlNode>;

constexpr Range any = {};

Range rangeOf(const char *setting)
{
  return settingsEntry(setting).range;
}

Range from(double low, double high)
{
  return {low, high, true, ""};
}

Nodes cameraNodes()
{
  // The nodes with a model in them are those of vpXmlParserCamera's files.
  return {{"camera", XmlNode::GROUP, any, nullptr},
          {"camera/width", XmlNode::NUMBER, any, nullptr},
          {"camera/height", XmlNode::NUMBER, any, nullptr},
          {"camera/px", XmlNode::NUMBER, rangeOf("camera.px"),
           [](const Values &values, Draft &draft) { draft.camera.px = values.camera.get_px(); }},
          {"camera/py", XmlNode::NUMBER, rangeOf("camera.py"),
           [](const Values &values, Draft &draft) { draft.camera.py = values.camera.get_py(); }},
          {"camera/u0", XmlNode::NUMBER, rangeOf("camera.u0"),
           [](const Values &values, Draft &draft) { draft.camera.u0 = values.camera.get_u0(); }},
          {"camera/v0", XmlNode::NUMBER, rangeOf("camera.v0"),
           [](const Values &values, Draft &draft) { draft.camera.v0 = values.camera.get_v0(); }},
          {"camera/name", XmlNode::ANYTHING, any, nullptr},
          {"camera/image_width", XmlNode::WHOLE, any, nullptr},
          {"camera/image_height", XmlNode::WHOLE, any, nullptr},
          {"camera/subsampling_width", XmlNode::WHOLE, any, nullptr},
          {"camera/subsampling_height", XmlNode::WHOLE, any, nullptr},
          {"camera/additional_information", XmlNode::ANYTHING, any, nullptr},
          {"camera/model", XmlNode::GROUP, any, nullptr},
          {"camera/model/type", XmlNode::ANYTHING, any, nullptr},
          {"camera/model/px", XmlNode::NUMBER, rangeOf("camera.px"), nullptr},
          {"camera/model/py", XmlNode::NUMBER, rangeOf("camera.py"), nullptr},
          {"camera/model/u0", XmlNode::NUMBER, rangeOf("camera.u0"), nullptr},
          {"camera/model/v0", XmlNode::NUMBER, rangeOf("camera.v0"), nullptr},
          {"camera/model/kud", XmlNode::NUMBER, rangeOf("camera.kud"), nullptr},
          {"camera/model/kdu", XmlNode::NUMBER, rangeOf("camera.kdu"), nullptr}};
}

Nodes faceNodes()
{
  return {{"face", XmlNode::GROUP, any, nullptr},
          {"face/angle_appear", XmlNode::NUMBER, rangeOf("view.appearAngle"),
           [](const Values &values, Draft &draft) { draft.members.view.appearAngle = values.parser.getAngleAppear(); }},
          {"face/angle_disappear", XmlNode::NUMBER, rangeOf("view.disappearAngle"),
           [](const Values &values, Draft &draft) {
             draft.members.view.disappearAngle = values.parser.getAngleDisappear();
           }},
          {"face/near_clipping", XmlNode::NUMBER, rangeOf("view.nearDistance"),
           [](const Values &values, Draft &draft) {
             draft.members.view.nearDistance = values.parser.getNearClippingDistance();
           }},
          {"face/far_clipping", XmlNode::NUMBER, rangeOf("view.farDistance"),
           [](const Values &values, Draft &draft) {
             draft.members.view.farDistance = values.parser.getFarClippingDistance();
           }},
          {"face/fov_clipping", XmlNode::WHOLE, from(0., 1.),
           [](const Values &values, Draft &draft) { draft.members.clipToImage = values.parser.getFovClipping(); }}};
}

Nodes lodNodes()
{
  return {{"lod", XmlNode::GROUP, any, nullptr},
          {"lod/use_lod", XmlNode::WHOLE, from(0., 1.),
           [](const Values &values, Draft &draft) { draft.members.useLod = values.parser.getLodState(); }},
          {"lod/min_line_length_threshold", XmlNode::NUMBER, rangeOf("lod.minLineLength"),
           [](const Values &values, Draft &draft) {
             draft.members.minLineLength = values.parser.getLodMinLineLengthThreshold();
           }},
          {"lod/min_polygon_area_threshold", XmlNode::NUMBER, rangeOf("lod.minPolygonArea"),
           [](const Values &values, Draft &draft) {
             draft.members.minPolygonArea = values.parser.getLodMinPolygonAreaThreshold();
           }}};
}

Nodes edgeNodes()
{
  const Range stepRange = rangeOf("view.sampleStep");
  const auto takeStep = [](const Values &values, Draft &draft) {
    draft.members.view.sampleStep = values.me.getSampleStep();
  };
  return {{"ecm", XmlNode::GROUP, any, nullptr},
          {"ecm/mask", XmlNode::GROUP, any, nullptr},
          {"ecm/mask/size", XmlNode::WHOLE, rangeOf("edge.maskSize"),
           [](const Values &values, Draft &draft) { draft.members.edge.maskSize = values.me.getMaskSize(); }},
          {"ecm/mask/nb_mask", XmlNode::WHOLE, from(1., 360.), nullptr},
          {"ecm/range", XmlNode::GROUP, any, nullptr},
          {"ecm/range/tracking", XmlNode::WHOLE, rangeOf("edge.range"),
           [](const Values &values, Draft &draft) { draft.members.edge.range = values.me.getRange(); }},
          {"ecm/range/init_range", XmlNode::WHOLE, any, nullptr, true},
          {"ecm/contrast", XmlNode::GROUP, any, nullptr},
          {"ecm/contrast/edge_threshold_margin_ratio", XmlNode::NUMBER, any, nullptr, true},
          {"ecm/contrast/edge_min_threshold", XmlNode::NUMBER, any, nullptr, true},
          {"ecm/contrast/edge_threshold_type", XmlNode::WHOLE, from(0., 1.), nullptr},
          {"ecm/contrast/edge_threshold", XmlNode::NUMBER, any, nullptr},
          {"ecm/contrast/mu1", XmlNode::NUMBER, rangeOf("edge.mu1"),
           [](const Values &values, Draft &draft) { draft.members.edge.mu1 = values.me.getMu1(); }},
          {"ecm/contrast/mu2", XmlNode::NUMBER, rangeOf("edge.mu2"),
           [](const Values &values, Draft &draft) { draft.members.edge.mu2 = values.me.getMu2(); }},
          {"ecm/sample", XmlNode::GROUP, any, nullptr},
          {"ecm/sample/step", XmlNode::WHOLE, stepRange, takeStep},
          {"ecm/sample/nb_sample", XmlNode::WHOLE, any, nullptr},
          {"sample", XmlNode::GROUP, any, nullptr},
          {"sample/step", XmlNode::WHOLE, stepRange, takeStep},
          {"sample/nb_sample", XmlNode::WHOLE, any, nullptr}};
}

Nodes kltNodes()
{
  return {
      {"klt", XmlNode::GROUP, any, nullptr},
      {"klt/mask_border", XmlNode::WHOLE, rangeOf("klt.maskBorder"),
       [](const Values &values, Draft &draft) { draft.members.klt.maskBorder = values.parser.getKltMaskBorder(); }},
      {"klt/max_features", XmlNode::WHOLE, rangeOf("klt.maxFeatures"),
       [](const Values &values, Draft &draft) {
         draft.members.klt.maxFeatures = static_cast<int>(values.parser.getKltMaxFeatures());
       }},
      {"klt/window_size", XmlNode::WHOLE, rangeOf("klt.windowSize"),
       [](const Values &values, Draft &draft) {
         draft.members.klt.windowSize = static_cast<int>(values.parser.getKltWindowSize());
       }},
      {"klt/quality", XmlNode::NUMBER, rangeOf("klt.quality"),
       [](const Values &values, Draft &draft) { draft.members.klt.quality = values.parser.getKltQuality(); }},
      {"klt/min_distance", XmlNode::NUMBER, rangeOf("klt.minDistance"),
       [](const Values &values, Draft &draft) { draft.members.klt.minDistance = values.parser.getKltMinDistance(); }},
      {"klt/harris", XmlNode::NUMBER, rangeOf("klt.harris"),
       [](const Values &values, Draft &draft) { draft.members.klt.harris = values.parser.getKltHarrisParam(); }},
      {"klt/size_block", XmlNode::WHOLE, rangeOf("klt.blockSize"),
       [](const Values &values, Draft &draft) {
         draft.members.klt.blockSize = static_cast<int>(values.parser.getKltBlockSize());
       }},
      {"klt/pyramid_lvl", XmlNode::WHOLE, rangeOf("klt.pyramidLevels"), [](const Values &values, Draft &draft) {
         draft.members.klt.pyramidLevels = static_cast<int>(values.parser.getKltPyramidLevels());
       }}};
}

// Of parts of ViSP that there is nothing like here.
Nodes passedOver()
{
  return {{"depth_normal", XmlNode::GROUP, any, nullptr, true},
          {"depth_normal/feature_estimation_method", XmlNode::WHOLE, any, nullptr},
          {"depth_normal/PCL_plane_estimation", XmlNode::GROUP, any, nullptr},
          {"depth_normal/PCL_plane_estimation/method", XmlNode::WHOLE, any, nullptr},
          {"depth_normal/PCL_plane_estimation/ransac_max_iter", XmlNode::WHOLE, any, nullptr},
          {"depth_normal/PCL_plane_estimation/ransac_threshold", XmlNode::NUMBER, any, nullptr},
          {"depth_normal/sampling_step", XmlNode::GROUP, any, nullptr},
          {"depth_normal/sampling_step/step_X", XmlNode::WHOLE, any, nullptr},
          {"depth_normal/sampling_step/step_Y", XmlNode::WHOLE, any, nullptr},
          {"depth_dense", XmlNode::GROUP, any, nullptr, true},
          {"depth_dense/sampling_step", XmlNode::GROUP, any, nullptr},
          {"depth_dense/sampling_step/step_X", XmlNode::WHOLE, any, nullptr},
          {"depth_dense/sampling_step/step_Y", XmlNode::WHOLE, any, nullptr},
          {"projection_error", XmlNode::GROUP, any, nullptr, true},
          {"projection_error/sample_step", XmlNode::NUMBER, any, nullptr},
          {"projection_error/kernel_size", XmlNode::ANYTHING, any, nullptr}};
}

vpCameraParameters cameraOf(const vpMbtXmlGenericParser &parser)
{
  vpCameraParameters camera;
  parser.getCameraParameters(camera);
  return camera;
}

vpMe movingEdgeOf(const vpMbtXmlGenericParser &parser)
{
  vpMe me;
  parser.getEdgeMe(me);
  return me;
}
} // namespace

XmlValues::XmlValues(const vpMbtXmlGenericParser &filled)
    : parser(filled), camera(cameraOf(filled)), me(movingEdgeOf(filled))
{
}

const std::vector<XmlNode> &xmlNodes()
{
  static const Nodes all = [] {
    Nodes nodes;
    for (const Nodes &some : {edgeNodes(), kltNodes(), cameraNodes(), faceNodes(), lodNodes(), passedOver()}) {
      nodes.insert(nodes.end(), some.begin(), some.end());
    }
    return nodes;
  }();
  return all;
}

const XmlNode *findXmlNode(const std::string &path)
{
  const std::vector<XmlNode> &nodes = xmlNodes();
  const auto found = std::find_if(nodes.begin(), nodes.end(), [&](const XmlNode &node) { return node.path == path; });
  return found == nodes.end() ? nullptr : &*found;
}

std::vector<std::string> xmlNodesBelow(const std::string &path)
{
  const std::string start = path.empty() ? path : path + '/';
  std::vector<std::string> names;
  for (const XmlNode &node : xmlNodes()) {
    const std::string other = node.path;
    if (other.compare(0, start.size(), start) == 0 && other.find('/', start.size()) == std::string::npos) {
      names.push_back(other.substr(start.size()));
    }
  }
  return names;
}
} // namespace vpSettingsDetail
END_VISP_NAMESPACE
