// SPDX-License-Identifier: GPL-2.0-or-later
#include <visp3/multicue/vpMbMultiCueTracker.h>

#include "model/vpPrimitiveCollector.h"
#include "facade/vpMbTrackerNames.h"
#include "tracker/vpTrackerState.h"

#include <visp3/core/vpException.h>
#include <visp3/model/vpModelReader.h>

#include <iostream>

BEGIN_VISP_NAMESPACE

vpTrackedModelBuilder vpMbMultiCueTracker::collect(const vpTrackedModelBuilder &before, const std::string &modelFile,
                                                   const vpHomogeneousMatrix &odTo) const
{
  if (!vpModelReader::isMesh(modelFile)) {
    return vpPrimitiveCollector::add(before, modelFile, odTo);
  }
  vpTrackedModelBuilder parts = before;
  vpModelReader::addTo(parts, modelFile, m_impl->modelOptions.unit, odTo);
  return parts;
}

void vpMbMultiCueTracker::loadModel(const std::string &modelFile, bool verbose, const vpHomogeneousMatrix &odTo)
{
  const vpTrackedModelBuilder before = m_impl->parts ? *m_impl->parts : vpTrackedModelBuilder(m_impl->modelOptions);
  vpTrackedModelBuilder parts = collect(before, modelFile, odTo);
  vpTrackedModel loaded = parts.build(modelFile);
  takeModel(std::move(parts), std::move(loaded), modelFile, verbose, odTo);
}

template <typename Pixel>
void vpMbMultiCueTracker::replaceModel(const vpImage<Pixel> &I, const std::string &modelFile,
                                       const vpHomogeneousMatrix &cMo, bool verbose, const vpHomogeneousMatrix &odTo)
{
  vpTrackedModelBuilder parts = collect(vpTrackedModelBuilder(m_impl->modelOptions), modelFile, odTo);
  vpTrackedModel loaded = parts.build(modelFile);
  // What a start needs, while the old model is there yet; the frame is asked for what it says of the mask.
  requireStart(I.getWidth(), I.getHeight(), loaded, cMo);
  m_impl->source.frame(I, m_cam, m_mask);
  forgetPrimitives();
  m_impl->hasMesh = false;
  m_impl->symmetries.forget();
  m_impl->untracked = Impl::Untracked();
  takeModel(std::move(parts), std::move(loaded), modelFile, verbose, odTo);
}

void vpMbMultiCueTracker::takeModel(vpTrackedModelBuilder &&parts, vpTrackedModel &&loaded,
                                    const std::string &modelFile, bool verbose, const vpHomogeneousMatrix &odTo)
{
  if (vpModelReader::isMesh(modelFile)) {
    m_impl->hasMesh = true;
  } else {
    // What vpMbTracker itself keeps of a model (faces, their level of detail, projection error) is read once more from
    // the file, which has just been read without an error.
    vpMbTracker::loadModel(modelFile, verbose, odTo);
  }
  modelInitialised = true;
  modelFileName = modelFile;
  m_impl->parts = std::make_unique<vpTrackedModelBuilder>(std::move(parts));
  m_impl->setModel(std::move(loaded));
  if (useLodGeneral) {
    vpMbTracker::setLod(true);
    vpMbTracker::setMinLineLengthThresh(minLineLengthThresholdGeneral);
    vpMbTracker::setMinPolygonAreaThresh(minPolygonAreaThresholdGeneral);
  }
  updateDetails();
  updatePointFilter();
  if (verbose) {
    std::cout << m_impl->model->report() << std::flush;
  }
}

void vpMbMultiCueTracker::updateDetails()
{
  std::vector<vpFaceDetail> &details = m_impl->viewOptions.details;
  details.clear();
  if (!m_impl->model) {
    return;
  }
  bool any = false;
  for (const vpModelFace &face : m_impl->model->faces()) {
    vpFaceDetail detail;
    detail.enabled = useLodGeneral; // Faces of meshes have no polygon of their own.
    detail.minLineLength = minLineLengthThresholdGeneral;
    detail.minPolygonArea = minPolygonAreaThresholdGeneral;
    if (face.polygon >= 0 && static_cast<unsigned int>(face.polygon) < faces.size()) {
      const vpMbtPolygon &polygon = *faces[static_cast<unsigned int>(face.polygon)];
      detail.enabled = polygon.useLod;
      detail.minLineLength = polygon.minLineLengthThresh;
      detail.minPolygonArea = polygon.minPolygonAreaThresh;
    }
    detail.tracked = m_impl->untracked.edges.count(face.name) == 0;
    any = any || detail.enabled || !detail.tracked;
    details.push_back(detail);
  }
  if (!any) {
    details.clear();
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
  replaceModel(I, modelFile, cMo, verbose, odTo);
  initFromPose(I, cMo);
}

void vpMbMultiCueTracker::reInitModel(const vpImage<vpRGBa> &I_color, const std::string &modelFile,
                                      const vpHomogeneousMatrix &cMo, bool verbose, const vpHomogeneousMatrix &odTo)
{
  replaceModel(I_color, modelFile, cMo, verbose, odTo);
  initFromPose(I_color, cMo);
}

// What ViSP's trackers keep (camera, moving edges), and all settings of the cues.
void vpMbMultiCueTracker::resetTracker()
{
  vpMultiCueSettings settings = currentSettings();
  settings.symmetries.clear(); // They are the model's.
  settings.symmetricObject = vpMultiCueSettings().symmetricObject;
  std::unique_ptr<Impl> before = std::move(m_impl);
  m_impl = std::make_unique<Impl>();
  forgetPrimitives();
  modelInitialised = false;
  modelFileName.clear();
  m_cMo.eye();
  m_error.resize(0);
  m_w.resize(0);
  covarianceMatrix.resize(0, 0);
  projectionError = 90.;
  applySettings(settings);
  m_impl->take(*before);
  oJo.eye(6);
  m_isoJoIdentity = true;
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
}

END_VISP_NAMESPACE
