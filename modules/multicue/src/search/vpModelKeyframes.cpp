// SPDX-License-Identifier: GPL-2.0-or-later
#include "search/vpModelKeyframes.h"

#include <visp3/core/vpImageConvert.h>

#include <algorithm>

BEGIN_VISP_NAMESPACE

namespace {
// The renderings' camera: the object's diameter spans 250 of 400 pixels. Corners are found at scales from 1 to 0.48.
const unsigned int side = 400;
const double focal = 1000.;
const unsigned char behind = 128; // Gray level around the object.
} // namespace

void vpModelKeyframes::setModel(std::shared_ptr<const vpTrackedModel> model)
{
  m_model = std::move(model);
  if (m_model) {
    m_keyframes.setObject(m_model->centre(), m_model->diameter());
  }
  m_isLearnt = false;
}

void vpModelKeyframes::learn(vpViewSphere &sphere, vpModelRenderer &renderer)
{
  for (std::size_t i = 0; i < std::min(vpViewSphere::size(level), sphere.size()); ++i) {
    learnView(sphere.poseOf(i), renderer);
  }
}

void vpModelKeyframes::learnView(const vpHomogeneousMatrix &cMo, vpModelRenderer &renderer)
{
  const double middle = 0.5 * (side - 1);
  const vpCameraParameters cam(focal, focal, middle, middle);
  vpRenderOptions options;
  options.channels = vpRenderOptions::DEPTH | vpRenderOptions::COLOR;
  vpRenderedView view;
  renderer.render(cMo, cam, side, side, options, view);
  vpImage<vpRGBa> I(side, side, vpRGBa(behind, behind, behind));
  for (int i = 0; i < view.height; ++i) {
    for (int j = 0; j < view.width; ++j) {
      const std::size_t k = static_cast<std::size_t>(i * view.width + j);
      if (view.depth[k] > 0.F) {
        I[static_cast<unsigned int>(view.top + i)][static_cast<unsigned int>(view.left + j)] = view.color[k];
      }
    }
  }
  vpFrameSource source;
  m_keyframes.learn(source.frame(I, cam, nullptr), cMo, view);
}

std::vector<vpKeyframePose> vpModelKeyframes::find(const vpCueFrame &frame, vpViewSphere &sphere,
                                                   vpModelRenderer::Preference preference)
{
  if (!m_model || m_model->appearance().images.empty() || !vpKeyframes::isAvailable()) {
    return {};
  }
  if (!m_isLearnt) {
    learn(sphere, *vpModelRenderer::create(m_model, preference));
    m_isLearnt = true;
  }
  vpKeyframes::Where anywhere;
  anywhere.expected = sphere.poseOf(0);
  return m_keyframes.find(frame, {0, 0, static_cast<int>(frame.width()), static_cast<int>(frame.height())}, anywhere);
}

END_VISP_NAMESPACE
