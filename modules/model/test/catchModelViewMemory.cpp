// SPDX-License-Identifier: GPL-2.0-or-later
#include <catchMain.h>

#include "texturedShapes.h"
#include "viewChecks.h"

#include <cstdlib>
#include <new>

using namespace modelShapes;
using namespace viewChecks;

namespace {
long allocations = 0;
}

// Counts what anything in the process allocates.
void *operator new(std::size_t size)
{
  ++allocations;
  if (void *memory = std::malloc(size == 0 ? 1 : size)) {
    return memory;
  }
  throw std::bad_alloc();
}

// Standard algorithms ask for temporary memory so; AddressSanitizer has its own one unless it is replaced with the
// rest.
void *operator new(std::size_t size, const std::nothrow_t &) noexcept
{
  ++allocations;
  return std::malloc(size == 0 ? 1 : size);
}

void operator delete(void *memory) noexcept
{
  std::free(memory);
}

void operator delete(void *memory, std::size_t) noexcept
{
  std::free(memory);
}

namespace {
//! Everything that a view has: polygons, a cylinder, a circle, a line, and a mesh with rims.
vpTrackedModel everything()
{
  vpTrackedModelBuilder builder;
  add(builder, lPolygons(0.1, 0.05));
  add(builder, sphereTriangles(0.03, 20, 40));
  builder.addCylinder(Point(-0.05, 0., 0.), Point(-0.05, 0.1, 0.), 0.02);
  builder.addCircle(Point(0.02, 0.02, 0.05), Point(0.03, 0.02, 0.05), Point(0.02, 0.03, 0.05), 0.01);
  builder.addLine(Point(0., 0., 0.1), Point(0.1, 0.1, 0.1));
  return builder.build("everything");
}

bool same(const vpControlPoint &a, const vpControlPoint &b)
{
  return a.position == b.position && a.direction == b.direction && a.pixel == b.pixel && a.normal == b.normal &&
         a.kind == b.kind && a.slides == b.slides && a.side == exactly(b.side) && a.contour == b.contour &&
         a.arcLength == exactly(b.arcLength) && a.edge == b.edge && a.parameter == exactly(b.parameter);
}

bool same(const std::vector<vpControlPoint> &a, const std::vector<vpControlPoint> &b)
{
  return a.size() == b.size() &&
         std::equal(a.begin(), a.end(), b.begin(),
                    [](const vpControlPoint &p, const vpControlPoint &q) { return same(p, q); });
}
} // namespace

TEST_CASE("A second view from the same pose allocates nothing")
{
  Looker looker(everything());
  const vpHomogeneousMatrix cMo = lookFrom(Point(1., 0.7, 1.2), 0.5);
  looker.look(cMo);
  const vpControlPoint *points = looker.points().data();
  const vpContour *contours = looker.view().contours().data();
  const long before = allocations;
  looker.look(cMo);
  const long after = allocations;
  CHECK(after == before);
  CHECK(looker.points().data() == points);
  CHECK(looker.view().contours().data() == contours);
}

TEST_CASE("Views from poses around one that was seen allocate nothing once the memory has grown")
{
  Looker looker(everything());
  const auto pose = [](int i) { return lookFrom(Point(1., 0.7, 1.2), 0.5 + 0.002 * i, 0.02 * i); };
  for (int i = 0; i < 10; ++i) {
    looker.look(pose(i));
  }
  const long before = allocations;
  for (int i = 9; i >= 0; --i) {
    looker.look(pose(i));
  }
  const long after = allocations;
  CHECK(after == before);
}

TEST_CASE("Views with edges of the texture allocate nothing once the memory has grown, and are the same again")
{
  vpTrackedModelBuilder builder;
  texturedShapes::addPrintedBox(builder, Point(0.2, 0.2, 0.2),
                                texturedShapes::printed(400, 400, 60, {{100, 300, 100, 300, 200}}));
  Looker looker(builder.build("printed cube"));
  looker.options.textureEdges = true;
  const auto pose = [](int i) { return lookFrom(Point(1., 0.7, 1.2), 0.7 + 0.002 * i, 0.02 * i); };
  const std::vector<vpControlPoint> first = looker.look(pose(0)).points();
  for (int i = 0; i < 10; ++i) {
    looker.look(pose(i));
  }
  REQUIRE(looker.view().textureEdgeOf(looker.points().back()) >= 0);
  const long before = allocations;
  for (int i = 9; i >= 0; --i) {
    looker.look(pose(i));
  }
  const long after = allocations;
  CHECK(after == before);
  CHECK(same(looker.points(), first));
}

TEST_CASE("The same pose gives the same control points to the last bit")
{
  Looker looker(everything());
  const vpHomogeneousMatrix cMo = lookFrom(Point(-1., 0.9, 0.8), 0.45, 0.3);
  const std::vector<vpControlPoint> first = looker.look(cMo).points();
  REQUIRE(first.size() > 100);
  looker.look(lookFrom(Point(1., -0.9, 0.3), 0.6));
  CHECK_FALSE(same(looker.points(), first));
  CHECK(same(looker.look(cMo).points(), first));
  Looker other(everything());
  CHECK(same(other.look(cMo).points(), first));
}

TEST_CASE("A copy of a view has the same model and gives the same control points")
{
  const auto model = std::make_shared<const vpTrackedModel>(everything());
  vpCpuRenderer renderer(model);
  const vpCameraParameters cam(600., 610., 321.3, 238.6);
  const vpModelViewOptions options;
  vpModelView view(model);
  view.compute(lookFrom(Point(1., 1., 1.), 0.5), cam, 640, 480, options, &renderer);
  const std::vector<vpControlPoint> points = view.points();
  vpModelView copy(view);
  CHECK(&copy.model() == &view.model());
  CHECK(&copy.model() == model.get());
  CHECK(same(copy.points(), points));
  copy.compute(lookFrom(Point(1., -1., 1.), 0.5), cam, 640, 480, options, &renderer);
  CHECK(same(view.points(), points));
  copy.compute(lookFrom(Point(1., 1., 1.), 0.5), cam, 640, 480, options, &renderer);
  CHECK(same(copy.points(), points));
}
