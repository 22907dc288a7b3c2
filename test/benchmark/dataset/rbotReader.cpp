// SPDX-License-Identifier: GPL-2.0-or-later
#include "dataset/rbotReader.h"

#include "dataset/checkedGeometry.h"
#include "dataset/datasetFiles.h"

#include <visp3/se3/vpExactNumber.h>

#include <algorithm>
#include <iterator>
#include <set>
#include <sstream>

namespace fs = std::filesystem;

namespace bench {
namespace {
const double millimetre = 0.001;
const char *const cameraName = "camera_calibration.txt";
const char *const posesName = "poses_first.txt";
const std::size_t digits = 4; // Of the images' numbers.

// True for a line that does not begin with a number.
bool isTitle(const std::string &line)
{
  double number = 0.;
  return !(std::istringstream(line) >> number);
}

// Numbers of all lines but the first, if that has titles.
std::vector<std::vector<double>> readTable(const fs::path &file)
{
  std::istringstream text(readText(file));
  std::string line;
  std::vector<std::vector<double>> rows;
  for (int number = 1; std::getline(text, line); ++number) {
    if (number == 1 && isTitle(line)) {
      continue;
    }
    std::vector<double> row = parseNumbers(line, inQuotes(file) + ", line " + std::to_string(number));
    if (!row.empty()) {
      rows.push_back(std::move(row));
    }
  }
  return rows;
}

std::size_t countTitles(const fs::path &file)
{
  std::istringstream text(readText(file));
  std::string line;
  std::getline(text, line);
  std::istringstream words(isTitle(line) ? line : "");
  return static_cast<std::size_t>(
      std::distance(std::istream_iterator<std::string>(words), std::istream_iterator<std::string>()));
}

vpCameraParameters readCamera(const fs::path &file)
{
  const std::vector<std::vector<double>> rows = readTable(file);
  if (rows.empty() || rows[0].size() < 4) {
    fail(inQuotes(file) + ": fx, fy, cx and cy are needed in the second line");
  }
  if (rows[0].size() < countTitles(file)) {
    fail(inQuotes(file) + ": the second line has fewer numbers than the first one has titles");
  }
  if (std::any_of(rows[0].begin() + 4, rows[0].end(), [](double number) { return !vpIsZero(number); })) {
    fail(inQuotes(file) + ": the camera has distortion, which RBOT's images do not have: a number other than 0 follows "
                          "fx, fy, cx and cy");
  }
  // From centres of pixels at halves to centres at integers, see the header.
  return checkedCamera(rows[0][0], rows[0][1], rows[0][2] - 0.5, rows[0][3] - 0.5, inQuotes(file));
}

vpHomogeneousMatrix readPose(const std::vector<double> &row, const std::string &place)
{
  if (row.size() != 12) {
    fail(place + ": a pose has 12 numbers, not " + std::to_string(row.size()));
  }
  const std::vector<double> rotation(row.begin(), row.begin() + 9);
  const vpHomogeneousMatrix cMo =
      checkedTransform(rotation, millimetre * Eigen::Vector3d(row[9], row[10], row[11]), place);
  requireInFront(cMo, place);
  return cMo;
}

// "a_regular" of "a_regular0012.png"; nothing for any other file.
std::string variantOf(const fs::path &file)
{
  const std::string stem = file.stem().string();
  if (file.extension() != ".png" || stem.size() <= digits || numberOf(stem.substr(stem.size() - digits)) < 0) {
    return "";
  }
  return stem.substr(0, stem.size() - digits);
}

std::vector<SequenceFrame> readFrames(const fs::path &folder, const fs::path &dataset, const std::string &variant)
{
  const fs::path poseFile = dataset / posesName;
  const vpCameraParameters cam = readCamera(dataset / cameraName);
  std::vector<SequenceFrame> frames;
  for (const std::vector<double> &row : readTable(poseFile)) {
    SequenceFrame frame;
    frame.id = static_cast<int>(frames.size());
    frame.image = (folder / (variant + numberedPath("%04d.png", frame.id))).string();
    requireFile(frame.image, inQuotes(poseFile) + " has its pose");
    frame.cam = cam;
    frame.cMo = readPose(row, inQuotes(poseFile) + ", frame " + std::to_string(frame.id));
    frame.hasTruth = true;
    frames.push_back(frame);
  }
  const fs::path next = folder / (variant + numberedPath("%04d.png", static_cast<int>(frames.size())));
  std::error_code ignored;
  if (fs::exists(next, ignored)) {
    fail(inQuotes(poseFile) + " ends before the pose of " + inQuotes(next));
  }
  return frames;
}
} // namespace

bool rbotReader::isDataset(const std::string &dataset)
{
  std::error_code ignored;
  return fs::exists(fs::path(dataset) / cameraName, ignored) || fs::exists(fs::path(dataset) / posesName, ignored);
}

std::vector<std::string> rbotReader::scenes(const std::string &dataset)
{
  std::set<std::string> names;
  for (const fs::path &folder : entriesOf(dataset)) {
    std::error_code ignored;
    if (!fs::is_directory(folder / "frames", ignored)) {
      continue;
    }
    for (const fs::path &file : entriesOf(folder / "frames")) {
      const std::string variant = variantOf(file);
      if (!variant.empty()) {
        names.insert(folder.filename().string() + "/" + variant);
      }
    }
  }
  return std::vector<std::string>(names.begin(), names.end());
}

std::vector<vpHomogeneousMatrix> rbotReader::readPoses(const std::string &file)
{
  std::vector<vpHomogeneousMatrix> poses;
  for (const std::vector<double> &row : readTable(file)) {
    poses.push_back(readPose(row, inQuotes(file) + ", pose " + std::to_string(poses.size())));
  }
  if (poses.size() < 2) {
    fail(inQuotes(file) + " has fewer than two poses: a line of 12 numbers is needed for each");
  }
  return poses;
}

Sequence rbotReader::open(const std::string &dataset, const std::string &scene, int object)
{
  if (object != 0 && object != 1) {
    fail(inQuotes(dataset) + ": there is no object " + std::to_string(object) + "; a scene has object 1 alone");
  }
  const fs::path root(dataset);
  const std::string name = scene.substr(0, scene.find('/'));
  Sequence sequence;
  sequence.scene = scene;
  sequence.object.mesh = (root / name / (name + ".obj")).string();
  sequence.object.meshUnit = millimetre;
  requireFile(sequence.object.mesh, "it is the object's model");
  sequence.frames = readFrames(root / name / "frames", root, scene.substr(scene.find('/') + 1));
  startAtFirstTruth(sequence.frames, "The scene " + inQuotes(root / scene));
  sequence.object.diameter = measuredDiameter(sequence.object);
  return sequence;
}

} // namespace bench
