// SPDX-License-Identifier: GPL-2.0-or-later
#include "dataset/bopReader.h"

#include "dataset/bopObject.h"
#include "dataset/checkedGeometry.h"
#include "dataset/datasetFiles.h"
#include "dataset/jsonFile.h"

#include <visp3/core/vpException.h>
#include <visp3/se3/vpExactNumber.h>

#include <algorithm>
#include <memory>
#include <set>

namespace fs = std::filesystem;

namespace bench {
namespace {
const double millimetre = 0.001;
// A scene with more that is wrong is taken for broken.
const std::size_t leastFramesPerNote = 10;

const std::string cameraPrefix = "scene_camera_";

// A scene whose poses are lost is still one: it is told apart from a scene that is not there.
bool isScene(const fs::path &folder)
{
  std::error_code ignored;
  return fs::is_regular_file(folder / "scene_gt.json", ignored) ||
         fs::is_regular_file(folder / "scene_camera.json", ignored);
}

// Adds the scenes in a folder: one, or one for each sensor.
void addScenes(const fs::path &folder, const std::string &name, std::vector<std::string> &names)
{
  if (isScene(folder)) {
    names.push_back(name);
  }
  for (const fs::path &file : entriesOf(folder)) {
    const std::string stem = file.stem().string();
    if (file.extension() == ".json" && stem.compare(0, cameraPrefix.size(), cameraPrefix) == 0) {
      names.push_back(name + "@" + stem.substr(cameraPrefix.size()));
    }
  }
}

std::vector<fs::path> foldersIn(const fs::path &folder)
{
  std::vector<fs::path> folders;
  for (const fs::path &entry : entriesOf(folder)) {
    std::error_code ignored;
    if (fs::is_directory(entry, ignored)) {
      folders.push_back(entry);
    }
  }
  return folders;
}

// \param suffix Of the sensor's files, such as "_photoneo"; empty where a scene has one sensor.
fs::path imageFolder(const fs::path &scene, const std::string &suffix)
{
  std::error_code ignored;
  for (const std::string name : {"rgb", "gray"}) {
    if (fs::is_directory(scene / (name + suffix), ignored)) {
      return scene / (name + suffix);
    }
  }
  fail("The scene " + inQuotes(scene) + " has no images: neither rgb" + suffix + "/ nor gray" + suffix + "/ is there");
}

// BOP's files of one scene, keyed by the number of the image.
class SceneFiles
{
public:
  SceneFiles(const fs::path &scene, const std::string &suffix)
      : m_cameraFile(scene / ("scene_camera" + suffix + ".json")), m_truthFile(scene / ("scene_gt" + suffix + ".json")),
        m_cameras(m_cameraFile.root().numberedMembers()), m_truth(m_truthFile.root().numberedMembers()),
        m_folder(imageFolder(scene, suffix)), m_images(numberedImages(m_folder))
  {
    const fs::path info = scene / ("scene_gt_info" + suffix + ".json");
    std::error_code ignored;
    if (fs::is_regular_file(info, ignored)) {
      m_infoFile = std::make_unique<JsonFile>(info);
      m_info = m_infoFile->root().numberedMembers();
    }
  }

  int chooseObject(int object) const;
  //! All that can be read; \e notes tell what cannot. \throw vpException where that is too much.
  std::vector<SequenceFrame> frames(int object, std::vector<std::string> &notes) const;

private:
  SequenceFrame frame(int image, int object, std::vector<std::string> &notes) const;
  // Every image that any of the files knows of.
  std::set<int> ids() const;
  void readTruth(const JsonValue &instances, int object, SequenceFrame &frame) const;
  double visibility(int image, std::size_t instance) const;

