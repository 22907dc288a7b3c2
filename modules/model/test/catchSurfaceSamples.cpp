// SPDX-License-Identifier: GPL-2.0-or-later
#include "modelShapes.h"

#include <visp3/model/vpSurfaceSamples.h>

#include <catchMain.h>

#include <algorithm>
#include <array>
#include <cmath>

using modelShapes::Point;

namespace {
const Point boxSize(0.2, 0.12, 0.08);

//! The side of the box that a point lies on, as in modelShapes::boxPolygons(); -1 for none.
int sideOf(const Eigen::Vector3f &point, const Eigen::Vector3f &normal)
{
  for (int axis = 0; axis < 3; ++axis) {
    for (const double sign : {-1., 1.}) {
      const bool isOn = std::fabs(static_cast<double>(point[axis]) - 0.5 * sign * boxSize[axis]) < 1e-6;
      if (isOn && static_cast<double>(normal[axis]) * sign > 1. - 1e-6) {
        return 2 * axis + (sign > 0. ? 1 : 0);
      }
    }
  }
  return -1;
}

bool isSame(const vpSurfaceSample &a, const vpSurfaceSample &b)
{
  return a.position == b.position && a.normal == b.normal && a.seenFromBothSides == b.seenFromBothSides;
}
} // namespace

TEST_CASE("A box's sides have places in proportion to their areas, all on the surface", "[surface-samples]")
{
  const bool isMesh = GENERATE(false, true);
  const std::size_t count = GENERATE(1U, 7U, 500U);
  CAPTURE(isMesh, count);
  const vpTrackedModel model = isMesh ? modelShapes::build(modelShapes::boxTriangles(boxSize, 5))
                                      : modelShapes::build(modelShapes::boxPolygons(boxSize));
  const std::vector<vpSurfaceSample> samples = vpSampleSurface(model, count);
  REQUIRE(samples.size() == count);
  std::array<double, 6> found{};
  for (const vpSurfaceSample &sample : samples) {
    const int side = sideOf(sample.position, sample.normal);
    REQUIRE(side >= 0);
    REQUIRE((sample.position.cast<double>().cwiseAbs() - 0.5 * boxSize).maxCoeff() < 1e-6);
    CHECK_FALSE(sample.seenFromBothSides);
    found[static_cast<std::size_t>(side)] += 1.;
  }
  const Point areas(boxSize.y() * boxSize.z(), boxSize.x() * boxSize.z(), boxSize.x() * boxSize.y());
  for (std::size_t side = 0; side < 6; ++side) {
    const double expected =
        static_cast<double>(count) * areas[static_cast<Eigen::Index>(side / 2)] / (2. * areas.sum());
    // Each end of a stretch of the sequence may take or lose one; sides of a mesh may be in several stretches.
    CHECK(std::fabs(found[side] - expected) <= (isMesh ? 6. : 1.));
  }
}

TEST_CASE("Places are spread evenly within a face", "[surface-samples]")
{
  const std::size_t count = 400;
  const vpTrackedModel model = modelShapes::build(modelShapes::boxPolygons(boxSize));
  const std::vector<vpSurfaceSample> samples = vpSampleSurface(model, count);
  // About 4 x 4 of the 100 places on the side below: no quarter is without one.
  std::array<int, 16> cells{};
  for (const vpSurfaceSample &sample : samples) {
    if (sample.normal.z() < -0.9F) {
      const auto part = [](double x, double size) { return std::min(3, static_cast<int>(4. * (x / size + 0.5))); };
      const int at = 4 * part(static_cast<double>(sample.position.x()), boxSize.x()) +
                     part(static_cast<double>(sample.position.y()), boxSize.y());
      ++cells[static_cast<std::size_t>(at)];
    }
  }
  CHECK(*std::min_element(cells.begin(), cells.end()) >= 3);
  CHECK(*std::max_element(cells.begin(), cells.end()) <= 14);
}

TEST_CASE("The same model has the same places", "[surface-samples]")
{
  const auto sampled = [] {
    return vpSampleSurface(modelShapes::build(modelShapes::sphereTriangles(0.05, 24, 48)), 300);
  };
  const std::vector<vpSurfaceSample> first = sampled();
  const std::vector<vpSurfaceSample> second = sampled();
  REQUIRE(first.size() == 300);
  REQUIRE(second.size() == 300);
  CHECK(std::equal(first.begin(), first.end(), second.begin(), isSame));
}

TEST_CASE("No places where none are wanted, or where there is no surface", "[surface-samples]")
{
  CHECK(vpSampleSurface(modelShapes::build(modelShapes::boxPolygons(boxSize)), 0).empty());
  vpTrackedModelBuilder builder;
  builder.addLine(Point(0., 0., 0.), Point(0.1, 0., 0.));
  const vpTrackedModel wire = builder.build("wire");
  REQUIRE(wire.triangles().empty());
  CHECK(vpSampleSurface(wire, 100).empty());
}

TEST_CASE("Places on an open surface are seen from both sides", "[surface-samples]")
{
  const modelShapes::Polygon sheet = modelShapes::boxPolygons(boxSize).front();
  const vpTrackedModel model = modelShapes::build(modelShapes::gridTriangles(sheet, 2));
  REQUIRE_FALSE(model.faces()[0].oriented);
  const std::vector<vpSurfaceSample> samples = vpSampleSurface(model, 20);
  REQUIRE(samples.size() == 20);
  CHECK(std::all_of(samples.begin(), samples.end(), [](const vpSurfaceSample &s) { return s.seenFromBothSides; }));
}
