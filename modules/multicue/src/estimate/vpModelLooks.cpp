// SPDX-License-Identifier: GPL-2.0-or-later
#include "estimate/vpModelLooks.h"

#include "frame/vpStopwatch.h"
#include "hypotheses/vpControlPointMotion.h"

#include <visp3/core/vpException.h>
#include <visp3/se3/vpPoseExponential.h>

#include <algorithm>
#include <cmath>

BEGIN_VISP_NAMESPACE

namespace {
// What hides what changes little for poses that move the control points by less than this, pixels.
const double sameDepth = 2.5;
// Half the side of the window around the expected pose, in projected diameters: the object and as much beside it as it
// may jump.
const double nearWindow = 0.85;

// The depth buffer only tells what hides what: a convex object needs none.
std::unique_ptr<vpModelRenderer> rendererOf(const std::shared_ptr<const vpTrackedModel> &model,
                                            vpModelRenderer::Preference preference)
{
  return model && !model->isConvex() ? vpModelRenderer::create(model, preference) : nullptr;
}
} // namespace

void vpModelLooks::setModel(std::shared_ptr<const vpTrackedModel> model)
{
  std::unique_ptr<vpModelRenderer> renderer = rendererOf(model, m_preference); // May throw: nothing has changed yet.
  m_view = std::make_unique<vpModelView>(model);
  m_model = std::move(model);
  m_renderer = std::move(renderer);
  m_depthRenderer.reset();
  m_hasToldFailure = false;
  setSize(0, 0);
}

const vpTrackedModel &vpModelLooks::requireModel() const
{
  if (!m_model) {
    throw vpException(vpException::notInitialized, "No model: call loadModel() first");
  }
  return *m_model;
}

void vpModelLooks::setPreference(vpModelRenderer::Preference preference)
{
  m_renderer = rendererOf(m_model, preference);
  m_preference = preference;
  m_depthRenderer.reset();
  m_hasToldFailure = false;
}

void vpModelLooks::setSize(unsigned int width, unsigned int height)
{
  m_width = width;
  m_height = height;
}

const vpModelView &vpModelLooks::compute(const vpFrameContext &frame, const vpHomogeneousMatrix &cMo, bool keepDepth)
{
  const vpStopwatch stage(frame.timings.view);
  const vpCueFrame &image = frame.image;
  m_view->compute(cMo, image.camera(), image.width(), image.height(), options, m_renderer.get(), keepDepth);
  m_viewedFrame = image.number();
  return *m_view;
}

const vpModelView &vpModelLooks::update(const vpFrameContext &frame, const vpHomogeneousMatrix &cMo, double near)
{
  const vpModelView &view = *m_view;
  const vpCameraParameters &cam = frame.image.camera();
  // A view without points, of a pose beside the image, tells nothing of how far another one is from it.
  const bool isOfFrame = m_viewedFrame == frame.image.number() && !view.points().empty();
  if (isOfFrame && vpControlPointMotion::mean(view, cMo, cam) <= near) {
    return view;
  }
  return compute(frame, cMo, isOfFrame && vpControlPointMotion::between(view, view.depthPose(), cMo, cam) < sameDepth);
}

// True where the depth buffer of this frame tells what hides what at a pose, too. It is looked into where the object's
// middle has gone, so that only the motion about that counts.
bool vpModelLooks::servesDepth(const vpFrameContext &frame, const vpHomogeneousMatrix &cMo) const
{
  const vpModelView &view = *m_view;
  return m_viewedFrame == frame.image.number() && !view.points().empty() && view.depth() != nullptr &&
         vpControlPointMotion::aroundMiddle(view, view.depthPose(), cMo, frame.image.camera()) < sameDepth;
}

const vpModelView &vpModelLooks::computeNear(const vpFrameContext &frame, const vpHomogeneousMatrix &cMo)
{
  return compute(frame, cMo, servesDepth(frame, cMo));
}

const vpModelView &vpModelLooks::computeCoarsely(const vpFrameContext &frame, const vpHomogeneousMatrix &cMo,
                                                 double coarseness)
{
  const vpStopwatch stage(frame.timings.view);
  const vpCueFrame &image = frame.image;
  const bool keepsDepth = servesDepth(frame, cMo);
  vpModelViewOptions coarse = options;
  coarse.sampleStep *= coarseness;
  m_view->compute(cMo, image.camera(), image.width(), image.height(), coarse, m_renderer.get(), keepsDepth);
  m_viewedFrame = image.number();
  return *m_view;
}

vpImageRegion vpModelLooks::regionAround(const vpHomogeneousMatrix &cMo) const
{
  const Eigen::Vector3d at = vpPoseExponential::toEigen(cMo) * m_model->centre();
  if (!(at.z() > 0.)) {
    return vpImageRegion();
  }
  const double size = nearWindow * m_model->diameter() * m_camera.get_px() / at.z();
  const double u = m_camera.get_u0() + m_camera.get_px() * at.x() / at.z();
  const double v = m_camera.get_v0() + m_camera.get_py() * at.y() / at.z();
  const auto whole = [](double x) { return static_cast<int>(std::lround(std::min(std::max(x, -1e6), 1e6))); };
  return vpImageRegion(whole(u - size), whole(v - size), whole(2. * size), whole(2. * size));
}

double vpModelLooks::depthOf(const vpHomogeneousMatrix &cMo) const
{
  const Eigen::Vector3d centre = m_model->centre();
  return cMo[2][0] * centre.x() + cMo[2][1] * centre.y() + cMo[2][2] * centre.z() + cMo[2][3];
}

std::string vpModelLooks::newFailure()
{
  for (const vpModelRenderer *renderer : {m_renderer.get(), m_depthRenderer.get()}) {
    if (!m_hasToldFailure && renderer != nullptr && !renderer->failure().empty()) {
      m_hasToldFailure = true; // The other one fails for the same reason.
      return renderer->failure();
    }
  }
  return std::string();
}

const vpRenderedView &vpModelLooks::renderDepth(const vpHomogeneousMatrix &cMo)
{
  if (!m_depthRenderer) {
    m_depthRenderer = vpModelRenderer::create(m_model, m_preference);
  }
  vpRenderOptions near;
  near.nearDistance = options.nearDistance;
  m_depthRenderer->render(cMo, m_camera, m_width, m_height, near, m_depth);
  return m_depth;
}

END_VISP_NAMESPACE
