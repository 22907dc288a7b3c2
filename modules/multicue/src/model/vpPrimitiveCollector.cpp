// SPDX-License-Identifier: GPL-2.0-or-later
#include "model/vpPrimitiveCollector.h"

#include "model/vpCaoParent.h"
#include "model/vpVrmlCheck.h"

#include <visp3/core/vpException.h>
#include <visp3/core/vpIoTools.h>

BEGIN_VISP_NAMESPACE

namespace {
Eigen::Vector3d toEigen(const vpPoint &point)
{
  return Eigen::Vector3d(point.get_oX(), point.get_oY(), point.get_oZ());
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
    if (extension == ".wrl" || extension == ".WRL") {
      requireReadableVrml(modelFile);
    }
    collector.loadModel(modelFile, false, odTo);
  } catch (const std::exception &e) {
    throw vpException(vpException::ioError, "The model file '%s' cannot be read: %s", modelFile.c_str(), e.what());
  }
  return collector.m_builder;
}

void vpPrimitiveCollector::loadCAOModel(const std::string &modelFile, std::vector<std::string> &vectorOfModelFilename,
                                        int &startIdFace, bool, bool, const vpHomogeneousMatrix &odTo)
{
  const unsigned int readBefore = m_partsRead;
  try {
    // Neither verbose nor, which makes ViSP print as well, a parent.
    vpMbTracker::loadCAOModel(modelFile, vectorOfModelFilename, startIdFace, false, false, odTo);
  } catch (...) {
    const unsigned int parts = countPartsOfCaoParent(modelFile);
    if (parts == 0 || m_partsRead != readBefore + parts) {
      throw;
    }
    m_partsRead = readBefore;
  }
  ++m_partsRead;
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
  addPolygonLines(polygon, true);
}

void vpPrimitiveCollector::initFaceFromLines(vpMbtPolygon &polygon)
{
  addPolygonLines(polygon, false);
}

void vpPrimitiveCollector::addPolygonLines(const vpMbtPolygon &polygon, bool closed)
{
  std::vector<Eigen::Vector3d> corners;
  for (unsigned int i = 0; i < polygon.getNbPoint(); ++i) {
    corners.push_back(toEigen(polygon.p[i]));
  }
  if (corners.size() >= 3) {
    m_builder.addFace(corners, polygon.getName(), polygon.getIndex(), closed);
  } else if (corners.size() == 2) {
    m_builder.addLine(corners[0], corners[1], polygon.getName(), polygon.getIndex());
  }
}

END_VISP_NAMESPACE
