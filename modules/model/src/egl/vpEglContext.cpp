// SPDX-License-Identifier: GPL-2.0-or-later
#include "vpEglContext.h"
#include "vpEglDisplays.h"

#include <visp3/core/vpException.h>

#include <array>
#include <string>

BEGIN_VISP_NAMESPACE

namespace {
//! The thread's rendering API, put back at the end: it decides what eglCreateContext() makes.
class ApiScope
{
public:
  ApiScope() : m_before(eglQueryAPI())
  {
    if (!eglBindAPI(EGL_OPENGL_API)) {
      vpThrowEgl("eglBindAPI(EGL_OPENGL_API)");
    }
  }
  ~ApiScope() { eglBindAPI(m_before); }
  ApiScope(const ApiScope &) = delete;
  ApiScope &operator=(const ApiScope &) = delete;

private:
  EGLenum m_before;
};

EGLConfig chooseConfig(EGLDisplay display)
{
  const std::array<EGLint, 5> wanted = {
      {EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_NONE}};
  EGLConfig config = nullptr;
  EGLint count = 0;
  if (!eglChooseConfig(display, wanted.data(), &config, 1, &count)) {
    vpThrowEgl("eglChooseConfig");
  }
  if (count == 0) {
    throw vpException(vpException::fatalError, "eglChooseConfig found no configuration for OpenGL");
  }
  return config;
}

/*!
  Displays stay initialized until the process ends: an EGLDisplay is shared by all who ask for the same device, and
  eglTerminate() would take the contexts of other renderers and of the application with it.
*/
EGLContext createContext(EGLDisplay display)
{
  EGLint major = 0;
  EGLint minor = 0;
  if (!eglInitialize(display, &major, &minor)) {
    vpThrowEgl("eglInitialize");
  }
  if (!vpHasEglExtension(display, "EGL_KHR_surfaceless_context")) {
    throw vpException(vpException::fatalError, "EGL_KHR_surfaceless_context is missing");
  }
  const std::array<EGLint, 7> attributes = {{EGL_CONTEXT_MAJOR_VERSION, 3, EGL_CONTEXT_MINOR_VERSION, 3,
                                             EGL_CONTEXT_OPENGL_PROFILE_MASK, EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                             EGL_NONE}};
  const EGLContext context = eglCreateContext(display, chooseConfig(display), EGL_NO_CONTEXT, attributes.data());
  if (context == EGL_NO_CONTEXT) {
    vpThrowEgl("eglCreateContext for OpenGL 3.3 core");
  }
  return context;
}
} // namespace

vpEglContext::vpEglContext()
{
  const ApiScope api;
  std::string failures;
  for (const vpEglDisplayChoice &choice : vpListEglDisplays()) {
    try {
      m_display = choice.open();
      m_context = createContext(m_display);
      const Scope usable(*this);
      return;
    } catch (const vpException &e) {
      if (m_context != EGL_NO_CONTEXT) {
        eglDestroyContext(m_display, m_context);
        m_context = EGL_NO_CONTEXT;
      }
      failures += (failures.empty() ? "" : "; ") + choice.name + ": " + e.getStringMessage();
    }
  }
  throw vpException(vpException::fatalError, "no EGL display gives an OpenGL 3.3 context (" + failures + ")");
}

vpEglContext::~vpEglContext()
{
  eglDestroyContext(m_display, m_context);
}

vpEglContext::Scope::Scope(const vpEglContext &context)
    : m_display(eglGetCurrentDisplay()), m_context(eglGetCurrentContext()), m_draw(eglGetCurrentSurface(EGL_DRAW)),
      m_read(eglGetCurrentSurface(EGL_READ)), m_own(context.m_display)
{
  if (!eglMakeCurrent(m_own, EGL_NO_SURFACE, EGL_NO_SURFACE, context.m_context)) {
    vpThrowEgl("eglMakeCurrent");
  }
}

vpEglContext::Scope::~Scope()
{
  if (m_context == EGL_NO_CONTEXT) {
    eglMakeCurrent(m_own, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  } else {
    eglMakeCurrent(m_display, m_draw, m_read, m_context);
  }
}

END_VISP_NAMESPACE
