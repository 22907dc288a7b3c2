// SPDX-License-Identifier: GPL-2.0-or-later
#include <visp3/model/vpTrackedModelBuilder.h>

#include "boundingBox.h"
#include "convexity.h"
#include "meshAssembler.h"
#include "modelErrors.h"
#include "primitiveAssembler.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <locale>
#include <sstream>
#include <utility>

BEGIN_VISP_NAMESPACE
using namespace vpMeshDetail;

namespace {
// Border loops below this share of the diameter are holes of a scan.
constexpr double smallestLoop = 0.05;

template <class Points> void checkPoints(const Points &points, const std::string &file, const std::string &what)
{
  for (const Eigen::Vector3d &point : points) {
    if (!point.allFinite()) {
      refuse("model '" + file + "': a coordinate of " + what + " is not finite");
    }
  }
}

template <class Primitives>
void checkPrimitives(const Primitives &primitives, const std::string &file, const std::string &kind)
{
  for (const auto &primitive : primitives) {
    checkPoints(primitive.points, file, describe(kind, primitive.name, primitive.polygon));
  }
}

template <class Primitive> Eigen::Vector3d axisOf(const Primitive &cylinder, const std::string &file)
{
  const Eigen::Vector3d axis = cylinder.points[1] - cylinder.points[0];
  if (axis.isZero(0.)) {
    refuse("model '" + file + "': the axis of " + describe("cylinder", cylinder.name, cylinder.polygon) +
           " has no length");
  }
  return axis.stableNormalized();
}

template <class Primitive> Eigen::Vector3d normalOf(const Primitive &circle, const std::string &file)
{
  const Eigen::Vector3d a = (circle.points[1] - circle.points[0]).stableNormalized();
  const Eigen::Vector3d b = (circle.points[2] - circle.points[0]).stableNormalized();
  const Eigen::Vector3d normal = a.cross(b);
  if (normal.norm() < 1e-6) {
    refuse("model '" + file + "': the three points of " + describe("circle", circle.name, circle.polygon) +
           " lie on a line and do not give its plane");
  }
  return normal.normalized();
}

void describeBox(const BoundingBox &box, vpModelReport &report)
{
  report.size = box.upper - box.lower;
  report.diameter = box.diagonal();
  report.centreOffset = 0.5 * (box.lower + box.upper);
}

void countParts(ModelParts &parts)
{
  const std::vector<char> surface = facesWithSurface(parts);
  vpModelReport &report = parts.report;
  report.vertices = parts.vertices.size();
  report.triangles = parts.triangles.size();
  report.faces = static_cast<std::size_t>(std::count(surface.begin(), surface.end(), 1));
  report.edges = parts.edges.size();
  report.cylinders = parts.cylinders.size();
  report.circles = parts.circles.size();
  report.closed = !parts.triangles.empty() && report.borderEdges == 0;
  report.convex = isConvex(parts);
}
} // namespace

void vpTrackedModelBuilder::checkFinite(const std::string &file) const
{
  checkPrimitives(m_faces, file, "polygon");
  checkPrimitives(m_lines, file, "line");
  checkPrimitives(m_cylinders, file, "cylinder");
  checkPrimitives(m_circles, file, "circle");
  for (std::size_t t = 0; t < m_triangles.size(); ++t) {
    if (!(m_triangles[t][0] + m_triangles[t][1] + m_triangles[t][2]).allFinite()) {
      refuse("model '" + file + "': a coordinate of triangle " + std::to_string(t) + " is not finite");
    }
  }
}

BoundingBox vpTrackedModelBuilder::measure(const std::string &file) const
{
  BoundingBox box;
  for (const std::vector<Primitive> *primitives : {&m_faces, &m_lines}) {
    for (const Primitive &primitive : *primitives) {
      for (const Eigen::Vector3d &point : primitive.points) {
        box.add(point);
      }
    }
  }
  for (const Primitive &cylinder : m_cylinders) {
    const Eigen::Vector3d axis = axisOf(cylinder, file);
    box.addDisc(cylinder.points[0], axis, cylinder.radius);
    box.addDisc(cylinder.points[1], axis, cylinder.radius);
  }
  for (const Primitive &circle : m_circles) {
    box.addDisc(circle.points[0], normalOf(circle, file), circle.radius);
  }
  for (const std::array<Eigen::Vector3d, 3> &triangle : m_triangles) {
    for (const Eigen::Vector3d &corner : triangle) {
      box.add(m_options.unit * corner);
    }
  }
  return box;
}

