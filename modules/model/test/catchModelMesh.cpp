// SPDX-License-Identifier: GPL-2.0-or-later
// Triangle soups: welding, creases, corner normals.
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

TEST_CASE("A cube of twelve triangles")
{
  const vpTrackedModel model = modelShapes::build(modelShapes::boxTriangles(cubeSize));
  checkCube(model, 12);
  CHECK(model.vertices().size() == 8);
  CHECK(model.report().flippedTriangles == 0);
  CHECK(model.report().weldedVertices == 0);
  CHECK(modelChecks::worstNormalAgreement(model) == Approx(1.));
}

TEST_CASE("The edges of a tessellated cube are its twelve edges")
{
  checkCube(modelShapes::build(modelShapes::boxTriangles(cubeSize, 9)), 6 * 9 * 9 * 2);
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
      const Point &corner = modelChecks::corner(model, triangle, k);
      worst = std::min(worst, corner.normalized().dot(modelChecks::cornerNormal(model, triangle, k)));
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
    for (std::size_t k = 0; k < 3; ++k) {
      CHECK(std::abs(modelChecks::cornerNormal(model, triangle, k).z()) == Approx(planar ? 1. : 0.).margin(1e-9));
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
