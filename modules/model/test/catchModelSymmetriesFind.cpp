// SPDX-License-Identifier: GPL-2.0-or-later
// Symmetries that are found in a model.
#include <catchMain.h>

#include "modelShapes.h"

#include <visp3/core/vpException.h>
#include <visp3/model/vpModelSymmetries.h>
#include <visp3/se3/vpPoseExponential.h>

#include <algorithm>
#include <cmath>

namespace {
using modelShapes::Point;

vpModelSymmetries findIn(const vpTrackedModel &model, const vpSymmetryOptions &options = vpSymmetryOptions())
{
  return vpFindSymmetries(model, options);
}

template <typename Shape> vpModelSymmetries find(const Shape &shape)
{
  return findIn(modelShapes::build(shape));
}

// Turned, so that no axis is one of the frame's.
template <typename Shape> Shape askew(Shape shape)
{
  const Eigen::Matrix3d R = Eigen::AngleAxisd(0.7, Point(1., 2., -0.5).normalized()).toRotationMatrix();
  for (auto &polygon : shape) {
    for (Point &corner : polygon) {
      corner = R * corner + Point(0.3, -0.1, 0.2);
    }
  }
  return shape;
}

std::vector<modelShapes::Triangle> cone(int sides)
{
  std::vector<modelShapes::Triangle> triangles;
  const auto at = [&](int i) {
    const double angle = 2. * M_PI * (i % sides) / sides;
    return Point(0.05 * std::cos(angle), 0.05 * std::sin(angle), 0.);
  };
  for (int i = 0; i < sides; ++i) {
    triangles.push_back({{at(i), at(i + 1), Point(0., 0., 0.12)}});
    triangles.push_back({{at(i + 1), at(i), Point(0., 0., 0.)}});
  }
  return triangles;
}

// The sides of a box, each of a colour of its own, or the opposite ones of the same.
vpTrackedModel coloredBox(bool oppositeAlike)
{
  const auto triangles = modelShapes::boxTriangles(Point(0.2, 0.12, 0.08));
  vpTrackedModelBuilder builder;
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    const std::size_t side = t / 2;
    const float level = 0.15F * static_cast<float>(oppositeAlike ? side / 2 : side);
    std::array<vpTrackedModelBuilder::Corner, 3> corners;
    for (std::size_t k = 0; k < 3; ++k) {
      corners[k].position = triangles[t][k];
      corners[k].color = Eigen::Vector3f(level, 0.5F, 0.2F);
    }
    builder.addTriangle(corners);
  }
  return builder.build("coloured box");
}

double angleTo(const vpSymmetryAxis &axis, const Point &direction)
{
  return std::acos(std::min(1., std::fabs(axis.direction.dot(direction.normalized())))) * 180. / M_PI;
}
} // namespace

TEST_CASE("A box looks the same after half turns, wherever it lies", "[symmetries]")
{
  const Point size(0.2, 0.12, 0.08);
  CHECK(find(modelShapes::boxPolygons(size)).discrete().size() == 4);
  CHECK(find(askew(modelShapes::boxPolygons(size))).discrete().size() == 4);
  CHECK(find(askew(modelShapes::boxTriangles(size, 3))).discrete().size() == 4);
  const vpModelSymmetries square = find(askew(modelShapes::boxPolygons(Point(0.2, 0.1, 0.1))));
  CHECK(square.discrete().size() == 8);
  CHECK(square.axes().empty());
}

TEST_CASE("A cube looks the same from 24 sides", "[symmetries]")
{
  CHECK(find(askew(modelShapes::boxPolygons(Point(0.1, 0.1, 0.1)))).discrete().size() == 24);
  CHECK(find(modelShapes::boxTriangles(Point(0.1, 0.1, 0.1), 4)).discrete().size() == 24);
}

TEST_CASE("Surfaces of revolution have an axis", "[symmetries]")
{
  const vpModelSymmetries can = find(modelShapes::cylinderTriangles(0.04, 0.12, 64));
  REQUIRE(can.axes().size() == 1);
  CHECK(angleTo(can.axes()[0], Point::UnitZ()) < 0.1);
  CHECK(can.discrete().size() == 2); // It can stand on its head.
  const vpModelSymmetries hat = find(askew(cone(48)));
  REQUIRE(hat.axes().size() == 1);
  CHECK(hat.discrete().size() == 1);
  const Eigen::Vector3d along = Eigen::AngleAxisd(0.7, Point(1., 2., -0.5).normalized()) * Point::UnitZ();
  CHECK(angleTo(hat.axes()[0], along) < 0.1);
  CHECK(find(modelShapes::sphereTriangles(0.1, 40, 60)).axes().size() == 3);
}

