// SPDX-License-Identifier: GPL-2.0-or-later
#include <visp3/cues/vpFrameSource.h>

#include <visp3/core/vpException.h>
#include <visp3/core/vpImageConvert.h>
#include <visp3/core/vpImageTools.h>

#include <cmath>

BEGIN_VISP_NAMESPACE

vpCueFrame vpFrameSource::prepare(unsigned int width, unsigned int height, const vpCameraParameters &cam,
                                  const vpImage<bool> *mask)
{
  if (width == 0 || height == 0) {
    throw vpException(vpException::dimensionError, "The image is empty (%u x %u): give one with pixels", width, height);
  }
  if (!std::isfinite(cam.get_px()) || !std::isfinite(cam.get_py()) || !(cam.get_px() > 0.) || !(cam.get_py() > 0.) ||
      !std::isfinite(cam.get_u0()) || !std::isfinite(cam.get_v0())) {
    throw vpException(
        vpException::badValue,
        "The camera is singular (px %g, py %g, u0 %g, v0 %g): set its parameters, focal lengths in pixels",
        cam.get_px(), cam.get_py(), cam.get_u0(), cam.get_v0());
  }
  if (mask != nullptr && (mask->getWidth() != width || mask->getHeight() != height)) {
    throw vpException(vpException::dimensionError,
                      "The mask is %u x %u and the image %u x %u: give setMask() one of the image's size",
                      mask->getWidth(), mask->getHeight(), width, height);
  }

  vpCueFrame frame;
  frame.m_mask = mask;
  frame.m_isDistorted = cam.get_projModel() != vpCameraParameters::perspectiveProjWithoutDistortion;
  frame.m_distortedCamera = cam;
  frame.m_camera.initPersProjWithoutDistortion(cam.get_px(), cam.get_py(), cam.get_u0(), cam.get_v0());
  if (frame.m_isDistorted && (m_mapCamera != cam || m_mapU.getRows() != height || m_mapU.getCols() != width)) {
    vpImageTools::initUndistortMap(cam, width, height, m_mapU, m_mapV, m_mapDu, m_mapDv);
    m_mapCamera = cam;
  }
  return frame;
}

vpCueFrame vpFrameSource::frame(const vpImage<unsigned char> &I, const vpCameraParameters &cam,
                                const vpImage<bool> *mask)
{
  vpCueFrame frame = prepare(I.getWidth(), I.getHeight(), cam, mask);
  frame.m_gray = &I;
  if (frame.m_isDistorted) {
    vpImageTools::remap(I, m_mapU, m_mapV, m_mapDu, m_mapDv, m_gray);
    frame.m_gray = &m_gray;
  }
  return frame;
}

vpCueFrame vpFrameSource::frame(const vpImage<vpRGBa> &I, const vpCameraParameters &cam, const vpImage<bool> *mask)
{
  vpCueFrame frame = prepare(I.getWidth(), I.getHeight(), cam, mask);
  frame.m_color = &I;
  if (frame.m_isDistorted) {
    vpImageTools::remap(I, m_mapU, m_mapV, m_mapDu, m_mapDv, m_color);
    frame.m_color = &m_color;
  }
  // The overload that starts no OpenMP threads: waiting for them can take longer than the conversion.
  m_gray.resize(I.getHeight(), I.getWidth());
  vpImageConvert::RGBaToGrey(reinterpret_cast<unsigned char *>(frame.m_color->bitmap), m_gray.bitmap, I.getSize());
  frame.m_gray = &m_gray;
  return frame;
}

END_VISP_NAMESPACE
