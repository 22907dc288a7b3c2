// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpGlProgram_h
#define vpGlProgram_h

#include "vpGl.h"

#include <string>

BEGIN_VISP_NAMESPACE

//! A linked shader program; its context is current whenever it is used.
class vpGlProgram
{
public:
  //! \throw vpException with the compiler's or the linker's log.
  vpGlProgram(const std::string &vertexSource, const std::string &fragmentSource);
  ~vpGlProgram();
  vpGlProgram(const vpGlProgram &) = delete;
  vpGlProgram &operator=(const vpGlProgram &) = delete;

  GLuint id() const { return m_id; }
  //! As vpGlObject::abandon().
  void abandon() { m_id = 0; }
  //! \throw vpException where the program has no such uniform variable.
  GLint uniform(const char *name) const;

private:
  GLuint m_id;
};

END_VISP_NAMESPACE
#endif