TEST_CASE("A cylinder of a .cao file has an axis", "[symmetries]")
{
  vpTrackedModelBuilder builder;
  const Point low(0.1, 0., -0.06), high(0.1, 0., 0.06);
  builder.addCylinder(low, high, 0.04);
  builder.addCircle(low, low + Point(0.04, 0., 0.), low + Point(0., 0.04, 0.), 0.04);
  builder.addCircle(high, high + Point(0.04, 0., 0.), high + Point(0., 0.04, 0.), 0.04);
  const vpModelSymmetries can = findIn(builder.build("can"));
  REQUIRE(can.axes().size() == 1);
  CHECK(can.axes()[0].direction.cross(Point::UnitZ()).norm() < 1e-3);
  CHECK(can.axes()[0].point.head<2>().isApprox(Eigen::Vector2d(0.1, 0.), 1e-6));
  builder.addLine(Point(0.14, 0., -0.06), Point(0.14, 0., 0.06)); // The seam.
  const vpModelSymmetries seamed = findIn(builder.build("can with a seam"));
  CHECK(seamed.axes().empty());
  CHECK(seamed.discrete().size() == 2); // About the line through the middle of the seam.
}

TEST_CASE("A prism with few sides has no axis", "[symmetries]")
{
  const vpModelSymmetries nut = find(askew(modelShapes::cylinderTriangles(0.1, 0.05, 6)));
  CHECK(nut.axes().empty());
  CHECK(nut.discrete().size() == 12);
}

TEST_CASE("What is irregular has no symmetry", "[symmetries]")
{
  CHECK(find(modelShapes::prismPolygons(
                 {Point(0., 0., 0.), Point(0.2, 0., 0.), Point(0.25, 0.1, 0.), Point(0., 0.17, 0.)},
                 0.08))
            .isEmpty()); // Upside down it is its mirror image.
  auto irregular = modelShapes::boxTriangles(Point(0.2, 0.12, 0.08), 6);
  for (auto &triangle : irregular) {
    for (Point &corner : triangle) {
      corner *= 1. + 0.9 * corner.x() + 1.3 * corner.y() * corner.z() * 50. + 0.7 * corner.y() + 0.5 * corner.z();
    }
  }
  CHECK(find(irregular).isEmpty());
  auto lump = modelShapes::sphereTriangles(0.1, 30, 40);
  for (auto &triangle : lump) {
    for (Point &corner : triangle) {
      const Point out = corner / 0.1;
      corner *= 1. + 0.2 * std::sin(3. * out.x() + 1.) + 0.15 * std::sin(4. * out.y() - 2. * out.z() + 2.);
    }
  }
  CHECK(find(lump).isEmpty());
}

TEST_CASE("One more edge is the end of all symmetry", "[symmetries]")
{
  vpTrackedModelBuilder builder;
  const Point size(0.2, 0.12, 0.08);
  modelShapes::add(builder, modelShapes::boxPolygons(size));
  CHECK(findIn(builder.build("box")).discrete().size() == 4);
  builder.addLine(Point(-0.05, 0.02, 0.04), Point(0.06, 0.01, 0.04));
  CHECK(findIn(builder.build("box with a line")).isEmpty());
}

TEST_CASE("Colours have to agree where a model has any", "[symmetries]")
{
  CHECK(findIn(coloredBox(false)).isEmpty());
  CHECK(findIn(coloredBox(true)).discrete().size() == 4);
  vpSymmetryOptions options;
  options.colorTolerance = 1.;
  CHECK(findIn(coloredBox(false), options).discrete().size() == 4);
}

TEST_CASE("Options of the search are checked", "[symmetries]")
{
  const vpTrackedModel box = modelShapes::build(modelShapes::boxPolygons(Point(0.2, 0.12, 0.08)));
  vpSymmetryOptions options;
  options.tolerance = 0.;
  CHECK_THROWS_WITH(findIn(box, options), ContainsSubstring("tolerance"));
  options = vpSymmetryOptions();
  options.mostTurns = 1;
  CHECK_THROWS_WITH(findIn(box, options), ContainsSubstring("mostTurns"));
  options = vpSymmetryOptions();
  options.colorTolerance = 2.;
  CHECK_THROWS_WITH(findIn(box, options), ContainsSubstring("colorTolerance"));
}
