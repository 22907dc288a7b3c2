// SPDX-License-Identifier: GPL-2.0-or-later
#include <catchMain.h>

#include "modelShapes.h"
#include "viewChecks.h"

using namespace modelShapes;
using namespace viewChecks;

namespace {
const Point circleCentre(0.01, 0.02, 0.03);
const Point circleNormal = Point(0.3, -0.2, 1.).normalized();
const double circleRadius = 0.05;

void addCircle(vpTrackedModelBuilder &builder, const Point &centre, const Point &normal, double radius)
{
  const Point x = normal.unitOrthogonal();
  builder.addCircle(centre, centre + 0.3 * x, centre + 0.2 * normal.cross(x), radius);
}

vpTrackedModel circle()
{
  vpTrackedModelBuilder builder;
  addCircle(builder, circleCentre, circleNormal, circleRadius);
  return builder.build("circle");
}

const Point axisStart(0.02, -0.03, -0.05);
const Point axisEnd(0.03, 0.01, 0.06);
const double cylinderRadius = 0.025;

vpTrackedModel cylinder(bool circles)
{
  vpTrackedModelBuilder builder;
  builder.addCylinder(axisStart, axisEnd, cylinderRadius);
  if (circles) {
    const Point axis = (axisEnd - axisStart).normalized();
    addCircle(builder, axisEnd, axis, cylinderRadius);
    addCircle(builder, axisStart, -axis, cylinderRadius);
  }
  return builder.build("cylinder");
}

//! The largest errors of the points of a circle: place, direction, and parameter against the angle between points.
void checkPlaces(const Looker &looker)
{
  REQUIRE(!looker.points().empty());
  const vpControlPoint &first = looker.points().front();
  const Point x = (first.position - circleCentre).normalized();
  const Point y = circleNormal.cross(x);
  double worst = 0.;
  double worstDirection = 0.;
  double worstParameter = 0.;
  for (const vpControlPoint &point : looker.points()) {
    const Point radial = point.position - circleCentre;
    worst = std::max({worst, std::fabs(radial.norm() - circleRadius), std::fabs(radial.dot(circleNormal))});
    worstDirection = std::max(worstDirection, (point.direction - circleNormal.cross(radial).normalized()).norm());
    const double angle = std::atan2(radial.dot(y), radial.dot(x));
    const double error = point.parameter - first.parameter - angle / (2. * M_PI);
    worstParameter = std::max(worstParameter, std::fabs(error - std::round(error)));
  }
  CHECK(worst < 1e-12);
  CHECK(worstDirection < 1e-9);
  CHECK(worstParameter < 1e-9);
}
} // namespace

TEST_CASE("A line is seen from all sides")
{
  vpTrackedModelBuilder builder;
  const Point start(-0.05, 0.01, 0.);
  const Point end(0.04, 0.02, 0.03);
  builder.addLine(start, end);
  Looker looker(builder.build("line"));
  for (const Point &direction : {Point(0., 0., 1.), Point(0., 0.2, -1.), Point(0.3, 1., 0.), Point(0.1, -1., 0.2)}) {
    const vpModelView &view = looker.look(lookFrom(direction, 0.4));
    REQUIRE(view.contours().size() == 1);
    CHECK(view.contours()[0].straight);
    CHECK(projectionError(looker) < 1e-9);
    CHECK(normalError(looker) < 1e-6);
    const double length = (looker.project(start) - looker.project(end)).norm();
    CHECK(view.contours()[0].count * view.contours()[0].step == Approx(length).epsilon(1e-9));
    for (const vpControlPoint &point : view.points()) {
      CHECK((point.position - start - point.parameter * (end - start)).norm() < 1e-12);
      CHECK(point.kind == vpEdgeKind::INNER);
      CHECK(point.edge == 0);
    }
  }
  // Along the line of sight it is a dot, which has no direction.
  CHECK(looker.look(lookFrom(end - start, 0.4, 0., start)).points().empty());
}

TEST_CASE("A box hides the part of a line behind it")
{
  vpTrackedModelBuilder builder;
  add(builder, boxPolygons(Point(0.04, 0.04, 0.04)));
  builder.addLine(Point(-0.06, 0., -0.05), Point(0.06, 0., -0.05));
  Looker looker(builder.build("line behind a box"));
  const vpModelView &view = looker.look(lookFrom(Point(0., 0., 1.), 0.4));
  const int line = static_cast<int>(looker.model().edges().size()) - 1;
  REQUIRE(looker.model().edges()[static_cast<std::size_t>(line)].faceCount == 0);
  // The front side, 0.38 m away, hides half of its width in 0.45 m.
  const double hidden = 0.02 / 0.38 * 0.45;
  std::vector<double> nearest(2, HUGE_VAL);
  for (const vpControlPoint &point : view.points()) {
    if (point.edge == line) {
      CHECK(std::fabs(point.position.x()) > hidden - 0.003);
      double &distance = nearest[point.position.x() > 0. ? 1 : 0];
      distance = std::min(distance, std::fabs(point.position.x()));
    }
  }
  CHECK(nearest[0] < hidden + 0.005);
  CHECK(nearest[1] < hidden + 0.005);
}

