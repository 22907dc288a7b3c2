// SPDX-License-Identifier: GPL-2.0-or-later
// Polygons, lines, cylinders and circles as ViSP's model files have them.
#include <catchMain.h>

#include "modelChecks.h"
#include "modelShapes.h"

#include <visp3/core/vpException.h>

using modelChecks::surfaceArea;
using modelChecks::worstNormalAgreement;
using modelShapes::Point;

TEST_CASE("A cube of polygons")
{
  const vpTrackedModel model = modelShapes::build(modelShapes::boxPolygons(Point(0.1, 0.1, 0.1)));
  CHECK(model.vertices().size() == 8);
  CHECK(model.faces().size() == 6);
  CHECK(model.triangles().size() == 12);
  REQUIRE(model.edges().size() == 12);
  for (const vpModelEdge &edge : model.edges()) {
    REQUIRE(edge.faceCount == 2);
    CHECK(edge.line == -1);
    const int *faces = &model.edgeFaces()[static_cast<std::size_t>(edge.firstFace)];
    const Point &n0 = model.faces()[static_cast<std::size_t>(faces[0])].normal;
    const Point &n1 = model.faces()[static_cast<std::size_t>(faces[1])].normal;
    CHECK(std::abs(n0.dot(n1)) < 1e-12);
  }
  CHECK(model.faces()[1].normal.isApprox(Point::UnitX()));
  CHECK(model.faces()[1].centre.isApprox(Point(0.05, 0., 0.)));
  CHECK(model.faces()[5].name == "polygon 5");
  CHECK(model.faces()[5].polygon == 5);
  CHECK(model.faces()[5].corners.size() == 4);
  CHECK(worstNormalAgreement(model) > 1. - 1e-12);
  CHECK(surfaceArea(model) == Approx(0.06));
  CHECK(model.isConvex());
  CHECK(model.report().closed);
  CHECK(model.report().flippedFaces == 0);
  CHECK(model.smoothTriangles().empty());
  CHECK(model.diameter() == Approx(0.1 * std::sqrt(3.)));
  CHECK(model.boxMax().isApprox(Point(0.05, 0.05, 0.05)));
}

TEST_CASE("A cube whose corners differ a little between its polygons is welded")
{
  std::vector<modelShapes::Polygon> polygons = modelShapes::boxPolygons(Point(0.1, 0.1, 0.1));
  for (std::size_t i = 0; i < polygons.size(); ++i) {
    polygons[i][0] += Point(1e-8 * static_cast<double>(i), 0., 0.);
  }
  const vpTrackedModel model = modelShapes::build(polygons);
  CHECK(model.vertices().size() == 8);
  CHECK(model.edges().size() == 12);
  CHECK(model.report().weldedVertices > 0);
  vpModelOptions exact;
  exact.weldTolerance = 0.;
  CHECK(modelShapes::build(polygons, exact).vertices().size() > 8);
}

TEST_CASE("A polygon wound against its neighbours is reported, not changed")
{
  std::vector<modelShapes::Polygon> polygons = modelShapes::boxPolygons(Point(0.1, 0.2, 0.3));
  std::reverse(polygons[1].begin(), polygons[1].end());
  const vpTrackedModel model = modelShapes::build(polygons);
  CHECK(model.report().flippedFaces == 1);
  CHECK(model.faces()[1].normal.isApprox(-Point::UnitX()));
  CHECK_FALSE(model.isConvex());
}

