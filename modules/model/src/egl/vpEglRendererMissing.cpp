// SPDX-License-Identifier: GPL-2.0-or-later
// Compiled in place of vpEglRenderer.cpp where EGL or OpenGL was not found.
#include <visp3/model/vpEglRenderer.h>

#include <visp3/core/vpException.h>

BEGIN_VISP_NAMESPACE

class vpEglRenderer::Impl
{
};

vpEglRenderer::vpEglRenderer(const std::shared_ptr<const vpTrackedModel> &)
{
  throw vpException(vpException::functionNotImplementedError,
                    "this library was built without EGL: install EGL and OpenGL for developers and build it again");
}

vpEglRenderer::~vpEglRenderer() = default;

void vpEglRenderer::render(const vpHomogeneousMatrix &, const vpCameraParameters &, unsigned int, unsigned int,
                           const vpRenderOptions &, vpRenderedView &)
{
}

std::string vpEglRenderer::name() const
{
  return "EGL (not built)";
}

bool vpEglRenderer::isSoftware() const
{
  return false;
}

END_VISP_NAMESPACE
