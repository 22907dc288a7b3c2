// SPDX-License-Identifier: GPL-2.0-or-later
#include "generate/scene.h"

#include "generate/meshError.h"
#include "generate/variants.h"

#include <visp3/core/vpException.h>
#include <visp3/se3/vpPoseExponential.h>
#include <visp3/se3/vpPoseRandom.h>

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>

namespace bench {
namespace {
const int noiseNumbers = 1 << 18;
const double noiseDeviation = 12.;
const int exposureSteps = 8;
const double exposure = 0.6;
const double mostMeshError = 5.;
const char *const renderedModels = "models_rendered";

void checkOptions(const SceneOptions &options)
{
  checkVariant(options.variant);
  if (options.frames < 2) {
    throw vpException(vpException::badValue, "a sequence has at least 2 frames, not %d", options.frames);
  }
  if (options.width < 64 || options.height < 48 || options.width > 4096 || options.height > 4096) {
    throw vpException(vpException::badValue, "images may have 64 x 48 to 4096 x 4096 pixels, not %u x %u",
                      options.width, options.height);
  }
  if (!(options.meshError >= 0. && options.meshError <= mostMeshError)) {
    throw vpException(vpException::badValue, "--mesh-error: %g is not from 0 to %g", options.meshError, mostMeshError);
  }
  if (options.dataset.empty()) {
    throw vpException(vpException::badValue, "no folder was given for the data set");
  }
}

bool isGenerated(const std::string &object)
{
  const std::vector<std::string> names = objectNames();
  return std::find(names.begin(), names.end(), object) != names.end();
}

MotionSettings motionOf(const SceneOptions &options, const SyntheticObject &object, const vpTrackedModel &model)
{
  MotionSettings settings;
  settings.kind = options.motion;
  settings.scale = options.motionScale;
  settings.fitsDistance = isGenerated(options.object);
  settings.points = model.vertices();
  settings.pixelDiameter = object.pixelDiameter;
  settings.frontOnly = object.frontOnly;
  settings.exits = hasVariant(options.variant, "exit");
  settings.frames = options.frames;
  settings.seed = options.seed * 64 + static_cast<std::uint64_t>(object.id);
  return settings;
}

//! Lacquered cardboard and plastic: a highlight that is nearly white.
void polish(SurfaceMaterial &material)
{
  material.specular = std::max(material.specular, 0.5F);
  material.shininess = std::max(material.shininess, 40.F);
}

programs::BopBox boundingBox(const cv::Mat &mask, const cv::Point &origin)
{
  const cv::Rect box = cv::boundingRect(mask);
  if (box.empty()) {
    return {{-1, -1, -1, -1}};
  }
  return {{box.x + origin.x, box.y + origin.y, box.width, box.height}};
}

//! Draws a layer over an image.
void compose(const ImageLayer &layer, cv::Mat &image)
{
  const cv::Rect inside = layer.area & cv::Rect(0, 0, image.cols, image.rows);
  for (int i = inside.y; i < inside.y + inside.height; ++i) {
    for (int j = inside.x; j < inside.x + inside.width; ++j) {
      const float coverage = layer.coverage.at<float>(i - layer.area.y, j - layer.area.x);
      cv::Vec3f &pixel = image.at<cv::Vec3f>(i, j);
      pixel = (1.F - coverage) * pixel + layer.color.at<cv::Vec3f>(i - layer.area.y, j - layer.area.x);
    }
  }
}
} // namespace

Scene::Scene(const SceneOptions &options) : m_options(options), m_camera(makeSceneCamera(options.width, options.height))
{
  checkOptions(options);
  m_synthetic = makeObject(options.object, options.seed, options.unit);
  writeModels();
  m_motion = makeMotion(m_camera, motionOf(options, m_synthetic, *m_object.model));
  const std::string suits = m_synthetic.inSpace ? "space" : "photo";
  m_background = std::make_unique<Background>(options.background.empty() ? suits : options.background, m_camera,
                                              options.seed * 64 + static_cast<std::uint64_t>(m_synthetic.id));
  m_webcam = std::make_unique<Webcam>(hasVariant(options.variant, "webcam") ? effectNames() : options.effects, m_camera,
                                      options.seed * 64 + static_cast<std::uint64_t>(m_synthetic.id));
  if (hasVariant(options.variant, "blur") && m_webcam->hasShutter()) {
    throw vpException(vpException::badValue,
                      "the variant 'blur' has a shutter of its own: leave the effects rolling-shutter, exposure and "
                      "soft-shadows out, or take the variant 'regular'");
  }
  if (m_webcam->has("highlights")) {
    std::for_each(m_object.materials.begin(), m_object.materials.end(), polish);
  }
  planForeground();
  if (hasVariant(options.variant, "noise")) {
    vpPoseRandom random(options.seed, {0x6e6f697365});
    m_noise.resize(noiseNumbers);
    std::generate(m_noise.begin(), m_noise.end(), [&] { return static_cast<float>(noiseDeviation * random.normal()); });
  }
}

void Scene::writeModels()
{
  if (!(m_options.meshError > 0.)) {
    m_object = writeAndLoad(m_options.dataset, m_synthetic);
    return;
  }
  // Trackers find the wrong mesh. A .cao has no room for its errors, and would give the right one away.
  m_object = writeAndLoad(m_options.dataset, m_synthetic, renderedModels);
  SyntheticObject wrong = m_synthetic;
  wrong.triangles = reconstructed(m_synthetic.triangles, m_options.meshError,
                                  m_options.seed * 64 + static_cast<std::uint64_t>(m_synthetic.id));
  wrong.cao.clear();
  writeObject(m_options.dataset, wrong);
}

void Scene::planForeground()
{
  const bool board = hasVariant(m_options.variant, "blackout");
  const bool occluder = hasVariant(m_options.variant, "occlusion");
  if (!board && !occluder) {
    return;
  }
  std::vector<ImageLayer> layers(static_cast<std::size_t>(m_options.frames));
  ObjectRenderer renderer = makeRenderer();
  for (int frame = 0; frame < m_options.frames; ++frame) {
    renderer.render(m_motion->pose(frame), Light(), 1, layers[static_cast<std::size_t>(frame)]);
    layers[static_cast<std::size_t>(frame)].color.release();
  }
  if (occluder) {
    m_foreground.push_back(makeOccluder(m_camera, layers, m_options.seed));
  }
  if (board) {
    m_foreground.push_back(makeBoard(m_camera, layers, m_options.seed));
  }
}

void Scene::fillTruth(const ImageLayer &object, const cv::Mat &hidden, programs::BopFrame &truth) const
{
  const cv::Mat whole = object.coverage >= 0.5F;
  const cv::Rect inside = object.area & cv::Rect(0, 0, hidden.cols, hidden.rows);
  cv::Mat seen = cv::Mat::zeros(whole.size(), CV_8U);
  if (!inside.empty()) {
    const cv::Rect part(inside.tl() - object.area.tl(), inside.size());
    const cv::Mat uncovered = hidden(inside) < 0.5F;
    cv::bitwise_and(whole(part), uncovered, seen(part));
  }
  truth.pixelsAll = cv::countNonZero(whole);
  truth.pixelsVisible = cv::countNonZero(seen);
  truth.boxObject = boundingBox(whole, object.area.tl());
  truth.boxVisible = boundingBox(seen, object.area.tl());
}

Light Scene::lightOf(double time, int instant) const
{
  const Light light = lightAt(m_synthetic, hasVariant(m_options.variant, "light"), time, m_options.seed);
  return m_webcam->has("soft-shadows") ? lampPoint(light, instant) : light;
}

cv::Mat Scene::renderInstant(double time, int samples, const Light &light, ObjectRenderer &renderer,
                             programs::BopFrame *truth) const
{
  ImageLayer object;
  renderer.render(m_motion->pose(time), light, samples, object);
  cv::Mat image = m_background->at(time, m_motion->backgroundTurn(time));
  compose(object, image);
  cv::Mat hidden = cv::Mat::zeros(image.size(), CV_32F);
  for (const std::unique_ptr<Foreground> &thing : m_foreground) {
    thing->draw(time, image, hidden);
  }
  if (truth != nullptr) {
    fillTruth(object, hidden, *truth);
  }
  return image;
}

cv::Mat Scene::renderExposure(double time, ObjectRenderer &renderer) const
{
  // The background of a camera at rest moves by less than a pixel meanwhile, so the means of colour and coverage are
  // all that is needed.
  cv::Mat image = m_background->at(time, m_motion->backgroundTurn(time));
  ImageLayer mean;
  mean.area = cv::Rect(cv::Point(0, 0), image.size());
  mean.color = cv::Mat::zeros(image.size(), CV_32FC3);
  mean.coverage = cv::Mat::zeros(image.size(), CV_32F);
  for (int i = 0; i < exposureSteps; ++i) {
    // Two samples along an axis are enough for each of the eight, whose edges lie elsewhere.
    const double instant = time + exposure * ((i + 0.5) / exposureSteps - 0.5);
    ImageLayer layer;
    renderer.render(m_motion->pose(instant), lightAt(m_synthetic, false, instant, m_options.seed), 2, layer);
    const cv::Rect inside = layer.area & mean.area;
    if (!inside.empty()) {
      const cv::Rect part(inside.tl() - layer.area.tl(), inside.size());
      mean.color(inside) += layer.color(part) / exposureSteps;
      mean.coverage(inside) += layer.coverage(part) / exposureSteps;
    }
  }
  compose(mean, image);
  return image;
}

double Scene::timeOf(int frame) const
{
  const Shutter shutter = m_webcam->shutter();
  double time = frame;
  if (!(shutter.readout > 0.)) {
    return time;
  }
  // While the object moves by fewer rows than are read meanwhile, each round is nearer to the row's own time.
  for (int i = 0; i < 20; ++i) {
    const Eigen::Vector3d centre = vpPoseExponential::toEigen(m_motion->pose(time)) * m_object.model->centre();
    const double row = m_camera.cam.get_v0() + m_camera.cam.get_py() * centre.y() / centre.z();
    const int rows = static_cast<int>(m_camera.height);
    time = frame + shutter.timeOfRow(std::clamp(row, 0., rows - 1.), rows);
  }
  return time;
}

cv::Mat Scene::renderShutter(int frame, ObjectRenderer &renderer) const
{
  const Shutter shutter = hasVariant(m_options.variant, "blur") ? Shutter{exposure, 0.} : m_webcam->shutter();
  return expose(shutter, [&](double time, int instant) {
    return renderInstant(frame + time, 2, lightOf(frame + time, instant), renderer, nullptr);
  });
}

cv::Mat Scene::render(int frame, ObjectRenderer &renderer, programs::BopFrame &truth) const
{
  truth = programs::BopFrame();
  truth.id = frame;
  truth.cMo = pose(frame);
  cv::Mat image;
  if (hasVariant(m_options.variant, "blur") && m_options.motion != "shaken-camera") {
    image = renderExposure(frame, renderer);
    ImageLayer object;
    renderer.render(truth.cMo, Light(), 1, object);
    fillTruth(object, cv::Mat::zeros(image.size(), CV_32F), truth);
  } else if (hasVariant(m_options.variant, "blur") || m_webcam->hasShutter()) {
    renderInstant(timeOf(frame), 1, Light(), renderer, &truth);
    image = renderShutter(frame, renderer);
  } else {
    image = renderInstant(frame, 4, lightOf(frame, 0), renderer, &truth);
  }
  if (!m_noise.empty()) {
    addNoise(frame, image);
  }
  m_webcam->process(frame, image);
  cv::Mat result;
  image.convertTo(result, CV_8UC3);
  return result;
}

void Scene::addNoise(int frame, cv::Mat &image) const
{
  // Each row starts at a random place of the numbers, which saves drawing a million of them for each image.
  vpPoseRandom random(m_options.seed, {0x726f77, static_cast<std::uint64_t>(frame)});
  const int count = image.cols * 3;
  for (int i = 0; i < image.rows; ++i) {
    const float *noise = &m_noise[random.index(m_noise.size() - static_cast<std::size_t>(count))];
    float *row = image.ptr<float>(i);
    for (int j = 0; j < count; ++j) {
      row[j] += noise[j];
    }
  }
}

} // namespace bench