TEST_CASE("Non-convex polygons are cut into triangles")
{
  modelShapes::Polygon outline = modelShapes::lOutline(0.2);
  CHECK(surfaceArea(modelShapes::build(std::vector<modelShapes::Polygon>{outline})) == Approx(0.03));
  SECTION("whatever corner comes first")
  {
    for (std::size_t i = 0; i < outline.size(); ++i) {
      std::rotate(outline.begin(), outline.begin() + 1, outline.end());
      const vpTrackedModel model = modelShapes::build(std::vector<modelShapes::Polygon>{outline});
      CHECK(surfaceArea(model) == Approx(0.03));
      CHECK(model.triangles().size() == 4);
      CHECK(worstNormalAgreement(model) > 1. - 1e-12);
    }
  }
  SECTION("with corners on the straight parts")
  {
    outline.insert(outline.begin() + 1, {Point(0.05, 0., 0.), Point(0.1, 0., 0.)});
    outline.emplace_back(0., 0.1, 0.);
    const vpTrackedModel model = modelShapes::build(std::vector<modelShapes::Polygon>{outline});
    CHECK(surfaceArea(model) == Approx(0.03));
    CHECK(model.edges().size() == 9);
    CHECK(model.faces()[0].corners.size() == 9);
  }
  SECTION("as sides of a solid")
  {
    const vpTrackedModel solid = modelShapes::build(modelShapes::lPolygons(0.2, 0.1));
    CHECK(surfaceArea(solid) == Approx(2. * 0.03 + 0.8 * 0.1));
    CHECK(solid.edges().size() == 18);
    CHECK(solid.report().closed);
    CHECK_FALSE(solid.isConvex());
    const vpTrackedModel frame = modelShapes::build(modelShapes::framePolygons(0.3, 0.05));
    CHECK(frame.report().closed);
    CHECK(frame.report().flippedFaces == 0);
    CHECK_FALSE(frame.isConvex());
  }
}

TEST_CASE("A star, and a polygon with a bridge to its hole")
{
  modelShapes::Polygon star;
  for (int i = 0; i < 40; ++i) {
    const double radius = i % 2 == 0 ? 0.1 : 0.01;
    star.emplace_back(0.3, radius * std::cos(M_PI * i / 20), radius * std::sin(M_PI * i / 20));
  }
  const double spike = 0.5 * 0.1 * 0.01 * std::sin(M_PI / 20);
  CHECK(surfaceArea(modelShapes::build(std::vector<modelShapes::Polygon>{star})) == Approx(40. * spike));

  const modelShapes::Polygon bridged = {Point(0, 0, 0), Point(3, 0, 0), Point(3, 3, 0), Point(0, 3, 0), Point(0, 0, 0),
                                        Point(1, 1, 0), Point(1, 2, 0), Point(2, 2, 0), Point(2, 1, 0), Point(1, 1, 0)};
  CHECK(surfaceArea(modelShapes::build(std::vector<modelShapes::Polygon>{bridged})) == Approx(8.));
}

TEST_CASE("Polygons that are not closed, too short or without area")
{
  vpTrackedModelBuilder builder;
  builder.addFace({Point(0, 0, 0), Point(1, 0, 0), Point(1, 1, 0), Point(0, 1, 0)}, "open", 0, false);
  CHECK(builder.build("open").edges().size() == 3);
  builder.addFace({Point(0, 0, 0), Point(0, 1, 0), Point(0, 2, 0)}, "flat", 1);
  const vpTrackedModel model = builder.build("flat");
  CHECK(model.triangles().size() == 2);
  CHECK(model.report().faces == 1);
  REQUIRE(model.edges().size() == 6);
  CHECK(std::count_if(model.edges().begin(), model.edges().end(),
                      [](const vpModelEdge &edge) { return edge.faceCount == 0; }) == 3);
  CHECK_THROWS_AS(builder.addFace({Point(0, 0, 0), Point(0, 1, 0)}), vpException);
}

