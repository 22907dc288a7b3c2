// SPDX-License-Identifier: GPL-2.0-or-later
#include "facade/vpTrackerImpl.h"
#include "motion/vpPoseCheck.h"

#include <visp3/core/vpException.h>

#include <cmath>

// Starts and hints at poses that are not exact.

BEGIN_VISP_NAMESPACE

void vpPoseDeviation::check() const
{
  if (!(translation >= 0.) || !std::isfinite(translation)) {
    throw vpException(vpException::badValue, "The deviation of the translation is %g m: give 0 or more", translation);
  }
  if (!(rotation >= 0. && rotation <= M_PI)) {
    throw vpException(vpException::badValue, "The deviation of the rotation is %g: give 0 to pi, radians", rotation);
  }
}

bool vpMbMultiCueTracker::initFromRoughPose(const vpImage<unsigned char> &I, const vpHomogeneousMatrix &cMo,
                                            const vpPoseDeviation &deviation)
{
  return m_impl->startRoughlyOn(I, {{cMo, 1.}}, deviation);
}

bool vpMbMultiCueTracker::initFromRoughPose(const vpImage<vpRGBa> &I_color, const vpHomogeneousMatrix &cMo,
                                            const vpPoseDeviation &deviation)
{
  return m_impl->startRoughlyOn(I_color, {{cMo, 1.}}, deviation);
}

bool vpMbMultiCueTracker::initFromRoughPoses(const vpImage<unsigned char> &I,
                                             const std::vector<vpWeightedPose> &candidates,
                                             const vpPoseDeviation &deviation)
{
  return m_impl->startRoughlyOn(I, candidates, deviation);
}

bool vpMbMultiCueTracker::initFromRoughPoses(const vpImage<vpRGBa> &I_color,
                                             const std::vector<vpWeightedPose> &candidates,
                                             const vpPoseDeviation &deviation)
{
  return m_impl->startRoughlyOn(I_color, candidates, deviation);
}

template <typename Pixel>
bool vpMbMultiCueTracker::Impl::startRoughlyOn(const vpImage<Pixel> &I, const std::vector<vpWeightedPose> &candidates,
                                               const vpPoseDeviation &deviation)
{
  requireTrackable(I.getWidth(), I.getHeight());
  deviation.check();
  if (candidates.empty()) {
    throw vpException(vpException::badValue, "No poses to start from: give at least one");
  }
  for (const vpWeightedPose &candidate : candidates) {
    requireStart(I.getWidth(), I.getHeight(), m_engine.looks.model(), candidate.cMo);
    if (!(candidate.weight > 0.) || !std::isfinite(candidate.weight)) {
      throw vpException(vpException::badValue, "A candidate's weight is %g, it must be above 0", candidate.weight);
    }
  }
  const vpCueFrame image = source.frame(I, m_tracker.m_cam, m_tracker.m_mask);
  start(vpRoughStart::heaviest(candidates), I.getWidth(), I.getHeight());
  bool isAccepted = false;
  estimate([&](vpHomogeneousMatrix &cMo) { isAccepted = m_engine.startRoughly(image, candidates, deviation, cMo); });
  m_tracker.followFaces(I.getWidth(), I.getHeight());
  return isAccepted;
}

void vpMbMultiCueTracker::setPoseHint(const vpHomogeneousMatrix &cMo, const vpPoseDeviation &deviation)
{
  const vpModelLooks &looks = m_impl->engine().looks;
  looks.requireModel();
  deviation.check();
  vpPoseCheck::requireRigid(cMo);
  if (!(looks.depthOf(cMo) > 0.)) {
    throw vpException(vpException::badValue, "At the hint's pose the object is behind the camera (z = %g m)",
                      cMo[2][3]);
  }
  vpRoughStart &rough = m_impl->engine().rough;
  rough.hint = cMo;
  rough.hintDeviation = deviation;
  rough.hasHint = true;
}

END_VISP_NAMESPACE
