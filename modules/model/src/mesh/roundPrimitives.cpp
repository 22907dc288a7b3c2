// SPDX-License-Identifier: GPL-2.0-or-later
#include "primitiveAssembler.h"

#include <Eigen/Geometry>

#include <cmath>

BEGIN_VISP_NAMESPACE
namespace vpMeshDetail {
namespace {
// 48 sides stay within 0.2 % of the radius.
constexpr int sides = 48;

//! Index of the vertex of a rim; those of the first rim come first.
int rimVertex(const std::vector<int> &rims, std::size_t end, int side)
{
  return rims[end * static_cast<std::size_t>(sides) + static_cast<std::size_t>(side % sides)];
}

Eigen::Vector3d axisDirection(const vpModelCylinder &cylinder)
{
  return (cylinder.axis[1] - cylinder.axis[0]).normalized();
}

//! Unit vectors from the axis to the sides, counter-clockwise seen against the axis' direction.
std::vector<Eigen::Vector3d> radialDirections(const Eigen::Vector3d &direction)
{
  const Eigen::Vector3d right = direction.unitOrthogonal();
  const Eigen::Vector3d up = direction.cross(right);
  std::vector<Eigen::Vector3d> radial;
  for (int i = 0; i < sides; ++i) {
    const double angle = 2. * M_PI * i / sides;
    radial.push_back(std::cos(angle) * right + std::sin(angle) * up);
  }
  return radial;
}
} // namespace

void PrimitiveAssembler::addCylinder(const std::array<Eigen::Vector3d, 2> &axis, double radius, const Label &label)
{
  vpModelCylinder cylinder;
  cylinder.axis = axis;
  cylinder.radius = radius;
  cylinder.face = addNamedFace(label);
  m_parts.faces.back().planar = false;
  m_parts.faces.back().centre = 0.5 * (axis[0] + axis[1]);
  std::vector<int> rims;
  for (const Eigen::Vector3d &end : axis) {
    for (const Eigen::Vector3d &radial : radialDirections(axisDirection(cylinder))) {
      rims.push_back(m_pool.addApart(end + radius * radial));
    }
  }
  addMantle(rims, cylinder);
  addCap(rims, 0, cylinder, label);
  addCap(rims, 1, cylinder, label);
  m_parts.cylinders.push_back(cylinder);
}

void PrimitiveAssembler::addMantle(const std::vector<int> &rims, const vpModelCylinder &cylinder)
{
  const int firstNormal = static_cast<int>(m_parts.normals.size());
  const std::vector<Eigen::Vector3d> radial = radialDirections(axisDirection(cylinder));
  m_parts.normals.insert(m_parts.normals.end(), radial.begin(), radial.end());
  for (int i = 0; i < sides; ++i) {
    const int here = firstNormal + i;
    const int next = firstNormal + (i + 1) % sides;
    vpModelTriangle triangle;
    triangle.face = cylinder.face;
    triangle.vertex = {{rimVertex(rims, 0, i), rimVertex(rims, 0, i + 1), rimVertex(rims, 1, i + 1)}};
    triangle.normal = {{here, next, next}};
    m_parts.triangles.push_back(triangle);
    triangle.vertex = {{rimVertex(rims, 0, i), rimVertex(rims, 1, i + 1), rimVertex(rims, 1, i)}};
    triangle.normal = {{here, next, here}};
    m_parts.triangles.push_back(triangle);
  }
}

// Caps hide what is behind them; their outline is not tracked, a circle does that where the model file has one.
void PrimitiveAssembler::addCap(const std::vector<int> &rims, std::size_t end, const vpModelCylinder &cylinder,
                                const Label &label)
{
  const bool top = end == 1;
  const int index = addNamedFace(label);
  vpModelFace &face = m_parts.faces.back();
  face.normal = axisDirection(cylinder) * (top ? 1. : -1.);
  face.centre = cylinder.axis[end];
  m_parts.normals.push_back(face.normal);
  const int normal = lastIndex(m_parts.normals);
  for (int i = 1; i + 1 < sides; ++i) {
    vpModelTriangle triangle;
    triangle.face = index;
    triangle.normal = {{normal, normal, normal}};
    triangle.vertex = {
        {rimVertex(rims, end, 0), rimVertex(rims, end, top ? i : i + 1), rimVertex(rims, end, top ? i + 1 : i)}};
    m_parts.triangles.push_back(triangle);
  }
}

void PrimitiveAssembler::addCircle(const Eigen::Vector3d &centre, const Eigen::Vector3d &normal, double radius,
                                   const Label &label)
{
  vpModelCircle circle;
  circle.centre = centre;
  circle.normal = normal;
  circle.radius = radius;
  circle.face = addNamedFace(label);
  m_parts.faces.back().normal = normal;
  m_parts.faces.back().centre = centre;
  m_parts.circles.push_back(circle);
}
} // namespace vpMeshDetail
END_VISP_NAMESPACE
