// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef benchShapes_h
#define benchShapes_h

#include <meshFiles.h>

#include <cmath>
#include <sstream>
#include <string>
#include <vector>

#ifdef ENABLE_VISP_NAMESPACE
using namespace VISP_NAMESPACE_NAME;
#endif

/*!
  \file benchShapes.h
  The models that stages are timed with, about 0.2 m long.
*/

namespace bench {

//! A model by the name that benchmarks have in their own names.
struct BenchShape
{
  const char *name;
  bool isCao;    //!< A file of ViSP's, which its trackers read too; else a mesh in metres.
  int rings;     //!< Of a lump.
  int sectors;   //!< Of a lump.
  int triangles; //!< How many there are.
};

//! box: convex, straight edges. lump: curved, tracked by its rim, and not convex, so that a depth buffer is needed.
inline const std::vector<BenchShape> &benchShapes()
{
  static const std::vector<BenchShape> shapes = {
      {"box-12", true, 0, 0, 12}, {"lump-1k", false, 17, 32, 1024}, {"lump-30k", false, 121, 125, 30000}};
  return shapes;
}

//! The six sides of a box of 20 x 12 x 8 cm as a .cao file.
inline std::string boxCao()
{
  std::ostringstream text;
  const auto sides = modelShapes::boxPolygons(modelShapes::Point(0.2, 0.12, 0.08));
  text << "V1\n" << 4 * sides.size() << "\n";
  for (const auto &side : sides) {
    for (const modelShapes::Point &corner : side) {
      text << corner.x() << " " << corner.y() << " " << corner.z() << "\n";
    }
  }
  text << "0\n0\n" << sides.size() << "\n";
  for (std::size_t i = 0; i < sides.size(); ++i) {
    text << "4 " << 4 * i << " " << 4 * i + 1 << " " << 4 * i + 2 << " " << 4 * i + 3 << "\n";
  }
  text << "0\n0\n";
  return text.str();
}

//! A sphere with three bulges around it and a dent at both poles: 2 (rings - 1) sectors triangles. Coarse ones have
//! creases in the dents.
inline meshFiles::Triangles lumpTriangles(int rings, int sectors)
{
  meshFiles::Triangles triangles = modelShapes::sphereTriangles(1., rings, sectors);
  for (modelShapes::Triangle &triangle : triangles) {
    for (modelShapes::Point &corner : triangle) {
      const double polar = std::acos(std::fmin(1., std::fmax(-1., corner.z())));
      const double azimuth = std::atan2(corner.y(), corner.x());
      const double bulge = 0.3 * std::cos(3. * azimuth) * std::pow(std::sin(polar), 3.);
      corner *= 0.09 * (1. + bulge + 0.25 * std::cos(2. * polar + 0.5));
    }
  }
  return triangles;
}

//! Writes a shape's file. \return Its path.
inline std::string writeShape(const BenchShape &shape, const meshFiles::TemporaryFolder &folder)
{
  const std::string name = shape.name;
  return shape.isCao ? folder.write(name + ".cao", boxCao())
                     : folder.write(name + ".obj", meshFiles::obj(lumpTriangles(shape.rings, shape.sectors)));
}

} // namespace bench
#endif
