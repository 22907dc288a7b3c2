// SPDX-License-Identifier: GPL-2.0-or-later
// Triangle soups: windings, holes, double and degenerate triangles.
#include <catchMain.h>

#include "cubeCheck.h"

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

} // namespace

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
        const Point &corner = modelChecks::corner(model, model.triangles()[t], k);
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
  CHECK(modelChecks::isOutwardFrom(model, Point::Zero()));
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
