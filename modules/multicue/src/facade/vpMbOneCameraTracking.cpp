// SPDX-License-Identifier: GPL-2.0-or-later
#include <visp3/multicue/vpMbOneCamera.h>

#include "facade/vpOneCameraEntry.h"

BEGIN_VISP_NAMESPACE

void vpMbOneCamera::getPose(PerCamera<vpHomogeneousMatrix> &mapOfCameraPoses) const
{
  mapOfCameraPoses.clear();
  mapOfCameraPoses[m_referenceCameraName] = getPose();
}

void vpMbOneCamera::getNbPolygon(PerCamera<unsigned int> &mapOfNbPolygons) const
{
  mapOfNbPolygons.clear();
  mapOfNbPolygons[m_referenceCameraName] = getNbPolygon();
}

void vpMbOneCamera::initClick(const GrayImages &mapOfImages, const PerCamera<std::string> &mapOfInitFiles,
                              bool displayHelp, const PerCamera<vpHomogeneousMatrix> &mapOfT)
{
  initClick(only(mapOfImages), only(mapOfInitFiles), displayHelp, onlyOrNone(mapOfT));
}

void vpMbOneCamera::initFromPoints(const GrayImages &mapOfImages, const PerCamera<std::string> &mapOfInitPoints)
{
  initFromPoints(only(mapOfImages), only(mapOfInitPoints));
}

void vpMbOneCamera::initFromPose(const GrayImages &mapOfImages, const PerCamera<std::string> &mapOfInitPoses)
{
  initFromPose(only(mapOfImages), only(mapOfInitPoses));
}

void vpMbOneCamera::initFromPose(const GrayImages &mapOfImages, const PerCamera<vpHomogeneousMatrix> &mapOfCameraPoses)
{
  initFromPose(only(mapOfImages), only(mapOfCameraPoses));
}

void vpMbOneCamera::setPose(const GrayImages &mapOfImages, const PerCamera<vpHomogeneousMatrix> &mapOfCameraPoses)
{
  setPose(only(mapOfImages), only(mapOfCameraPoses));
}

void vpMbOneCamera::track(const GrayImages &mapOfImages)
{
  track(only(mapOfImages));
}

void vpMbOneCamera::display(const GrayImages &mapOfImages, const PerCamera<vpHomogeneousMatrix> &mapOfCameraPoses,
                            const PerCamera<vpCameraParameters> &mapOfCameraParameters, const vpColor &col,
                            unsigned int thickness, bool displayFullModel)
{
  display(only(mapOfImages), only(mapOfCameraPoses), only(mapOfCameraParameters), col, thickness, displayFullModel);
}

void vpMbOneCamera::initClick(const ColorImages &mapOfColorImages, const PerCamera<std::string> &mapOfInitFiles,
                              bool displayHelp, const PerCamera<vpHomogeneousMatrix> &mapOfT)
{
  initClick(only(mapOfColorImages), only(mapOfInitFiles), displayHelp, onlyOrNone(mapOfT));
}

void vpMbOneCamera::initFromPoints(const ColorImages &mapOfColorImages, const PerCamera<std::string> &mapOfInitPoints)
{
  initFromPoints(only(mapOfColorImages), only(mapOfInitPoints));
}

void vpMbOneCamera::initFromPose(const ColorImages &mapOfColorImages, const PerCamera<std::string> &mapOfInitPoses)
{
  initFromPose(only(mapOfColorImages), only(mapOfInitPoses));
}

void vpMbOneCamera::initFromPose(const ColorImages &mapOfColorImages,
                                 const PerCamera<vpHomogeneousMatrix> &mapOfCameraPoses)
{
  initFromPose(only(mapOfColorImages), only(mapOfCameraPoses));
}

void vpMbOneCamera::setPose(const ColorImages &mapOfColorImages, const PerCamera<vpHomogeneousMatrix> &mapOfCameraPoses)
{
  setPose(only(mapOfColorImages), only(mapOfCameraPoses));
}

void vpMbOneCamera::track(const ColorImages &mapOfColorImages)
{
  track(only(mapOfColorImages));
}

void vpMbOneCamera::display(const ColorImages &mapOfColorImages, const PerCamera<vpHomogeneousMatrix> &mapOfCameraPoses,
                            const PerCamera<vpCameraParameters> &mapOfCameraParameters, const vpColor &col,
                            unsigned int thickness, bool displayFullModel)
{
  display(only(mapOfColorImages), only(mapOfCameraPoses), only(mapOfCameraParameters), col, thickness,
          displayFullModel);
}

vpMbHiddenFaces<vpMbtPolygon> &vpMbOneCamera::getFaces(const std::string &cameraName)
{
  requireCamera(cameraName);
  return getFaces();
}

vpMbtPolygon *vpMbOneCamera::getPolygon(const std::string &cameraName, unsigned int index)
{
  requireCamera(cameraName);
  return getPolygon(index);
}

void vpMbOneCamera::getPolygonFaces(PerCamera<std::vector<vpPolygon>> &mapOfPolygons,
                                    PerCamera<std::vector<std::vector<vpPoint>>> &mapOfPoints, bool orderPolygons,
                                    bool useVisibility, bool clipPolygon)
{
  auto polygons = getPolygonFaces(orderPolygons, useVisibility, clipPolygon);
  mapOfPolygons.clear();
  mapOfPoints.clear();
  mapOfPolygons[m_referenceCameraName] = std::move(polygons.first);
  mapOfPoints[m_referenceCameraName] = std::move(polygons.second);
}

void vpMbOneCamera::getLline(const std::string &cameraName, std::list<vpMbtDistanceLine *> &linesList,
                             unsigned int level) const
{
  requireCamera(cameraName);
  getLline(linesList, level);
}

void vpMbOneCamera::getLcylinder(const std::string &cameraName, std::list<vpMbtDistanceCylinder *> &cylindersList,
                                 unsigned int level) const
{
  requireCamera(cameraName);
  getLcylinder(cylindersList, level);
}

void vpMbOneCamera::getLcircle(const std::string &cameraName, std::list<vpMbtDistanceCircle *> &circlesList,
                               unsigned int level) const
{
  requireCamera(cameraName);
  getLcircle(circlesList, level);
}

void vpMbOneCamera::getNbPoints(PerCamera<unsigned int> &mapOfNbPoints, unsigned int level) const
{
  mapOfNbPoints.clear();
  mapOfNbPoints[m_referenceCameraName] = getNbPoints(level);
}

void vpMbOneCamera::getFeaturesForDisplay(PerCamera<std::vector<std::vector<double>>> &mapOfFeatures)
{
  mapOfFeatures.clear();
  mapOfFeatures[m_referenceCameraName] = getFeaturesForDisplay();
}

void vpMbOneCamera::getModelForDisplay(PerCamera<std::vector<std::vector<double>>> &mapOfModels,
                                       const PerCamera<unsigned int> &mapOfwidths,
                                       const PerCamera<unsigned int> &mapOfheights,
                                       const PerCamera<vpHomogeneousMatrix> &mapOfcMos,
                                       const PerCamera<vpCameraParameters> &mapOfCams, bool displayFullModel)
{
  mapOfModels.clear();
  mapOfModels[m_referenceCameraName] =
      getModelForDisplay(only(mapOfwidths), only(mapOfheights), only(mapOfcMos), only(mapOfCams), displayFullModel);
}

END_VISP_NAMESPACE
