// SPDX-License-Identifier: GPL-2.0-or-later
#include <visp3/multicue/vpMbMultiCueTracker.h>

#include "model/vpPrimitiveCollector.h"
#include "facade/vpMbTrackerNames.h"
#include "facade/vpTrackerImpl.h"

#include <visp3/core/vpException.h>
#include <visp3/model/vpModelReader.h>

#include <iostream>

BEGIN_VISP_NAMESPACE

vpTrackedModelBuilder vpMbMultiCueTracker::Impl::collect(const vpTrackedModelBuilder &before, const std::string &file,
                                                         const vpHomogeneousMatrix &odTo) const
{
  if (!vpModelReader::isMesh(file)) {
    return vpPrimitiveCollector::add(before, file, odTo);
  }
  vpTrackedModelBuilder collected = before;
  vpModelReader::addTo(collected, file, modelOptions.unit, odTo);
  return collected;
}

void vpMbMultiCueTracker::loadModel(const std::string &modelFile, bool verbose, const vpHomogeneousMatrix &odTo)
{
  const vpTrackedModelBuilder before = m_impl->parts ? *m_impl->parts : vpTrackedModelBuilder(m_impl->modelOptions);
  vpTrackedModelBuilder parts = m_impl->collect(before, modelFile, odTo);
  vpTrackedModel loaded = parts.build(modelFile);
  m_impl->takeModel(std::move(parts), std::move(loaded), modelFile, verbose, odTo);
}

template <typename Pixel>
void vpMbMultiCueTracker::Impl::replaceModel(const vpImage<Pixel> &I, const std::string &file,
                                             const vpHomogeneousMatrix &cMo, bool verbose,
                                             const vpHomogeneousMatrix &odTo)
{
  vpTrackedModelBuilder added = collect(vpTrackedModelBuilder(modelOptions), file, odTo);
  vpTrackedModel loaded = added.build(file);
  // What a start needs, while the old model is there yet; the frame is asked for what it says of the mask.
  requireStart(I.getWidth(), I.getHeight(), loaded, cMo);
  source.frame(I, m_tracker.m_cam, m_tracker.m_mask);
  m_tracker.forgetPrimitives();
  hasMesh = false;
  modelFile.clear();
  m_engine.symmetries.forget();
  untracked = Untracked();
  takeModel(std::move(added), std::move(loaded), file, verbose, odTo);
}

void vpMbMultiCueTracker::Impl::takeModel(vpTrackedModelBuilder &&added, vpTrackedModel &&loaded,
                                          const std::string &file, bool verbose, const vpHomogeneousMatrix &odTo)
{
  if (vpModelReader::isMesh(file)) {
    hasMesh = true;
  } else {
    // What vpMbTracker itself keeps of a model (faces, their level of detail, projection error) is read once more from
    // the file, which has just been read without an error.
    m_tracker.vpMbTracker::loadModel(file, verbose, odTo);
  }
  m_tracker.modelInitialised = true;
  m_tracker.modelFileName = file;
  parts = std::make_unique<vpTrackedModelBuilder>(std::move(added));
  m_engine.setModel(std::move(loaded));
  displayView.reset();
  if (m_tracker.useLodGeneral) {
    m_tracker.vpMbTracker::setLod(true);
    m_tracker.vpMbTracker::setMinLineLengthThresh(m_tracker.minLineLengthThresholdGeneral);
    m_tracker.vpMbTracker::setMinPolygonAreaThresh(m_tracker.minPolygonAreaThresholdGeneral);
  }
  updateDetails();
  updatePointFilter();
  if (verbose) {
    std::cout << m_engine.looks.model().report() << std::flush;
  }
}

void vpMbMultiCueTracker::Impl::updateDetails()
{
  std::vector<vpFaceDetail> &details = m_engine.looks.options.details;
  details.clear();
  if (!m_engine.looks.pointer()) {
    return;
  }
  bool any = false;
  for (const vpModelFace &face : m_engine.looks.model().faces()) {
    vpFaceDetail detail;
    detail.enabled = m_tracker.useLodGeneral; // Faces of meshes have no polygon of their own.
    detail.minLineLength = m_tracker.minLineLengthThresholdGeneral;
    detail.minPolygonArea = m_tracker.minPolygonAreaThresholdGeneral;
    if (face.polygon >= 0 && static_cast<unsigned int>(face.polygon) < m_tracker.faces.size()) {
      const vpMbtPolygon &polygon = *m_tracker.faces[static_cast<unsigned int>(face.polygon)];
      detail.enabled = polygon.useLod;
      detail.minLineLength = polygon.minLineLengthThresh;
      detail.minPolygonArea = polygon.minPolygonAreaThresh;
    }
    detail.tracked = untracked.edges.count(face.name) == 0;
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
  return m_impl->engine().looks.requireModel().report();
}

std::shared_ptr<const vpTrackedModel> vpMbMultiCueTracker::getModel() const
{
  return m_impl->engine().looks.pointer();
}

void vpMbMultiCueTracker::reInitModel(const vpImage<unsigned char> &I, const std::string &modelFile,
                                      const vpHomogeneousMatrix &cMo, bool verbose, const vpHomogeneousMatrix &odTo)
{
  m_impl->replaceModel(I, modelFile, cMo, verbose, odTo);
  initFromPose(I, cMo);
}

void vpMbMultiCueTracker::reInitModel(const vpImage<vpRGBa> &I_color, const std::string &modelFile,
                                      const vpHomogeneousMatrix &cMo, bool verbose, const vpHomogeneousMatrix &odTo)
{
  m_impl->replaceModel(I_color, modelFile, cMo, verbose, odTo);
  initFromPose(I_color, cMo);
}

// What ViSP's trackers keep (camera, moving edges), and all settings of the cues.
void vpMbMultiCueTracker::resetTracker()
{
  vpMultiCueSettings settings = m_impl->settings();
  settings.symmetries.clear(); // They are the model's.
  settings.symmetricObject = vpMultiCueSettings().symmetricObject;
  settings.modelFile.clear();
  std::unique_ptr<Impl> before = std::move(m_impl);
  m_impl = std::make_unique<Impl>(*this);
  forgetPrimitives();
  modelInitialised = false;
  modelFileName.clear();
  m_cMo.eye();
  m_error.clear(); // And not resize(0), which ViSP 3.5 does on memory that there is none of.
  m_w.clear();
  covarianceMatrix.clear();
  projectionError = 90.;
  m_impl->apply(settings);
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
