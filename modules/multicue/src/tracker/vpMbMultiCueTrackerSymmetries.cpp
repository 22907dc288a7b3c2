// SPDX-License-Identifier: GPL-2.0-or-later
#include <visp3/multicue/vpMbMultiCueTracker.h>

#include "hypotheses/vpMotionFrame.h"
#include "tracker/vpTrackerState.h"

#include <algorithm>

BEGIN_VISP_NAMESPACE

void vpMbMultiCueTracker::setSymmetries(const vpModelSymmetries &symmetries)
{
  m_impl->symmetries.set(symmetries, "", 0, m_impl->model.get());
}

const vpModelSymmetries &vpMbMultiCueTracker::getSymmetries() const
{
  return m_impl->symmetries.known();
}

// Motions that pose hypotheses may take: they rest on edges alone, and outlines do not show turns about an axis of the
// shape.
// Those of the user that edges can show.
vpPoseMatrix6 vpMbMultiCueTracker::Impl::freeMotions(const vpMatrix &oJo) const
{
  const vpPoseMatrix6 chosen = vpMotionFrame::toEigen(oJo);
  return !symmetries.hasAxis() || edgesShowTurns() ? chosen : vpPoseMatrix6(symmetries.visibleMotions() * chosen);
}

void vpMbMultiCueTracker::Impl::restrictHypotheses(const vpMatrix &oJo)
{
  const Eigen::Matrix<double, 6, 6, Eigen::RowMajor> both = freeMotions(oJo);
  visibleMotions.resize(6, 6, false, false);
  std::copy(both.data(), both.data() + 36, visibleMotions.data);
  hypotheses.setEstimatedMotions(visibleMotions);
}

vpHomogeneousMatrix vpMbMultiCueTracker::Impl::nearestAlike(const vpHomogeneousMatrix &cMo) const
{
  return symmetries.get() == nullptr ? cMo : symmetries.nearest(cMo, mustConfirm ? trusted.cMo : expectedPose, *model);
}

// How far a rival is from another pose, of those that look like it the nearest one; see vpTrackerParticles::distance().
double vpMbMultiCueTracker::Impl::rivalDistance(const vpHomogeneousMatrix &c1Mb, const vpHomogeneousMatrix &c2Mb) const
{
  if (symmetries.get() == nullptr) {
    return particles.distance(c1Mb, c2Mb, model->diameter());
  }
  const vpHomogeneousMatrix oMb = centreFrame();
  const vpHomogeneousMatrix bMo = oMb.inverse();
  return particles.distance(symmetries.nearest(c1Mb * bMo, c2Mb * bMo, *model) * oMb, c2Mb, model->diameter());
}

END_VISP_NAMESPACE
