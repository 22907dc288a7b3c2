// SPDX-License-Identifier: GPL-2.0-or-later
#include <catchMain.h>

#include "modelShapes.h"
#include "viewChecks.h"

#include <visp3/core/vpException.h>

using namespace modelShapes;
using namespace viewChecks;

namespace {
vpTrackedModel cube()
{
  return build(boxPolygons(Point(0.1, 0.1, 0.1)));
}

//! A square of the plane z = 0 whose front looks along z.
vpTrackedModel square()
{
  return build(std::vector<Polygon>{
      {Point(-0.05, -0.05, 0.), Point(0.05, -0.05, 0.), Point(0.05, 0.05, 0.), Point(-0.05, 0.05, 0.)}});
}

//! The camera sees the square under this angle between its normal and the line of sight, degrees.
vpHomogeneousMatrix atAngle(double degrees)
{
  const double angle = degrees * M_PI / 180.;
  return lookFrom(Point(std::sin(angle), 0., std::cos(angle)), 0.5);
}

vpTrackedModel line(const Point &start, const Point &end)
{
  vpTrackedModelBuilder builder;
  builder.addLine(start, end, "line", 7);
  return builder.build("line");
}

//! Extreme depths of the control points, metres.
std::pair<double, double> depths(const Looker &looker)
{
  std::pair<double, double> range(HUGE_VAL, -HUGE_VAL);
  for (const vpControlPoint &point : looker.points()) {
    const double depth = looker.toCamera(point.position).z();
    range.first = std::min(range.first, depth);
    range.second = std::max(range.second, depth);
  }
  return range;
}

std::string refusal(const vpModelViewOptions &options)
{
  try {
    options.check();
  } catch (const vpException &e) {
    return e.getStringMessage();
  }
  return "";
}
} // namespace

TEST_CASE("A face appears below one angle and disappears above another one")
{
  Looker looker(square());
  looker.options.appearAngle = 80.;
  looker.options.disappearAngle = 86.;
  const std::vector<std::pair<double, bool>> sweep = {{83., false}, {80.1, false}, {79.9, true}, {83., true},
                                                      {85.9, true}, {86.1, false}, {83., false}, {100., false}};
  for (const std::pair<double, bool> &step : sweep) {
    CAPTURE(step.first);
    const vpModelView &view = looker.look(atAngle(step.first));
    CHECK((view.facesSeen()[0] != 0) == step.second);
    CHECK(view.points().empty() != step.second);
  }
}

TEST_CASE("Control points are between the near and the far distance")
{
  // Along the camera's axis, 2 cm beside it, from 1 m behind the camera to 2 m in front of it.
  const vpTrackedModel model = line(Point(0.02, 0., 1.), Point(0.02, 0., -2.));
  Looker looker(model);
  looker.options.border = 0.;
  looker.options.nearDistance = 0.5;
  looker.options.farDistance = 0.8;
  looker.look(lookFrom(Point(0., 0., 1.), 0.));
  CHECK(projectionError(looker) < 1e-9);
  CHECK(looker.points().size() == 2);
  CHECK(depths(looker).first >= 0.5);
  CHECK(depths(looker).second <= 0.8);
  const double length = 0.02 * 600. * (1. / 0.5 - 1. / 0.8);
  CHECK(looker.view().contours()[0].step * 2. == Approx(length).epsilon(0.02));

  looker.options.farDistance = 0.;
  looker.look(lookFrom(Point(0., 0., 1.), 0.));
  CHECK(depths(looker).first >= 0.5);
  CHECK(depths(looker).second > 1.);
  looker.options.nearDistance = 2.5;
  CHECK(looker.look(lookFrom(Point(0., 0., 1.), 0.)).points().empty());
}

TEST_CASE("Of an object partly outside the image the part inside has control points")
{
  Looker looker(cube());
  looker.options.border = 5.;
  for (const Pixel &shift : {Pixel(-0.25, 0.), Pixel(0.27, 0.05), Pixel(0.02, -0.2), Pixel(0.25, 0.2)}) {
    const vpHomogeneousMatrix aside(shift.x(), shift.y(), 0., 0., 0., 0.);
    const vpHomogeneousMatrix cMo = aside * lookFrom(Point(1., 0.8, 1.1), 0.5);
    looker.width = 640;
    looker.height = 480;
    looker.look(cMo);
    CHECK(projectionError(looker) < 1e-9);
    const std::vector<vpControlPoint> inside = looker.points();
    REQUIRE(!inside.empty());
    CHECK(contoursHoldAllPoints(looker.view()));
    for (const vpControlPoint &point : inside) {
      CHECK(point.pixel.minCoeff() >= 5.);
      CHECK(point.pixel.x() <= 634.);
      CHECK(point.pixel.y() <= 474.);
    }
    // A larger image around the same camera sees all of it: what is in the smaller one has to be there.
    const vpModelView small(looker.view());
    looker.cam = vpCameraParameters(600., 610., 1321.3, 1238.6);
    looker.width = 2640;
    looker.height = 2480;
    looker.look(cMo);
    CHECK(looker.points().size() > inside.size());
    for (const vpControlPoint &point : looker.points()) {
      const Pixel pixel = point.pixel - Pixel(1000., 1000.);
      if (pixel.minCoeff() > 10. && pixel.x() < 629. && pixel.y() < 469.) {
        CHECK(nearestPoint(small, pixel) < 4.5);
      }
    }
    looker.cam = vpCameraParameters(600., 610., 321.3, 238.6);
  }
}

