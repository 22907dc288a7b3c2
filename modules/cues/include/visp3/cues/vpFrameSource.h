// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpFrameSource_h
#define vpFrameSource_h

#include <visp3/core/vpArray2D.h>
#include <visp3/cues/vpCueFrame.h>

BEGIN_VISP_NAMESPACE

/*!
  \ingroup group_cues_frame
  Turns the user's images into frames: colours to gray, and the lens's distortion removed once per image. Owns the
  memory for that and uses it again; a frame is good until the next one is made.
*/
class VISP_EXPORT vpFrameSource
{
public:
  /*!
    \param I Image as it was taken.
    \param cam Camera, with or without distortion.
    \param mask True where the image may be used, as vpMbTracker::setMask() has it; null: everywhere.
    \throw vpException where the image is empty, the mask has another size, or the camera is singular or lacks its
    distortion.
  */
  vpCueFrame frame(const vpImage<unsigned char> &I, const vpCameraParameters &cam, const vpImage<bool> *mask);
  //! Likewise in colour. \param I Image as it was taken.
  vpCueFrame frame(const vpImage<vpRGBa> &I, const vpCameraParameters &cam, const vpImage<bool> *mask);

private:
  vpCueFrame prepare(unsigned int width, unsigned int height, const vpCameraParameters &cam, const vpImage<bool> *mask);

  // Where each pixel of the undistorted image comes from: whole pixels and remainder.
  vpArray2D<int> m_mapU, m_mapV;
  vpArray2D<float> m_mapDu, m_mapDv;
  vpCameraParameters m_mapCamera;
  vpImage<unsigned char> m_gray;
  vpImage<vpRGBa> m_color;
};

END_VISP_NAMESPACE
#endif
