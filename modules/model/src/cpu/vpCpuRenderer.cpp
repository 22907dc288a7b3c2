// SPDX-License-Identifier: GPL-2.0-or-later
#include <visp3/model/vpCpuRenderer.h>

#include "vpTriangleRasterizer.h"
#include "../render/vpSurfaceShader.h"

#include <visp3/core/vpException.h>

BEGIN_VISP_NAMESPACE

class vpCpuRenderer::Impl
{
public:
  explicit Impl(const std::shared_ptr<const vpTrackedModel> &model)
      : m_model(model), m_rasterizer(*model), m_shader(*model)
  {
  }

  const vpTrackedModel &model() const { return *m_model; }

  void render(const vpHomogeneousMatrix &cMo, const vpCameraParameters &cam, const vpRenderOptions &options,
              vpRenderedView &view)
  {
    const std::size_t size = static_cast<std::size_t>(view.width) * static_cast<std::size_t>(view.height);
    const bool withTriangle = (options.channels & ~static_cast<unsigned int>(vpRenderOptions::DEPTH)) != 0;
    const vpCropCamera camera(cam, view);
    view.depth.assign(size, 0.F);
    m_triangle.assign(withTriangle ? size : 0, -1);
    m_rasterizer.draw(cMo, camera, options.nearDistance,
                      {view.width, view.height, view.depth.data(), withTriangle ? m_triangle.data() : nullptr});
    for (float &depth : view.depth) {
      depth = depth > 0.F ? 1.F / depth : 0.F;
    }
    m_shader.shade(cMo, camera, options.channels, m_triangle, view);
  }

private:
  std::shared_ptr<const vpTrackedModel> m_model;
  vpTriangleRasterizer m_rasterizer;
  vpSurfaceShader m_shader;
  std::vector<int> m_triangle;
};

vpCpuRenderer::vpCpuRenderer(const std::shared_ptr<const vpTrackedModel> &model)
{
  if (!model) {
    throw vpException(vpException::badValue, "vpCpuRenderer was given no model");
  }
  m_impl = std::make_unique<Impl>(model);
}

vpCpuRenderer::~vpCpuRenderer() = default;

void vpCpuRenderer::render(const vpHomogeneousMatrix &cMo, const vpCameraParameters &cam, unsigned int imageWidth,
                           unsigned int imageHeight, const vpRenderOptions &options, vpRenderedView &view)
{
  placeCrop(m_impl->model(), cMo, cam, imageWidth, imageHeight, options, view);
  m_impl->render(cMo, cam, options, view);
}

std::string vpCpuRenderer::name() const
{
  return "CPU";
}

END_VISP_NAMESPACE
