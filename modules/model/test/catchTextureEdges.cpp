// SPDX-License-Identifier: GPL-2.0-or-later
#include <catchMain.h>

#include "texturedShapes.h"

#include <visp3/core/vpException.h>
#include <visp3/model/vpTextureEdges.h>

using namespace texturedShapes;

namespace {
const Polygon sheet = {Point(0., 0., 0.), Point(0.2, 0., 0.), Point(0.2, 0.1, 0.), Point(0., 0.1, 0.)};

//! 200 x 100 mm in the plane z = 0, seen from +z; 4 texels to the millimetre.
vpTrackedModel printedSheet(const std::vector<Print> &prints, unsigned char ground = 60)
{
  vpTrackedModelBuilder builder;
  addPicture(builder, sheet, builder.addImage(printed(800, 400, ground, prints)));
  return builder.build("sheet");
}

bool same(const std::vector<vpTextureEdge> &a, const std::vector<vpTextureEdge> &b)
{
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const vpTextureEdge &p, const vpTextureEdge &q) {
    return p.position == q.position && p.normal == q.normal && p.contrast == exactly(q.contrast) &&
           p.clearance == exactly(q.clearance);
  });
}

//! Number of edges whose both ends lie, within a distance, where a coordinate has a value.
std::size_t countAlong(const std::vector<vpTextureEdge> &edges, int axis, double value, double tolerance)
{
  return static_cast<std::size_t>(std::count_if(edges.begin(), edges.end(), [&](const vpTextureEdge &edge) {
    return std::fabs(edge.position[0][axis] - value) < tolerance &&
           std::fabs(edge.position[1][axis] - value) < tolerance;
  }));
}
} // namespace

TEST_CASE("The sides of a printed rectangle are found to a tenth of a millimetre")
{
  const std::vector<vpTextureEdge> edges = vpFindTextureEdges(printedSheet({{200, 600, 100, 300, 200}}));
  REQUIRE(edges.size() == 4);
  CHECK(countAlong(edges, 0, 0.05, 1e-4) == 1);
  CHECK(countAlong(edges, 0, 0.15, 1e-4) == 1);
  CHECK(countAlong(edges, 1, 0.025, 1e-4) == 1);
  CHECK(countAlong(edges, 1, 0.075, 1e-4) == 1);
  const Point middle(0.1, 0.05, 0.);
  for (const vpTextureEdge &edge : edges) {
    CHECK(edge.contrast == Approx(140.).epsilon(0.05));
    CHECK(std::fabs(edge.normal.z()) == Approx(1.).margin(1e-6));
    CHECK(std::fabs(edge.position[0].z()) < 1e-6);
    // Bright print: going along the edge, its inside is on the left.
    const Point left = edge.normal.cross(edge.position[1] - edge.position[0]);
    CHECK(left.dot(middle - edge.position[0]) > 0.);
  }
  // The longest are first, and reach to near the corners.
  CHECK((edges[0].position[1] - edges[0].position[0]).norm() == Approx(0.1).margin(0.006));
  CHECK((edges[3].position[1] - edges[3].position[0]).norm() == Approx(0.05).margin(0.006));
}

TEST_CASE("An oblique side is found as one straight edge")
{
  vpImage<vpRGBa> picture = printed(800, 400, 60, {});
  for (unsigned int i = 0; i < 400; ++i) {
    for (unsigned int j = 0; j < 200 + i / 2; ++j) {
      picture[i][j] = vpRGBa(180, 180, 180, 255);
    }
  }
  vpTrackedModelBuilder builder;
  addPicture(builder, sheet, builder.addImage(picture));
  const std::vector<vpTextureEdge> edges = vpFindTextureEdges(builder.build("oblique"));
  REQUIRE(edges.size() == 1);
  for (const Point &end : edges[0].position) {
    CHECK(end.x() == Approx(0.05 + 0.5 * (0.1 - end.y())).margin(2e-4));
  }
}

TEST_CASE("Clearance is the distance to what is printed beside an edge")
{
  // A line 5 mm wide, and a step far from anything.
  const std::vector<vpTextureEdge> edges =
      vpFindTextureEdges(printedSheet({{100, 120, 50, 350, 200}, {500, 800, 0, 400, 200}}));
  REQUIRE(edges.size() == 3);
  for (const vpTextureEdge &edge : edges) {
    if (edge.position[0].x() < 0.1) {
      CHECK(edge.clearance == Approx(0.004).margin(0.0015));
    } else {
      CHECK(edge.clearance > 0.02);
    }
  }
}

