// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpDistortedPoint_h
#define vpDistortedPoint_h

#include <visp3/core/vpCameraParameters.h>
#include <visp3/core/vpImagePoint.h>
#include <visp3/core/vpMeterPixelConversion.h>
#include <visp3/se3/vpCompatibility.h>

#include <Eigen/Core>

BEGIN_VISP_NAMESPACE

//! Where a pixel of the undistorted frame is in the image as it was taken.
class vpDistortedPoint
{
public:
  static vpImagePoint of(const Eigen::Vector2d &pixel, const vpCameraParameters &cam)
  {
    double u = pixel.x();
    double v = pixel.y();
    if (cam.get_projModel() != vpCameraParameters::perspectiveProjWithoutDistortion) {
      vpMeterPixelConversion::convertPoint(cam, (u - cam.get_u0()) / cam.get_px(), (v - cam.get_v0()) / cam.get_py(), u,
                                           v);
    }
    return vpImagePoint(v, u);
  }
};

END_VISP_NAMESPACE
#endif