void vpTrackedModelBuilder::checkSize(double diameter, const std::string &file) const
{
  if (diameter >= m_options.minSize && diameter <= m_options.maxSize) {
    return;
  }
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text.precision(4);
  text << "model '" << file << "' is " << diameter << " m wide (unit " << m_options.unit << " m): ";
  if (diameter > m_options.maxSize) {
    text << "more than " << m_options.maxSize
         << " m is not believed; give the unit (0.001 for millimetres) or raise maxSize";
  } else {
    text << "less than " << m_options.minSize << " m is not believed; give the unit (1 for metres) or lower minSize";
  }
  refuse(text.str());
}

void vpTrackedModelBuilder::assemblePrimitives(const std::string &file, ModelParts &parts, VertexPool &pool) const
{
  PrimitiveAssembler assembler(parts, pool);
  for (const Primitive &face : m_faces) {
    assembler.addFace(face.points, Label{face.name, face.polygon}, face.closed);
  }
  for (const Primitive &line : m_lines) {
    assembler.addLine(line.points[0], line.points[1], Label{line.name, line.polygon});
  }
  for (const Primitive &cylinder : m_cylinders) {
    assembler.addCylinder({{cylinder.points[0], cylinder.points[1]}}, cylinder.radius,
                          Label{cylinder.name, cylinder.polygon});
  }
  for (const Primitive &circle : m_circles) {
    assembler.addCircle(circle.points[0], normalOf(circle, file), circle.radius, Label{circle.name, circle.polygon});
  }
  assembler.finish();
}

void vpTrackedModelBuilder::assembleMesh(ModelParts &parts, VertexPool &pool) const
{
  if (m_triangles.empty()) {
    return;
  }
  WeldedSoup soup;
  soup.tolerance = std::max(pool.tolerance(), 1e-12 * parts.report.diameter);
  soup.creaseAngle = m_options.creaseAngle;
  soup.smallestLoop = smallestLoop * parts.report.diameter;
  soup.triangles.reserve(m_triangles.size());
  for (const std::array<Eigen::Vector3d, 3> &triangle : m_triangles) {
    soup.triangles.push_back({{pool.add(m_options.unit * triangle[0]), pool.add(m_options.unit * triangle[1]),
                               pool.add(m_options.unit * triangle[2])}});
  }
  addMesh(parts, soup, m_appearance);
}

vpTrackedModel vpTrackedModelBuilder::build(const std::string &file) const
{
  checkFinite(file);
  const BoundingBox box = measure(file);
  if (box.empty()) {
    refuse("model '" + file + "' is empty: there is neither surface nor line to track");
  }
  checkSize(box.diagonal(), file);

  ModelParts parts;
  vpModelReport &report = parts.report;
  report.file = file;
  report.unit = m_options.unit;
  describeBox(box, report);
  report.missingImages = m_missingImages;
  report.warnings = m_warnings;
  VertexPool pool(box.lower, report.diameter, m_options.weldTolerance * report.diameter, m_triangles.size(),
                  parts.vertices);
  assemblePrimitives(file, parts, pool);
  assembleMesh(parts, pool);
  report.weldedVertices = pool.welded();
  countParts(parts);
  if (parts.triangles.empty() && parts.edges.empty() && parts.circles.empty()) {
    refuse("model '" + file + "' has nothing to track: all of its polygons, lines and triangles are degenerate");
  }

  vpTrackedModel model;
  model.m_vertices = std::move(parts.vertices);
  model.m_normals = std::move(parts.normals);
  model.m_triangles = std::move(parts.triangles);
  model.m_faces = std::move(parts.faces);
  model.m_edges = std::move(parts.edges);
  model.m_edgeFaces = std::move(parts.edgeFaces);
  model.m_cylinders = std::move(parts.cylinders);
  model.m_circles = std::move(parts.circles);
  model.m_smoothTriangles = std::move(parts.smoothTriangles);
  model.m_appearance = std::move(parts.appearance);
  model.m_report = std::move(parts.report);
  model.m_boxMin = box.lower;
  model.m_boxMax = box.upper;
  return model;
}
END_VISP_NAMESPACE
