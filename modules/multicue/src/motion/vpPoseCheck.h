// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpPoseCheck_h
#define vpPoseCheck_h

#include <visp3/core/vpCameraParameters.h>
#include <visp3/core/vpHomogeneousMatrix.h>
#include <visp3/model/vpTrackedModel.h>

#include <string>

BEGIN_VISP_NAMESPACE

// Whether an object may be at a pose that came from outside.
struct vpPoseCheck
{
  static bool isFinite(const vpHomogeneousMatrix &cMo);
  // Throws vpException where the pose is not finite or no rotation and translation.
  static void requireRigid(const vpHomogeneousMatrix &cMo);
  // Why no camera can have seen the object at a pose that was estimated; empty where one can.
  static std::string whyUnbelievable(const vpTrackedModel &model, const vpHomogeneousMatrix &cMo,
                                     const vpCameraParameters &cam);
  // Throws vpException where the camera sees nothing of the object.
  static void requireInView(const vpTrackedModel &model, const vpHomogeneousMatrix &cMo, const vpCameraParameters &cam,
                            unsigned int width, unsigned int height);
};

END_VISP_NAMESPACE
#endif
