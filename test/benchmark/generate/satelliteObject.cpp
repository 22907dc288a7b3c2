// SPDX-License-Identifier: GPL-2.0-or-later
#include "generate/gridSolid.h"

#include <visp3/se3/vpPoseRandom.h>

#include <Eigen/Geometry>

#include <cmath>

#ifdef ENABLE_VISP_NAMESPACE
using namespace VISP_NAMESPACE_NAME;
#endif

namespace bench {
namespace {
using Point = Eigen::Vector3d;

enum Part
{
  FOIL,
  CELLS,
  METAL,
  PAINT
};

GridSolid::Color plain(float red, float green, float blue)
{
  return [=](const GridSolid::Side &) { return Eigen::Vector3f(red, green, blue); };
}

//! Lines of a panel: alternately a thin gap and a cell, from a start to an end.
std::vector<double> cellLines(double from, double to, int cells, double gap)
{
  const double step = (to - from - gap) / cells;
  std::vector<double> lines;
  for (int i = 0; i < cells; ++i) {
    lines.push_back(from + i * step);
    lines.push_back(from + i * step + gap);
  }
  lines.push_back(to - gap);
  lines.push_back(to);
  return lines;
}

//! A wing of cells between two distances from the body, in the x-y plane.
void addPanel(double from, double to, const std::string &name, SyntheticObject &object, CaoText &cao)
{
  const std::array<std::vector<double>, 3> lines = {
      {cellLines(from, to, 6, 0.010), cellLines(-0.36, 0.36, 4, 0.010), {-0.012, 0.012}}};
  const GridSolid solid(lines, [](const GridSolid::Cell &) { return true; });
  const auto color = [](const GridSolid::Side &side) -> Eigen::Vector3f {
    if (side.axis != 2) {
      return {0.55F, 0.55F, 0.55F};
    }
    if (side.direction < 0) {
      return {0.62F, 0.60F, 0.56F}; // The back has no cells.
    }
    const bool cell = side.cell[0] % 2 == 1 && side.cell[1] % 2 == 1;
    const float tone = (side.cell[0] / 2 + side.cell[1] / 2) % 2 == 0 ? 1.F : 0.8F;
    return cell ? Eigen::Vector3f(tone * Eigen::Vector3f(0.09F, 0.13F, 0.42F)) : Eigen::Vector3f(0.66F, 0.66F, 0.70F);
  };
  solid.addTo(object, color, CELLS);
  solid.addTo(cao, name);
}

void addBlock(const Point &centre, const Point &size, const GridSolid::Color &color, Part part, const std::string &name,
              SyntheticObject &object, CaoText &cao)
{
  const GridSolid solid = boxSolid(centre, size);
  solid.addTo(object, color, part);
  solid.addTo(cao, name);
}

void addTriangle(const Point &a, const Point &b, const Point &c, const Eigen::Vector3f &color, Part part,
                 SyntheticObject &object)
{
  ColoredTriangle triangle;
  triangle.position = {{a, b, c}};
  triangle.color.fill(color);
  triangle.texture.fill(Eigen::Vector2f::Zero());
  triangle.part = part;
  object.triangles.push_back(triangle);
}

//! A closed surface of revolution. \param profile Radius and height from its axis's one end to the other, both on it.
void addTurned(const Point &base, const Point &axis, const std::vector<Eigen::Vector2d> &profile, int segments,
               const Eigen::Vector3f &color, Part part, SyntheticObject &object)
{
  const Point u = axis.unitOrthogonal();
  const Point v = axis.cross(u);
  const auto at = [&](std::size_t ring, int segment) -> Point {
    const double angle = 2. * M_PI * (segment % segments) / segments;
    return base + profile[ring].y() * axis + profile[ring].x() * (std::cos(angle) * u + std::sin(angle) * v);
  };
  for (std::size_t ring = 0; ring + 1 < profile.size(); ++ring) {
    for (int s = 0; s < segments; ++s) {
      if (profile[ring].x() > 0.) {
        addTriangle(at(ring, s), at(ring, s + 1), at(ring + 1, s + 1), color, part, object);
      }
      if (profile[ring + 1].x() > 0.) {
        addTriangle(at(ring, s), at(ring + 1, s + 1), at(ring + 1, s), color, part, object);
      }
    }
  }
}

//! A dish that opens along an axis; its rim is a circle in the .cao.
void addDish(const Point &base, const Point &axis, SyntheticObject &object, CaoText &cao)
{
  const double radius = 0.36;
  const double depth = 0.13;
  const double thickness = 0.012;
  const int rings = 8;
  std::vector<Eigen::Vector2d> profile;
  for (int i = 0; i <= rings; ++i) {
    const double r = radius * i / rings;
    profile.emplace_back(r, depth * r * r / (radius * radius));
  }
  for (int i = rings; i >= 0; --i) {
    const double r = radius * i / rings;
    profile.emplace_back(r, depth * r * r / (radius * radius) + thickness);
  }
  addTurned(base, axis, profile, 48, Eigen::Vector3f(0.72F, 0.72F, 0.70F), PAINT, object);
  const Point u = axis.unitOrthogonal();
  const Point rim = base + (depth + thickness) * axis;
  cao.addCircle(rim, rim + radius * u, rim + radius * axis.cross(u), radius, "dish");
}

void addBoom(const Point &start, const Point &end, double radius, const std::string &name, SyntheticObject &object,
             CaoText &cao)
{
  const double length = (end - start).norm();
  const std::vector<Eigen::Vector2d> profile = {{0., 0.}, {radius, 0.}, {radius, length}, {0., length}};
  addTurned(start, (end - start) / length, profile, 24, Eigen::Vector3f(0.70F, 0.70F, 0.72F), METAL, object);
  cao.addCylinder(start, end, radius, name);
}
} // namespace

SyntheticObject makeSatellite(std::uint64_t seed)
{
  SyntheticObject object;
  object.name = "satellite";
  object.id = 4;
  object.pixelDiameter = 290.;
  object.inSpace = true;
  vpPoseRandom random(seed, {0x736174});
  const float gold = static_cast<float>(0.95 + 0.1 * random.uniform());
  object.materials = {SurfaceMaterial{0.9F, 14.F, 0.30F, 0.055F}, SurfaceMaterial{0.55F, 60.F, 0.F, 0.F},
                      SurfaceMaterial{0.35F, 20.F, 0.F, 0.F}, SurfaceMaterial{0.05F, 10.F, 0.F, 0.F}};
  CaoText cao;
  addBlock({0., 0., 0.}, {0.70, 0.84, 0.80}, plain(0.72F * gold, 0.52F * gold, 0.20F * gold), FOIL, "body", object,
           cao);
  addBlock({0.44, 0., 0.}, {0.18, 0.06, 0.05}, plain(0.6F, 0.6F, 0.6F), METAL, "right_yoke", object, cao);
  addBlock({-0.44, 0., 0.}, {0.18, 0.06, 0.05}, plain(0.6F, 0.6F, 0.6F), METAL, "left_yoke", object, cao);
  addPanel(0.53, 1.45, "right_panel", object, cao);
  addPanel(-1.45, -0.53, "left_panel", object, cao);
  addBlock({-0.12, 0.47, 0.14}, {0.30, 0.10, 0.34}, plain(0.75F, 0.75F, 0.73F), PAINT, "instrument", object, cao);
  addDish({0.06, -0.05, 0.46}, Point::UnitZ(), object, cao);
  addBoom({0.06, -0.05, 0.40}, {0.06, -0.05, 0.46}, 0.06, "dish_foot", object, cao);
  addBoom({0.22, 0.42, -0.25}, {0.22, 0.95, -0.25}, 0.025, "boom", object, cao);
  object.cao = cao.text();
  return object;
}

} // namespace bench
