// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpCentreFrame_h
#define vpCentreFrame_h

#include <visp3/core/vpHomogeneousMatrix.h>
#include <visp3/model/vpTrackedModel.h>

BEGIN_VISP_NAMESPACE

//! oMb: the frame b with the object's orientation at the middle of its box.
inline vpHomogeneousMatrix vpCentreFrame(const vpTrackedModel &model)
{
  const Eigen::Vector3d at = model.centre();
  return vpHomogeneousMatrix(vpTranslationVector(at.x(), at.y(), at.z()), vpRotationMatrix());
}

END_VISP_NAMESPACE
#endif
