// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpGlFramebuffer_h
#define vpGlFramebuffer_h

#include "vpGl.h"

BEGIN_VISP_NAMESPACE

/*!
  Where pixels are drawn: depth in metres, index of the triangle, and the z-buffer. Row 0 is the image's first row.
  Grows with the largest crop and never shrinks.
*/
class vpGlFramebuffer
{
public:
  //! Makes room, selects what is drawn, and clears it. \throw vpException naming the call, or the size where too large.
  void begin(int width, int height, bool withTriangle);
  //! Waits for the drawing and copies it; width and height are those of begin().
  void readDepth(int width, int height, float *depth) const;
  void readTriangle(int width, int height, int *triangle) const;
  //! As vpGlObject::abandon().
  void abandon()
  {
    m_framebuffer.abandon();
    m_depth.abandon();
    m_triangle.abandon();
    m_zBuffer.abandon();
  }

private:
  void resize(int width, int height);

  vpGlFramebufferName m_framebuffer;
  vpGlRenderbuffer m_depth;
  vpGlRenderbuffer m_triangle;
  vpGlRenderbuffer m_zBuffer;
  int m_width = 0;
  int m_height = 0;
};

END_VISP_NAMESPACE
#endif
