// SPDX-License-Identifier: GPL-2.0-or-later
#include "tracker/vpTrackerState.h"

#include <visp3/core/vpException.h>

BEGIN_VISP_NAMESPACE

const char *toString(vpTrackingState state)
{
  switch (state) {
  case vpTrackingState::TRACKING:
    return "TRACKING";
  case vpTrackingState::UNCERTAIN:
    return "UNCERTAIN";
  case vpTrackingState::LOST:
    break;
  }
  return "LOST";
}

void vpMbMultiCueTracker::Impl::updateMe()
{
  const vpEdgeCueSettings &settings = edges.settings();
  me.setRange(static_cast<unsigned int>(settings.range));
  me.setMaskSize(settings.maskSize);
  me.setThreshold(vpEdgeCueSettings::toLikelihood(settings.contrast, settings.maskSize));
  me.setMu1(settings.mu1);
  me.setMu2(settings.mu2);
  me.setSampleStep(viewOptions.sampleStep);
}

const vpTrackedModel &vpMbMultiCueTracker::Impl::requireModel() const
{
  if (!model) {
    throw vpException(vpException::notInitialized, "No model: call loadModel() first");
  }
  return *model;
}

void vpMbMultiCueTracker::Impl::setModel(vpTrackedModel &&loaded)
{
  model = std::make_shared<const vpTrackedModel>(std::move(loaded));
  view = std::make_unique<vpModelView>(model);
  displayView.reset();
  makeRenderer();
  forgetImages();
  width = 0;
  height = 0;
  state = vpTrackingState::UNCERTAIN;
}

void vpMbMultiCueTracker::Impl::makeRenderer()
{
  // The depth buffer only tells what hides what: a convex object needs none.
  renderer = model && !model->isConvex() ? vpModelRenderer::create(model, preference) : nullptr;
}

void vpMbMultiCueTracker::Impl::forgetImages()
{
  edges = vpEdgeCue(edges.settings());
  hypotheses.clear();
  frames = 0;
  minimisations = 0;
  block.rows.clear();
  weights.clear();
  expected = 0;
  found = 0;
  good = 0;
}

END_VISP_NAMESPACE
