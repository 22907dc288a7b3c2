// SPDX-License-Identifier: GPL-2.0-or-later
#include <catchMain.h>

#include "modelShapes.h"
#include "viewChecks.h"

using namespace modelShapes;
using namespace viewChecks;

namespace {
const double ringRadius = 0.04;
const double tubeRadius = 0.015;

//! Outward normal of the torus around the z axis at two angles, around the ring and around the tube.
Point tubeNormal(double u, double v)
{
  return Point(std::cos(v) * std::cos(u), std::cos(v) * std::sin(u), std::sin(v));
}

Point tubePoint(double u, double v)
{
  return ringRadius * Point(std::cos(u), std::sin(u), 0.) + tubeRadius * tubeNormal(u, v);
}

//! Distance from the surface, positive outside.
double height(const Point &point)
{
  return std::hypot(point.head<2>().norm() - ringRadius, point.z()) - tubeRadius;
}

std::vector<Triangle> torusTriangles(int sectors, int sides)
{
  const auto at = [&](int i, int j) {
    return tubePoint(2. * M_PI * (i % sectors) / sectors, 2. * M_PI * (j % sides) / sides);
  };
  std::vector<Triangle> triangles;
  for (int i = 0; i < sectors; ++i) {
    for (int j = 0; j < sides; ++j) {
      triangles.push_back({{at(i, j), at(i + 1, j), at(i + 1, j + 1)}});
      triangles.push_back({{at(i, j), at(i + 1, j + 1), at(i, j + 1)}});
    }
  }
  return triangles;
}

double facing(const Looker &looker, double u, double v)
{
  return tubeNormal(u, v).dot(tubePoint(u, v) - looker.centre());
}

struct RimPoint
{
  double u;
  double v;
};

//! Where the surface is perpendicular to the line of sight and turns away from the camera along it, found on a grid.
std::vector<RimPoint> exactRim(const Looker &looker)
{
  std::vector<RimPoint> rim;
  for (int i = 0; i < 180; ++i) {
    const double u = 2. * M_PI * i / 180.;
    for (int j = 0; j < 360; ++j) {
      double low = 2. * M_PI * j / 360.;
      double high = 2. * M_PI * (j + 1) / 360.;
      const bool lowFaces = facing(looker, u, low) < 0.;
      if (lowFaces == (facing(looker, u, high) < 0.)) {
        continue;
      }
      while (high - low > 1e-9) {
        const double middle = 0.5 * (low + high);
        ((facing(looker, u, middle) < 0.) == lowFaces ? low : high) = middle;
      }
      rim.push_back({u, low});
    }
  }
  return rim;
}

//! Nothing is in front of the line of sight that passes the surface closely, 0.3 mm beside the rim.
bool isWellVisible(const Looker &looker, const RimPoint &rim)
{
  const Point outside = tubePoint(rim.u, rim.v) + 0.0003 * tubeNormal(rim.u, rim.v);
  const std::vector<Pixel> pixels = around(looker.project(outside), 5.);
  // Of the pixels around, those on the torus' side of the rim show the surface of the rim itself or farther ones.
  const double limit = looker.toCamera(outside).z() - 0.8 * tubeRadius;
  return looker.castRay(pixels[0]) > looker.toCamera(outside).z() &&
         std::all_of(pixels.begin(), pixels.end(), [&](const Pixel &pixel) { return looker.castRay(pixel) > limit; });
}

const std::vector<Point> directions = {Point(0., 0.6, 1.), Point(0.8, 0.1, 0.5), Point(-0.5, -0.6, -0.4),
                                       Point(0.05, 0.02, 1.), Point(1., 0.4, 0.05)};
} // namespace

TEST_CASE("Control points of a torus are on rims that can be seen")
{
  Looker looker(build(torusTriangles(80, 40)));
  for (const Point &direction : directions) {
    CAPTURE(direction);
    const vpModelView &view = looker.look(lookFrom(direction, 0.35, 0.2));
    REQUIRE(view.points().size() > 50);
    CHECK(contoursHoldAllPoints(view));
    CHECK(arcLengthError(view) < 1e-6);
    CHECK(projectionError(looker) < 1e-9);
    CHECK(normalError(looker) < 1e-5);
    double worst = 0.;
    int hidden = 0;
    int wrongSide = 0;
    int inHollow = 0;
    for (const vpControlPoint &point : view.points()) {
      const double u = std::atan2(point.position.y(), point.position.x());
      const double across = std::hypot(point.position.x(), point.position.y()) - ringRadius;
      const Point normal = tubeNormal(u, std::atan2(point.position.z(), across));
      worst = std::max(worst, std::fabs(normal.dot((point.position - looker.centre()).normalized())));
      hidden += isWellHidden(looker, point.position + 0.001 * normal, 5., 0.002) ? 1 : 0;
      wrongSide += point.normal.dot(looker.project(point.position + 0.001 * normal) - point.pixel) > 0. ? 0 : 1;
      // Before and behind a rim the line of sight is outside the tube, at a hollow's turning point inside.
      const Point ahead = 0.002 * (point.position - looker.centre()).normalized();
      inHollow += height(point.position + ahead) + height(point.position - ahead) < 2. * height(point.position) ? 1 : 0;
    }
    CHECK(inHollow == 0);
    CHECK(worst < 0.03);
    CHECK(hidden == 0);
    CHECK(wrongSide == 0);
  }
}

TEST_CASE("Every visible rim of a torus has control points")
{
  Looker looker(build(torusTriangles(80, 40)));
  for (const Point &direction : directions) {
    CAPTURE(direction);
    const vpModelView &view = looker.look(lookFrom(direction, 0.35, 0.2));
    int visible = 0;
    int missing = 0;
    for (const RimPoint &rim : exactRim(looker)) {
      if (isWellVisible(looker, rim)) {
        ++visible;
        missing += nearestPoint(view, looker.project(tubePoint(rim.u, rim.v))) > 6. ? 1 : 0;
      }
    }
    CHECK(visible > 50);
    CHECK(missing == 0);
  }
}

TEST_CASE("The near part of a torus covers the far part with an inner rim")
{
  Looker looker(build(torusTriangles(80, 40)));
  // So flat that the near side of the ring hides a part of the far side's inner rim.
  const vpModelView &view = looker.look(lookFrom(Point(1., 0.4, 0.3), 0.35, 0.2));
  const long inner = std::count_if(view.points().begin(), view.points().end(),
                                   [](const vpControlPoint &point) { return point.kind == vpEdgeKind::INNER; });
  CHECK(inner > 10);
  // From above, the hole shows the background: two closed rims.
  const vpModelView &above = looker.look(lookFrom(Point(0.05, 0.02, 1.), 0.35, 0.2));
  CHECK(above.contours().size() == 2);
  for (const vpControlPoint &point : above.points()) {
    CHECK(point.kind == vpEdgeKind::SILHOUETTE);
    const bool outer = point.position.head<2>().norm() > ringRadius;
    CHECK((point.normal.dot(point.pixel - looker.project(Point::Zero())) > 0.) == outer);
  }
}
