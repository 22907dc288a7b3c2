// SPDX-License-Identifier: GPL-2.0-or-later
#include "generate/gridSolid.h"
#include "generate/printTexture.h"

#include <visp3/se3/vpPoseRandom.h>

#include <cmath>

#ifdef ENABLE_VISP_NAMESPACE
using namespace VISP_NAMESPACE_NAME;
#endif

namespace bench {
namespace {
//! Texture coordinates that show a picture upright and unmirrored from outside: u to the right, v down.
void mapPicture(const GridSolid::Side &side, ColoredTriangle &triangle)
{
  // The side's first edge is the picture's right in the turn of its corners, its second one is up.
  const Eigen::Vector3d right = side.corner[1] - side.corner[0];
  const Eigen::Vector3d up = side.corner[3] - side.corner[0];
  for (std::size_t i = 0; i < 3; ++i) {
    const Eigen::Vector3d from = triangle.position[i] - side.corner[0];
    triangle.texture[i] << static_cast<float>(from.dot(right) / right.squaredNorm()),
        static_cast<float>(1. - from.dot(up) / up.squaredNorm());
  }
}
} // namespace

SyntheticObject makeBox(std::uint64_t seed)
{
  SyntheticObject object;
  object.name = "box";
  object.id = 1;
  object.materials = {SurfaceMaterial{0.15F, 30.F, 0.F, 0.F}};
  const double pixelsPerMetre = 4500.;
  const GridSolid solid = boxSolid(Eigen::Vector3d::Zero(), Eigen::Vector3d(0.16, 0.10, 0.06));
  solid.addTo(
      object, [](const GridSolid::Side &) { return Eigen::Vector3f(1.F, 1.F, 1.F); }, 0);
  for (std::size_t i = 0; i < solid.sides().size(); ++i) {
    const GridSolid::Side &side = solid.sides()[i];
    const double width = (side.corner[1] - side.corner[0]).norm();
    const double height = (side.corner[3] - side.corner[0]).norm();
    object.images.push_back(printTexture(static_cast<int>(std::lround(width * pixelsPerMetre)),
                                         static_cast<int>(std::lround(height * pixelsPerMetre)), seed, i));
    for (std::size_t half = 0; half < 2; ++half) {
      object.triangles[2 * i + half].image = static_cast<int>(i);
      mapPicture(side, object.triangles[2 * i + half]);
    }
  }
  CaoText cao;
  solid.addTo(cao, "box");
  object.cao = cao.text();
  return object;
}

SyntheticObject makeBands(std::uint64_t seed)
{
  SyntheticObject object;
  object.name = "bands";
  object.id = 2;
  object.materials = {SurfaceMaterial{0.10F, 15.F, 0.F, 0.F}};
  vpPoseRandom random(seed, {0x62616e6473});
  const double gray = 0.5 + 0.1 * random.uniform();
  // Not symmetric, so that the pose is unique although most edges have parallel ones close by.
  const std::array<std::vector<double>, 3> lines = {{gridLines(0.16, {-0.067, -0.058, 0.049, 0.055}),
                                                     gridLines(0.10, {-0.040, -0.033}),
                                                     gridLines(0.06, {0.017, 0.023})}};
  const GridSolid solid(lines, [](const GridSolid::Cell &) { return true; });
  const auto color = [gray](const GridSolid::Side &side) {
    const bool band = (side.axis != 0 && (side.cell[0] == 1 || side.cell[0] == 3)) ||
                      (side.axis != 1 && side.cell[1] == 1) || (side.axis != 2 && side.cell[2] == 1);
    const double value = gray + (band ? -0.16 : 0.);
    return Eigen::Vector3f(static_cast<float>(value * 1.03), static_cast<float>(value),
                           static_cast<float>(value * 0.96));
  };
  solid.addTo(object, color, 0);
  CaoText cao;
  solid.addTo(cao, "bands", color);
  object.cao = cao.text();
  return object;
}

} // namespace bench
