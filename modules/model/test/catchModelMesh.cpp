// SPDX-License-Identifier: GPL-2.0-or-later
// Triangle soups: welding, windings, creases, borders, corner normals.
#include <catchMain.h>

#include "modelShapes.h"

#include <visp3/core/vpException.h>

#include <limits>
#include <sstream>

#ifdef ENABLE_VISP_NAMESPACE
using namespace VISP_NAMESPACE_NAME;
#endif

namespace {
using modelShapes::Point;
using modelShapes::Triangle;
using Triangles = std::vector<Triangle>;

const Point cubeSize(0.1, 0.1, 0.1);

Triangles joined(Triangles a, const Triangles &b)
{
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

Point normalByCorners(const vpTrackedModel &model, const vpModelTriangle &triangle)
{
  const Point &a = model.vertices()[static_cast<std::size_t>(triangle.vertex[0])];
  const Point &b = model.vertices()[static_cast<std::size_t>(triangle.vertex[1])];
  const Point &c = model.vertices()[static_cast<std::size_t>(triangle.vertex[2])];
  return (b - a).cross(c - a).normalized();
}

bool isOutwardFrom(const vpTrackedModel &model, const Point &inside)
{
  return std::all_of(model.triangles().begin(), model.triangles().end(), [&](const vpModelTriangle &triangle) {
    const Point &corner = model.vertices()[static_cast<std::size_t>(triangle.vertex[0])];
    return normalByCorners(model, triangle).dot(corner - inside) > 0.;
  });
}

double length(const vpTrackedModel &model, const vpModelEdge &edge)
{
  return (model.vertices()[static_cast<std::size_t>(edge.vertex[1])] -
          model.vertices()[static_cast<std::size_t>(edge.vertex[0])])
      .norm();
}

void checkCube(const vpTrackedModel &model, std::size_t triangles)
{
  CHECK(model.faces().size() == 6);
  CHECK(model.triangles().size() == triangles);
  REQUIRE(model.edges().size() == 12);
  for (const vpModelEdge &edge : model.edges()) {
    CHECK(edge.faceCount == 2);
    CHECK(length(model, edge) == Approx(0.1));
  }
  for (const vpModelFace &face : model.faces()) {
    CHECK(face.planar);
    CHECK(face.oriented);
    CHECK(face.normal.cwiseAbs().maxCoeff() == Approx(1.));
    CHECK(face.centre.norm() == Approx(0.05));
  }
  CHECK(isOutwardFrom(model, Point::Zero()));
  CHECK(model.smoothTriangles().empty());
  CHECK(model.isConvex());
  CHECK(model.report().closed);
  CHECK(model.report().holes == 0);
}
} // namespace

TEST_CASE("A cube of twelve triangles")
{
  const vpTrackedModel model = modelShapes::build(modelShapes::boxTriangles(cubeSize));
  checkCube(model, 12);
  CHECK(model.vertices().size() == 8);
  CHECK(model.report().flippedTriangles == 0);
  CHECK(model.report().weldedVertices == 0);
  for (const vpModelTriangle &triangle : model.triangles()) {
    for (const int corner : triangle.normal) {
      CHECK(model.normals()[static_cast<std::size_t>(corner)].dot(normalByCorners(model, triangle)) == Approx(1.));
    }
  }
}

TEST_CASE("The edges of a tessellated cube are its twelve edges")
{
  checkCube(modelShapes::build(modelShapes::boxTriangles(cubeSize, 9)), 6 * 9 * 9 * 2);
}

TEST_CASE("Triangles that are turned over are turned back")
{
  Triangles triangles = modelShapes::boxTriangles(cubeSize, 4);
  SECTION("half of them")
  {
    for (std::size_t i = 0; i < triangles.size(); i += 2) {
      std::swap(triangles[i][0], triangles[i][1]);
    }
    const vpTrackedModel model = modelShapes::build(triangles);
    checkCube(model, triangles.size());
    CHECK(model.report().flippedTriangles == triangles.size() / 2);
  }
  SECTION("all of them")
  {
    for (Triangle &triangle : triangles) {
      std::swap(triangle[0], triangle[1]);
    }
    const vpTrackedModel model = modelShapes::build(triangles);
    checkCube(model, triangles.size());
    CHECK(model.report().flippedTriangles == triangles.size());
  }
  SECTION("with their colours")
  {
    vpTrackedModelBuilder builder;
    for (Triangle &triangle : triangles) {
      std::array<vpTrackedModelBuilder::Corner, 3> corners;
      for (std::size_t k = 0; k < 3; ++k) {
        corners[k].position = triangle[2 - k];
        corners[k].color = triangle[2 - k].cast<float>();
      }
      builder.addTriangle(corners);
    }
    const vpTrackedModel model = builder.build("coloured");
    REQUIRE(model.appearance().color.size() == model.triangles().size());
    CHECK(model.appearance().image.empty());
    for (std::size_t t = 0; t < model.triangles().size(); ++t) {
      for (std::size_t k = 0; k < 3; ++k) {
        const Point &corner = model.vertices()[static_cast<std::size_t>(model.triangles()[t].vertex[k])];
        CHECK((model.appearance().color[t][k] - corner.cast<float>()).norm() < 1e-6F);
      }
    }
  }
}

TEST_CASE("A cube without lid has a hole with tracked edges")
{
  Triangles triangles = modelShapes::boxTriangles(cubeSize);
  triangles.resize(10);
  std::swap(triangles[3][0], triangles[3][1]);
  const vpTrackedModel model = modelShapes::build(triangles);
  CHECK(model.report().borderEdges == 4);
  CHECK(model.report().holes == 1);
  CHECK(model.report().flippedTriangles == 1);
  CHECK_FALSE(model.report().closed);
  CHECK_FALSE(model.isConvex());
  CHECK(model.edges().size() == 12);
  CHECK(std::count_if(model.edges().begin(), model.edges().end(),
                      [](const vpModelEdge &edge) { return edge.faceCount == 1; }) == 4);
  CHECK_FALSE(model.faces()[0].oriented);
  CHECK(isOutwardFrom(model, Point::Zero()));
}

TEST_CASE("A small hole is reported and not tracked")
{
  Triangles triangles = modelShapes::boxTriangles(cubeSize, 50);
  triangles.erase(triangles.begin() + 1050);
  const vpTrackedModel model = modelShapes::build(triangles);
  CHECK(model.report().borderEdges == 3);
  CHECK(model.report().holes == 1);
  CHECK(model.edges().size() == 12);
}

TEST_CASE("An open sheet keeps the sides that most of its triangles had")
{
  Triangles sheet = modelShapes::gridTriangles({Point(0, 0, 0), Point(1, 0, 0), Point(1, 1, 0), Point(0, 1, 0)}, 5);
  std::swap(sheet[7][0], sheet[7][1]);
  const vpTrackedModel model = modelShapes::build(sheet);
  CHECK(model.report().flippedTriangles == 1);
  CHECK(model.report().holes == 1);
  CHECK(model.report().borderEdges == 20);
  REQUIRE(model.faces().size() == 1);
  CHECK(model.faces()[0].normal.isApprox(Point::UnitZ()));
  CHECK_FALSE(model.faces()[0].oriented);
  CHECK(model.edges().size() == 4);
}

TEST_CASE("A double-sided sheet is taken once")
{
  const Triangles sheet =
      modelShapes::gridTriangles({Point(0, 0, 0), Point(1, 0, 0), Point(1, 1, 0), Point(0, 1, 0)}, 3);
  Triangles back = sheet;
  for (Triangle &triangle : back) {
    std::swap(triangle[0], triangle[1]);
  }
  const vpTrackedModel model = modelShapes::build(joined(sheet, back));
  CHECK(model.report().duplicateTriangles == sheet.size());
  CHECK(model.report().nonManifoldEdges == 0);
  CHECK(model.triangles().size() == sheet.size());
  CHECK(model.edges().size() == 4);
}

TEST_CASE("A sphere has no creases and radial normals")
{
  const vpTrackedModel model = modelShapes::build(modelShapes::sphereTriangles(0.1, 24, 48));
  CHECK(model.edges().empty());
  REQUIRE(model.faces().size() == 1);
  CHECK_FALSE(model.faces()[0].planar);
  CHECK(model.faces()[0].oriented);
  CHECK(model.smoothTriangles().size() == model.triangles().size());
  CHECK_FALSE(model.isConvex());
  double worst = 1.;
  for (const vpModelTriangle &triangle : model.triangles()) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Point &corner = model.vertices()[static_cast<std::size_t>(triangle.vertex[k])];
      worst = std::min(worst, corner.normalized().dot(model.normals()[static_cast<std::size_t>(triangle.normal[k])]));
    }
  }
  CHECK(worst > std::cos(M_PI / 180.));
}