TEST_CASE("Nothing outside the image or behind the camera has control points")
{
  Looker looker(GENERATE(0, 1) == 0 ? cube() : build(lPolygons(0.1, 0.05)));
  CHECK(looker.look(vpHomogeneousMatrix(1., 0., 0.5, 0.1, 0.2, 0.3)).points().empty());
  CHECK(looker.look(vpHomogeneousMatrix(0., -1., 0.5, 0.1, 0.2, 0.3)).points().empty());
  CHECK(looker.look(vpHomogeneousMatrix(0., 0., -0.5, 0.1, 0.2, 0.3)).points().empty());
  CHECK(looker.view().contours().empty());
  // The camera inside the object: the sides' backs are not seen.
  CHECK(looker.look(vpHomogeneousMatrix(-0.02, -0.02, -0.02, 0.1, 0.2, 0.3)).points().empty());
  CHECK(!looker.look(vpHomogeneousMatrix(0., 0., 0.5, 0.7, 0.5, 0.3)).points().empty());
  // An image that is all border.
  looker.width = looker.height = 3;
  CHECK(looker.look(vpHomogeneousMatrix(0., 0., 0.5, 0.7, 0.5, 0.3)).points().empty());
}

TEST_CASE("Short edges and small faces of limited detail are left out")
{
  Looker looker(cube());
  const vpHomogeneousMatrix cMo = lookFrom(Point(1., 0.9, 1.1), 0.5);
  CHECK(looker.look(cMo).contours().size() == 9);
  looker.options.details.assign(6, vpFaceDetail());
  CHECK(looker.look(cMo).contours().size() == 9);
  for (vpFaceDetail &detail : looker.options.details) {
    detail.enabled = true;
    detail.minLineLength = 10.;
    detail.minPolygonArea = 100.;
  }
  CHECK(looker.look(cMo).contours().size() == 9);
  for (vpFaceDetail &detail : looker.options.details) {
    detail.minLineLength = 500.;
  }
  CHECK(looker.look(cMo).contours().empty());
  // The edges of a face in full detail stay.
  looker.options.details[5].enabled = false;
  CHECK(looker.look(cMo).contours().size() == 4);
  for (vpFaceDetail &detail : looker.options.details) {
    detail.minLineLength = 10.;
    detail.minPolygonArea = 1e5;
  }
  const vpModelView &view = looker.look(cMo);
  CHECK(std::count(view.facesSeen().begin(), view.facesSeen().end(), 1) == 1);
  CHECK(view.facesSeen()[5] == 1);
  CHECK(view.contours().size() == 4);
}

TEST_CASE("Level of detail is for lines as well")
{
  const vpTrackedModel model = line(Point(-0.05, 0., 0.), Point(0.05, 0., 0.));
  Looker looker(model);
  const vpHomogeneousMatrix cMo = lookFrom(Point(0., 0., 1.), 0.5); // 120 pixels long
  looker.options.details.assign(model.faces().size(), vpFaceDetail());
  looker.options.details[0].enabled = true;
  looker.options.details[0].minLineLength = 100.;
  CHECK(looker.look(cMo).contours().size() == 1);
  looker.options.details[0].minLineLength = 150.;
  CHECK(looker.look(cMo).contours().empty());
}

TEST_CASE("All edges are those of the faces that are turned away too")
{
  Looker looker(cube());
  const vpHomogeneousMatrix cMo = lookFrom(Point(1., 0.9, 1.1), 0.5);
  looker.look(cMo);
  looker.options.allEdges = true;
  CHECK(looker.look(cMo).contours().size() == 12);
  looker.options.allEdges = false;
  CHECK(looker.look(cMo).contours().size() == 9);
}

TEST_CASE("An option out of range is refused by name")
{
  vpModelViewOptions options;
  CHECK(refusal(options).empty());
  const auto refuses = [&options](double &member, double value) {
    const double good = member;
    member = value;
    const std::string text = refusal(options);
    member = good;
    return text;
  };
  CHECK_THAT(refuses(options.sampleStep, 0.4), ContainsSubstring("sampleStep is 0.4"));
  CHECK_THAT(refuses(options.appearAngle, 0.), ContainsSubstring("appearAngle"));
  CHECK_THAT(refuses(options.disappearAngle, 88.), ContainsSubstring("disappearAngle"));
  CHECK_THAT(refuses(options.disappearAngle, 91.), ContainsSubstring("disappearAngle"));
  CHECK_THAT(refuses(options.nearDistance, 0.), ContainsSubstring("nearDistance"));
  CHECK_THAT(refuses(options.farDistance, 0.0005), ContainsSubstring("farDistance"));
  CHECK_THAT(refuses(options.border, -1.), ContainsSubstring("border"));
  CHECK_THAT(refuses(options.sampleStep, std::nan("")), ContainsSubstring("sampleStep"));
  options.visibilitySize = 15;
  CHECK_THAT(refusal(options), ContainsSubstring("visibilitySize is 15"));
}
