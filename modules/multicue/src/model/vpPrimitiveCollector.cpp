// SPDX-License-Identifier: GPL-2.0-or-later
#include "model/vpPrimitiveCollector.h"

#include "model/vpCaoFile.h"
#include "model/vpVrmlCheck.h"

#include <visp3/core/vpException.h>
#include <visp3/core/vpIoTools.h>

BEGIN_VISP_NAMESPACE

namespace {
Eigen::Vector3d toEigen(const vpPoint &point)
{
  return Eigen::Vector3d(point.get_oX(), point.get_oY(), point.get_oZ());
}

std::vector<Eigen::Vector3d> cornersOf(const vpMbtPolygon &polygon)
{
  std::vector<Eigen::Vector3d> corners;
  for (unsigned int i = 0; i < polygon.getNbPoint(); ++i) {
    corners.push_back(toEigen(polygon.p[i]));
  }
  return corners;
}

// The lines of a face meet in points that each of them names.
std::vector<Eigen::Vector3d> withoutRepeats(const std::vector<vpPoint> &points)
{
  std::vector<Eigen::Vector3d> corners;
  for (const vpPoint &point : points) {
    const Eigen::Vector3d corner = toEigen(point);
    if (corners.empty() || corners.back() != corner) {
      corners.push_back(corner);
    }
  }
  return corners;
}
} // namespace

vpTrackedModelBuilder vpPrimitiveCollector::add(const vpTrackedModelBuilder &builder, const std::string &modelFile,
                                                const vpHomogeneousMatrix &odTo)
{
  if (!vpIoTools::checkFilename(modelFile)) {
    throw vpException(vpException::ioError, "The model file '%s' does not exist or cannot be read: check its path",
                      modelFile.c_str());
  }
  vpPrimitiveCollector collector(builder);
  try {
    const std::string extension = vpIoTools::getFileExtension(modelFile);
    if (extension == ".cao" || extension == ".CAO") {
      collector.addCao(vpCaoFile::read(modelFile, odTo));
      return collector.m_builder;
    }
    if (extension != ".wrl" && extension != ".WRL") {
      throw vpException(vpException::ioError, "its name ends neither in .cao nor .wrl, nor in one of a mesh (.obj, "
                                              ".ply, .stl, .dae, .gltf, .glb)");
    }
    for (const std::string &warning : requireReadableVrml(modelFile)) {
      collector.m_builder.addWarning(warning);
    }
    collector.loadModel(modelFile, false, odTo);
  } catch (const std::exception &e) {
    throw vpException(vpException::ioError, "The model file '%s' cannot be read: %s", modelFile.c_str(), e.what());
  }
  return collector.m_builder;
}

void vpPrimitiveCollector::addCao(const vpCaoFile &file)
{
  int face = 0;
  for (const vpCaoShape &shape : file.shapes) {
    const std::vector<vpPoint> &points = shape.points;
    switch (shape.kind) {
    case vpCaoShape::FACE:
    case vpCaoShape::FACE_OF_LINES:
      addPolygonLines(withoutRepeats(points), shape.kind == vpCaoShape::FACE, shape.name, face++);
      break;
    case vpCaoShape::CYLINDER:
      initCylinder(points[0], points[1], shape.radius, face, shape.name);
      face += 5; // ViSP's numbers: the axis, and the sides of a box around the cylinder.
      break;
    case vpCaoShape::CIRCLE:
      initCircle(points[0], points[1], points[2], shape.radius, face++, shape.name);
      break;
    }
  }
  for (const std::string &warning : file.warnings) {
    m_builder.addWarning(warning);
  }
}

void vpPrimitiveCollector::initCircle(const vpPoint &centre, const vpPoint &second, const vpPoint &third, double radius,
                                      int idFace, const std::string &name)
{
  m_builder.addCircle(toEigen(centre), toEigen(second), toEigen(third), radius, name, idFace);
}

void vpPrimitiveCollector::initCylinder(const vpPoint &start, const vpPoint &end, double radius, int idFace,
                                        const std::string &name)
{
  m_builder.addCylinder(toEigen(start), toEigen(end), radius, name, idFace);
}

void vpPrimitiveCollector::initFaceFromCorners(vpMbtPolygon &polygon)
{
  addPolygonLines(cornersOf(polygon), true, polygon.getName(), polygon.getIndex());
}

void vpPrimitiveCollector::initFaceFromLines(vpMbtPolygon &polygon)
{
  addPolygonLines(cornersOf(polygon), false, polygon.getName(), polygon.getIndex());
}

void vpPrimitiveCollector::addPolygonLines(const std::vector<Eigen::Vector3d> &corners, bool closed,
                                           const std::string &name, int index)
{
  if (corners.size() >= 3) {
    m_builder.addFace(corners, name, index, closed);
  } else if (corners.size() == 2) {
    m_builder.addLine(corners[0], corners[1], name, index);
  }
}

END_VISP_NAMESPACE
