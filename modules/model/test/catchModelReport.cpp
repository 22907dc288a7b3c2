// SPDX-License-Identifier: GPL-2.0-or-later
// What a model is refused for, and what its report says.
#include <catchMain.h>

#include "modelShapes.h"

#include <visp3/core/vpException.h>

#include <limits>
#include <sstream>

namespace {
using modelShapes::Point;

const Point cubeSize(0.1, 0.1, 0.1);

std::string messageOf(const vpTrackedModelBuilder &builder)
{
  try {
    builder.build("thing.cao");
  } catch (const vpException &e) {
    return e.what();
  }
  return "";
}
} // namespace

TEST_CASE("What cannot be tracked is refused with a reason")
{
  vpTrackedModelBuilder builder;
  CHECK_THAT(messageOf(builder), ContainsSubstring("thing.cao") && ContainsSubstring("empty"));
  CHECK_THROWS_AS(builder.addCylinder(Point(0, 0, 0), Point(0, 0, 1), 0.), vpException);
  CHECK_THROWS_AS(builder.addCircle(Point(0, 0, 0), Point(1, 0, 0), Point(0, 1, 0), -1.), vpException);
  SECTION("collinear points of a circle")
  {
    builder.addCircle(Point(0, 0, 0), Point(1, 0, 0), Point(2, 0, 0), 1., "ring", 4);
    CHECK_THAT(messageOf(builder), ContainsSubstring("circle 4 'ring'"));
  }
  SECTION("cylinder without length")
  {
    builder.addCylinder(Point(0, 0, 1), Point(0, 0, 1), 1., "", 5);
    CHECK_THAT(messageOf(builder), ContainsSubstring("cylinder 5"));
  }
  SECTION("not a number")
  {
    builder.addFace({Point(0, 0, 0), Point(1, 0, 0), Point(1, std::numeric_limits<double>::quiet_NaN(), 0)}, "lid", 6);
    CHECK_THAT(messageOf(builder), ContainsSubstring("polygon 6 'lid'") && ContainsSubstring("finite"));
  }
  SECTION("nothing left")
  {
    builder.addLine(Point(0, 0, 0), Point(0, 0, 0));
    CHECK_THROWS_AS(builder.build("thing.cao"), vpException);
  }
}

TEST_CASE("Options out of range are named")
{
  const auto message = [](double vpModelOptions::*member, double value) -> std::string {
    vpModelOptions options;
    options.*member = value;
    try {
      const vpTrackedModelBuilder builder(options);
    } catch (const vpException &e) {
      return e.what();
    }
    return "";
  };
  CHECK(message(&vpModelOptions::creaseAngle, 60.).empty());
  CHECK_THAT(message(&vpModelOptions::unit, 0.), ContainsSubstring("unit"));
  CHECK_THAT(message(&vpModelOptions::unit, std::numeric_limits<double>::quiet_NaN()), ContainsSubstring("unit"));
  CHECK_THAT(message(&vpModelOptions::creaseAngle, 180.), ContainsSubstring("creaseAngle"));
  CHECK_THAT(message(&vpModelOptions::weldTolerance, 0.1), ContainsSubstring("weldTolerance"));
  CHECK_THAT(message(&vpModelOptions::minSize, -1.), ContainsSubstring("minSize"));
  CHECK_THAT(message(&vpModelOptions::maxSize, 1e-4), ContainsSubstring("maxSize"));
}

TEST_CASE("The report says what the model is in a readable unit")
{
  std::vector<modelShapes::Polygon> polygons = modelShapes::boxPolygons(Point(0.165, 0.068, 0.08), Point(0., 0., 2.));
  std::reverse(polygons[0].begin(), polygons[0].end());
  std::ostringstream text;
  text.precision(1);
  text << modelShapes::build(polygons, vpModelOptions(), "box.cao").report();
  CHECK_THAT(text.str(), ContainsSubstring("box.cao") && ContainsSubstring("16.5 x 6.8 x 8 cm"));
  CHECK_THAT(text.str(), ContainsSubstring("8 vertices") && ContainsSubstring("12 edges"));
  CHECK_THAT(text.str(), ContainsSubstring("(0, 0, 200) cm") && ContainsSubstring("outside the object"));
  CHECK_THAT(text.str(), ContainsSubstring("1 polygon is wound against"));
}

TEST_CASE("Units, polygons and a mesh together, and sizes that are not believed")
{
  vpModelOptions options;
  options.unit = 0.001;
  vpTrackedModelBuilder builder(options);
  modelShapes::add(builder, modelShapes::boxTriangles(1000. * cubeSize));
  const vpTrackedModel cube = builder.build("cube");
  CHECK(cube.isConvex());
  CHECK(cube.boxMax().isApprox(0.5 * cubeSize));
  CHECK(cube.report().unit == exactly(0.001));
  builder.addLine(Point(0.05, 0.05, 0.05), Point(0.1, 0.1, 0.1));
  const vpTrackedModel both = builder.build("cube and line");
  CHECK(both.vertices().size() == 9);
  CHECK(both.edges().size() == 13);

  try {
    modelShapes::build(modelShapes::boxTriangles(Point(165., 68., 80.)), vpModelOptions(), "teabox.obj");
    FAIL("a box of 165 m was believed");
  } catch (const vpException &e) {
    CHECK_THAT(e.what(), ContainsSubstring("'teabox.obj' is 195.6 m wide (unit 1 m)") &&
                             ContainsSubstring("0.001 for millimetres") && ContainsSubstring("maxSize"));
  }
  CHECK_THROWS_AS(modelShapes::build(modelShapes::boxTriangles(1e-4 * cubeSize)), vpException);
}

TEST_CASE("Broken triangles and images are refused")
{
  vpTrackedModelBuilder builder;
  std::array<vpTrackedModelBuilder::Corner, 3> corners;
  corners[1].position = Point(1., 0., 0.);
  CHECK_THROWS_AS(builder.addTriangle(corners, 0), vpException);
  CHECK(builder.addImage(vpImage<vpRGBa>()) == -1);
  builder.addTriangle(corners);
  CHECK_THROWS_AS(builder.build("line of triangles"), vpException);
  corners[2].position = Point(0., std::numeric_limits<double>::infinity(), 0.);
  builder.addTriangle(corners);
  CHECK_THROWS_AS(builder.build("endless"), vpException);
}

TEST_CASE("The report warns about what was repaired")
{
  std::vector<modelShapes::Triangle> triangles = modelShapes::boxTriangles(cubeSize);
  triangles.resize(10);
  std::swap(triangles[3][0], triangles[3][1]);
  std::ostringstream text;
  text << modelShapes::build(triangles).report();
  CHECK_THAT(text.str(), ContainsSubstring("1 triangle was turned over") && ContainsSubstring("1 hole\n"));
  CHECK_THAT(text.str(), ContainsSubstring("4 border edges") && ContainsSubstring("open"));
}
