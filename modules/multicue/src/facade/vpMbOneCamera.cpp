// SPDX-License-Identifier: GPL-2.0-or-later
#include <visp3/multicue/vpMbOneCamera.h>

#include "facade/vpOneCameraEntry.h"

#include <visp3/core/vpException.h>

#include <algorithm>
#include <cmath>

BEGIN_VISP_NAMESPACE

namespace {
bool isIdentity(const vpHomogeneousMatrix &matrix)
{
  const vpHomogeneousMatrix identity;
  return std::equal(matrix.data, matrix.data + 16, identity.data,
                    [](double a, double b) { return std::fabs(a - b) < 1e-9; });
}
} // namespace

void vpMbOneCamera::requireOneCamera(std::size_t cameras)
{
  if (cameras != 1) {
    throw vpException(vpException::badValue,
                      "%zu cameras were asked for, this tracker has one: use vpMbGenericTracker for several; cues are "
                      "chosen by vpMbMultiCueTracker(1, type), setTrackerType(type), or a value of vpTrackerType",
                      cameras);
  }
}

void vpMbOneCamera::requireCamera(const std::string &cameraName) const
{
  if (cameraName != m_referenceCameraName) {
    throw vpException(vpException::badValue,
                      "There is no camera '%s': the one of this tracker is '%s', and its name can be given to the "
                      "constructor",
                      cameraName.c_str(), m_referenceCameraName.c_str());
  }
}

vpHomogeneousMatrix vpMbOneCamera::onlyOrNone(const PerCamera<vpHomogeneousMatrix> &matrices) const
{
  return matrices.empty() ? vpHomogeneousMatrix() : only(matrices);
}

void vpMbOneCamera::setReferenceCameraName(const std::string &referenceCameraName)
{
  requireCamera(referenceCameraName);
}

void vpMbOneCamera::setCameraTransformationMatrix(const std::string &cameraName, const vpHomogeneousMatrix &cameraMref)
{
  requireCamera(cameraName);
  if (!isIdentity(cameraMref)) {
    throw vpException(
        vpException::badValue,
        "The camera '%s' was placed %g m from the reference camera, which it is itself: give the identity, "
        "or use vpMbGenericTracker for several cameras",
        cameraName.c_str(), cameraMref.getTranslationVector().frobeniusNorm());
  }
}

void vpMbOneCamera::setCameraTransformationMatrix(const PerCamera<vpHomogeneousMatrix> &mapOfTransformationMatrix)
{
  setCameraTransformationMatrix(m_referenceCameraName, only(mapOfTransformationMatrix));
}

void vpMbOneCamera::reInitModel(const GrayImages &mapOfImages, const PerCamera<std::string> &mapOfModelFiles,
                                const PerCamera<vpHomogeneousMatrix> &mapOfCameraPoses, bool verbose,
                                const PerCamera<vpHomogeneousMatrix> &mapOfT)
{
  reInitModel(only(mapOfImages), only(mapOfModelFiles), only(mapOfCameraPoses), verbose, onlyOrNone(mapOfT));
}

void vpMbOneCamera::reInitModel(const ColorImages &mapOfColorImages, const PerCamera<std::string> &mapOfModelFiles,
                                const PerCamera<vpHomogeneousMatrix> &mapOfCameraPoses, bool verbose,
                                const PerCamera<vpHomogeneousMatrix> &mapOfT)
{
  reInitModel(only(mapOfColorImages), only(mapOfModelFiles), only(mapOfCameraPoses), verbose, onlyOrNone(mapOfT));
}

void vpMbOneCamera::loadModel(const PerCamera<std::string> &mapOfModelFiles, bool verbose,
                              const PerCamera<vpHomogeneousMatrix> &mapOfT)
{
  loadModel(only(mapOfModelFiles), verbose, onlyOrNone(mapOfT));
}

void vpMbOneCamera::loadConfigFile(const PerCamera<std::string> &mapOfConfigFiles, bool verbose)
{
  loadConfigFile(only(mapOfConfigFiles), verbose);
}

void vpMbOneCamera::setTrackerType(const PerCamera<int> &mapOfTrackerTypes)
{
  setTrackerType(only(mapOfTrackerTypes));
}

void vpMbOneCamera::setCameraParameters(const PerCamera<vpCameraParameters> &mapOfCameraParameters)
{
  setCameraParameters(only(mapOfCameraParameters));
}

void vpMbOneCamera::setAngleAppear(const PerCamera<double> &mapOfAngles)
{
  setAngleAppear(only(mapOfAngles));
}

void vpMbOneCamera::setAngleDisappear(const PerCamera<double> &mapOfAngles)
{
  setAngleDisappear(only(mapOfAngles));
}

void vpMbOneCamera::setClipping(const PerCamera<unsigned int> &mapOfClippingFlags)
{
  setClipping(only(mapOfClippingFlags));
}

void vpMbOneCamera::setNearClippingDistance(const PerCamera<double> &mapOfDists)
{
  setNearClippingDistance(only(mapOfDists));
}

void vpMbOneCamera::setFarClippingDistance(const PerCamera<double> &mapOfDists)
{
  setFarClippingDistance(only(mapOfDists));
}

void vpMbOneCamera::setMovingEdge(const PerCamera<vpMe> &mapOfMe)
{
  setMovingEdge(only(mapOfMe));
}

void vpMbOneCamera::setKltOpencv(const PerCamera<vpKltOpencv> &mapOfKlts)
{
  setKltOpencv(only(mapOfKlts));
}

void vpMbOneCamera::setKltMaskBorder(const PerCamera<unsigned int> &mapOfErosions)
{
  setKltMaskBorder(only(mapOfErosions));
}

void vpMbOneCamera::getClipping(PerCamera<unsigned int> &mapOfClippingFlags) const
{
  mapOfClippingFlags.clear();
  mapOfClippingFlags[m_referenceCameraName] = getClipping();
}

void vpMbOneCamera::getMovingEdge(PerCamera<vpMe> &mapOfMovingEdges) const
{
  mapOfMovingEdges.clear();
  mapOfMovingEdges[m_referenceCameraName] = getMovingEdge();
}

void vpMbOneCamera::getKltOpencv(PerCamera<vpKltOpencv> &mapOfKlts) const
{
  mapOfKlts.clear();
  mapOfKlts[m_referenceCameraName] = getKltOpencv();
}

void vpMbOneCamera::getCameraParameters(PerCamera<vpCameraParameters> &mapOfCameraParameters) const
{
  mapOfCameraParameters.clear();
  mapOfCameraParameters[m_referenceCameraName] = m_cam;
}

END_VISP_NAMESPACE
