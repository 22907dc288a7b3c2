// SPDX-License-Identifier: GPL-2.0-or-later
#include <catchMain.h>

#include "sphereShapes.h"
#include "viewChecks.h"

#include <algorithm>
#include <string>

using namespace modelShapes;
using namespace sphereShapes;
using namespace viewChecks;

namespace {
//! Looks with the sphere's own camera and options.
class SphereLooker : public Looker
{
public:
  explicit SphereLooker(const vpViewSphere &sphere) : Looker(sphere.model())
  {
    cam = sphere.camera();
    width = height = vpViewSphere::imageSize;
    options = sphere.options().view;
  }
};

bool isSame(const vpSphereViewPoint &point, const vpControlPoint &control)
{
  return point.position == control.position.cast<float>() && point.direction == control.direction.cast<float>() &&
         point.side == exactly(static_cast<float>(control.side)) &&
         point.silhouette == (control.kind == vpEdgeKind::SILHOUETTE);
}

//! For each point of a view, the place in a list of the control point that it is; the list's size where it is none.
std::vector<std::size_t> origins(const vpSphereView &view, const std::vector<vpControlPoint> &points)
{
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < view.size(); ++i) {
    const vpSphereViewPoint point = view.point(i);
    const auto found = std::find_if(points.begin(), points.end(),
                                    [&](const vpControlPoint &control) { return isSame(point, control); });
    places.push_back(static_cast<std::size_t>(found - points.begin()));
  }
  return places;
}

double distanceToEdge(const vpTrackedModel &model, const vpModelEdge &edge, const Point &oX)
{
  const Point &a = model.vertices()[static_cast<std::size_t>(edge.vertex[0])];
  const Point along = model.vertices()[static_cast<std::size_t>(edge.vertex[1])] - a;
  const double s = std::min(std::max(along.dot(oX - a) / along.squaredNorm(), 0.), 1.);
  return (a + s * along - oX).norm();
}

//! How many of an edge's two faces look to the camera; -1 where one is seen so flat that it could be either.
int facesAhead(const vpTrackedModel &model, const vpModelEdge &edge, const Point &camera)
{
  int count = 0;
  for (int k = edge.firstFace; k < edge.firstFace + edge.faceCount; ++k) {
    const std::size_t index = static_cast<std::size_t>(model.edgeFaces()[static_cast<std::size_t>(k)]);
    const double cosine = model.faces()[index].normal.dot((camera - model.faces()[index].centre).normalized());
    if (std::fabs(cosine) < 0.03) {
      return -1;
    }
    count += cosine > 0. ? 1 : 0;
  }
  return count;
}
} // namespace

TEST_CASE("The points of a view are control points seen from its pose, silhouettes first")
{
  const std::string name = GENERATE_COPY(from_range(shapes));
  CAPTURE(name);
  vpViewSphere sphere = makeSphere(shape(name), optionsOf(1));
  SphereLooker looker(sphere);
  for (std::size_t i = 0; i < sphere.size(); ++i) {
    CAPTURE(i);
    const vpSphereView &view = sphere.view(i);
    looker.look(sphere.poseOf(i));
    REQUIRE(view.size() == std::min<std::size_t>(looker.points().size(), sphere.options().points));
    REQUIRE(view.size() > 50);
    CHECK(view.silhouettes() + view.inner() == view.size());
    std::vector<std::size_t> places = origins(view, looker.points());
    std::sort(places.begin(), places.end());
    CHECK(places.back() < looker.points().size());
    CHECK(std::adjacent_find(places.begin(), places.end()) == places.end());
  }
}

TEST_CASE("A convex object's silhouette and inner edges follow from the faces that look to the camera")
{
  vpViewSphere sphere = makeSphere(shape("box"), optionsOf(2));
  const vpTrackedModel &model = sphere.model();
  REQUIRE(model.isConvex());
  for (std::size_t i = 0; i < sphere.size(); ++i) {
    CAPTURE(i);
    const Point camera = model.centre() + sphere.options().distance * model.diameter() * sphere.directionOf(i);
    const vpSphereView &view = sphere.view(i);
    for (const vpModelEdge &edge : model.edges()) {
      int silhouettes = 0;
      int inner = 0;
      for (std::size_t k = 0; k < view.size(); ++k) {
        if (distanceToEdge(model, edge, view.point(k).position.cast<double>()) < 1e-6) {
          (view.point(k).silhouette ? silhouettes : inner) += 1;
        }
      }
      const int ahead = facesAhead(model, edge, camera);
      if (ahead >= 0) {
        CHECK((silhouettes > 0) == (ahead == 1));
        CHECK((inner > 0) == (ahead == 2));
      }
    }
  }
}

