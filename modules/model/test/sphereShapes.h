// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef sphereShapes_h
#define sphereShapes_h

#include "modelShapes.h"

#include <visp3/model/vpCpuRenderer.h>
#include <visp3/model/vpViewSphere.h>

#include <cstring>
#include <memory>
#include <string>
#include <vector>

/*! \file sphereShapes.h Objects to look at from all around. */

BEGIN_VISP_NAMESPACE
namespace sphereShapes {
using modelShapes::boxPolygons;
using modelShapes::build;
using modelShapes::framePolygons;
using modelShapes::lPolygons;
using modelShapes::Point;
using modelShapes::sphereTriangles;
using modelShapes::Triangle;

//! Names of shapes.
inline const std::vector<std::string> shapes = {"box", "letter L", "window", "ball", "two balls"};

inline vpTrackedModel shape(const std::string &name)
{
  if (name == "box") {
    return build(boxPolygons(Point(0.1, 0.08, 0.06), Point(0.02, 0.01, -0.03)));
  }
  if (name == "letter L") {
    return build(lPolygons(0.12, 0.05));
  }
  if (name == "window") {
    return build(framePolygons(0.14, 0.03));
  }
  std::vector<Triangle> triangles = sphereTriangles(0.05, 24, 48);
  if (name == "two balls") {
    for (Triangle triangle : sphereTriangles(0.03, 24, 48)) {
      for (Point &corner : triangle) {
        corner += Point(0.09, 0.02, 0.01);
      }
      triangles.push_back(triangle);
    }
  }
  return build(triangles);
}

inline vpViewSphere makeSphere(const vpTrackedModel &model, const vpViewSphereOptions &options)
{
  const std::shared_ptr<const vpTrackedModel> shared = std::make_shared<const vpTrackedModel>(model);
  return vpViewSphere(shared, options, std::make_unique<vpCpuRenderer>(shared));
}

inline vpViewSphereOptions optionsOf(unsigned int level)
{
  vpViewSphereOptions options;
  options.level = level;
  return options;
}

//! True where all points are the same to the last bit.
inline bool isSame(const vpSphereView &a, const vpSphereView &b)
{
  return a.size() == b.size() && a.silhouettes() == b.silhouettes() &&
         (a.size() == 0 || std::memcmp(a.x(), b.x(), 7 * a.size() * sizeof(float)) == 0);
}
} // namespace sphereShapes
END_VISP_NAMESPACE
#endif
