// SPDX-License-Identifier: GPL-2.0-or-later
#include <catchMain.h>

#include "meshFiles.h"
#include "sphereShapes.h"

#include <visp3/core/vpException.h>

#include <functional>
#include <iterator>

using namespace modelShapes;
using namespace sphereShapes;

namespace {
vpViewSphereOptions fewPoints(unsigned int level)
{
  vpViewSphereOptions options = optionsOf(level);
  options.points = 40;
  return options;
}

vpViewSphere letterSphere()
{
  return makeSphere(build(lPolygons(0.12, 0.05)), fewPoints(1));
}

std::string read(const std::string &file)
{
  std::ifstream stream(file, std::ios::binary);
  return std::string((std::istreambuf_iterator<char>(stream)), std::istreambuf_iterator<char>());
}

//! What load() says of a file; empty where it takes it.
std::string refusal(vpViewSphere &sphere, const std::string &file)
{
  try {
    sphere.load(file);
  } catch (const vpException &e) {
    return e.getStringMessage();
  }
  return "";
}

std::size_t countMade(const vpViewSphere &sphere)
{
  std::size_t count = 0;
  for (std::size_t i = 0; i < sphere.size(); ++i) {
    count += sphere.isMade(i) ? 1U : 0U;
  }
  return count;
}
} // namespace

TEST_CASE("Views come back from a file as they were made")
{
  const meshFiles::TemporaryFolder folder;
  vpViewSphere saved = letterSphere();
  for (std::size_t i = 0; i < saved.size(); i += 3) {
    saved.make(i);
  }
  saved.save(folder.path("sphere"));
  vpViewSphere loaded = letterSphere();
  const float *made = loaded.view(3).x();
  loaded.make(4);
  loaded.load(folder.path("sphere"));
  CHECK(loaded.view(3).x() == made); // A view that is there stays where it is.
  for (std::size_t i = 0; i < saved.size(); ++i) {
    CAPTURE(i);
    CHECK(loaded.isMade(i) == (saved.isMade(i) || i == 4));
  }
  for (std::size_t i = 0; i < saved.size(); ++i) {
    CHECK(isSame(loaded.view(i), saved.view(i)));
  }
  CHECK(loaded.memory() == saved.memory());
}

TEST_CASE("A sphere without views, and views without points, can be saved")
{
  const meshFiles::TemporaryFolder folder;
  letterSphere().save(folder.path("none"));
  vpViewSphere loaded = letterSphere();
  CHECK(refusal(loaded, folder.path("none")).empty());
  CHECK(countMade(loaded) == 0);

  vpViewSphereOptions options = fewPoints(1);
  options.view.appearAngle = 1.;
  const vpTrackedModel box = build(boxPolygons(Point(0.1, 0.08, 0.06)));
  vpViewSphere blind = makeSphere(box, options);
  REQUIRE(blind.view(0).size() == 0);
  blind.save(folder.path("blind"));
  vpViewSphere other = makeSphere(box, options);
  other.load(folder.path("blind"));
  CHECK(other.isMade(0));
  CHECK(other.view(0).size() == 0);
}

TEST_CASE("A file of another model or of other options is refused")
{
  const meshFiles::TemporaryFolder folder;
  const std::string file = folder.path("sphere");
  vpViewSphere saved = letterSphere();
  saved.make(5);
  saved.save(file);
  const auto check = [&](vpViewSphere sphere) {
    const std::string text = refusal(sphere, file);
    CHECK_THAT(text, ContainsSubstring(file) && ContainsSubstring("another model or other options"));
    CHECK(countMade(sphere) == 0);
  };
  check(makeSphere(build(lPolygons(0.12000001, 0.05)), fewPoints(1)));
  const std::vector<std::function<void(vpViewSphereOptions &)>> changes = {
      [](vpViewSphereOptions &options) { options.level = 2; },
      [](vpViewSphereOptions &options) { options.distance = 3.; },
      [](vpViewSphereOptions &options) { options.points = 41; },
      [](vpViewSphereOptions &options) { options.view.sampleStep = 3.; },
      [](vpViewSphereOptions &options) { options.view.appearAngle = 80.; },
      [](vpViewSphereOptions &options) { options.view.visibilitySize = 100; },
      [](vpViewSphereOptions &options) { options.view.allEdges = true; },
      [](vpViewSphereOptions &options) { options.view.textureEdges = true; },
      [](vpViewSphereOptions &options) { options.view.textureEdgesLeftOut = {1}; },
      [](vpViewSphereOptions &options) { options.view.details.resize(8); }};
  for (const std::function<void(vpViewSphereOptions &)> &change : changes) {
    vpViewSphereOptions options = fewPoints(1);
    change(options);
    check(makeSphere(build(lPolygons(0.12, 0.05)), options));
  }
  // What does not change the views does not matter.
  vpViewSphereOptions options = fewPoints(1);
  options.view.farDistance = 2.;
  vpViewSphere same = makeSphere(build(lPolygons(0.12, 0.05)), options);
  CHECK(refusal(same, file).empty());
}

TEST_CASE("A broken file is refused by name, and the sphere goes on as before")
{
  const meshFiles::TemporaryFolder folder;
  vpViewSphere saved = letterSphere();
  saved.make(5);
  saved.make(6);
  saved.save(folder.path("sphere"));
  const std::string good = read(folder.path("sphere"));
  vpViewSphere sphere = letterSphere();
  sphere.make(0);
  int accepted = 0;
  const auto attempt = [&](const std::string &content) {
    const std::string text = refusal(sphere, folder.write("broken", content));
    accepted += text.find(folder.path("broken")) == std::string::npos || countMade(sphere) != 1 ? 1 : 0;
  };
  for (std::size_t length = 0; length < good.size(); length += length < 100 ? 1 : 41) {
    attempt(good.substr(0, length));
  }
  for (std::size_t at = 0; at < good.size(); at += at < 100 ? 1 : 41) {
    std::string flipped = good;
    flipped[at] = static_cast<char>(flipped[at] ^ 0x10);
    attempt(flipped);
  }
  attempt(good + "more");
  CHECK(accepted == 0);
  CHECK_THAT(refusal(sphere, folder.path("missing")), ContainsSubstring("missing' of a view sphere cannot be read"));
  CHECK_THAT(refusal(sphere, folder.path("")), ContainsSubstring("of a view sphere"));
  CHECK(isSame(sphere.view(5), saved.view(5)));
}

TEST_CASE("A file that cannot be written is named")
{
  const meshFiles::TemporaryFolder folder;
  CHECK_THROWS_WITH(letterSphere().save(folder.path("no/such/folder")), ContainsSubstring("no/such/folder"));
}
