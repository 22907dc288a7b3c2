// SPDX-License-Identifier: GPL-2.0-or-later
#include <visp3/multicue/vpMbTrackerCalls.h>

#include <visp3/core/vpException.h>
#include <visp3/mbt/vpMbtDistanceCircle.h>
#include <visp3/mbt/vpMbtDistanceCylinder.h>
#include <visp3/mbt/vpMbtDistanceLine.h>

#include <algorithm>

BEGIN_VISP_NAMESPACE

namespace {
// ViSP gives a cylinder the polygon after its own index, and three more, which lie around it.
const int cylinderSides = 4;

template <typename T> void deleteAll(std::vector<T *> &primitives)
{
  for (T *primitive : primitives) {
    delete primitive;
  }
  primitives.clear();
}

bool isSeen(vpMbHiddenFaces<vpMbtPolygon> &faces, int index)
{
  return index < 0 || faces.isVisible(static_cast<unsigned int>(index));
}

bool isSeen(const vpMbtDistanceLine &line)
{
  const std::list<int> &faces = line.Lindex_polygon;
  return faces.empty() ||
         std::any_of(faces.begin(), faces.end(), [&line](int face) { return isSeen(*line.hiddenface, face); });
}

bool isSeen(const vpMbtDistanceCylinder &cylinder)
{
  for (int side = 1; side <= cylinderSides && cylinder.index_polygon >= 0; ++side) {
    if (isSeen(*cylinder.hiddenface, cylinder.index_polygon + side)) {
      return true;
    }
  }
  return cylinder.index_polygon < 0;
}

bool isSeen(const vpMbtDistanceCircle &circle)
{
  return isSeen(*circle.hiddenface, circle.index_polygon);
}

// Primitives know their faces by a pointer, through which the visibility can be brought up to date where the tracker is
// constant, as ViSP's calls have it.
template <typename T>
void show(const std::vector<T *> &primitives, std::list<T *> &list, const vpCameraParameters &cam,
          const vpHomogeneousMatrix &cMo, unsigned int width, unsigned int height, double angleAppears,
          double angleDisappears)
{
  list.assign(primitives.begin(), primitives.end());
  if (primitives.empty() || width == 0) {
    return;
  }
  vpCameraParameters camera = cam;
  camera.computeFov(width, height);
  bool changed = false;
  primitives.front()->hiddenface->setVisible(width, height, camera, cMo, angleAppears, angleDisappears, changed);
  for (T *primitive : primitives) {
    primitive->setCameraParameters(cam);
    primitive->setVisible(isSeen(*primitive));
  }
}
} // namespace

void vpMbTrackerCalls::forgetPrimitives()
{
  faces.reset();
  m_projectionErrorFaces.reset();
  deleteAll(m_projectionErrorLines);
  deleteAll(m_projectionErrorCylinders);
  deleteAll(m_projectionErrorCircles);
  m_circles.clear();
  m_facesWidth = 0;
  m_facesHeight = 0;
}

void vpMbTrackerCalls::followFaces(unsigned int width, unsigned int height)
{
  m_facesWidth = width;
  m_facesHeight = height;
  if (m_facesAreAsked) {
    updateFaces();
  }
}

void vpMbTrackerCalls::updateFaces()
{
  m_facesAreAsked = true;
  if (m_facesWidth == 0) {
    return;
  }
  // A copy, since a camera with a field of view differs from the same camera without one.
  vpCameraParameters cam = m_cam;
  cam.computeFov(m_facesWidth, m_facesHeight);
  bool changed = false;
  faces.setVisible(m_facesWidth, m_facesHeight, cam, m_cMo, angleAppears, angleDisappears, changed);
  if (useScanLine) {
    faces.computeClippedPolygons(m_cMo, cam);
    faces.computeScanLineRender(cam, m_facesWidth, m_facesHeight);
  }
}

vpMbHiddenFaces<vpMbtPolygon> &vpMbTrackerCalls::getFaces()
{
  updateFaces();
  return faces;
}

vpMbtPolygon *vpMbTrackerCalls::getPolygon(unsigned int index)
{
  updateFaces();
  return vpMbTracker::getPolygon(index);
}

