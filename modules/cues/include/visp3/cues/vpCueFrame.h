// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpCueFrame_h
#define vpCueFrame_h

#include <visp3/core/vpCameraParameters.h>
#include <visp3/core/vpImage.h>
#include <visp3/core/vpRGBa.h>
#include <visp3/se3/vpCompatibility.h>

BEGIN_VISP_NAMESPACE

/*!
  \ingroup group_cues_frame
  One image as all cues see it: without lens distortion, with everything that several cues need computed once.

  Made by vpFrameSource for the length of one call of track(): it refers to images that it does not own.
*/
class VISP_EXPORT vpCueFrame
{
public:
  //! Gray levels, undistorted.
  const vpImage<unsigned char> &gray() const { return *m_gray; }
  bool hasColor() const { return m_color != nullptr; }
  //! Colours, undistorted. \pre hasColor()
  const vpImage<vpRGBa> &color() const { return *m_color; }
  //! The camera of these images: it has no distortion.
  const vpCameraParameters &camera() const { return m_camera; }
  unsigned int width() const { return m_gray->getWidth(); }
  unsigned int height() const { return m_gray->getHeight(); }

  //! Differs from that of every other frame of this process: for work that is done once per frame. 0: no frame.
  unsigned long long number() const { return m_number; }

  bool hasMask() const { return m_mask != nullptr; }
  //! True where pixel (u, v) of this frame shows nothing that may be used: the user's mask, given for the image as it
  //! was taken, hides it, or the lens did not see it.
  bool isMasked(double u, double v) const { return (m_mask != nullptr || m_isDistorted) && isHidden(u, v); }

private:
  friend class vpFrameSource;

  bool isHidden(double u, double v) const;

  const vpImage<unsigned char> *m_gray = nullptr;
  const vpImage<vpRGBa> *m_color = nullptr;
  const vpImage<bool> *m_mask = nullptr;
  vpCameraParameters m_camera;
  vpCameraParameters m_distortedCamera;
  bool m_isDistorted = false;
  unsigned long long m_number = 0;
};

END_VISP_NAMESPACE
#endif
