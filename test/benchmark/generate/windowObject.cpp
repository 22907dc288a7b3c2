// SPDX-License-Identifier: GPL-2.0-or-later
#include "generate/gridSolid.h"

#include <visp3/se3/vpPoseRandom.h>

#ifdef ENABLE_VISP_NAMESPACE
using namespace VISP_NAMESPACE_NAME;
#endif

namespace bench {
namespace {
// Cells of the grid along x: wall, left stile, left pane, middle stile, right pane, right stile, wall.
const std::vector<double> columns = {-0.600, -0.440, -0.385, -0.030, 0.030, 0.385, 0.440, 0.600};
// Along y: lower wall, sill, bottom rail, panes, top rail, wall above.
const std::vector<double> rows = {-0.50, -0.38, -0.33, -0.275, 0.29, 0.345, 0.50};
// Along z, towards the viewer: to the panes, the rails, the stiles, the wall, the sill.
const std::vector<double> depths = {-0.16, -0.10, -0.065, -0.05, 0.0, 0.07};

enum Front
{
  PANE = 1,
  RAIL = 2,
  STILE = 3,
  WALL = 4,
  SILL = 5
};

//! How many cells of depth a column and row has: all joints are steps, so that every edge of a face is a real one.
int frontOf(int column, int row)
{
  if (row == 1) {
    return SILL;
  }
  if (column == 0 || column == 6 || row == 0 || row == 5) {
    return WALL;
  }
  if (column == 1 || column == 3 || column == 5) {
    return STILE;
  }
  return row == 2 || row == 4 ? RAIL : PANE;
}

bool belongsToFrame(const GridSolid::Side &side)
{
  const int front = frontOf(side.cell[0], side.cell[1]);
  return front == STILE || front == RAIL;
}
} // namespace

SyntheticObject makeWindow(std::uint64_t seed)
{
  SyntheticObject object;
  object.name = "window";
  object.id = 3;
  object.pixelDiameter = 250.;
  object.frontOnly = true;
  object.materials = {SurfaceMaterial{0.04F, 8.F, 0.F, 0.F}, SurfaceMaterial{0.5F, 40.F, 0.F, 0.F}};
  vpPoseRandom random(seed, {0x77696e646f77});
  const float shade = static_cast<float>(0.95 + 0.1 * random.uniform());
  const GridSolid solid({{columns, rows, depths}},
                        [](const GridSolid::Cell &cell) { return cell[2] < frontOf(cell[0], cell[1]); });
  const auto color = [shade](const GridSolid::Side &side) -> Eigen::Vector3f {
    if (frontOf(side.cell[0], side.cell[1]) == PANE) {
      return Eigen::Vector3f(0.20F, 0.25F, 0.29F);
    }
    if (belongsToFrame(side)) {
      return shade * Eigen::Vector3f(0.86F, 0.85F, 0.82F);
    }
    if (frontOf(side.cell[0], side.cell[1]) == SILL) {
      return shade * Eigen::Vector3f(0.66F, 0.64F, 0.60F);
    }
    return shade * Eigen::Vector3f(0.74F, 0.66F, 0.55F);
  };
  solid.addTo(object, color, 0);
  for (ColoredTriangle &triangle : object.triangles) {
    // Glass alone is that dark.
    triangle.part = triangle.color[0].x() < 0.3F ? 1 : 0;
  }
  CaoText cao;
  solid.addTo(cao, "window");
  object.cao = cao.text();
  return object;
}

} // namespace bench
