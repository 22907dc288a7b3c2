// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpGl_h
#define vpGl_h

// Declares the functions of OpenGL's core profile, which the library called OpenGL exports.
#define GL_GLEXT_PROTOTYPES
#include <GL/glcorearb.h>

#include <visp3/se3/vpCompatibility.h>

BEGIN_VISP_NAMESPACE

//! \throw vpException with \e call and the error's name where OpenGL has recorded an error.
void vpCheckGl(const char *call);

/*!
  Owns the name of an OpenGL object. Made and destroyed while its context is current.
  \tparam Kind Has static create(GLuint *), destroy(const GLuint *) and a name for messages.
*/
template <class Kind> class vpGlObject
{
public:
  vpGlObject()
  {
    Kind::create(&m_id);
    vpCheckGl(Kind::call);
  }
  ~vpGlObject()
  {
    if (m_id != 0) {
      Kind::destroy(&m_id);
    }
  }
  vpGlObject(const vpGlObject &) = delete;
  vpGlObject &operator=(const vpGlObject &) = delete;

  GLuint id() const { return m_id; }
  //! Its context is gone, and the name with it: nothing is deleted, whichever context is current.
  void abandon() { m_id = 0; }

private:
  GLuint m_id = 0;
};

struct vpGlBufferKind
{
  static constexpr const char *call = "glGenBuffers";
  static void create(GLuint *id) { glGenBuffers(1, id); }
  static void destroy(const GLuint *id) { glDeleteBuffers(1, id); }
};

struct vpGlVertexArrayKind
{
  static constexpr const char *call = "glGenVertexArrays";
  static void create(GLuint *id) { glGenVertexArrays(1, id); }
  static void destroy(const GLuint *id) { glDeleteVertexArrays(1, id); }
};

struct vpGlRenderbufferKind
{
  static constexpr const char *call = "glGenRenderbuffers";
  static void create(GLuint *id) { glGenRenderbuffers(1, id); }
  static void destroy(const GLuint *id) { glDeleteRenderbuffers(1, id); }
};

struct vpGlFramebufferKind
{
  static constexpr const char *call = "glGenFramebuffers";
  static void create(GLuint *id) { glGenFramebuffers(1, id); }
  static void destroy(const GLuint *id) { glDeleteFramebuffers(1, id); }
};

using vpGlBuffer = vpGlObject<vpGlBufferKind>;
using vpGlVertexArray = vpGlObject<vpGlVertexArrayKind>;
using vpGlRenderbuffer = vpGlObject<vpGlRenderbufferKind>;
using vpGlFramebufferName = vpGlObject<vpGlFramebufferKind>;

END_VISP_NAMESPACE
#endif
