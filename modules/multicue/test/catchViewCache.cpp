// SPDX-License-Identifier: GPL-2.0-or-later
#include "search/vpViewMaker.cpp" // The library keeps it to itself.

#include <catchMain.h>
#include <exceptionMessage.h>

#include "renderedBox.h"

#include <meshFiles.h>
#include <modelShapes.h>

#include <visp3/multicue/vpMbMultiCueTracker.h>

#include <cerrno>
#include <chrono>
#include <dlfcn.h>
#include <fstream>
#include <pthread.h>

/*! \file catchViewCache.cpp Views that are made beside the frames, and kept in a folder. */

namespace {
bool refusesThreads = false;
} // namespace

// In place of the C library's: as a system does that has no thread left.
extern "C" int pthread_create(pthread_t *thread, const pthread_attr_t *attributes, void *(*begin)(void *),
                              void *argument) noexcept
{
  using Create = int (*)(pthread_t *, const pthread_attr_t *, void *(*)(void *), void *);
  static const auto create = reinterpret_cast<Create>(dlsym(RTLD_NEXT, "pthread_create"));
  return refusesThreads ? EAGAIN : create(thread, attributes, begin, argument);
}

namespace {
namespace fs = std::filesystem;

std::shared_ptr<const vpTrackedModel> boxModel()
{
  return std::make_shared<const vpTrackedModel>(modelShapes::build(modelShapes::boxPolygons({0.1, 0.07, 0.05})));
}

vpViewSphere sphereOf(const std::shared_ptr<const vpTrackedModel> &model)
{
  vpViewSphereOptions options;
  options.level = 2;
  return vpViewSphere(model, options, nullptr);
}

template <typename Condition> bool comesTrue(Condition &&condition)
{
  for (unsigned int i = 0; i < 2000 && !condition(); ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  return condition();
}

std::string emptyFolder(const std::string &name)
{
  const std::string folder = meshFiles::temporaryFile(name);
  fs::remove_all(folder);
  fs::create_directories(folder);
  return folder;
}
} // namespace

TEST_CASE("A thread makes all views, coarse levels first", "[view-cache]")
{
  vpViewSphere sphere = sphereOf(boxModel());
  {
    const vpViewMaker maker(sphere, "");
    REQUIRE(comesTrue([&] { return maker.has(2); }));
    CHECK(maker.level() == 2);
  }
  vpViewSphere other = sphereOf(boxModel());
  for (std::size_t i = 0; i < sphere.size(); ++i) {
    REQUIRE(sphere.isMade(i));
    CHECK(sphere.view(i).size() == other.view(i).size());
  }
}

TEST_CASE("A maker that ends early leaves a sphere that can be gone on with", "[view-cache]")
{
  for (unsigned int i = 0; i < 20; ++i) {
    vpViewSphere sphere = sphereOf(boxModel());
    {
      const vpViewMaker maker(sphere, "");
    }
    CHECK(sphere.view(sphere.size() - 1).size() > 0);
  }
}

TEST_CASE("Without a thread the views are there at once", "[view-cache]")
{
  vpViewSphere sphere = sphereOf(boxModel());
  refusesThreads = true;
  CHECK_THROWS_AS(std::thread([] {}), std::system_error);
  {
    const vpViewMaker maker(sphere, "");
    CHECK(maker.has(2));
  }
  refusesThreads = false;
}

TEST_CASE("All views are kept for the next program", "[view-cache]")
{
  const std::string folder = emptyFolder("view-cache");
  vpViewSphere sphere = sphereOf(boxModel());
  const fs::path file = fs::path(folder) / sphere.fileName();
  {
    const vpViewMaker maker(sphere, folder);
    REQUIRE(comesTrue([&] { return fs::exists(file); }));
  }
  vpViewSphere other = sphereOf(boxModel());
  CHECK(other.fileName() == sphere.fileName());
  other.load(file.string());
  for (std::size_t i = 0; i < other.size(); ++i) {
    CHECK(other.isMade(i));
  }
  CHECK(std::distance(fs::directory_iterator(folder), fs::directory_iterator()) == 1);
}

TEST_CASE("A tracker takes no harm from what lies in the folder", "[view-cache]")
{
  const std::string folder = emptyFolder("view-cache-damaged");
  renderedBox box;
  const vpImage<vpRGBa> I = box.drawColor(renderedBox::pose());
  const std::string model = renderedBox::writeCao(meshFiles::temporaryFile("view-cache-box.cao"));
  std::string name;
  for (unsigned int i = 0; i < 3; ++i) { // Made, read, made again in place of a damaged one.
    vpMbMultiCueTracker tracker;
    tracker.setFrameDeadline(1000.);
    tracker.setViewCache(folder);
    CHECK(tracker.getViewCache() == folder);
    tracker.setCameraParameters(renderedBox::camera());
    tracker.loadModel(model);
    tracker.initFromPose(I, renderedBox::pose());
    tracker.track(I);
    CHECK(tracker.getTrackingState() == vpTrackingState::TRACKING);
    const auto whole = [&] {
      for (const fs::directory_entry &entry : fs::directory_iterator(folder)) {
        name = entry.path().extension() == ".views" ? entry.path().string() : name;
      }
      return !name.empty() && fs::file_size(name) > 10000;
    };
    REQUIRE(comesTrue(whole));
    if (i == 1) {
      fs::resize_file(name, 1000);
    }
  }
}

TEST_CASE("A folder that is none is refused by name", "[view-cache]")
{
  vpMbMultiCueTracker tracker;
  CHECK_THAT(messageOf([&] { tracker.setViewCache("no-such-folder"); }), ContainsSubstring("no-such-folder"));
  CHECK(tracker.getViewCache().empty());
}
