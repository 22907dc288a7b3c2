// SPDX-License-Identifier: GPL-2.0-or-later
#include <catchMain.h>

#include "sphereShapes.h"

#include <visp3/core/vpException.h>

#include <cmath>
#include <functional>

using namespace modelShapes;
using namespace sphereShapes;

TEST_CASE("A sphere that sees nothing has empty views")
{
  const Polygon square = {Point(-0.05, -0.05, 0.), Point(0.05, -0.05, 0.), Point(0.05, 0.05, 0.),
                          Point(-0.05, 0.05, 0.)};
  vpViewSphereOptions options = optionsOf(2);
  options.view.appearAngle = options.view.disappearAngle = 30.;
  vpViewSphere sphere = makeSphere(build(std::vector<Polygon>{square}), options);
  std::size_t empty = 0;
  for (std::size_t i = 0; i < sphere.size(); ++i) {
    CAPTURE(i);
    CHECK((sphere.view(i).size() == 0) == (sphere.directionOf(i).z() <= std::cos(30. * M_PI / 180.)));
    CHECK(sphere.isMade(i));
    CHECK(isSame(sphere.view(i), sphere.view(i)));
    empty += sphere.view(i).size() == 0 ? 1U : 0U;
  }
  CHECK(empty > 140);
  CHECK(empty < 162);
}

TEST_CASE("A full sphere takes less than 50 megabytes")
{
  vpViewSphere sphere = makeSphere(shape("box"), vpViewSphereOptions());
  for (std::size_t i = 0; i < sphere.size(); ++i) {
    REQUIRE(sphere.view(i).size() <= 120);
  }
  CHECK(sphere.memory() > 2562 * 7 * 4 * 100);
  CHECK(sphere.memory() < 12000000);
}

TEST_CASE("An option of a sphere out of range is refused by name")
{
  const auto refuses = [](const std::function<void(vpViewSphereOptions &)> &spoil, const std::string &text) {
    vpViewSphereOptions options;
    spoil(options);
    CHECK_THROWS_WITH(options.check(), ContainsSubstring(text));
    CHECK_THROWS_WITH(makeSphere(shape("box"), options), ContainsSubstring(text));
  };
  CHECK_NOTHROW(vpViewSphereOptions().check());
  refuses([](vpViewSphereOptions &options) { options.level = 5; }, "vpViewSphereOptions::level is 5");
  refuses([](vpViewSphereOptions &options) { options.distance = 1.; }, "vpViewSphereOptions::distance is 1");
  refuses([](vpViewSphereOptions &options) { options.distance = HUGE_VAL; }, "vpViewSphereOptions::distance");
  refuses([](vpViewSphereOptions &options) { options.distance = std::nan(""); }, "vpViewSphereOptions::distance");
  refuses([](vpViewSphereOptions &options) { options.points = 0; }, "vpViewSphereOptions::points is 0");
  refuses([](vpViewSphereOptions &options) { options.view.sampleStep = 0.; }, "sampleStep");
}

TEST_CASE("A sphere says what it misses")
{
  const std::shared_ptr<const vpTrackedModel> letter = std::make_shared<const vpTrackedModel>(shape("letter L"));
  CHECK_THROWS_WITH(vpViewSphere(letter, optionsOf(1), nullptr), ContainsSubstring("needs a renderer"));
  CHECK_THROWS_WITH(vpViewSphere(nullptr, optionsOf(1), nullptr), ContainsSubstring("needs a model"));
  const std::shared_ptr<const vpTrackedModel> box = std::make_shared<const vpTrackedModel>(shape("box"));
  vpViewSphere sphere(box, optionsOf(1), nullptr);
  CHECK(sphere.view(3).size() > 50);
  CHECK_THROWS_WITH(sphere.view(42), ContainsSubstring("no view 42"));
  CHECK_THROWS_WITH(sphere.make(42), ContainsSubstring("no view 42"));
  CHECK_THROWS_WITH(sphere.isMade(42), ContainsSubstring("no view 42"));
}
