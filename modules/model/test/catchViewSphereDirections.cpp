// SPDX-License-Identifier: GPL-2.0-or-later
#include <catchMain.h>
#include <countAllocations.h>

#include "modelShapes.h"
#include "viewChecks.h"

#include <visp3/core/vpException.h>
#include <visp3/model/vpViewSphere.h>
#include <visp3/se3/vpPoseRandom.h>

#include <algorithm>
#include <utility>

using namespace modelShapes;
using namespace viewChecks;

namespace {
const Point centre(0.3, -0.2, 0.1);

vpViewSphere boxSphere(unsigned int level)
{
  vpViewSphereOptions options;
  options.level = level;
  return vpViewSphere(std::make_shared<const vpTrackedModel>(build(boxPolygons(Point(0.1, 0.08, 0.06), centre))),
                      options, nullptr);
}

//! Cosine of the least angle between a direction and one of the first vertices.
double leastAngleCosine(const vpViewSphere &sphere, const Point &direction, std::size_t count)
{
  double best = -HUGE_VAL;
  for (std::size_t i = 0; i < count; ++i) {
    best = std::max(best, sphere.directionOf(i).dot(direction));
  }
  return best;
}

//! Angle from each direction of a level to the nearest other one, radians: least and largest.
std::pair<double, double> gaps(const vpViewSphere &sphere)
{
  std::pair<double, double> range(HUGE_VAL, 0.);
  for (std::size_t i = 0; i < sphere.size(); ++i) {
    double cosine = -1.;
    for (std::size_t j = 0; j < sphere.size(); ++j) {
      cosine = j == i ? cosine : std::max(cosine, sphere.directionOf(i).dot(sphere.directionOf(j)));
    }
    range.first = std::min(range.first, std::acos(cosine));
    range.second = std::max(range.second, std::acos(cosine));
  }
  return range;
}
} // namespace

TEST_CASE("Directions are distinct unit vectors, evenly spread over the sphere")
{
  const std::vector<std::size_t> counts = {12, 42, 162, 642, 2562};
  for (unsigned int level = 0; level <= 4; ++level) {
    CAPTURE(level);
    const vpViewSphere sphere = boxSphere(level);
    REQUIRE(sphere.size() == counts[level]);
    CHECK(vpViewSphere::size(level) == counts[level]);
    Point sum = Point::Zero();
    for (std::size_t i = 0; i < sphere.size(); ++i) {
      REQUIRE(sphere.directionOf(i).norm() == Approx(1.).epsilon(1e-14));
      sum += sphere.directionOf(i);
    }
    CHECK(sum.norm() < 1e-10);
    const std::pair<double, double> range = gaps(sphere);
    CHECK(range.first > 0.8 * vpViewSphere::spacing(level));
    CHECK(range.second < 1.1 * vpViewSphere::spacing(level));
  }
}

TEST_CASE("The directions of a coarser sphere come first")
{
  const vpViewSphere fine = boxSphere(4);
  for (unsigned int level = 0; level < 4; ++level) {
    const vpViewSphere coarse = boxSphere(level);
    for (std::size_t i = 0; i < coarse.size(); ++i) {
      REQUIRE(coarse.directionOf(i) == fine.directionOf(i));
    }
  }
}

TEST_CASE("The nearest direction is the nearest of all, at every level")
{
  const vpViewSphere sphere = boxSphere(4);
  vpPoseRandom random(1);
  for (unsigned int level = 0; level <= 4; ++level) {
    CAPTURE(level);
    int wrong = 0;
    for (int k = 0; k < 20000; ++k) {
      const Point direction(random.normal(), random.normal(), random.normal());
      const double best = leastAngleCosine(sphere, direction, vpViewSphere::size(level));
      const std::size_t found = sphere.nearest(direction, level);
      wrong += found >= vpViewSphere::size(level) || sphere.directionOf(found).dot(direction) < best ? 1 : 0;
    }
    CHECK(wrong == 0);
  }
}

