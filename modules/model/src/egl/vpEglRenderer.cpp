// SPDX-License-Identifier: GPL-2.0-or-later
#include <visp3/model/vpEglRenderer.h>

#include "vpEglContext.h"
#include "vpGlScene.h"
#include "../render/vpSurfaceShader.h"

#include <visp3/core/vpException.h>

BEGIN_VISP_NAMESPACE

namespace {
// No depth: what a context that is lost leaves as it was must not be taken for what it drew.
constexpr float unread = -1.F;
} // namespace

class vpEglRenderer::Impl
{
public:
  explicit Impl(const std::shared_ptr<const vpTrackedModel> &model) : m_model(model), m_shader(*model)
  {
    const vpEglContext::Scope scope(m_context);
    m_scene = std::make_unique<vpGlScene>(*model);
    const GLubyte *device = glGetString(GL_RENDERER);
    vpCheckGl("glGetString(GL_RENDERER)");
    m_device = device ? reinterpret_cast<const char *>(device) : "unnamed";
  }

  ~Impl()
  {
    try {
      const vpEglContext::Scope scope(m_context);
      m_scene.reset();
    } catch (const vpException &) {
      // OpenGL's names must not be deleted in another context, and they go with their own one anyway.
      m_scene->abandon();
    }
  }

  Impl(const Impl &) = delete;
  Impl &operator=(const Impl &) = delete;

  const vpTrackedModel &model() const { return *m_model; }
  const std::string &device() const { return m_device; }

  void render(const vpHomogeneousMatrix &cMo, const vpCameraParameters &cam, const vpRenderOptions &options,
              vpRenderedView &view)
  {
    const std::size_t size = static_cast<std::size_t>(view.width) * static_cast<std::size_t>(view.height);
    const bool withTriangle = (options.channels & ~static_cast<unsigned int>(vpRenderOptions::DEPTH)) != 0;
    const vpCropCamera camera(cam, view);
    view.depth.assign(size, unread);
    m_triangle.resize(withTriangle ? size : 0);
    if (size > 0) {
      const vpEglContext::Scope scope(m_context);
      m_scene->render(cMo, camera, options.nearDistance, view, withTriangle ? &m_triangle : nullptr);
    }
    m_shader.shade(cMo, camera, options.channels, m_triangle, view);
  }

private:
  std::shared_ptr<const vpTrackedModel> m_model;
  vpSurfaceShader m_shader;
  vpEglContext m_context;
  std::unique_ptr<vpGlScene> m_scene;
  std::string m_device;
  std::vector<int> m_triangle;
};

vpEglRenderer::vpEglRenderer(const std::shared_ptr<const vpTrackedModel> &model)
{
  if (!model) {
    throw vpException(vpException::badValue, "vpEglRenderer was given no model");
  }
  m_impl = std::make_unique<Impl>(model);
}

vpEglRenderer::~vpEglRenderer() = default;

void vpEglRenderer::render(const vpHomogeneousMatrix &cMo, const vpCameraParameters &cam, unsigned int imageWidth,
                           unsigned int imageHeight, const vpRenderOptions &options, vpRenderedView &view)
{
  placeCrop(m_impl->model(), cMo, cam, imageWidth, imageHeight, options, view);
  m_impl->render(cMo, cam, options, view);
}

std::string vpEglRenderer::name() const
{
  return "EGL (" + m_impl->device() + ")";
}

bool vpEglRenderer::isSoftware() const
{
  for (const char *driver : {"llvmpipe", "softpipe", "swrast", "SWR", "Software Rasterizer"}) {
    if (m_impl->device().find(driver) != std::string::npos) {
      return true;
    }
  }
  return false;
}

END_VISP_NAMESPACE
