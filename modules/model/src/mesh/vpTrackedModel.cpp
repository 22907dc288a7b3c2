// SPDX-License-Identifier: GPL-2.0-or-later
#include <visp3/model/vpTrackedModel.h>

#include <locale>
#include <ostream>
#include <sstream>

BEGIN_VISP_NAMESPACE
namespace {
struct LengthUnit
{
  const char *name;
  double metres;
};

LengthUnit readableUnit(double length)
{
  if (length >= 1.) {
    return {"m", 1.};
  }
  return length >= 0.1 ? LengthUnit{"cm", 0.01} : LengthUnit{"mm", 0.001};
}

//! "1 hole", "3 holes"
std::string count(std::size_t number, const std::string &one, const std::string &many)
{
  return std::to_string(number) + " " + (number == 1 ? one : many);
}

void writeSize(std::ostream &text, const vpModelReport &report)
{
  const LengthUnit unit = readableUnit(report.diameter);
  const Eigen::Vector3d size = report.size / unit.metres;
  const Eigen::Vector3d offset = report.centreOffset / unit.metres;
  text << "model '" << report.file << "': " << size.x() << " x " << size.y() << " x " << size.z() << " " << unit.name
       << ", diameter " << report.diameter / unit.metres << " " << unit.name << " (1 unit of the file = " << report.unit
       << " m)\n"
       << "  centre of its box at (" << offset.x() << ", " << offset.y() << ", " << offset.z() << ") " << unit.name
       << " in the object frame\n";
}

void writeCounts(std::ostream &text, const vpModelReport &report)
{
  text << "  " << count(report.vertices, "vertex", "vertices") << ", "
       << count(report.triangles, "triangle", "triangles") << ", " << count(report.faces, "face", "faces") << ", "
       << count(report.edges, "edge", "edges");
  if (report.cylinders > 0) {
    text << ", " << count(report.cylinders, "cylinder", "cylinders");
  }
  if (report.circles > 0) {
    text << ", " << count(report.circles, "circle", "circles");
  }
  text << "; " << (report.closed ? "closed" : "open") << ", " << (report.convex ? "convex" : "not convex") << "\n";
}

void tell(std::ostream &text, const char *weight, std::size_t number, const std::string &one, const std::string &many)
{
  if (number > 0) {
    text << "  " << weight << ": " << count(number, one, many) << "\n";
  }
}
} // namespace

std::ostream &operator<<(std::ostream &os, const vpModelReport &report)
{
  // A stream of its own: the caller's precision and flags neither count nor change.
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text.precision(4);
  writeSize(text, report);
  writeCounts(text, report);
  if (report.centreOffset.norm() > report.diameter) {
    text << "  warning: the origin is outside the object, farther from its centre than the object is wide\n";
  }
  tell(text, "warning", report.flippedTriangles, "triangle was turned over", "triangles were turned over");
  tell(text, "warning", report.flippedFaces, "polygon is wound against its neighbours",
       "polygons are wound against their neighbours");
  tell(text, "warning", report.degenerateTriangles, "triangle without area was dropped",
       "triangles without area were dropped");
  tell(text, "warning", report.duplicateTriangles, "triangle was there twice", "triangles were there twice");
  tell(text, "note", report.weldedVertices, "vertex was moved onto a close one",
       "vertices were moved onto a close one");
  tell(text, "warning", report.holes, "hole", "holes");
  tell(text, "warning", report.borderEdges, "border edge", "border edges");
  tell(text, "warning", report.nonManifoldEdges, "edge with more than two faces", "edges with more than two faces");
  tell(text, "warning", report.missingImages, "texture image could not be read", "texture images could not be read");
  for (const std::string &warning : report.warnings) {
    text << "  warning: " << warning << "\n";
  }
  return os << text.str();
}
END_VISP_NAMESPACE
