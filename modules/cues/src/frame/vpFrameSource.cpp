// SPDX-License-Identifier: GPL-2.0-or-later
#include <visp3/cues/vpFrameSource.h>

#include <visp3/core/vpException.h>
#include <visp3/core/vpImageConvert.h>
#include <visp3/core/vpImageTools.h>
#include <visp3/se3/vpExactNumber.h>

#include <algorithm>
#include <atomic>
#include <cmath>

BEGIN_VISP_NAMESPACE

namespace {
std::atomic<unsigned long long> framesMade{0};

bool isDistorted(const vpCameraParameters &cam)
{
  switch (cam.get_projModel()) {
  case vpCameraParameters::perspectiveProjWithoutDistortion:
    return false;
  case vpCameraParameters::perspectiveProjWithDistortion:
    return !vpIsZero(cam.get_kud()); // Often stored with a model that has distortion, but none of it.
  default:
    return true;
  }
}

void checkCamera(const vpCameraParameters &cam)
{
  if (!std::isfinite(cam.get_px()) || !std::isfinite(cam.get_py()) || !(cam.get_px() > 0.) || !(cam.get_py() > 0.) ||
      !std::isfinite(cam.get_u0()) || !std::isfinite(cam.get_v0())) {
    throw vpException(
        vpException::badValue,
        "The camera is singular (px %g, py %g, u0 %g, v0 %g): set its parameters, focal lengths in pixels",
        cam.get_px(), cam.get_py(), cam.get_u0(), cam.get_v0());
  }
  if (!std::isfinite(cam.get_kud())) {
    throw vpException(vpException::badValue, "The camera's distortion kud is %g: set it, 0 for none", cam.get_kud());
  }
  if (cam.get_projModel() == vpCameraParameters::ProjWithKannalaBrandtDistortion &&
      cam.getKannalaBrandtDistortionCoefficients().size() != 4) {
    throw vpException(vpException::badValue, "The camera has %zu Kannala-Brandt coefficients: give it four",
                      cam.getKannalaBrandtDistortionCoefficients().size());
  }
}

// Where the lens saw nothing, the map goes on with the image's border: ViSP's remap() would make it black, and that
// edge would be found.
void clampMap(vpArray2D<int> &map, vpArray2D<float> &remainder, int size)
{
  for (unsigned int k = 0; k < map.size(); ++k) {
    const int place = map.data[k];
    if (place < 0 || place > size - 2 || remainder.data[k] < 0.F) {
      map.data[k] = std::max(std::min(place, size - 2), 0);
      remainder.data[k] = 0.F;
    }
  }
}
} // namespace

vpCueFrame vpFrameSource::prepare(unsigned int width, unsigned int height, const vpCameraParameters &cam,
                                  const vpImage<bool> *mask)
{
  if (width == 0 || height == 0) {
    throw vpException(vpException::dimensionError, "The image is empty (%u x %u): give one with pixels", width, height);
  }
  checkCamera(cam);
  if (mask != nullptr && (mask->getWidth() != width || mask->getHeight() != height)) {
    throw vpException(vpException::dimensionError,
                      "The mask is %u x %u and the image %u x %u: give setMask() one of the image's size",
                      mask->getWidth(), mask->getHeight(), width, height);
  }

  vpCueFrame frame;
  frame.m_number = ++framesMade;
  frame.m_mask = mask;
  frame.m_isDistorted = isDistorted(cam);
  frame.m_distortedCamera = cam;
  frame.m_camera.initPersProjWithoutDistortion(cam.get_px(), cam.get_py(), cam.get_u0(), cam.get_v0());
  if (frame.m_isDistorted && (m_mapCamera != cam || m_mapU.getRows() != height || m_mapU.getCols() != width)) {
    vpImageTools::initUndistortMap(cam, width, height, m_mapU, m_mapV, m_mapDu, m_mapDv);
    clampMap(m_mapU, m_mapDu, static_cast<int>(width));
    clampMap(m_mapV, m_mapDv, static_cast<int>(height));
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
