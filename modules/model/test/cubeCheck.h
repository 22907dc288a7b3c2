// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef cubeCheck_h
#define cubeCheck_h

#include <catchMain.h>

#include "modelChecks.h"
#include "modelShapes.h"

//! Checks everything about the model of a cube of 0.1 m around the origin that was a mesh.
inline void checkCube(const vpTrackedModel &model, std::size_t triangles)
{
  CHECK(model.faces().size() == 6);
  CHECK(model.triangles().size() == triangles);
  REQUIRE(model.edges().size() == 12);
  for (const vpModelEdge &edge : model.edges()) {
    CHECK(edge.faceCount == 2);
    CHECK(modelChecks::length(model, edge) == Approx(0.1));
  }
  for (const vpModelFace &face : model.faces()) {
    CHECK(face.planar);
    CHECK(face.oriented);
    CHECK(face.normal.cwiseAbs().maxCoeff() == Approx(1.));
    CHECK(face.centre.norm() == Approx(0.05));
  }
  CHECK(modelChecks::isOutwardFrom(model, modelShapes::Point::Zero()));
  CHECK(model.smoothTriangles().empty());
  CHECK(model.isConvex());
  CHECK(model.report().closed);
  CHECK(model.report().holes == 0);
}

#endif
