// SPDX-License-Identifier: GPL-2.0-or-later
#include <catchMain.h>

#include "texturedShapes.h"
#include "viewChecks.h"

using namespace texturedShapes;
using namespace viewChecks;

namespace {
const Point boxSize(0.2, 0.2, 0.2);

//! A cube with a bright square of half its width on each side.
vpTrackedModel printedCube()
{
  vpTrackedModelBuilder builder;
  addPrintedBox(builder, boxSize, printed(400, 400, 60, {{100, 300, 100, 300, 200}}));
  return builder.build("printed cube");
}

class TexturedLooker : public Looker
{
public:
  explicit TexturedLooker(vpTrackedModel model) : Looker(std::move(model)) { options.textureEdges = true; }
};

std::vector<vpControlPoint> texturePoints(const Looker &looker)
{
  std::vector<vpControlPoint> points;
  std::copy_if(looker.points().begin(), looker.points().end(), std::back_inserter(points),
               [&](const vpControlPoint &point) { return looker.view().textureEdgeOf(point) >= 0; });
  return points;
}

//! Distance of a point of the cube's surface from the nearest side of the printed square on its face, metres.
double offSquare(const Point &position)
{
  Eigen::Index axis = 0;
  position.cwiseAbs().maxCoeff(&axis);
  const double a = std::fabs(position[(axis + 1) % 3]);
  const double b = std::fabs(position[(axis + 2) % 3]);
  return std::max(std::fabs(std::max(a, b) - 0.05), std::fabs(position.cwiseAbs()[axis] - 0.1));
}
} // namespace

TEST_CASE("Edges of the texture are inner control points where they are printed")
{
  TexturedLooker looker(printedCube());
  looker.look(lookFrom(Point(1., 0.8, 0.9), 0.7));
  const std::vector<vpControlPoint> points = texturePoints(looker);
  CHECK(points.size() > 50);
  for (const vpControlPoint &point : points) {
    CHECK(offSquare(point.position) < 2e-4);
    CHECK(point.kind == vpEdgeKind::INNER);
    CHECK_FALSE(point.slides);
    CHECK(point.edge < looker.view().edgeNames());
  }
  CHECK(projectionError(looker) < 1e-6);
  CHECK(normalError(looker) < 1e-4);
  CHECK(contoursHoldAllPoints(looker.view()));
  CHECK(arcLengthError(looker.view()) < 1e-6);
}

TEST_CASE("Print on sides that are turned away is not seen")
{
  TexturedLooker looker(printedCube());
  looker.look(lookFrom(Point(0., 0., 1.), 0.7));
  const std::vector<vpControlPoint> points = texturePoints(looker);
  REQUIRE(points.size() > 20);
  for (const vpControlPoint &point : points) {
    CHECK(point.position.z() == Approx(0.1).margin(1e-4));
  }
}

TEST_CASE("Print behind another part of the object is not seen")
{
  vpTrackedModelBuilder builder;
  addPrintedBox(builder, boxSize, printed(400, 400, 60, {{100, 300, 100, 300, 200}}));
  // A plain box in front of the right half of the side +z.
  for (const Polygon &side : modelShapes::boxPolygons(Point(0.1, 0.3, 0.02), Point(0.06, 0., 0.2))) {
    addPicture(builder, side, -1);
  }
  TexturedLooker looker(builder.build("half hidden"));
  looker.look(lookFrom(Point(0., 0., 1.), 0.9));
  const std::vector<vpControlPoint> points = texturePoints(looker);
  REQUIRE(points.size() > 10);
  for (const vpControlPoint &point : points) {
    CHECK_FALSE(isWellHidden(looker, point.position, 3., 0.01));
    CHECK(point.position.x() < 0.03);
  }
}

TEST_CASE("Texture gives at most as many control points as geometry, and none unless asked for")
{
  TexturedLooker looker(printedCube());
  const vpHomogeneousMatrix cMo = lookFrom(Point(0.1, 0.2, 1.), 0.45);
  looker.look(cMo);
  const std::size_t all = looker.points().size();
  const std::size_t fromTexture = texturePoints(looker).size();
  CHECK(fromTexture > 0);
  looker.options.textureEdges = false;
  looker.look(cMo);
  CHECK(texturePoints(looker).empty());
  CHECK(looker.points().size() == all - fromTexture);
  CHECK(looker.view().edgeNames() == 12);
  // A contour more than fills the limit at most.
  CHECK(fromTexture <= looker.points().size() + 60);
}

TEST_CASE("What is left out does not appear")
{
  TexturedLooker looker(printedCube());
  const vpHomogeneousMatrix cMo = lookFrom(Point(0., 0., 1.), 0.7);
  looker.look(cMo);
  REQUIRE_FALSE(texturePoints(looker).empty());
  const int dropped = looker.view().textureEdgeOf(texturePoints(looker).front());
  looker.options.textureEdgesLeftOut.assign(looker.view().textureEdges().size(), 0);
  looker.options.textureEdgesLeftOut[static_cast<std::size_t>(dropped)] = 1;
  looker.look(cMo);
  REQUIRE_FALSE(texturePoints(looker).empty());
  for (const vpControlPoint &point : texturePoints(looker)) {
    CHECK(looker.view().textureEdgeOf(point) != dropped);
  }
}

TEST_CASE("Print too near to other edges in the image is left out, and comes back when it is seen larger")
{
  vpTrackedModelBuilder builder;
  // A bright line of 4 mm: 3 pixels in the one view, and 10 in the other.
  addPrintedBox(builder, boxSize, printed(400, 400, 60, {{196, 204, 50, 350, 200}}));
  TexturedLooker looker(builder.build("printed line"));
  looker.look(lookFrom(Point(0., 0., 1.), 0.8));
  CHECK(texturePoints(looker).empty());
  looker.look(lookFrom(Point(0., 0., 1.), 0.35));
  CHECK(texturePoints(looker).size() > 50);
}

TEST_CASE("Print that runs beside an edge of the geometry is left out")
{
  vpTrackedModelBuilder builder;
  addPrintedBox(builder, boxSize, printed(400, 400, 60, {{14, 386, 14, 386, 200}}));
  TexturedLooker looker(builder.build("printed border"));
  looker.look(lookFrom(Point(0., 0., 1.), 1.2));
  CHECK(texturePoints(looker).empty());
  looker.look(lookFrom(Point(0., 0., 1.), 0.5));
  CHECK(texturePoints(looker).size() > 50);
}

TEST_CASE("A model without texture gives the same view with and without texture edges")
{
  vpTrackedModelBuilder builder;
  modelShapes::add(builder, modelShapes::boxPolygons(boxSize));
  Looker looker(builder.build("plain"));
  const vpHomogeneousMatrix cMo = lookFrom(Point(1., 0.8, 0.9), 0.7);
  const std::size_t before = looker.look(cMo).points().size();
  const int names = looker.view().edgeNames();
  looker.options.textureEdges = true;
  CHECK(looker.look(cMo).points().size() == before);
  CHECK(looker.view().edgeNames() == names);
}
