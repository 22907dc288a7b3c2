// SPDX-License-Identifier: GPL-2.0-or-later
#include <visp3/model/vpSurfaceSamples.h>

#include <Eigen/Geometry>

#include <cmath>

BEGIN_VISP_NAMESPACE

namespace {
// Steps of the sequence with the lowest known discrepancy in two dimensions, powers of the inverse plastic number.
const double stepU = 0.7548776662466927;
const double stepV = 0.5698402909980532;

// The point of the unit square, folded into the triangle of barycentric coordinates.
vpSurfaceSample sampleOf(const vpTrackedModel &model, const vpModelTriangle &triangle, std::size_t number)
{
  double whole = 0.;
  double u = std::modf(0.5 + stepU * static_cast<double>(number), &whole);
  double v = std::modf(0.5 + stepV * static_cast<double>(number), &whole);
  if (u + v > 1.) {
    u = 1. - u;
    v = 1. - v;
  }
  const auto corner = [&](std::size_t i) { return model.vertices()[static_cast<std::size_t>(triangle.vertex[i])]; };
  const Eigen::Vector3d along = corner(1) - corner(0);
  const Eigen::Vector3d across = corner(2) - corner(0);
  vpSurfaceSample sample;
  sample.position = (corner(0) + u * along + v * across).cast<float>();
  sample.normal = along.cross(across).normalized().cast<float>();
  sample.seenFromBothSides = !model.faces()[static_cast<std::size_t>(triangle.face)].oriented;
  return sample;
}

double areaOf(const vpTrackedModel &model, const vpModelTriangle &triangle)
{
  const Eigen::Vector3d &a = model.vertices()[static_cast<std::size_t>(triangle.vertex[0])];
  const Eigen::Vector3d &b = model.vertices()[static_cast<std::size_t>(triangle.vertex[1])];
  const Eigen::Vector3d &c = model.vertices()[static_cast<std::size_t>(triangle.vertex[2])];
  return 0.5 * (b - a).cross(c - a).norm();
}
} // namespace

// Systematic sampling along the triangles' areas put end to end.
std::vector<vpSurfaceSample> vpSampleSurface(const vpTrackedModel &model, std::size_t count)
{
  double total = 0.;
  for (const vpModelTriangle &triangle : model.triangles()) {
    total += areaOf(model, triangle);
  }
  std::vector<vpSurfaceSample> samples;
  if (!(total > 0.)) {
    return samples;
  }
  samples.reserve(count);
  const double step = total / static_cast<double>(count);
  double reached = 0.;
  for (const vpModelTriangle &triangle : model.triangles()) {
    reached += areaOf(model, triangle);
    while (samples.size() < count && (static_cast<double>(samples.size()) + 0.5) * step < reached) {
      samples.push_back(sampleOf(model, triangle, samples.size()));
    }
  }
  return samples;
}

END_VISP_NAMESPACE