TEST_CASE("A direction is nearest to itself, and the corners and edges of a cube around the sphere have one")
{
  const vpViewSphere sphere = boxSphere(4);
  for (unsigned int level = 0; level <= 4; ++level) {
    for (std::size_t i = 0; i < vpViewSphere::size(level); ++i) {
      REQUIRE(sphere.nearest(7. * sphere.directionOf(i), level) == i);
    }
    for (const double x : {-1., 0., 1.}) {
      for (const double y : {-1., 0., 1.}) {
        for (const double z : {-1., 0., 1.}) {
          const Point direction(x, y, z);
          const double best = leastAngleCosine(sphere, direction, vpViewSphere::size(level));
          const std::size_t found = sphere.nearest(1e-200 * direction, level);
          CHECK(sphere.directionOf(found).dot(direction) > best - 1e-12);
        }
      }
    }
  }
}

TEST_CASE("A direction without length has an answer")
{
  const vpViewSphere sphere = boxSphere(2);
  CHECK(sphere.nearest(Point(0., 0., 0.)) == 0);
  CHECK(sphere.nearest(Point(std::nan(""), 1., 0.)) == 0);
  CHECK(sphere.nearest(Point(1., HUGE_VAL, 0.)) == 0);
}

TEST_CASE("The camera of a pose is looked for around the middle of the box")
{
  const vpViewSphere sphere = boxSphere(3);
  vpPoseRandom random(2);
  for (int k = 0; k < 1000; ++k) {
    const Point direction(random.normal(), random.normal(), random.normal());
    const vpHomogeneousMatrix cMo = lookFrom(direction, 0.2 + random.uniform(), 6. * random.uniform(), centre);
    REQUIRE(sphere.nearest(cMo) == sphere.nearest(direction));
  }
  for (std::size_t i = 0; i < sphere.size(); ++i) {
    REQUIRE(sphere.nearest(sphere.poseOf(i)) == i);
  }
}

TEST_CASE("Every virtual camera sees all of the object, upright and in the middle")
{
  for (const double distance : {1.001, 4., 900.}) {
    vpViewSphereOptions options;
    options.level = 2;
    options.distance = distance;
    const vpTrackedModel box = build(boxPolygons(Point(0.1, 0.08, 0.06), centre));
    const vpViewSphere sphere(std::make_shared<const vpTrackedModel>(box), options, nullptr);
    Looker looker(box);
    looker.cam = sphere.camera();
    for (std::size_t i = 0; i < sphere.size(); ++i) {
      CAPTURE(distance, i);
      looker.look(sphere.poseOf(i));
      REQUIRE((looker.centre() - centre - distance * box.diameter() * sphere.directionOf(i)).norm() < 1e-9);
      REQUIRE((looker.project(centre) - Pixel(159.5, 159.5)).norm() < 1e-6);
      REQUIRE(looker.project(centre + Point(0., 0., 0.01)).y() < 159.5 + 1e-6);
      for (const Point &corner : box.vertices()) {
        REQUIRE((looker.project(corner) - Pixel(159.5, 159.5)).norm() < 116.);
      }
    }
  }
}

TEST_CASE("Looking for a direction allocates nothing")
{
  const vpViewSphere sphere = boxSphere(4);
  std::size_t sum = 0;
  const std::size_t before = countAllocations::allocations;
  for (int k = 0; k < 1000; ++k) {
    sum += sphere.nearest(Point(std::sin(k), std::cos(3. * k), 0.5));
  }
  CHECK(countAllocations::allocations == before);
  CHECK(sum > 0);
}

TEST_CASE("A direction or level that is not there is refused with its number")
{
  const vpViewSphere sphere = boxSphere(2);
  CHECK_THROWS_WITH(sphere.directionOf(162), ContainsSubstring("no view 162"));
  CHECK_THROWS_WITH(sphere.poseOf(162), ContainsSubstring("only 162 views"));
  CHECK_THROWS_WITH(sphere.nearest(Point(1., 0., 0.), 3), ContainsSubstring("levels up to 2, not 3"));
}