TEST_CASE("A cylinder has two rims, a smooth mantle and flat caps")
{
  const vpTrackedModel model = modelShapes::build(modelShapes::cylinderTriangles(0.05, 0.2, 48));
  CHECK(model.edges().size() == 2 * 48);
  REQUIRE(model.faces().size() == 3);
  CHECK(std::count_if(model.faces().begin(), model.faces().end(), [](const vpModelFace &f) { return f.planar; }) == 2);
  CHECK(model.smoothTriangles().size() == 2 * 48);
  for (const vpModelTriangle &triangle : model.triangles()) {
    const bool planar = model.faces()[static_cast<std::size_t>(triangle.face)].planar;
    for (const int corner : triangle.normal) {
      CHECK(std::abs(model.normals()[static_cast<std::size_t>(corner)].z()) == Approx(planar ? 1. : 0.).margin(1e-9));
    }
  }
}

TEST_CASE("The crease angle decides what is tracked")
{
  vpModelOptions options;
  options.creaseAngle = 7.;
  const Triangles cylinder = modelShapes::cylinderTriangles(0.05, 0.2, 48);
  CHECK(modelShapes::build(cylinder, options).edges().size() == 3 * 48);
  options.creaseAngle = 100.;
  CHECK(modelShapes::build(cylinder, options).edges().empty());
}

