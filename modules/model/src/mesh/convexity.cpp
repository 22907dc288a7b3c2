// SPDX-License-Identifier: GPL-2.0-or-later
#include "convexity.h"

#include <algorithm>

BEGIN_VISP_NAMESPACE
namespace vpMeshDetail {
namespace {
// Times the diameter: how far in front of a plane a point may lie.
constexpr double planeTolerance = 1e-6;
constexpr std::size_t longestSearch = 200000000;
// Circle and face have one normal; cosine of 0.1 degree.
constexpr double sameNormalCosine = 0.99999847691328770;

double height(const vpModelFace &face, const Eigen::Vector3d &point)
{
  return face.normal.dot(point - face.centre);
}

//! True where the circle is drawn on the face's plane, to be seen from the same side.
bool isDrawnOn(const vpModelFace &face, const vpModelCircle &circle, double tolerance)
{
  return face.normal.dot(circle.normal) > sameNormalCosine && height(face, circle.centre) <= tolerance &&
         height(face, circle.centre) >= -tolerance;
}

bool allBehind(const vpModelFace &face, const std::vector<Eigen::Vector3d> &vertices, double tolerance)
{
  return std::all_of(vertices.begin(), vertices.end(),
                     [&](const Eigen::Vector3d &vertex) { return height(face, vertex) <= tolerance; });
}
} // namespace

bool isConvex(const ModelParts &parts)
{
  if (parts.triangles.empty()) {
    return true;
  }
  const bool hasLines =
      std::any_of(parts.edges.begin(), parts.edges.end(), [](const vpModelEdge &edge) { return edge.faceCount == 0; });
  if (hasLines || !parts.smoothTriangles.empty() || !parts.cylinders.empty()) {
    return false;
  }
  const double tolerance = planeTolerance * parts.report.diameter;
  const std::vector<char> surface = facesWithSurface(parts);
  std::vector<char> drawn(parts.circles.size(), 0);
  std::size_t looked = 0;
  for (std::size_t f = 0; f < parts.faces.size(); ++f) {
    const vpModelFace &face = parts.faces[f];
    if (surface[f] == 0) {
      continue;
    }
    looked += parts.vertices.size();
    if (looked > longestSearch || !face.planar || !face.oriented || !allBehind(face, parts.vertices, tolerance)) {
      return false;
    }
    for (std::size_t c = 0; c < drawn.size(); ++c) {
      drawn[c] = drawn[c] != 0 || isDrawnOn(face, parts.circles[c], tolerance) ? 1 : 0;
    }
  }
  return std::find(drawn.begin(), drawn.end(), 0) == drawn.end();
}
} // namespace vpMeshDetail
END_VISP_NAMESPACE