TEST_CASE("Weak and short print gives no edges")
{
  CHECK(vpFindTextureEdges(printedSheet({{200, 600, 100, 300, 80}})).empty());
  CHECK(vpFindTextureEdges(printedSheet({{200, 220, 100, 120, 255}})).empty());
  vpTextureEdgeOptions options;
  options.minContrast = 15.;
  CHECK(vpFindTextureEdges(printedSheet({{200, 600, 100, 300, 80}}), options).size() == 4);
}

TEST_CASE("Colours of a mesh's triangles have edges, too, across coplanar triangles")
{
  vpTrackedModelBuilder builder;
  const auto addStripe = [&](double from, double to, float gray) {
    const Polygon p = {Point(from, 0., 0.), Point(to, 0., 0.), Point(to, 0.1, 0.), Point(from, 0.1, 0.)};
    for (const std::array<std::size_t, 3> &triangle : {std::array<std::size_t, 3>{{0, 1, 2}}, {{0, 2, 3}}}) {
      std::array<vpTrackedModelBuilder::Corner, 3> c;
      for (std::size_t k = 0; k < 3; ++k) {
        c[k].position = p[triangle[k]];
        c[k].color.setConstant(gray);
      }
      builder.addTriangle(c);
    }
  };
  addStripe(0., 0.08, 0.2F);
  addStripe(0.08, 0.2, 0.7F);
  const std::vector<vpTextureEdge> edges = vpFindTextureEdges(builder.build("stripes"));
  REQUIRE(edges.size() == 1);
  CHECK(countAlong(edges, 0, 0.08, 1e-4) == 1);
  CHECK(edges[0].contrast == Approx(0.5 * 255.).epsilon(0.05));
}

TEST_CASE("Edges of print on a curved surface lie on it")
{
  // Half a cylinder of radius 50 mm around y, dark for y < 0 and bright above, in facets of 5 degrees.
  vpTrackedModelBuilder builder;
  const int image = builder.addImage(printed(8, 400, 40, {{0, 8, 0, 200, 220}}));
  const double radius = 0.05;
  const auto at = [&](int i, double y) {
    return Point(radius * std::sin(i * M_PI / 36.), y, radius * std::cos(i * M_PI / 36.));
  };
  for (int i = -18; i < 18; ++i) {
    addPicture(builder, {at(i, -0.05), at(i + 1, -0.05), at(i + 1, 0.05), at(i, 0.05)}, image);
  }
  vpTextureEdgeOptions options;
  options.minLength = 0.02;
  const std::vector<vpTextureEdge> edges = vpFindTextureEdges(builder.build("half cylinder"), options);
  REQUIRE(edges.size() > 5);
  for (const vpTextureEdge &edge : edges) {
    for (const Point &end : edge.position) {
      CHECK(std::fabs(end.y()) < 2e-4);
      CHECK(std::hypot(end.x(), end.z()) == Approx(radius).margin(3e-4));
    }
    const Point middle = 0.5 * (edge.position[0] + edge.position[1]);
    CHECK(edge.normal.dot(Point(middle.x(), 0., middle.z()).normalized()) > 0.99);
  }
}

TEST_CASE("The same model gives the same edges to the last bit, the best ones first")
{
  const std::vector<Print> prints = {{100, 300, 50, 200, 200}, {350, 700, 100, 350, 120}, {120, 280, 250, 300, 160}};
  const std::vector<vpTextureEdge> edges = vpFindTextureEdges(printedSheet(prints));
  REQUIRE(edges.size() == 12);
  CHECK(same(edges, vpFindTextureEdges(printedSheet(prints))));
  vpTextureEdgeOptions options;
  options.maxEdges = 3;
  CHECK(same(vpFindTextureEdges(printedSheet(prints), options), {edges[0], edges[1], edges[2]}));
}

TEST_CASE("A model without texture has no texture edges")
{
  vpTrackedModelBuilder polygons;
  modelShapes::add(polygons, modelShapes::boxPolygons(Point(0.1, 0.1, 0.1)));
  CHECK(vpFindTextureEdges(polygons.build("box")).empty());
  vpTrackedModelBuilder mesh;
  addPicture(mesh, sheet, -1);
  CHECK(vpFindTextureEdges(mesh.build("sheet")).empty());
}

TEST_CASE("Options out of range are refused")
{
  const vpTrackedModel model = printedSheet({});
  vpTextureEdgeOptions options;
  options.resolution = 10.;
  CHECK_THROWS_AS(vpFindTextureEdges(model, options), vpException);
  options = vpTextureEdgeOptions();
  options.minContrast = 0.;
  CHECK_THROWS_AS(vpFindTextureEdges(model, options), vpException);
  options = vpTextureEdgeOptions();
  options.minLength = 2.;
  CHECK_THROWS_AS(vpFindTextureEdges(model, options), vpException);
  options = vpTextureEdgeOptions();
  options.maxEdges = 0;
  CHECK_THROWS_AS(vpFindTextureEdges(model, options), vpException);
}
