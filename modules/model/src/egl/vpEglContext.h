// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpEglContext_h
#define vpEglContext_h

#include <visp3/se3/vpCompatibility.h>

#include <EGL/egl.h>

BEGIN_VISP_NAMESPACE

/*!
  An OpenGL 3.3 core context without a window, on the first of these that gives one: EGL devices with hardware, EGL
  devices in software, Mesa's surfaceless platform, the default display.
*/
class vpEglContext
{
public:
  //! \throw vpException listing what was tried and which EGL call failed on each.
  vpEglContext();
  ~vpEglContext();
  vpEglContext(const vpEglContext &) = delete;
  vpEglContext &operator=(const vpEglContext &) = delete;

  //! Makes the context current in this thread for as long as it lives, then what was current before.
  class Scope
  {
  public:
    explicit Scope(const vpEglContext &context);
    ~Scope();
    Scope(const Scope &) = delete;
    Scope &operator=(const Scope &) = delete;

  private:
    EGLDisplay m_display;
    EGLContext m_context;
    EGLSurface m_draw;
    EGLSurface m_read;
    EGLDisplay m_own;
  };

private:
  EGLDisplay m_display = EGL_NO_DISPLAY;
  EGLContext m_context = EGL_NO_CONTEXT;
};

END_VISP_NAMESPACE
#endif
