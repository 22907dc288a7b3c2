// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef modelShapes_h
#define modelShapes_h

#include <visp3/model/vpTrackedModelBuilder.h>

#include <Eigen/Geometry>

#include <array>
#include <cmath>
#include <string>
#include <vector>

/*!
  \file modelShapes.h
  Simple shapes for tests: as polygons of a .cao file, or as the triangles of a mesh. Metres, outside counter-clockwise.
*/

BEGIN_VISP_NAMESPACE
namespace modelShapes {
using Point = Eigen::Vector3d;
using Polygon = std::vector<Point>;
using Triangle = std::array<Point, 3>;

//! The six sides of a box: -x, +x, -y, +y, -z, +z.
inline std::vector<Polygon> boxPolygons(const Point &size, const Point &centre = Point::Zero())
{
  std::vector<Polygon> sides;
  for (int axis = 0; axis < 3; ++axis) {
    for (const double sign : {-1., 1.}) {
      const Point out = sign * Point::Unit(axis);
      const Point right = Point::Unit((axis + 1) % 3);
      const Point up = out.cross(right);
      const Point half = 0.5 * size;
      Polygon side;
      for (const std::array<double, 2> &corner : {std::array<double, 2>{{-1., -1.}}, std::array<double, 2>{{1., -1.}},
                                                  std::array<double, 2>{{1., 1.}}, std::array<double, 2>{{-1., 1.}}}) {
        side.push_back(centre + half.cwiseProduct(out + corner[0] * right + corner[1] * up));
      }
      sides.push_back(side);
    }
  }
  return sides;
}

//! A parallelogram as cells x cells x 2 triangles. \param corners Four, in order.
inline std::vector<Triangle> gridTriangles(const Polygon &corners, int cells)
{
  const Point right = (corners[1] - corners[0]) / cells;
  const Point up = (corners[3] - corners[0]) / cells;
  const auto at = [&](int i, int j) { return Point(corners[0] + i * right + j * up); };
  std::vector<Triangle> triangles;
  for (int i = 0; i < cells; ++i) {
    for (int j = 0; j < cells; ++j) {
      triangles.push_back({{at(i, j), at(i + 1, j), at(i + 1, j + 1)}});
      triangles.push_back({{at(i, j), at(i + 1, j + 1), at(i, j + 1)}});
    }
  }
  return triangles;
}

//! A box whose sides have cells x cells x 2 triangles each.
inline std::vector<Triangle> boxTriangles(const Point &size, int cells = 1, const Point &centre = Point::Zero())
{
  std::vector<Triangle> triangles;
  for (const Polygon &side : boxPolygons(size, centre)) {
    const std::vector<Triangle> grid = gridTriangles(side, cells);
    triangles.insert(triangles.end(), grid.begin(), grid.end());
  }
  return triangles;
}

//! A sphere around the origin with poles on the z axis.
inline std::vector<Triangle> sphereTriangles(double radius, int rings, int sectors)
{
  const auto at = [&](int ring, int sector) {
    if (ring == 0 || ring == rings) {
      return Point(0., 0., ring == 0 ? radius : -radius);
    }
    const double polar = M_PI * ring / rings;
    const double azimuth = 2. * M_PI * (sector % sectors) / sectors;
    return Point(radius *
                 Point(std::sin(polar) * std::cos(azimuth), std::sin(polar) * std::sin(azimuth), std::cos(polar)));
  };
  std::vector<Triangle> triangles;
  for (int r = 0; r < rings; ++r) {
    for (int s = 0; s < sectors; ++s) {
      if (r + 1 < rings) {
        triangles.push_back({{at(r, s), at(r + 1, s), at(r + 1, s + 1)}});
      }
      if (r > 0) {
        triangles.push_back({{at(r, s), at(r + 1, s + 1), at(r, s + 1)}});
      }
    }
  }
  return triangles;
}

//! A cylinder with caps, its axis along z, from z = 0 to z = height.
inline std::vector<Triangle> cylinderTriangles(double radius, double height, int sides)
{
  const auto at = [&](int side, double z) {
    const double angle = 2. * M_PI * (side % sides) / sides;
    return Point(radius * std::cos(angle), radius * std::sin(angle), z);
  };
  std::vector<Triangle> triangles;
  for (int i = 0; i < sides; ++i) {
    triangles.push_back({{at(i, 0.), at(i + 1, 0.), at(i + 1, height)}});
    triangles.push_back({{at(i, 0.), at(i + 1, height), at(i, height)}});
    triangles.push_back({{Point(0., 0., 0.), at(i + 1, 0.), at(i, 0.)}});
    triangles.push_back({{Point(0., 0., height), at(i, height), at(i + 1, height)}});
  }
  return triangles;
}

//! The side of a prism over each edge of an outline in the plane z = 0, and the outline at the bottom and at the top.
inline std::vector<Polygon> prismPolygons(const Polygon &outline, double height)
{
  const Point up(0., 0., height);
  Polygon top;
  std::vector<Polygon> polygons;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Point &next = outline[(i + 1) % outline.size()];
    top.push_back(outline[i] + up);
    polygons.push_back({outline[i], next, next + up, outline[i] + up});
  }
  polygons.emplace_back(outline.rbegin(), outline.rend());
  polygons.push_back(top);
  return polygons;
}

