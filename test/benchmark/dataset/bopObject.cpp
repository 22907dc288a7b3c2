// SPDX-License-Identifier: GPL-2.0-or-later
#include "dataset/bopObject.h"

#include "dataset/checkedGeometry.h"
#include "dataset/datasetFiles.h"
#include "dataset/jsonFile.h"

#include <visp3/model/vpModelReader.h>

#include <algorithm>
#include <cmath>

namespace fs = std::filesystem;

namespace bench {
namespace {
const double millimetre = 0.001;

std::string existing(const fs::path &file)
{
  std::error_code ignored;
  return fs::is_regular_file(file, ignored) ? file.string() : std::string();
}

bool findFiles(const fs::path &folder, SequenceObject &object)
{
  const fs::path name = folder / numberedPath("obj_%06d", object.id);
  object.mesh = existing(name.string() + ".obj");
  object.meshUnit = 1.;
  if (object.mesh.empty()) {
    object.mesh = existing(name.string() + ".ply");
    object.meshUnit = millimetre;
  }
  object.cao = existing(name.string() + ".cao");
  return !object.mesh.empty() || !object.cao.empty();
}

// Which models there are instead of the one that is missing.
std::vector<std::string> modelsIn(const fs::path &folder)
{
  std::vector<std::string> names;
  for (const fs::path &file : entriesOf(folder)) {
    if (file.stem().string().rfind("obj_", 0) == 0) {
      names.push_back(file.filename().string());
    }
  }
  return names;
}

// The first folder of models that has the object.
fs::path findModels(const fs::path &dataset, const fs::path &scene, SequenceObject &object)
{
  std::vector<std::string> others;
  for (const fs::path &root : {dataset, scene}) {
    for (const char *name : {"models", "models_cad", "models_eval", "models_fine"}) {
      const fs::path folder = root / name;
      std::error_code ignored;
      if (!fs::is_directory(folder, ignored)) {
        continue;
      }
      if (findFiles(folder, object)) {
        return folder;
      }
      const std::vector<std::string> found = modelsIn(folder);
      others.insert(others.end(), found.begin(), found.end());
    }
  }
  fail("The model of object " + std::to_string(object.id) +
       " is missing: " + inQuotes(dataset / "models" / numberedPath("obj_%06d.ply", object.id)) +
       " (or .obj, .cao) is needed; there is: " + listed(others));
}

SymmetryAxis readAxis(const JsonValue &symmetry)
{
  const std::vector<double> axis = symmetry.at("axis").numbers(3);
  SymmetryAxis result;
  const Eigen::Vector3d direction(axis[0], axis[1], axis[2]);
  if (!(direction.norm() > 0.)) {
    symmetry.refuse("the axis has no direction");
  }
  result.direction = direction.normalized();
  if (symmetry.has("offset")) {
    const std::vector<double> offset = symmetry.at("offset").numbers(3);
    result.point = millimetre * Eigen::Vector3d(offset[0], offset[1], offset[2]);
  }
  return result;
}

void readSymmetry(const JsonValue &symmetry, SequenceObject &object)
{
  const vpHomogeneousMatrix T = checkedTransform(symmetry.numbers(16), millimetre, symmetry.place());
  const vpHomogeneousMatrix identity;
  const bool isIdentity =
      std::equal(T.data, T.data + 16, identity.data, [](double a, double b) { return std::fabs(a - b) < 1e-9; });
  if (!isIdentity) {
    object.symmetry.push_back(T);
  }
}

void readInfo(const JsonValue &info, SequenceObject &object)
{
  if (info.has("diameter")) {
    const JsonValue diameter = info.at("diameter");
    object.diameter = millimetre * diameter.number();
    if (!(object.diameter > 0.)) {
      diameter.refuse("a diameter is positive");
    }
  }
  if (info.has("symmetries_discrete")) {
    for (const JsonValue &symmetry : info.at("symmetries_discrete").items()) {
      readSymmetry(symmetry, object);
    }
  }
  if (info.has("symmetries_continuous")) {
    for (const JsonValue &symmetry : info.at("symmetries_continuous").items()) {
      object.axis.push_back(readAxis(symmetry));
    }
  }
}
} // namespace

namespace {
// Longest side of its box, over the diameter that a file tells: between these for every shape.
const double leastRatio = 0.5;
const double mostRatio = 1.1;

// Longest side of a mesh's box in its own unit, which may be any.
double longestSide(const std::string &mesh)
{
  vpModelOptions options;
  options.minSize = 1e-9;
  options.maxSize = 1e9;
  return vpModelReader::read(mesh, options).report().size.maxCoeff();
}

// An .obj is in metres or, beside a models_info.json that tells so, in millimetres; the .ply is taken where it is
// neither.
void chooseUnit(SequenceObject &object, const fs::path &infoFile)
{
  if (fs::path(object.mesh).extension() != ".obj" || !(object.diameter > 0.)) {
    return;
  }
  const double side = longestSide(object.mesh);
  for (const double unit : {1., millimetre}) {
    const double ratio = unit * side / object.diameter;
    if (ratio > leastRatio && ratio < mostRatio) {
      object.meshUnit = unit;
      return;
    }
  }
  const std::string ply = existing(fs::path(object.mesh).replace_extension(".ply"));
  if (ply.empty()) {
    fail("The model " + inQuotes(object.mesh) + " is " + std::to_string(side) + " long, and " + inQuotes(infoFile) +
         " says that the object has a diameter of " + std::to_string(object.diameter / millimetre) +
         " mm: the model has to be in metres or millimetres, or the file to tell its diameter in millimetres");
  }
  object.mesh = ply;
  object.meshUnit = millimetre;
}
} // namespace

SequenceObject findBopObject(const fs::path &dataset, const fs::path &scene, int id)
{
  SequenceObject object;
  object.id = id;
  const fs::path infoFile = findModels(dataset, scene, object) / "models_info.json";
  if (!existing(infoFile).empty()) {
    const JsonFile file(infoFile);
    const std::map<int, JsonValue> infos = file.root().numberedMembers();
    const auto info = infos.find(id);
    if (info != infos.end()) {
      readInfo(info->second, object);
    }
  }
  chooseUnit(object, infoFile);
  if (!(object.diameter > 0.)) {
    object.diameter = measuredDiameter(object);
  }
  return object;
}

} // namespace bench