TEST_CASE("No point of a view is hidden by another part of the object")
{
  const std::string name = GENERATE("letter L", "window");
  CAPTURE(name);
  vpViewSphere sphere = makeSphere(shape(name), optionsOf(2));
  REQUIRE_FALSE(sphere.model().isConvex());
  SphereLooker looker(sphere);
  int wrong = 0;
  int turnedAway = 0;
  for (std::size_t i = 0; i < sphere.size(); ++i) {
    looker.look(sphere.poseOf(i));
    const vpSphereView &view = sphere.view(i);
    for (std::size_t k = 0; k < view.size(); ++k) {
      const vpSphereViewPoint point = view.point(k);
      const Point oX = point.position.cast<double>();
      wrong += isWellHidden(looker, oX, 5., 0.002) ? 1 : 0;
      if (point.silhouette) { // The normal by the rule for side has less surface before it than behind it.
        const Pixel ahead = looker.project(oX + 1e-4 * point.direction.cast<double>());
        const Pixel tangent = (ahead - looker.project(oX)).normalized();
        const Pixel normal = static_cast<double>(point.side) * Pixel(-tangent.y(), tangent.x());
        const auto hasSurface = [&](double across) {
          return std::isfinite(looker.castRay(looker.project(oX) + across * normal));
        };
        turnedAway += hasSurface(0.5) && !hasSurface(-0.5) ? 1 : 0;
      }
    }
  }
  CHECK(wrong == 0);
  CHECK(turnedAway == 0);
}

TEST_CASE("Points are spread over contours in proportion to their lengths, and evenly on each")
{
  const std::string name = GENERATE_COPY(from_range(shapes));
  const unsigned int most = GENERATE(1U, 30U, 60U);
  CAPTURE(name, most);
  vpViewSphereOptions options = optionsOf(1);
  options.points = most;
  vpViewSphere sphere = makeSphere(shape(name), options);
  SphereLooker looker(sphere);
  for (std::size_t i = 0; i < sphere.size(); ++i) {
    CAPTURE(i);
    looker.look(sphere.poseOf(i));
    REQUIRE(sphere.view(i).size() == most);
    std::vector<std::size_t> places = origins(sphere.view(i), looker.points());
    std::sort(places.begin(), places.end());
    const double pitch = static_cast<double>(looker.points().size()) / most;
    for (const vpContour &contour : looker.view().contours()) {
      const auto first = std::lower_bound(places.begin(), places.end(), static_cast<std::size_t>(contour.first));
      const auto last =
          std::lower_bound(places.begin(), places.end(), static_cast<std::size_t>(contour.first + contour.count));
      CHECK(std::fabs(static_cast<double>(last - first) - contour.count / pitch) <= 1.);
    }
    for (std::size_t k = 1; k < places.size(); ++k) {
      CHECK(std::fabs(static_cast<double>(places[k] - places[k - 1]) - pitch) < 1.);
    }
  }
}

TEST_CASE("A view does not depend on those made before")
{
  const std::string name = GENERATE_COPY(from_range(shapes));
  CAPTURE(name);
  vpViewSphereOptions options = optionsOf(2);
  options.view.appearAngle = 70.; // Far from the other one, so that a face seen before would stay.
  options.view.disappearAngle = 89.;
  const vpTrackedModel model = shape(name);
  vpViewSphere forward = makeSphere(model, options);
  vpViewSphere backward = makeSphere(model, options);
  for (std::size_t i = 0; i < forward.size(); ++i) {
    forward.make(i);
    backward.make(forward.size() - 1 - i);
  }
  int different = 0;
  for (std::size_t i = 0; i < forward.size(); ++i) {
    different += isSame(forward.view(i), backward.view(i)) ? 0 : 1;
  }
  CHECK(different == 0);
}

TEST_CASE("Views are made when they are asked for, once, and are the same on a finer sphere")
{
  const vpTrackedModel model = shape("letter L");
  vpViewSphere sphere = makeSphere(model, optionsOf(1));
  const std::size_t before = sphere.memory();
  CHECK_FALSE(sphere.isMade(7));
  CHECK(sphere.find(7) == nullptr);
  const vpSphereView *view = &sphere.view(7);
  CHECK(sphere.isMade(7));
  CHECK_FALSE(sphere.isMade(6));
  CHECK(sphere.find(7) == view);
  CHECK(sphere.memory() == before + 7 * sizeof(float) * view->size());
  const float *values = view->x();
  sphere.make(7);
  CHECK(sphere.view(7).x() == values);
  vpViewSphere finer = makeSphere(model, optionsOf(3));
  CHECK(isSame(finer.view(7), *view));
}
