// SPDX-License-Identifier: GPL-2.0-or-later
#include "vpGlProgram.h"

#include <visp3/core/vpException.h>

#include <vector>

BEGIN_VISP_NAMESPACE

namespace {
using GetParameter = void (*)(GLuint, GLenum, GLint *);
using GetLog = void (*)(GLuint, GLsizei, GLsizei *, GLchar *);

void checkStatus(GLuint id, GLenum status, const char *call, GetParameter getParameter, GetLog getLog)
{
  GLint good = GL_FALSE;
  getParameter(id, status, &good);
  if (good == GL_TRUE) {
    return;
  }
  GLint length = 0;
  getParameter(id, GL_INFO_LOG_LENGTH, &length);
  std::vector<GLchar> log(static_cast<std::size_t>(length) + 1, '\0');
  getLog(id, length, nullptr, log.data());
  throw vpException(vpException::fatalError, std::string(call) + " failed: " + log.data());
}

//! A shader that is needed only until the program is linked.
class Shader
{
public:
  Shader(GLenum kind, const std::string &source) : m_id(glCreateShader(kind))
  {
    const GLchar *text = source.c_str();
    glShaderSource(m_id, 1, &text, nullptr);
    glCompileShader(m_id);
  }
  ~Shader() { glDeleteShader(m_id); }
  Shader(const Shader &) = delete;
  Shader &operator=(const Shader &) = delete;

  void check() const
  {
    checkStatus(
        m_id, GL_COMPILE_STATUS, "glCompileShader",
        [](GLuint id, GLenum name, GLint *value) { glGetShaderiv(id, name, value); },
        [](GLuint id, GLsizei size, GLsizei *length, GLchar *log) { glGetShaderInfoLog(id, size, length, log); });
  }
  GLuint id() const { return m_id; }

private:
  GLuint m_id;
};

void link(GLuint program, const std::string &vertexSource, const std::string &fragmentSource)
{
  const Shader vertex(GL_VERTEX_SHADER, vertexSource);
  const Shader fragment(GL_FRAGMENT_SHADER, fragmentSource);
  vertex.check();
  fragment.check();
  glAttachShader(program, vertex.id());
  glAttachShader(program, fragment.id());
  glLinkProgram(program);
  glDetachShader(program, vertex.id());
  glDetachShader(program, fragment.id());
  checkStatus(
      program, GL_LINK_STATUS, "glLinkProgram",
      [](GLuint id, GLenum name, GLint *value) { glGetProgramiv(id, name, value); },
      [](GLuint id, GLsizei size, GLsizei *length, GLchar *log) { glGetProgramInfoLog(id, size, length, log); });
  vpCheckGl("glLinkProgram");
}
} // namespace

vpGlProgram::vpGlProgram(const std::string &vertexSource, const std::string &fragmentSource) : m_id(glCreateProgram())
{
  try {
    link(m_id, vertexSource, fragmentSource);
  } catch (...) {
    glDeleteProgram(m_id);
    throw;
  }
}

vpGlProgram::~vpGlProgram()
{
  if (m_id != 0) {
    glDeleteProgram(m_id);
  }
}

GLint vpGlProgram::uniform(const char *name) const
{
  const GLint location = glGetUniformLocation(m_id, name);
  if (location < 0) {
    throw vpException(vpException::fatalError, std::string("glGetUniformLocation found no ") + name);
  }
  return location;
}

END_VISP_NAMESPACE