  JsonFile m_cameraFile;
  JsonFile m_truthFile;
  std::unique_ptr<JsonFile> m_infoFile;
  std::map<int, JsonValue> m_cameras;
  std::map<int, JsonValue> m_truth;
  std::map<int, JsonValue> m_info;
  fs::path m_folder;
  std::map<int, fs::path> m_images;
};

int SceneFiles::chooseObject(int object) const
{
  std::set<int> objects;
  for (const auto &image : m_truth) {
    for (const JsonValue &instance : image.second.items()) {
      int id = 0;
      try {
        id = instance.at("obj_id").integer();
      } catch (const vpException &) {
        continue; // frames() tells of it.
      }
      if (object == 0 || object == id) {
        return id;
      }
      objects.insert(id);
    }
  }
  std::vector<std::string> names;
  for (const int id : objects) {
    names.push_back(std::to_string(id));
  }
  fail(m_truthFile.root().place() + ": there is no object " + (object == 0 ? "at all" : std::to_string(object)) +
       "; there is: " + listed(names, 30));
}

std::set<int> SceneFiles::ids() const
{
  std::set<int> ids;
  for (const auto &image : m_images) {
    ids.insert(image.first);
  }
  for (const std::map<int, JsonValue> *file : {&m_cameras, &m_truth}) {
    for (const auto &image : *file) {
      ids.insert(image.first);
    }
  }
  return ids;
}

vpCameraParameters readCamera(const JsonValue &camera)
{
  const JsonValue matrix = camera.at("cam_K");
  const std::vector<double> K = matrix.numbers(9);
  if (!vpIsZero(K[1]) || !vpIsZero(K[3]) || !vpIsZero(K[6]) || !vpIsZero(K[7]) || vpIsOther(K[8], 1.)) {
    matrix.refuse("a camera fx 0 cx 0 fy cy 0 0 1 is needed: ViSP's cameras have no skew");
  }
  return checkedCamera(K[0], K[4], K[2], K[5], matrix.place());
}

double SceneFiles::visibility(int image, std::size_t instance) const
{
  const auto infos = m_info.find(image);
  if (infos == m_info.end()) {
    return 1.;
  }
  const std::vector<JsonValue> instances = infos->second.items();
  if (instance >= instances.size() || !instances[instance].has("visib_fract")) {
    return 1.;
  }
  const JsonValue share = instances[instance].at("visib_fract");
  const double visible = share.number();
  if (vpIsSame(visible, -1.)) {
    return 1.; // BOP's word for not computed.
  }
  if (visible < 0. || visible > 1.001) { // A bit more is what rounding leaves.
    share.refuse("a share in [0, 1] is needed");
  }
  return std::min(visible, 1.);
}

void SceneFiles::readTruth(const JsonValue &instances, int object, SequenceFrame &frame) const
{
  const std::vector<JsonValue> items = instances.items();
  for (std::size_t i = 0; i < items.size(); ++i) {
    if (items[i].at("obj_id").integer() != object) {
      continue;
    }
    const std::vector<double> t = items[i].at("cam_t_m2c").numbers(3);
    frame.cMo = checkedTransform(items[i].at("cam_R_m2c").numbers(9), millimetre * Eigen::Vector3d(t[0], t[1], t[2]),
                                 items[i].place());
    // Head-mounted cameras have objects behind them: such a pose is right, but no image shows it.
    frame.hasTruth = frame.cMo[2][3] > 0.;
    frame.visibility = frame.hasTruth ? visibility(frame.id, i) : 0.;
    return;
  }
}

SequenceFrame SceneFiles::frame(int image, int object, std::vector<std::string> &notes) const
{
  SequenceFrame frame;
  frame.id = image;
  const auto file = m_images.find(image);
  if (file == m_images.end()) {
    fail("The image " + inQuotes(m_folder / numberedPath("%06d.png", image)) +
         " (or .jpg, .jpeg, .tif) is missing: the scene's JSON files name it");
  }
  requireFile(file->second);
  frame.image = file->second.string();
  const auto camera = m_cameras.find(image);
  if (camera == m_cameras.end()) {
    m_cameraFile.root().refuse("image " + std::to_string(image) + " has no camera");
  }
  frame.cam = readCamera(camera->second);
  const auto truth = m_truth.find(image);
  if (truth != m_truth.end()) {
    try {
      readTruth(truth->second, object, frame);
    } catch (const vpException &e) {
      frame.hasTruth = false;
      notes.push_back(std::string("without truth: ") + e.getMessage());
    }
  }
  return frame;
}

std::vector<SequenceFrame> SceneFiles::frames(int object, std::vector<std::string> &notes) const
{
  std::vector<SequenceFrame> frames;
  const std::set<int> images = ids();
  for (const int image : images) {
    try {
      frames.push_back(frame(image, object, notes));
    } catch (const vpException &e) {
      notes.push_back(std::string("frame left out: ") + e.getMessage());
    }
  }
  if (notes.size() * leastFramesPerNote > images.size()) {
    fail(std::to_string(notes.size()) + " of " + std::to_string(images.size()) +
         " frames cannot be read; the first one, " + notes.front());
  }
  return frames;
}
} // namespace

std::vector<std::string> bopReader::scenes(const std::string &dataset)
{
  const fs::path root(dataset);
  std::vector<std::string> names;
  addScenes(root, ".", names);
  for (const fs::path &folder : foldersIn(root)) {
    const std::size_t before = names.size();
    addScenes(folder, folder.filename().string(), names);
    if (names.size() > before) {
      continue;
    }
    for (const fs::path &inner : foldersIn(folder)) {
      addScenes(inner, (folder.filename() / inner.filename()).generic_string(), names);
    }
  }
  std::sort(names.begin(), names.end());
  return names;
}

Sequence bopReader::open(const std::string &dataset, const std::string &scene, int object)
{
  const std::size_t at = scene.rfind('@');
  const std::string name = scene.substr(0, at);
  const std::string suffix = at == std::string::npos ? "" : "_" + scene.substr(at + 1);
  const fs::path folder = name == "." ? fs::path(dataset) : fs::path(dataset) / name;
  const SceneFiles files(folder, suffix);
  Sequence sequence;
  sequence.scene = scene;
  sequence.object = findBopObject(dataset, folder, files.chooseObject(object));
  sequence.frames = files.frames(sequence.object.id, sequence.notes);
  startAtFirstTruth(sequence.frames, "The scene " + inQuotes(folder));
  return sequence;
}

} // namespace bench
