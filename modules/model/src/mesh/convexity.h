// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef convexity_h
#define convexity_h

#include "modelParts.h"

BEGIN_VISP_NAMESPACE
namespace vpMeshDetail {
/*!
  True where what faces the camera is what is seen: no part of the object lies in front of a face's plane.

  The backs of faces count as never seen, so that a box without bottom is convex. Where it would take too long to
  find out, the answer is no, which costs time later but is never wrong.
*/
bool isConvex(const ModelParts &parts);
} // namespace vpMeshDetail
END_VISP_NAMESPACE
#endif
