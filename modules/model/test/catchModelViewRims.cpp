// SPDX-License-Identifier: GPL-2.0-or-later
#include <catchMain.h>

#include "modelShapes.h"
#include "viewChecks.h"

using namespace modelShapes;
using namespace viewChecks;

namespace {
const double sphereRadius = 0.05;

//! Signed distance of a pixel from the outline of the sphere, outside > 0: the cone that touches the sphere cuts it
//! out.
double distanceFromOutline(const Looker &looker, const Pixel &pixel)
{
  const Point toCentre = -looker.centre();
  const double halfAngle = std::asin(sphereRadius / toCentre.norm());
  const auto excess = [&](const Pixel &p) {
    const Point ray = looker.sight(p);
    return std::atan2(ray.cross(toCentre).norm(), ray.dot(toCentre)) - halfAngle;
  };
  const double h = 0.01;
  const Pixel gradient((excess(pixel + Pixel(h, 0.)) - excess(pixel - Pixel(h, 0.))) / (2. * h),
                       (excess(pixel + Pixel(0., h)) - excess(pixel - Pixel(0., h))) / (2. * h));
  return excess(pixel) / gradient.norm();
}

//! Largest distance in pixels of two neighbouring control points, in the order of their angles around a pixel.
double largestGapAround(const std::vector<vpControlPoint> &points, const Pixel &centre)
{
  std::vector<std::pair<double, Pixel>> byAngle;
  for (const vpControlPoint &point : points) {
    const Pixel from = point.pixel - centre;
    byAngle.emplace_back(std::atan2(from.y(), from.x()), point.pixel);
  }
  std::sort(byAngle.begin(), byAngle.end(), [](const auto &a, const auto &b) { return a.first < b.first; });
  double gap = 0.;
  for (std::size_t i = 0; i < byAngle.size(); ++i) {
    gap = std::max(gap, (byAngle[i].second - byAngle[(i + 1) % byAngle.size()].second).norm());
  }
  return gap;
}
} // namespace

TEST_CASE("The rim of a fine sphere is the outline of the sphere")
{
  Looker looker(build(sphereTriangles(sphereRadius, 60, 120)));
  for (const double distance : {0.15, 0.3, 1.}) {
    for (const Point &direction : {Point(0.2, 0.1, 1.), Point(1., 0.3, 0.1), Point(-0.4, -1., -0.7)}) {
      CAPTURE(distance, direction);
      const vpModelView &view = looker.look(lookFrom(direction, distance, distance));
      CHECK(view.contours().size() == 1);
      CHECK(contoursHoldAllPoints(view));
      CHECK(arcLengthError(view) < 1e-6);
      CHECK(projectionError(looker) < 1e-9);
      CHECK(normalError(looker) < 1e-5);
      CHECK(view.hasSlidingRims());
      double worst = 0.;
      double leastRadial = 1.;
      double leastOutward = 1.;
      const Pixel centre = looker.project(Point::Zero());
      for (const vpControlPoint &point : view.points()) {
        worst = std::max(worst, std::fabs(distanceFromOutline(looker, point.pixel)));
        // Perpendicular to edge and line of sight is the surface's normal.
        const Point normal = point.direction.cross(point.position - looker.centre()).normalized();
        leastRadial = std::min(leastRadial, std::fabs(normal.dot(point.position.normalized())));
        leastOutward = std::min(leastOutward, point.normal.dot((point.pixel - centre).normalized()));
        CHECK(point.slides);
        CHECK(point.edge == -1);
        CHECK(point.kind == vpEdgeKind::SILHOUETTE);
      }
      CHECK(worst < 0.3);
      CHECK(leastRadial > 0.999);
      CHECK(leastOutward > 0.995);
      CHECK(largestGapAround(view.points(), centre) < 1.1 * view.contours()[0].step);
    }
  }
}