std::pair<std::vector<vpPolygon>, std::vector<std::vector<vpPoint>>>
vpMbTrackerCalls::getPolygonFaces(bool orderPolygons, bool useVisibility, bool clipPolygon)
{
  updateFaces();
  const vpCameraParameters before = m_cam;
  if (clipPolygon && m_facesWidth > 0) {
    m_cam.computeFov(m_facesWidth, m_facesHeight);
  }
  const auto result = vpMbTracker::getPolygonFaces(orderPolygons, useVisibility, clipPolygon);
  m_cam = before;
  return result;
}

void vpMbTrackerCalls::requireLevel(unsigned int level)
{
  if (level != 0) {
    throw vpException(vpException::badValue, "Level %u of the image pyramid is not used: ask for level 0", level);
  }
}

void vpMbTrackerCalls::requirePrimitives(unsigned int level) const
{
  requireLevel(level);
  if (modelInitialised && faces.size() == 0) {
    throw vpException(vpException::badValue, "The model consists of meshes, which have no lines, cylinders and circles "
                                             "of ViSP: getModelForDisplay() shows their edges");
  }
}

void vpMbTrackerCalls::getLline(std::list<vpMbtDistanceLine *> &linesList, unsigned int level) const
{
  requirePrimitives(level);
  show(m_projectionErrorLines, linesList, m_cam, m_cMo, m_facesWidth, m_facesHeight, angleAppears, angleDisappears);
}

void vpMbTrackerCalls::getLcylinder(std::list<vpMbtDistanceCylinder *> &cylindersList, unsigned int level) const
{
  requirePrimitives(level);
  show(m_projectionErrorCylinders, cylindersList, m_cam, m_cMo, m_facesWidth, m_facesHeight, angleAppears,
       angleDisappears);
}

void vpMbTrackerCalls::getLcircle(std::list<vpMbtDistanceCircle *> &circlesList, unsigned int level) const
{
  requirePrimitives(level);
  show(m_projectionErrorCircles, circlesList, m_cam, m_cMo, m_facesWidth, m_facesHeight, angleAppears, angleDisappears);
}

std::list<vpMbtDistanceCircle *> &vpMbTrackerCalls::getFeaturesCircle()
{
  getLcircle(m_circles);
  return m_circles;
}

std::list<vpMbtDistanceKltPoints *> &vpMbTrackerCalls::getFeaturesKlt()
{
  throw vpException(vpException::functionNotImplementedError,
                    "getFeaturesKlt(): points belong to the surface and not to faces; getKltImagePointsWithId() has "
                    "them, getPolygonFaces() tells where the faces are");
}

std::list<vpMbtDistanceKltCylinder *> &vpMbTrackerCalls::getFeaturesKltCylinder()
{
  throw vpException(vpException::functionNotImplementedError,
                    "getFeaturesKltCylinder(): points belong to the surface and not to cylinders; "
                    "getKltImagePointsWithId() has them, getLcylinder() has the cylinders");
}

std::vector<vpImagePoint> vpMbTrackerCalls::getKltImagePoints() const
{
  std::vector<vpImagePoint> points;
  for (const auto &point : getKltImagePointsWithId()) {
    points.push_back(point.second);
  }
  return points;
}

std::vector<cv::Point2f> vpMbTrackerCalls::getKltPoints() const
{
  std::vector<cv::Point2f> points;
  for (const auto &point : getKltImagePointsWithId()) {
    points.emplace_back(static_cast<float>(point.second.get_u()), static_cast<float>(point.second.get_v()));
  }
  return points;
}

int vpMbTrackerCalls::getKltNbPoints() const
{
  return static_cast<int>(getKltImagePointsWithId().size());
}

std::vector<bool> vpMbTrackerCalls::getScales() const
{
  return {true};
}

void vpMbTrackerCalls::setScales(const std::vector<bool> &scales)
{
  if (scales.empty() || !scales.front() || std::count(scales.begin(), scales.end(), true) != 1) {
    throw vpException(vpException::badValue,
                      "setScales(): edges are looked for in the image itself, so that only the first of the %zu scales "
                      "may be true; a larger range of vpMe, or setSearch(true), reaches farther",
                      scales.size());
  }
}

END_VISP_NAMESPACE
