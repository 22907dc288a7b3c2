// SPDX-License-Identifier: GPL-2.0-or-later
#include "config/xmlNodes.h"

#include <algorithm>

BEGIN_VISP_NAMESPACE
namespace vpSettingsDetail {
namespace {
using Values = XmlValues;
using Nodes = std::vector<XmlNode>;

constexpr const char *imageTellsSize = "the images tell their size";
constexpr const char *needsDepth = "it needs a depth camera";
constexpr const char *ownMeasure = "the projection error is measured at the model's edges";

XmlNode group(const char *path)
{
  return {path, XmlNode::GROUP};
}

XmlNode taken(const char *path, XmlNode::Kind kind, const char *setting, XmlNode::Take take)
{
  return {path, kind, settingsEntry(setting).range, setting, "", take};
}

XmlNode left(const char *path, XmlNode::Kind kind, const char *reason, const Range &range = {})
{
  return {path, kind, range, "", reason};
}

Range from(double low, double high)
{
  return {low, high, true, ""};
}

Nodes cameraNodes()
{
  return {group("camera"),
          left("camera/width", XmlNode::NUMBER, imageTellsSize),
          left("camera/height", XmlNode::NUMBER, imageTellsSize),
          taken("camera/px", XmlNode::NUMBER, "camera.px",
                [](const Values &values, Draft &draft) { draft.camera.px = values.camera.get_px(); }),
          taken("camera/py", XmlNode::NUMBER, "camera.py",
                [](const Values &values, Draft &draft) { draft.camera.py = values.camera.get_py(); }),
          taken("camera/u0", XmlNode::NUMBER, "camera.u0",
                [](const Values &values, Draft &draft) { draft.camera.u0 = values.camera.get_u0(); }),
          taken("camera/v0", XmlNode::NUMBER, "camera.v0",
                [](const Values &values, Draft &draft) { draft.camera.v0 = values.camera.get_v0(); })};
}

// Of vpXmlParserCamera's files.
Nodes calibrationNodes()
{
  constexpr const char *isText = "it is a remark";
  constexpr const char *wasGrabbed = "it tells how the images were grabbed";
  constexpr const char *otherModel = "its model cannot be tracked with";
  Nodes nodes = {left("camera/name", XmlNode::ANYTHING, isText),
                 left("camera/image_width", XmlNode::WHOLE, imageTellsSize),
                 left("camera/image_height", XmlNode::WHOLE, imageTellsSize),
                 left("camera/subsampling_width", XmlNode::WHOLE, wasGrabbed),
                 left("camera/subsampling_height", XmlNode::WHOLE, wasGrabbed),
                 left("camera/full_width", XmlNode::WHOLE, wasGrabbed),
                 left("camera/full_height", XmlNode::WHOLE, wasGrabbed),
                 left("camera/additional_information", XmlNode::ANYTHING, isText),
                 group("camera/model"),
                 left("camera/model/type", XmlNode::ANYTHING, "it says which of the values there are"),
                 taken("camera/model/px", XmlNode::NUMBER, "camera.px", nullptr),
                 taken("camera/model/py", XmlNode::NUMBER, "camera.py", nullptr),
                 taken("camera/model/u0", XmlNode::NUMBER, "camera.u0", nullptr),
                 taken("camera/model/v0", XmlNode::NUMBER, "camera.v0", nullptr),
                 taken("camera/model/kud", XmlNode::NUMBER, "camera.kud", nullptr),
                 taken("camera/model/kdu", XmlNode::NUMBER, "camera.kdu", nullptr)};
  for (const char *coefficient :
       {"camera/model/k1", "camera/model/k2", "camera/model/k3", "camera/model/k4", "camera/model/k5"}) {
    nodes.push_back(left(coefficient, XmlNode::NUMBER, otherModel));
  }
  return nodes;
}

Nodes faceNodes()
{
  return {group("face"),
          taken("face/angle_appear", XmlNode::NUMBER, "view.appearAngle",
                [](const Values &values, Draft &draft) {
                  draft.members.view.appearAngle = values.parser.getAngleAppear();
                }),
          taken("face/angle_disappear", XmlNode::NUMBER, "view.disappearAngle",
                [](const Values &values, Draft &draft) {
                  draft.members.view.disappearAngle = values.parser.getAngleDisappear();
                }),
          taken("face/near_clipping", XmlNode::NUMBER, "view.nearDistance",
                [](const Values &values, Draft &draft) {
                  draft.members.view.nearDistance = values.parser.getNearClippingDistance();
                }),
          taken("face/far_clipping", XmlNode::NUMBER, "view.farDistance",
                [](const Values &values, Draft &draft) {
                  draft.members.view.farDistance = values.parser.getFarClippingDistance();
                }),
          {"face/fov_clipping", XmlNode::WHOLE, from(0., 1.), "view.clipToImage", "lines are always clipped",
           [](const Values &values, Draft &draft) { draft.members.clipToImage = values.parser.getFovClipping(); }}};
}

Nodes lodNodes()
{
  return {group("lod"),
          {"lod/use_lod", XmlNode::WHOLE, from(0., 1.), "lod.enabled", "",
           [](const Values &values, Draft &draft) { draft.members.useLod = values.parser.getLodState(); }},
          taken("lod/min_line_length_threshold", XmlNode::NUMBER, "lod.minLineLength",
                [](const Values &values, Draft &draft) {
                  draft.members.minLineLength = values.parser.getLodMinLineLengthThreshold();
                }),
          taken("lod/min_polygon_area_threshold", XmlNode::NUMBER, "lod.minPolygonArea",
                [](const Values &values, Draft &draft) {
                  draft.members.minPolygonArea = values.parser.getLodMinPolygonAreaThreshold();
                })};
}

Nodes edgeNodes()
{
  const auto takeStep = [](const Values &values, Draft &draft) {
    draft.members.view.sampleStep = values.me.getSampleStep();
  };
  constexpr const char *stepTells = "the step between control points tells how many there are";
  constexpr const char *ownThreshold = "the threshold adapts itself to the light";
  return {group("ecm"),
          group("ecm/mask"),
          taken("ecm/mask/size", XmlNode::WHOLE, "edge.maskSize",
                [](const Values &values, Draft &draft) { draft.members.edge.maskSize = values.me.getMaskSize(); }),
          left("ecm/mask/nb_mask", XmlNode::WHOLE, "masks are made for each edge's own direction", from(1., 360.)),
          group("ecm/range"),
          taken("ecm/range/tracking", XmlNode::WHOLE, "edge.range",
                [](const Values &values, Draft &draft) { draft.members.edge.range = values.me.getRange(); }),
          left("ecm/range/init_range", XmlNode::WHOLE, "a start looks as far as it has to"),
          group("ecm/contrast"),
          left("ecm/contrast/edge_threshold_margin_ratio", XmlNode::NUMBER, ownThreshold),
          left("ecm/contrast/edge_min_threshold", XmlNode::NUMBER, ownThreshold),
          {"ecm/contrast/edge_threshold_type", XmlNode::WHOLE, from(0., 1.), "edge.contrast",
           "the scale of edge_threshold"},
          {"ecm/contrast/edge_threshold", XmlNode::NUMBER, {}, "edge.contrast", "in gray levels"},
          taken("ecm/contrast/mu1", XmlNode::NUMBER, "edge.mu1",
                [](const Values &values, Draft &draft) { draft.members.edge.mu1 = values.me.getMu1(); }),
          taken("ecm/contrast/mu2", XmlNode::NUMBER, "edge.mu2",
                [](const Values &values, Draft &draft) { draft.members.edge.mu2 = values.me.getMu2(); }),
          group("ecm/sample"),
          taken("ecm/sample/step", XmlNode::WHOLE, "view.sampleStep", takeStep),
          left("ecm/sample/nb_sample", XmlNode::WHOLE, stepTells),
          group("sample"), // Where ViSP 2 had it.
          taken("sample/step", XmlNode::WHOLE, "view.sampleStep", takeStep),
          left("sample/nb_sample", XmlNode::WHOLE, stepTells)};
}

Nodes kltNodes()
{
  return {
      group("klt"),
      taken(
          "klt/mask_border", XmlNode::WHOLE, "klt.maskBorder",
          [](const Values &values, Draft &draft) { draft.members.klt.maskBorder = values.parser.getKltMaskBorder(); }),
      taken("klt/max_features", XmlNode::WHOLE, "klt.maxFeatures",
            [](const Values &values, Draft &draft) {
              draft.members.klt.maxFeatures = static_cast<int>(values.parser.getKltMaxFeatures());
            }),
      taken("klt/window_size", XmlNode::WHOLE, "klt.windowSize",
            [](const Values &values, Draft &draft) {
              draft.members.klt.windowSize = static_cast<int>(values.parser.getKltWindowSize());
            }),
      taken("klt/quality", XmlNode::NUMBER, "klt.quality",
            [](const Values &values, Draft &draft) { draft.members.klt.quality = values.parser.getKltQuality(); }),
      taken("klt/min_distance", XmlNode::NUMBER, "klt.minDistance",
            [](const Values &values, Draft &draft) {
              draft.members.klt.minDistance = values.parser.getKltMinDistance();
            }),
      taken("klt/harris", XmlNode::NUMBER, "klt.harris",
            [](const Values &values, Draft &draft) { draft.members.klt.harris = values.parser.getKltHarrisParam(); }),
      taken("klt/size_block", XmlNode::WHOLE, "klt.blockSize",
            [](const Values &values, Draft &draft) {
              draft.members.klt.blockSize = static_cast<int>(values.parser.getKltBlockSize());
            }),
      taken("klt/pyramid_lvl", XmlNode::WHOLE, "klt.pyramidLevels", [](const Values &values, Draft &draft) {
        draft.members.klt.pyramidLevels = static_cast<int>(values.parser.getKltPyramidLevels());
      })};
}

// Of parts of ViSP that there is nothing like here.
Nodes passedOver()
{
  return {group("depth_normal"),
          left("depth_normal/feature_estimation_method", XmlNode::WHOLE, needsDepth),
          group("depth_normal/PCL_plane_estimation"),
          left("depth_normal/PCL_plane_estimation/method", XmlNode::WHOLE, needsDepth),
          left("depth_normal/PCL_plane_estimation/ransac_max_iter", XmlNode::WHOLE, needsDepth),
          left("depth_normal/PCL_plane_estimation/ransac_threshold", XmlNode::NUMBER, needsDepth),
          group("depth_normal/sampling_step"),
          left("depth_normal/sampling_step/step_X", XmlNode::WHOLE, needsDepth),
          left("depth_normal/sampling_step/step_Y", XmlNode::WHOLE, needsDepth),
          group("depth_dense"),
          group("depth_dense/sampling_step"),
          left("depth_dense/sampling_step/step_X", XmlNode::WHOLE, needsDepth),
          left("depth_dense/sampling_step/step_Y", XmlNode::WHOLE, needsDepth),
          group("projection_error"),
          left("projection_error/sample_step", XmlNode::NUMBER, ownMeasure),
          left("projection_error/kernel_size", XmlNode::ANYTHING, ownMeasure)};
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
    for (const Nodes &some :
         {edgeNodes(), kltNodes(), cameraNodes(), calibrationNodes(), faceNodes(), lodNodes(), passedOver()}) {
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