TEST_CASE("Control points of a circle lie exactly on it and go all around")
{
  Looker looker(circle());
  for (const double distance : {0.2, 0.5, 3.}) {
    for (const Point &direction : {Point(0.3, -0.2, 1.), Point(1., 0.3, 0.7), Point(-0.2, 1., 0.5)}) {
      CAPTURE(distance, direction);
      const vpModelView &view = looker.look(lookFrom(direction, distance, 0.3, circleCentre));
      checkPlaces(looker);
      CHECK(projectionError(looker) < 1e-9);
      CHECK(normalError(looker) < 1e-6);
      REQUIRE(view.contours().size() == 1);
      CHECK_FALSE(view.contours()[0].straight);
      double perimeter = 0.;
      for (std::size_t i = 0; i < view.points().size(); ++i) {
        const std::size_t next = (i + 1) % view.points().size();
        const double gap = (view.points()[i].pixel - view.points()[next].pixel).norm();
        // The step is counted along the curve: at the ends of a narrow ellipse the straight way is shorter.
        CHECK(gap < 1.02 * view.contours()[0].step);
        CHECK(gap > 0.75 * view.contours()[0].step);
        perimeter += gap;
      }
      CHECK(perimeter > 0.95 * view.contours()[0].count * view.contours()[0].step);
    }
  }
  CHECK(looker.look(lookFrom(-circleNormal, 0.5)).points().empty());
  CHECK(looker.look(lookFrom(circleNormal, -0.5)).points().empty());
}

TEST_CASE("A circle partly outside the image stays inside it")
{
  Looker looker(circle());
  looker.options.border = 0.;
  const vpHomogeneousMatrix aside(-0.28, 0.01, 0., 0., 0., 0.);
  looker.look(aside * lookFrom(circleNormal, 0.5, 0., circleCentre));
  checkPlaces(looker);
  CHECK(contoursHoldAllPoints(looker.view()));
  for (const vpControlPoint &point : looker.points()) {
    CHECK(point.pixel.x() >= 0.);
  }
  // The left end of the circle is cut off.
  CHECK(nearestPoint(looker.view(), Pixel(0., looker.points().front().pixel.y())) < 60.);
  CHECK(static_cast<double>(looker.points().size()) * looker.view().contours()[0].step <
        2. * M_PI * circleRadius * 600. / 0.5);
}

TEST_CASE("A circle and a cylinder next to the camera do no harm")
{
  Looker looker(GENERATE(false, true) ? circle() : cylinder(true));
  for (int i = 0; i < 60; ++i) {
    looker.look(lookFrom(Point(std::cos(i), std::sin(1.7 * i), std::sin(i)), 0.002 * i, i));
    CHECK(projectionError(looker) < 1e-6);
    for (const vpControlPoint &point : looker.points()) {
      CHECK(point.normal.allFinite());
      CHECK(looker.toCamera(point.position).z() >= looker.options.nearDistance - 1e-9);
    }
  }
}

TEST_CASE("On a cylinder's limbs the surface is perpendicular to the line of sight")
{
  Looker looker(cylinder(GENERATE(false, true)));
  const Point axis = (axisEnd - axisStart).normalized();
  for (const Point &direction : {Point(1., 0.2, 0.), Point(-0.3, 1., 0.3), Point(0.6, 0.2, 1.)}) {
    looker.look(lookFrom(direction, 0.3, 0.5));
    CHECK(projectionError(looker) < 1e-9);
    CHECK(normalError(looker) < 1e-6);
    CHECK(looker.view().hasSlidingRims());
    std::vector<int> count(2, 0);
    for (const vpControlPoint &point : looker.points()) {
      if (point.edge >= 2) {
        CHECK_FALSE(point.slides);
        continue;
      }
      ++count[static_cast<std::size_t>(point.edge)];
      const Point radial = point.position - axisStart - axis * axis.dot(point.position - axisStart);
      const Point sight = (point.position - looker.centre()).normalized();
      CHECK(std::fabs(radial.norm() - cylinderRadius) < 1e-12);
      CHECK(std::fabs(radial.normalized().dot(sight)) < 1e-9);
      CHECK((point.direction - axis).norm() < 1e-12);
      CHECK((axisStart + radial + point.parameter * (axisEnd - axisStart) - point.position).norm() < 1e-12);
      CHECK(point.slides);
      CHECK(point.kind == vpEdgeKind::SILHOUETTE);
      CHECK(point.normal.dot(looker.project(point.position + 0.001 * radial) - point.pixel) > 0.);
    }
    CHECK(count[0] > 10);
    CHECK(count[1] > 10);
  }
}

TEST_CASE("From inside a cylinder or along its axis no limb is seen")
{
  Looker looker(cylinder(false));
  const Point axis = (axisEnd - axisStart).normalized();
  for (const double height : {-0.3, 0.02, 0.05, 0.4}) {
    const Point camera = axisStart + height * axis + 0.9 * cylinderRadius * axis.unitOrthogonal();
    for (const Point &direction : {Point(1., 0., 0.), Point(0., 1., 0.), axis, Point(-axis)}) {
      CHECK(looker.look(lookFrom(direction, 0., 0., camera)).points().empty());
    }
  }
}

TEST_CASE("Of a cylinder's two circles the one that faces the camera is seen")
{
  Looker looker(cylinder(true));
  CHECK(looker.view().edgeNames() == 4);
  for (const int end : {0, 1}) {
    const Point axis = (axisEnd - axisStart).normalized() * (end == 0 ? 1. : -1.);
    const Point centre = end == 0 ? axisEnd : axisStart;
    looker.look(lookFrom(axis + 0.8 * axis.unitOrthogonal(), 0.3));
    int circle = 0;
    for (const vpControlPoint &point : looker.points()) {
      if (point.edge >= 2) {
        ++circle;
        CHECK(point.edge == 2 + end);
        CHECK(std::fabs((point.position - centre).norm() - cylinderRadius) < 1e-12);
        const bool onMantle = point.normal.dot(looker.project(centre - axis) - looker.project(centre)) > 0.;
        const bool farFromLimbs =
            std::fabs((point.position - centre).normalized().dot(looker.sight(point.pixel).cross(axis).normalized())) <
            0.8;
        CHECK((!farFromLimbs || onMantle == (point.kind == vpEdgeKind::INNER)));
      }
    }
    CHECK(circle > 20);
  }
}
