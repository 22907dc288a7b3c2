// SPDX-License-Identifier: GPL-2.0-or-later
#include <catchMain.h>

#include "modelShapes.h"
#include "viewChecks.h"

#include <random>

using namespace modelShapes;
using namespace viewChecks;

namespace {
const double radius = 0.05;

std::vector<Triangle> dome()
{
  std::vector<Triangle> triangles;
  for (const Triangle &triangle : sphereTriangles(radius, 40, 80)) {
    if (triangle[0].z() + triangle[1].z() + triangle[2].z() > 0.) {
      triangles.push_back(triangle);
    }
  }
  return triangles;
}

//! True where every control point of one view has one of the other within a distance in pixels.
bool covers(const vpModelView &view, const std::vector<vpControlPoint> &points, double distance)
{
  return std::all_of(points.begin(), points.end(),
                     [&](const vpControlPoint &point) { return nearestPoint(view, point.pixel) < distance; });
}

//! Every vertex moved by up to 0.5 % of the diameter, in the same way in all triangles that share it.
std::vector<Triangle> noisy(std::vector<Triangle> triangles)
{
  for (Triangle &triangle : triangles) {
    for (Point &corner : triangle) {
      const Point cell = (corner / 1e-5).array().round();
      std::mt19937 random(static_cast<unsigned int>(cell.dot(Point(7919., 104729., 1299709.))));
      const auto uniform = [&random] { return static_cast<double>(random()) / 2147483647.5 - 1.; };
      const Point noise(uniform(), uniform(), uniform());
      corner += 0.005 * 2. * radius * noise;
    }
  }
  return triangles;
}

const std::vector<Point> directions = {Point(0.2, 0.1, 1.), Point(1., 0.3, 0.4), Point(-0.4, -1., -0.7),
                                       Point(0.3, -0.2, -1.)};
} // namespace

TEST_CASE("An open dome shows its border and its rim from both sides")
{
  Looker looker(build(dome()));
  REQUIRE_FALSE(looker.model().faces()[0].oriented);
  for (const Point &direction : directions) {
    CAPTURE(direction);
    const vpModelView &view = looker.look(lookFrom(direction, 0.3, 0.4));
    CHECK(contoursHoldAllPoints(view));
    CHECK(projectionError(looker) < 1e-9);
    CHECK(normalError(looker) < 1e-5);
    int visible = 0;
    int missing = 0;
    for (int i = 0; i < 360; ++i) {
      const double angle = i * M_PI / 180.;
      const Point onBorder(radius * std::cos(angle), radius * std::sin(angle), 0.);
      const bool isFront = looker.centre().z() < 0. || onBorder.dot(looker.centre()) > 0.1 * radius * 0.3;
      if (isFront) {
        ++visible;
        missing += nearestPoint(view, looker.project(onBorder)) > 4.5 ? 1 : 0;
      }
    }
    CHECK(visible > 100);
    CHECK(missing == 0);
    int hidden = 0;
    for (const vpControlPoint &point : view.points()) {
      hidden += isWellHidden(looker, point.position, 5., 0.002) ? 1 : 0;
    }
    CHECK(hidden == 0);
  }
}

TEST_CASE("Triangles wound the wrong way round change nothing")
{
  std::vector<Triangle> triangles = sphereTriangles(radius, 30, 60);
  const std::vector<Triangle> cap = boxTriangles(Point(0.03, 0.03, 0.03), 1, Point(0.03, 0., 0.05));
  triangles.insert(triangles.end(), cap.begin(), cap.end());
  Looker good(build(triangles));
  std::mt19937 random(5);
  for (Triangle &triangle : triangles) {
    if (random() % 3 == 0) {
      std::swap(triangle[0], triangle[1]);
    }
  }
  Looker repaired(build(triangles));
  CHECK(repaired.model().report().flippedTriangles > 100);
  for (const Point &direction : directions) {
    good.look(lookFrom(direction, 0.4));
    repaired.look(lookFrom(direction, 0.4));
    REQUIRE(good.points().size() > 50);
    CHECK(repaired.points().size() == good.points().size());
    CHECK(covers(good.view(), repaired.points(), 2.5));
    CHECK(covers(repaired.view(), good.points(), 2.5));
  }
}

TEST_CASE("What is smaller than the step has no control points")
{
  vpTrackedModelBuilder builder;
  add(builder, boxPolygons(Point(0.1, 0.1, 0.1)));
  add(builder, boxPolygons(Point(0.001, 0.001, 0.001), Point(0., 0., 0.0505)));
  Looker looker(builder.build("box with a knob"));
  const vpModelView &view = looker.look(lookFrom(Point(0.8, 0.9, 1.), 0.5));
  CHECK(view.contours().size() >= 9);
  for (const vpControlPoint &point : view.points()) {
    CHECK(point.edge < 12);
  }
  // Of the whole object a few pixels or less are left.
  CHECK(looker.look(lookFrom(Point(0.8, 0.9, 1.), 30.)).points().empty());
  CHECK(looker.look(lookFrom(Point(0.8, 0.9, 1.), 5000.)).points().empty());
}

TEST_CASE("The outline of a noisy scan is covered")
{
  const int rings = GENERATE(15, 30, 60);
  CAPTURE(rings);
  Looker looker(build(noisy(sphereTriangles(radius, rings, 2 * rings))));
  for (const Point &direction : directions) {
    CAPTURE(direction);
    const double distance = 0.3;
    const vpModelView &view = looker.look(lookFrom(direction, distance));
    CHECK(contoursHoldAllPoints(view));
    CHECK(projectionError(looker) < 1e-9);
    for (const vpControlPoint &point : view.points()) {
      REQUIRE(point.pixel.allFinite());
      REQUIRE(point.direction.allFinite());
      REQUIRE(std::fabs(point.normal.norm() - 1.) < 1e-9);
    }
    // The sphere's outline: a circle around the centre of the image's own axes, as the camera looks at its centre.
    const double tangent = radius / std::sqrt(distance * distance - radius * radius);
    int covered = 0;
    for (int i = 0; i < 360; ++i) {
      const double angle = i * M_PI / 180.;
      const Pixel onOutline =
          looker.project(Point::Zero()) + tangent * Pixel(600. * std::cos(angle), 610. * std::sin(angle));
      const double nearest = nearestPoint(
          view, onOutline, [](const vpControlPoint &point) { return point.kind == vpEdgeKind::SILHOUETTE; });
      covered += nearest < 5. ? 1 : 0;
    }
    CHECK(covered > 0.95 * 360);
  }
}
