// SPDX-License-Identifier: GPL-2.0-or-later
#include <catchMain.h>
#include <exceptionMessage.h>

#include "plainScene.h"

#include <diskLimit.h>

#include <visp3/core/vpException.h>
#include <visp3/model/vpViewSphere.h>

#include <filesystem>
#include <functional>
#include <iterator>

namespace {
namespace fs = std::filesystem;

//! Linux has a file whose disk is always full. \return The path of one with this name; empty where there is none.
std::string fullFile(const meshFiles::TemporaryFolder &folder, const std::string &name)
{
  const fs::path full = "/dev/full";
  if (!fs::exists(full)) {
    WARN("Left out: there is no /dev/full");
    return std::string();
  }
  fs::create_symlink(full, folder.path(name));
  return folder.path(name);
}

using Save = std::function<void(const std::string &)>;

void checkNamed(const std::string &file, const Save &save)
{
  if (!file.empty()) {
    CHECK_THAT(messageOf([&] { save(file); }), ContainsSubstring(file));
  }
}

std::string textOf(const std::string &file)
{
  std::ifstream stream(file, std::ios::binary);
  return std::string((std::istreambuf_iterator<char>(stream)), std::istreambuf_iterator<char>());
}

//! A disk that has no room for the second of two files.
void checkOldStays(const meshFiles::TemporaryFolder &folder, const std::string &name, const Save &save)
{
  const std::string file = folder.path(name);
  save(file);
  const std::string before = textOf(file);
  REQUIRE(before.size() > 10);
  const DiskLimit limit(before.size() / 2);
  if (limit.isSet) {
    checkNamed(file, save);
    CHECK(textOf(file) == before);
  }
}
} // namespace

TEST_CASE("Where the disk is full, what was to be saved is named, and tracking goes on", "[disk-full]")
{
  const meshFiles::TemporaryFolder folder;
  const meshFiles::Triangles box = modelShapes::boxTriangles(modelShapes::Point(0.12, 0.07, 0.05));
  plainScene scene(box);
  vpMbMultiCueTracker tracker;
  tracker.setFrameDeadline(0.);
  tracker.setCameraParameters(plainScene::camera());
  tracker.loadModel(folder.write("box.stl", meshFiles::asciiStl(box)));
  tracker.initFromPose(scene.draw(plainScene::poseAt(0)), plainScene::poseAt(0));
  tracker.track(scene.draw(plainScene::poseAt(1)));

  const Save saveSettings = [&](const std::string &file) { tracker.saveConfigFile(file); };
  const Save saveResult = [&](const std::string &file) { tracker.getTrackingResult().saveToFile(file); };
  checkNamed(fullFile(folder, "settings.json"), saveSettings);
  checkNamed(fullFile(folder, "result.json"), saveResult);
  checkOldStays(folder, "old-settings.json", saveSettings);
  checkOldStays(folder, "old-result.json", saveResult);
  tracker.track(scene.draw(plainScene::poseAt(2)));
  CHECK(tracker.getTrackingState() == vpTrackingState::TRACKING);
}

TEST_CASE("Where the disk is full, a file of views is named, and the views stay", "[disk-full]")
{
  const meshFiles::TemporaryFolder folder;
  const auto model = std::make_shared<const vpTrackedModel>(
      modelShapes::build(modelShapes::boxPolygons(modelShapes::Point(0.1, 0.08, 0.06))));
  vpViewSphereOptions options;
  options.level = 0;
  vpViewSphere sphere(model, options, std::make_unique<vpCpuRenderer>(model));
  sphere.make(3);
  const Save save = [&](const std::string &file) { sphere.save(file); };
  checkNamed(fullFile(folder, "views"), save);
  checkOldStays(folder, "old-views", save);
  CHECK(sphere.isMade(3));
}
