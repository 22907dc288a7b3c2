// SPDX-License-Identifier: GPL-2.0-or-later
#include "vpFallbackRenderer.h"

#include "vpCropCamera.h"

#include <visp3/core/vpException.h>
#include <visp3/model/vpCpuRenderer.h>
#include <visp3/se3/vpExactNumber.h>

#include <algorithm>
#include <utility>

BEGIN_VISP_NAMESPACE

namespace {
// A depth may be that much of the object's size before or behind its box: 32 bits are exact to a millionth of it.
constexpr double depthTolerance = 0.01;
// Pixels that one renderer alone may see of an object: those that its outline goes through are not always the same.
constexpr long fewPixels = 20;

bool isSeen(float depth)
{
  return depth > 0.F;
}
} // namespace

vpFallbackRenderer::vpFallbackRenderer(std::unique_ptr<vpModelRenderer> renderer,
                                       std::shared_ptr<const vpTrackedModel> model)
    : m_model(std::move(model)), m_renderer(std::move(renderer))
{
}

bool vpFallbackRenderer::areDepthsOfModel(const vpHomogeneousMatrix &cMo, const vpRenderOptions &options,
                                          const vpRenderedView &view) const
{
  const Eigen::Vector3d middle = 0.5 * (m_model->boxMin() + m_model->boxMax());
  const double radius = (0.5 + depthTolerance) * (m_model->boxMax() - m_model->boxMin()).norm();
  const double atMiddle = vpTransform(vpToPoseMatrix(cMo), middle).z();
  const auto nearest = static_cast<float>(std::max(atMiddle - radius, (1. - depthTolerance) * options.nearDistance));
  const auto farthest = static_cast<float>(atMiddle + radius);
  return std::all_of(view.depth.begin(), view.depth.end(), [nearest, farthest](float depth) {
    return vpIsZero(static_cast<double>(depth)) || (depth >= nearest && depth <= farthest);
  });
}

void vpFallbackRenderer::fail(const std::string &reason)
{
  m_failure = "the renderer " + m_renderer->name() + " failed, so that the CPU draws in its place: " + reason;
  m_renderer.reset();
}

void vpFallbackRenderer::render(const vpHomogeneousMatrix &cMo, const vpCameraParameters &cam, unsigned int imageWidth,
                                unsigned int imageHeight, const vpRenderOptions &options, vpRenderedView &view)
{
  const auto renderOnCpu = [&](vpRenderedView &result) {
    if (!m_cpu) {
      m_cpu = std::make_unique<vpCpuRenderer>(m_model);
    }
    m_cpu->render(cMo, cam, imageWidth, imageHeight, options, result);
  };
  if (!m_renderer) {
    return renderOnCpu(view);
  }
  try {
    m_renderer->render(cMo, cam, imageWidth, imageHeight, options, view);
  } catch (const vpException &e) {
    renderOnCpu(view); // It refuses what was asked for wrongly, too.
    return fail(e.getStringMessage());
  }
  if (!areDepthsOfModel(cMo, options, view)) {
    renderOnCpu(view);
    return fail("it drew depths that the object cannot have");
  }
  // Seldom, since the crop is where the object is; it ends at the first pixel that is seen.
  if (!view.depth.empty() && std::none_of(view.depth.begin(), view.depth.end(), isSeen)) {
    renderOnCpu(m_compared);
    if (std::count_if(m_compared.depth.begin(), m_compared.depth.end(), isSeen) > fewPixels) {
      std::swap(view, m_compared);
      fail("it drew nothing of the object");
    }
  }
}

END_VISP_NAMESPACE