TEST_CASE("Two boxes, apart or touching along an edge")
{
  const Triangles one = modelShapes::boxTriangles(cubeSize);
  const vpTrackedModel apart =
      modelShapes::build(joined(one, modelShapes::boxTriangles(cubeSize, 1, Point(0.3, 0., 0.))));
  CHECK(apart.edges().size() == 24);
  CHECK(apart.faces().size() == 12);
  CHECK(apart.report().closed);
  CHECK_FALSE(apart.isConvex());
  const vpTrackedModel touching =
      modelShapes::build(joined(one, modelShapes::boxTriangles(cubeSize, 1, Point(0.1, 0.1, 0.))));
  CHECK(touching.report().nonManifoldEdges == 1);
  CHECK(touching.edges().size() == 23);
  CHECK(std::all_of(touching.faces().begin(), touching.faces().end(), [](const vpModelFace &f) { return f.oriented; }));
}

TEST_CASE("Slivers do not tear a mesh open")
{
  // The upper half of one side's triangle pair has a corner on its diagonal; a triangle without area fills the gap.
  Triangles triangles = modelShapes::boxTriangles(cubeSize);
  const Triangle cut = triangles[10];
  const Point middle = 0.5 * (cut[2] + cut[0]);
  triangles[10] = {{cut[0], cut[1], middle}};
  triangles.push_back({{cut[1], cut[2], middle}});
  triangles.push_back({{cut[0], middle, cut[2]}});
  triangles.push_back({{cut[0], cut[0], cut[1]}});
  const vpTrackedModel model = modelShapes::build(triangles);
  checkCube(model, 13);
  CHECK(model.report().degenerateTriangles == 2);
}

TEST_CASE("A Moebius strip is no closed surface and does no harm")
{
  const auto at = [](int i, double across) {
    const double angle = 2. * M_PI * i / 40;
    const double r = 0.1 + across * std::cos(0.5 * angle);
    return Point(r * std::cos(angle), r * std::sin(angle), across * std::sin(0.5 * angle));
  };
  Triangles strip;
  for (int i = 0; i < 40; ++i) {
    strip.push_back({{at(i, -0.02), at(i + 1, -0.02), at(i + 1, 0.02)}});
    strip.push_back({{at(i, -0.02), at(i + 1, 0.02), at(i, 0.02)}});
  }
  const vpTrackedModel model = modelShapes::build(strip);
  CHECK(model.report().holes == 1);
  CHECK(model.report().borderEdges == 80);
  CHECK_FALSE(model.report().closed);
  CHECK_FALSE(model.faces()[0].oriented);
}

TEST_CASE("Units, polygons and a mesh together, and sizes that are not believed")
{
  vpModelOptions options;
  options.unit = 0.001;
  vpTrackedModelBuilder builder(options);
  modelShapes::add(builder, modelShapes::boxTriangles(1000. * cubeSize));
  const vpTrackedModel cube = builder.build("cube");
  checkCube(cube, 12);
  CHECK(cube.report().unit == 0.001);
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
  Triangles triangles = modelShapes::boxTriangles(cubeSize);
  triangles.resize(10);
  std::swap(triangles[3][0], triangles[3][1]);
  std::ostringstream text;
  text << modelShapes::build(triangles).report();
  CHECK_THAT(text.str(), ContainsSubstring("1 triangle was turned over") && ContainsSubstring("1 hole\n"));
  CHECK_THAT(text.str(), ContainsSubstring("4 border edges") && ContainsSubstring("open"));
}