//! Outline of the letter L in the plane z = 0: a square of the given size without its upper right quarter.
inline Polygon lOutline(double size)
{
  const double half = 0.5 * size;
  return {Point(0., 0., 0.),     Point(size, 0., 0.),   Point(size, half, 0.),
          Point(half, half, 0.), Point(half, size, 0.), Point(0., size, 0.)};
}

//! The letter L as a solid, not convex.
inline std::vector<Polygon> lPolygons(double size, double height)
{
  return prismPolygons(lOutline(size), height);
}

//! A square picture frame around the z axis, four bars with a square section of the given width; not convex.
inline std::vector<Polygon> framePolygons(double size, double width)
{
  const auto corner = [](double reach, int i, double z) {
    const std::array<Point, 4> signs = {{Point(-1, -1, 0), Point(1, -1, 0), Point(1, 1, 0), Point(-1, 1, 0)}};
    return Point(reach * signs[static_cast<std::size_t>(i % 4)] + Point(0., 0., z));
  };
  const double out = 0.5 * size;
  const double in = out - width;
  std::vector<Polygon> polygons;
  for (int i = 0; i < 4; ++i) {
    polygons.push_back({corner(out, i, 0.), corner(out, i + 1, 0.), corner(out, i + 1, width), corner(out, i, width)});
    polygons.push_back({corner(in, i + 1, 0.), corner(in, i, 0.), corner(in, i, width), corner(in, i + 1, width)});
    polygons.push_back(
        {corner(out, i, width), corner(out, i + 1, width), corner(in, i + 1, width), corner(in, i, width)});
    polygons.push_back({corner(out, i + 1, 0.), corner(out, i, 0.), corner(in, i, 0.), corner(in, i + 1, 0.)});
  }
  return polygons;
}

//! Adds polygons with numbers and names "polygon 0", "polygon 1", ...
inline void add(vpTrackedModelBuilder &builder, const std::vector<Polygon> &polygons)
{
  for (std::size_t i = 0; i < polygons.size(); ++i) {
    builder.addFace(polygons[i], "polygon " + std::to_string(i), static_cast<int>(i));
  }
}

//! Adds triangles of a mesh.
inline void add(vpTrackedModelBuilder &builder, const std::vector<Triangle> &triangles)
{
  for (const Triangle &triangle : triangles) {
    std::array<vpTrackedModelBuilder::Corner, 3> corners;
    for (std::size_t k = 0; k < 3; ++k) {
      corners[k].position = triangle[k];
    }
    builder.addTriangle(corners);
  }
}

//! A model of one shape, polygons or triangles.
template <class Shape>
vpTrackedModel build(const Shape &shape, const vpModelOptions &options = vpModelOptions(),
                     const std::string &name = "shape")
{
  vpTrackedModelBuilder builder(options);
  add(builder, shape);
  return builder.build(name);
}
} // namespace modelShapes
END_VISP_NAMESPACE
#endif
