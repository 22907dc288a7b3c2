// SPDX-License-Identifier: GPL-2.0-or-later
#include <visp3/multicue/vpMbMultiCueTracker.h>

#include "model/vpPrimitiveCollector.h"
#include "tracker/vpTrackerState.h"

#include <visp3/core/vpException.h>
#include <visp3/mbt/vpMbtDistanceCircle.h>
#include <visp3/mbt/vpMbtDistanceCylinder.h>
#include <visp3/mbt/vpMbtDistanceLine.h>
#include <visp3/model/vpModelReader.h>

#include <iostream>

BEGIN_VISP_NAMESPACE

namespace {
template <typename T> void deleteAll(std::vector<T *> &primitives)
{
  for (T *primitive : primitives) {
    delete primitive;
  }
  primitives.clear();
}
} // namespace

void vpMbMultiCueTracker::forgetPrimitives()
{
  faces.reset();
  m_projectionErrorFaces.reset();
  deleteAll(m_projectionErrorLines);
  deleteAll(m_projectionErrorCylinders);
  deleteAll(m_projectionErrorCircles);
}

void vpMbMultiCueTracker::loadModel(const std::string &modelFile, bool verbose, const vpHomogeneousMatrix &odTo)
{
  if (vpModelReader::isMesh(modelFile)) {
    loadMesh(modelFile, odTo);
  } else {
    loadVispModel(modelFile, verbose, odTo);
  }
  if (verbose) {
    std::cout << m_impl->model->report() << std::flush;
  }
}

void vpMbMultiCueTracker::loadMesh(const std::string &modelFile, const vpHomogeneousMatrix &odTo)
{
  vpTrackedModel loaded = vpModelReader::read(modelFile, m_impl->modelOptions, odTo);
  forgetPrimitives();
  m_impl->setModel(std::move(loaded));
  modelInitialised = true;
  modelFileName = modelFile;
}

void vpMbMultiCueTracker::loadVispModel(const std::string &modelFile, bool verbose, const vpHomogeneousMatrix &odTo)
{
  // The unit is that of meshes: ViSP's files are in metres.
  vpModelOptions options = m_impl->modelOptions;
  options.unit = 1.;
  vpTrackedModel loaded = vpPrimitiveCollector(options).read(modelFile, odTo);
  forgetPrimitives();
  // Read once more for what vpMbTracker itself keeps of a model: faces, their level of detail, projection error.
  vpMbTracker::loadModel(modelFile, verbose, odTo);
  m_impl->setModel(std::move(loaded));
  if (useLodGeneral) {
    vpMbTracker::setLod(true);
    vpMbTracker::setMinLineLengthThresh(minLineLengthThresholdGeneral);
    vpMbTracker::setMinPolygonAreaThresh(minPolygonAreaThresholdGeneral);
  }
}

void vpMbMultiCueTracker::setModelUnit(double metresPerUnit)
{
  vpModelOptions options = m_impl->modelOptions;
  options.unit = metresPerUnit;
  setModelOptions(options);
}

void vpMbMultiCueTracker::setModelOptions(const vpModelOptions &options)
{
  options.check();
  m_impl->modelOptions = options;
}

const vpModelOptions &vpMbMultiCueTracker::getModelOptions() const
{
  return m_impl->modelOptions;
}

const vpModelReport &vpMbMultiCueTracker::getModelReport() const
{
  return m_impl->requireModel().report();
}

std::shared_ptr<const vpTrackedModel> vpMbMultiCueTracker::getModel() const
{
  return m_impl->model;
}

void vpMbMultiCueTracker::reInitModel(const vpImage<unsigned char> &I, const std::string &modelFile,
                                      const vpHomogeneousMatrix &cMo, bool verbose, const vpHomogeneousMatrix &odTo)
{
  loadModel(modelFile, verbose, odTo);
  initFromPose(I, cMo);
}

void vpMbMultiCueTracker::reInitModel(const vpImage<vpRGBa> &I_color, const std::string &modelFile,
                                      const vpHomogeneousMatrix &cMo, bool verbose, const vpHomogeneousMatrix &odTo)
{
  loadModel(modelFile, verbose, odTo);
  initFromPose(I_color, cMo);
}

void vpMbMultiCueTracker::resetTracker()
{
  forgetPrimitives();
  modelInitialised = false;
  modelFileName.clear();
  m_cMo.eye();
  m_cam = vpCameraParameters();
  m_error.resize(0);
  m_w.resize(0);
  covarianceMatrix.resize(0, 0);
  computeCovariance = false;
  computeProjError = false;
  projectionError = 90.;
  displayFeatures = false;
  m_mask = nullptr;
  oJo.eye(6);
  isoJoIdentity = true;
  angleAppears = vpMath::rad(89.);
  angleDisappears = vpMath::rad(89.);
  clippingFlag = vpPolygon3D::NO_CLIPPING;
  distNearClip = 0.001;
  distFarClip = 100.;
  useScanLine = false;
  useLodGeneral = false;
  applyLodSettingInConfig = false;
  minLineLengthThresholdGeneral = 50.;
  minPolygonAreaThresholdGeneral = 2500.;
  m_optimizationMethod = GAUSS_NEWTON_OPT;
  m_computeInteraction = true;
  m_lambda = 1.;
  m_maxIter = 30;
  m_stopCriteriaEpsilon = 1e-8;
  m_initialMu = 0.01;
  const int type = m_impl->type;
  m_impl = std::make_unique<Impl>();
  m_impl->type = type;
}

END_VISP_NAMESPACE
