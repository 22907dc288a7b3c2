// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef fuzzGeometry_h
#define fuzzGeometry_h

#include "fuzzBytes.h"

#include <visp3/core/vpCameraParameters.h>
#include <visp3/core/vpHomogeneousMatrix.h>

namespace fuzz {
#ifdef ENABLE_VISP_NAMESPACE
using namespace VISP_NAMESPACE_NAME;
#endif

//! A camera that a program may have, and at times one that it cannot.
inline vpCameraParameters cameraOf(Bytes &bytes)
{
  const double px = bytes.anyNumber(20., 800.);
  const double py = bytes.flag() ? px : bytes.anyNumber(20., 800.);
  vpCameraParameters cam(px, py, bytes.anyNumber(-100., 300.), bytes.anyNumber(-100., 300.));
  if (bytes.choice(4) == 3) {
    cam.initPersProjWithDistortion(px, py, cam.get_u0(), cam.get_v0(), bytes.anyNumber(-2., 2.),
                                   bytes.anyNumber(-2., 2.));
  }
  return cam;
}

//! The same for a pose.
inline vpHomogeneousMatrix poseOf(Bytes &bytes)
{
  vpHomogeneousMatrix cMo(bytes.anyNumber(-0.2, 0.2), bytes.anyNumber(-0.2, 0.2), bytes.anyNumber(0., 1.5),
                          bytes.number(-3., 3.), bytes.number(-3., 3.), bytes.number(-3., 3.));
  if (bytes.choice(32) == 31) {
    cMo[bytes.choice(4)][bytes.choice(4)] = bytes.anyNumber(-2., 2.);
  }
  return cMo;
}

} // namespace fuzz

#endif
