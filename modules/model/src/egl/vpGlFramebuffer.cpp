// SPDX-License-Identifier: GPL-2.0-or-later
#include "vpGlFramebuffer.h"

#include <visp3/core/vpException.h>

#include <algorithm>
#include <array>
#include <string>

BEGIN_VISP_NAMESPACE

namespace {
void allocate(const vpGlRenderbuffer &buffer, GLenum format, GLenum attachment, int width, int height)
{
  glBindRenderbuffer(GL_RENDERBUFFER, buffer.id());
  glRenderbufferStorage(GL_RENDERBUFFER, format, width, height);
  vpCheckGl("glRenderbufferStorage");
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, attachment, GL_RENDERBUFFER, buffer.id());
  vpCheckGl("glFramebufferRenderbuffer");
}
} // namespace

void vpGlFramebuffer::resize(int width, int height)
{
  GLint limit = 0;
  glGetIntegerv(GL_MAX_RENDERBUFFER_SIZE, &limit);
  if (width > limit || height > limit) {
    throw vpException(vpException::badValue, "A crop of " + std::to_string(width) + " x " + std::to_string(height) +
                                                 " pixels is too large for OpenGL, whose limit is " +
                                                 std::to_string(limit) + ": set vpRenderOptions::maxSize");
  }
  m_width = m_height = 0;
  allocate(m_depth, GL_R32F, GL_COLOR_ATTACHMENT0, width, height);
  allocate(m_triangle, GL_R32I, GL_COLOR_ATTACHMENT1, width, height);
  allocate(m_zBuffer, GL_DEPTH_COMPONENT24, GL_DEPTH_ATTACHMENT, width, height);
  const GLenum status = glCheckFramebufferStatus(GL_FRAMEBUFFER);
  if (status != GL_FRAMEBUFFER_COMPLETE) {
    throw vpException(vpException::fatalError, "glCheckFramebufferStatus gave " + std::to_string(status));
  }
  m_width = width;
  m_height = height;
}

void vpGlFramebuffer::begin(int width, int height, bool withTriangle)
{
  glBindFramebuffer(GL_FRAMEBUFFER, m_framebuffer.id());
  if (width > m_width || height > m_height) {
    resize(std::max(width, m_width), std::max(height, m_height));
  }
  const std::array<GLenum, 2> drawn = {{GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1}};
  glDrawBuffers(withTriangle ? 2 : 1, drawn.data());
  vpCheckGl("glDrawBuffers");

  // Clearing is limited to the crop, the buffers may be larger.
  glViewport(0, 0, width, height);
  glScissor(0, 0, width, height);
  glEnable(GL_SCISSOR_TEST);
  const std::array<GLfloat, 4> noDepth = {{0.F, 0.F, 0.F, 0.F}};
  const std::array<GLint, 4> noTriangle = {{-1, -1, -1, -1}};
  const GLfloat farthest = 1.F;
  glClearBufferfv(GL_COLOR, 0, noDepth.data());
  glClearBufferfv(GL_DEPTH, 0, &farthest);
  if (withTriangle) {
    glClearBufferiv(GL_COLOR, 1, noTriangle.data());
  }
  vpCheckGl("glClearBuffer");
}

void vpGlFramebuffer::readDepth(int width, int height, float *depth) const
{
  glReadBuffer(GL_COLOR_ATTACHMENT0);
  glReadPixels(0, 0, width, height, GL_RED, GL_FLOAT, depth);
  vpCheckGl("glReadPixels of the depth");
}

void vpGlFramebuffer::readTriangle(int width, int height, int *triangle) const
{
  glReadBuffer(GL_COLOR_ATTACHMENT1);
  glReadPixels(0, 0, width, height, GL_RED_INTEGER, GL_INT, triangle);
  vpCheckGl("glReadPixels of the triangle");
}

END_VISP_NAMESPACE
