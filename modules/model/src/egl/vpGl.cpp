// SPDX-License-Identifier: GPL-2.0-or-later
#include "vpGl.h"

#include <visp3/core/vpException.h>

#include <string>

BEGIN_VISP_NAMESPACE

namespace {
std::string errorName(GLenum error)
{
  switch (error) {
  case GL_INVALID_ENUM:
    return "GL_INVALID_ENUM";
  case GL_INVALID_VALUE:
    return "GL_INVALID_VALUE";
  case GL_INVALID_OPERATION:
    return "GL_INVALID_OPERATION";
  case GL_INVALID_FRAMEBUFFER_OPERATION:
    return "GL_INVALID_FRAMEBUFFER_OPERATION";
  case GL_OUT_OF_MEMORY:
    return "GL_OUT_OF_MEMORY";
  default:
    return "error " + std::to_string(error);
  }
}
} // namespace

void vpCheckGl(const char *call)
{
  const GLenum error = glGetError();
  if (error != GL_NO_ERROR) {
    throw vpException(vpException::fatalError, std::string(call) + " failed with " + errorName(error));
  }
}

END_VISP_NAMESPACE
