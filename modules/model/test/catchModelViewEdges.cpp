// SPDX-License-Identifier: GPL-2.0-or-later
#include <catchMain.h>

#include "modelShapes.h"
#include "viewChecks.h"

using namespace modelShapes;
using namespace viewChecks;

namespace {
const Point boxSize(0.1, 0.08, 0.06);
const std::vector<Point> cornerDirections = {Point(1., 1., 1.), Point(-1., 0.8, 1.2), Point(1., -0.7, -0.9),
                                             Point(-0.9, -1.1, -1.)};

vpTrackedModel box(bool mesh)
{
  return mesh ? build(boxTriangles(boxSize, 3)) : build(boxPolygons(boxSize));
}

const Point &edgeEnd(const Looker &looker, int edge, std::size_t end)
{
  const vpModelEdge &e = looker.model().edges()[static_cast<std::size_t>(edge)];
  return looker.model().vertices()[static_cast<std::size_t>(e.vertex[end])];
}

//! How many of the two sides of the box that meet at an edge face the camera.
int sidesSeen(const Looker &looker, int edge)
{
  const Point middle = 0.5 * (edgeEnd(looker, edge, 0) + edgeEnd(looker, edge, 1));
  int seen = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const double half = 0.5 * boxSize[axis];
    if (std::fabs(std::fabs(middle[axis]) - half) < 1e-9) {
      seen += looker.centre()[axis] * (middle[axis] > 0. ? 1. : -1.) > half ? 1 : 0;
    }
  }
  return seen;
}

//! Distance of a pixel from the line through the projected ends of an edge.
double distanceFromEdge(const Looker &looker, int edge, const Pixel &pixel)
{
  const Pixel a = looker.project(edgeEnd(looker, edge, 0));
  const Pixel along = (looker.project(edgeEnd(looker, edge, 1)) - a).normalized();
  return std::fabs(along.x() * (pixel - a).y() - along.y() * (pixel - a).x());
}
} // namespace

TEST_CASE("Control points of a box lie on its projected edges")
{
  const bool mesh = GENERATE(false, true);
  const double step = GENERATE(1.5, 4., 9.);
  CAPTURE(mesh, step);
  Looker looker(box(mesh));
  looker.options.sampleStep = step;
  for (const Point &direction : cornerDirections) {
    looker.look(lookFrom(direction, 0.5, direction.x()));
    REQUIRE(looker.points().size() > 50);
    CHECK(projectionError(looker) < 1e-9);
    double worst = 0.;
    double worstPlace = 0.;
    double worstDirection = 0.;
    for (const vpControlPoint &point : looker.points()) {
      worst = std::max(worst, distanceFromEdge(looker, point.edge, point.pixel));
      const Point &a = edgeEnd(looker, point.edge, 0);
      const Point along = edgeEnd(looker, point.edge, 1) - a;
      worstPlace = std::max(worstPlace, (point.position - a - point.parameter * along).norm());
      worstDirection = std::max(worstDirection, (point.direction - along.normalized()).norm());
      CHECK_FALSE(point.slides);
    }
    CHECK(worst < 1e-6);
    CHECK(worstPlace < 1e-12);
    CHECK(worstDirection < 1e-12);
  }
}

TEST_CASE("A corner of a box shows nine edges, six of them silhouettes")
{
  const bool mesh = GENERATE(false, true);
  CAPTURE(mesh);
  Looker looker(box(mesh));
  for (const Point &direction : cornerDirections) {
    const vpModelView &view = looker.look(lookFrom(direction, 0.5, direction.y()));
    REQUIRE(view.contours().size() == 9);
    int inner = 0;
    for (const vpContour &contour : view.contours()) {
      const vpControlPoint &first = view.points()[static_cast<std::size_t>(contour.first)];
      const int sides = sidesSeen(looker, first.edge);
      REQUIRE(sides > 0);
      inner += sides == 2 ? 1 : 0;
      for (int i = contour.first; i < contour.first + contour.count; ++i) {
        const vpControlPoint &point = view.points()[static_cast<std::size_t>(i)];
        REQUIRE(point.edge == first.edge);
        REQUIRE(point.kind == (sides == 2 ? vpEdgeKind::INNER : vpEdgeKind::SILHOUETTE));
      }
    }
    CHECK(inner == 3);
    CHECK(std::count(view.facesSeen().begin(), view.facesSeen().end(), 1) == 3);
  }
  CHECK(looker.view().edgeNames() == 12);
  CHECK_FALSE(looker.view().hasSlidingRims());
}

TEST_CASE("Edges of the sides that are turned away have no control points")
{
  Looker looker(box(false));
  // Straight at one side: its four edges alone.
  const vpModelView &view = looker.look(lookFrom(Point(0., 0., 1.), 0.4, 0.2));
  CHECK(view.contours().size() == 4);
  for (const vpControlPoint &point : view.points()) {
    CHECK(point.position.z() == Approx(0.03));
    CHECK(point.kind == vpEdgeKind::SILHOUETTE);
  }
}

TEST_CASE("Normals are perpendicular to the edges, and silhouettes' point away from the box")
{
  Looker looker(box(GENERATE(false, true)));
  for (const Point &direction : cornerDirections) {
    const vpModelView &view = looker.look(lookFrom(direction, 0.4, 2. * direction.z(), Point(0.02, 0.03, 0.)));
    CHECK(normalError(looker) < 1e-6);
    const Pixel centre = looker.project(Point::Zero());
    double least = 1.;
    for (const vpControlPoint &point : view.points()) {
      CHECK(std::fabs(point.normal.norm() - 1.) < 1e-12);
      CHECK(std::fabs(point.side) == exactly(1.));
      if (point.kind == vpEdgeKind::SILHOUETTE) {
        least = std::min(least, point.normal.dot((point.pixel - centre).normalized()));
      }
    }
    CHECK(least > 0.1);
  }
}

TEST_CASE("Control points are spread evenly over an edge")
{
  const double step = GENERATE(0.5, 4., 11.);
  CAPTURE(step);
  Looker looker(box(false));
  looker.options.sampleStep = step;
  const vpModelView &view = looker.look(lookFrom(Point(1., 0.6, 0.8), 0.35, 0.4));
  CHECK(contoursHoldAllPoints(view));
  CHECK(arcLengthError(view) < 1e-6);
  double worst = 0.;
  for (const vpContour &contour : view.contours()) {
    CHECK(contour.straight);
    CHECK(contour.step >= step);
    CHECK(contour.step < 2. * step);
    const auto first = view.points().begin() + contour.first;
    for (auto point = first + 1; point != first + contour.count; ++point) {
      worst = std::max(worst, std::fabs((point->pixel - (point - 1)->pixel).norm() - contour.step));
    }
    const double length =
        (looker.project(edgeEnd(looker, first->edge, 0)) - looker.project(edgeEnd(looker, first->edge, 1))).norm();
    CHECK(contour.count * contour.step == Approx(length).epsilon(1e-9));
  }
  CHECK(worst < 1e-6);
}