TEST_CASE("Edges that polygons share, repeated corners and lines of no length")
{
  vpTrackedModelBuilder builder;
  builder.addFace({Point(0, 0, 0), Point(1, 0, 0), Point(1, 0, 0), Point(1, 1, 0), Point(0, 0, 0)});
  builder.addFace({Point(0, 0, 0), Point(0, 0, 1), Point(1, 0, 0)});
  builder.addFace({Point(0, 0, 0), Point(0, 0, -1), Point(1, 0, 0)});
  builder.addLine(Point(0, 0, 0), Point(0, 0, 0));
  const vpTrackedModel model = builder.build("fan");
  REQUIRE(model.edges().size() == 7);
  CHECK(model.edges()[0].faceCount == 3);
  CHECK(model.report().nonManifoldEdges == 1);
  CHECK(model.report().borderEdges == 6);
  CHECK_FALSE(model.report().closed);
}

TEST_CASE("Lines are seen from all sides and keep their name")
{
  vpTrackedModelBuilder builder;
  builder.addLine(Point(0, 0, 0), Point(0.5, 0, 0), "antenna", 7);
  const vpTrackedModel alone = builder.build("line");
  REQUIRE(alone.edges().size() == 1);
  CHECK(alone.edges()[0].faceCount == 0);
  CHECK(alone.faces()[static_cast<std::size_t>(alone.edges()[0].line)].name == "antenna");
  CHECK(alone.faces()[static_cast<std::size_t>(alone.edges()[0].line)].polygon == 7);
  CHECK(alone.report().faces == 0);
  CHECK(alone.isConvex());
  modelShapes::add(builder, modelShapes::boxPolygons(Point(0.1, 0.1, 0.1)));
  const vpTrackedModel both = builder.build("box with a line");
  CHECK(both.edges().size() == 13);
  CHECK_FALSE(both.isConvex());
}

TEST_CASE("A cylinder hides and has limbs, no creases")
{
  vpTrackedModelBuilder builder;
  builder.addCylinder(Point(0, 0, 0.1), Point(0, 0, 0.3), 0.05, "mast", 3);
  const vpTrackedModel model = builder.build("cylinder");
  REQUIRE(model.cylinders().size() == 1);
  const vpModelCylinder &cylinder = model.cylinders()[0];
  CHECK(cylinder.radius == exactly(0.05));
  CHECK(cylinder.axis[1].isApprox(Point(0, 0, 0.3)));
  const vpModelFace &mantle = model.faces()[static_cast<std::size_t>(cylinder.face)];
  CHECK_FALSE(mantle.planar);
  CHECK(mantle.name == "mast");
  CHECK(mantle.polygon == 3);
  CHECK(model.edges().empty());
  CHECK(model.smoothTriangles().empty());
  CHECK_FALSE(model.isConvex());
  CHECK(model.triangles().size() >= 4 * 32 - 4);
  CHECK(surfaceArea(model) == Approx(2. * M_PI * 0.05 * (0.2 + 0.05)).epsilon(0.01));
  CHECK(worstNormalAgreement(model) > std::cos(M_PI / 32));
  CHECK(model.report().size.isApprox(Point(0.1, 0.1, 0.2)));
}

TEST_CASE("A circle is a face without triangles")
{
  vpTrackedModelBuilder builder;
  builder.addCircle(Point(0, 0, 0.05), Point(0.01, 0, 0.05), Point(0, 0.01, 0.05), 0.04, "ring", 2);
  const vpTrackedModel alone = builder.build("circle");
  REQUIRE(alone.circles().size() == 1);
  CHECK(alone.circles()[0].normal.isApprox(Point::UnitZ()));
  CHECK(alone.faces()[static_cast<std::size_t>(alone.circles()[0].face)].name == "ring");
  CHECK(alone.triangles().empty());
  CHECK(alone.diameter() == Approx(0.08 * std::sqrt(2.)));
  modelShapes::add(builder, modelShapes::boxPolygons(Point(0.1, 0.1, 0.1)));
  CHECK(builder.build("circle on a box").isConvex());
  builder.addCircle(Point(0, 0, 0.06), Point(0.01, 0, 0.06), Point(0, 0.01, 0.06), 0.04);
  CHECK_FALSE(builder.build("circle over a box").isConvex());
}