TEST_CASE("The rim of a sphere partly outside the image goes to the border and no further")
{
  Looker looker(build(sphereTriangles(sphereRadius, 40, 80)));
  const vpHomogeneousMatrix aside(0.24, -0.18, 0., 0., 0., 0.);
  const vpModelView &view = looker.look(aside * lookFrom(Point(0.3, 0.2, 1.), 0.5));
  REQUIRE(view.points().size() > 10);
  double nearestToRight = HUGE_VAL;
  double nearestToTop = HUGE_VAL;
  for (const vpControlPoint &point : view.points()) {
    CHECK(std::fabs(distanceFromOutline(looker, point.pixel)) < 0.3);
    nearestToRight = std::min(nearestToRight, 637. - point.pixel.x());
    nearestToTop = std::min(nearestToTop, point.pixel.y() - 2.);
  }
  CHECK(nearestToRight >= 0.);
  CHECK(nearestToRight < 4.5);
  CHECK(nearestToTop >= 0.);
  CHECK(nearestToTop < 4.5);
}

TEST_CASE("A camera inside or behind a sphere sees no rim")
{
  Looker looker(build(sphereTriangles(sphereRadius, 20, 40)));
  CHECK(looker.look(vpHomogeneousMatrix(0.01, 0.02, 0.01, 0.1, 0.2, 0.3)).points().empty());
  CHECK(looker.look(vpHomogeneousMatrix(0., 0., -0.3, 0.1, 0.2, 0.3)).points().empty());
  CHECK(looker.look(vpHomogeneousMatrix(1., 0., 0.3, 0.1, 0.2, 0.3)).points().empty());
}

TEST_CASE("A cylinder mesh has two limbs, one whole end and half of the other one")
{
  const double radius = 0.03;
  const double height = 0.1;
  Looker looker(build(cylinderTriangles(radius, height, 64)));
  const vpModelView &view = looker.look(lookFrom(Point(0.9, 0.3, 0.6), 0.4, 0.3, Point(0., 0., 0.5 * height)));
  CHECK(contoursHoldAllPoints(view));
  CHECK(arcLengthError(view) < 1e-6);
  CHECK(projectionError(looker) < 1e-9);
  CHECK(normalError(looker) < 1e-5);
  CHECK(view.contours().size() <= 6);
  std::vector<double> length(3, 0.);
  for (const vpContour &contour : view.contours()) {
    const vpControlPoint &first = view.points()[static_cast<std::size_t>(contour.first)];
    const std::size_t part = first.slides ? 2 : (first.position.z() > 0.5 * height ? 1 : 0);
    length[part] += contour.count * contour.step;
    for (int i = contour.first; i < contour.first + contour.count; ++i) {
      const vpControlPoint &point = view.points()[static_cast<std::size_t>(i)];
      REQUIRE(point.slides == first.slides);
      if (point.slides) {
        const Point radial(point.position.x(), point.position.y(), 0.);
        const Point sight = (point.position - looker.centre()).normalized();
        CHECK(std::fabs(radial.normalized().dot(sight)) < 0.02);
        CHECK(point.kind == vpEdgeKind::SILHOUETTE);
        CHECK(point.normal.dot(looker.project(point.position + 0.1 * radial) - point.pixel) > 0.);
      } else {
        CHECK(std::fabs(point.position.z() - first.position.z()) < 1e-12);
      }
    }
  }
  // Lengths in the image of what is seen, from the closed forms of the rim's points.
  const auto arc = [&](double z, double from, double to) {
    double sum = 0.;
    for (int i = 0; i < 1000; ++i) {
      const double a = from + (to - from) * i / 1000.;
      const double b = from + (to - from) * (i + 1) / 1000.;
      sum += (looker.project(Point(radius * std::cos(a), radius * std::sin(a), z)) -
              looker.project(Point(radius * std::cos(b), radius * std::sin(b), z)))
                 .norm();
    }
    return sum;
  };
  const double azimuth = std::atan2(looker.centre().y(), looker.centre().x());
  const double half = std::acos(radius / std::hypot(looker.centre().x(), looker.centre().y()));
  CHECK(length[1] == Approx(arc(height, -M_PI, M_PI)).epsilon(0.02));
  // Where it meets the limbs, the hidden half runs so closely behind them that a little of it is taken for visible.
  const double visibleHalf = arc(0., azimuth - half, azimuth + half);
  CHECK(length[0] > 0.97 * visibleHalf);
  CHECK(length[0] < visibleHalf + 20.);
  double limbs = 0.;
  for (const double angle : {azimuth - half, azimuth + half}) {
    const Point foot(radius * std::cos(angle), radius * std::sin(angle), 0.);
    limbs += (looker.project(foot) - looker.project(foot + Point(0., 0., height))).norm();
  }
  CHECK(length[2] == Approx(limbs).epsilon(0.06));
}
