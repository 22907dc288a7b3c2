// SPDX-License-Identifier: GPL-2.0-or-later
#include <visp3/multicue/vpMbMultiCueTracker.h>

#include "tracker/vpTrackerState.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

BEGIN_VISP_NAMESPACE

namespace {
// Half the side of the window around the expected pose, in projected diameters: the object and as much beside it as it
// may jump.
const double nearWindow = 0.85;
const double nearShift = 0.5;     // Diameters.
const double nearTurn = 1.;       // Radians.
const double wellExplained = 0.7; // By all other cues.
// Features that may agree by chance, and so many that no other pose can be right.
const unsigned int fewestAgreeing = 8;
const unsigned int manyAgreeing = 24;
const double mostOfAll = 0.35; // Their weight, as a share of that of all other cues.
} // namespace

// Keeps what a trusted pose shows, for the frames in which nothing near the expected pose fits.
void vpMbMultiCueTracker::learnKeyframe(const vpCueFrame &frame)
{
  Impl &impl = *m_impl;
  if (!impl.searches || !impl.uses(KLT_TRACKER) || impl.surface.texture() < Impl::leastTexture) {
    return;
  }
  // What hides a part of the object is not to be learnt.
  const bool isWhole = !impl.isJudged || impl.share.sum > wellExplained * impl.share.cues;
  if (!isWhole) {
    return;
  }
  const bool isStart = !impl.isJudged || impl.keyframeIsProvisional;
  if (impl.keyframeIsProvisional) {
    impl.keyframes.reset();
    impl.keyframeIsProvisional = false;
  }
  impl.keyframes.confirm(frame, m_cMo);
  if (!impl.keyframes.wants(m_cMo)) {
    return;
  }
  const vpRenderedView &depth = *impl.renderDepth(m_cMo);
  if (isStart) {
    impl.keyframes.learn(frame, m_cMo, depth);
  } else {
    impl.keyframes.propose(frame, m_cMo, depth);
  }
}

vpImageRegion vpMbMultiCueTracker::Impl::regionAround(const vpHomogeneousMatrix &cMo) const
{
  const Eigen::Vector3d at = vpPoseExponential::toEigen(cMo) * model->centre();
  if (!(at.z() > 0.)) {
    return vpImageRegion();
  }
  const double size = nearWindow * model->diameter() * frameCamera.get_px() / at.z();
  const double u = frameCamera.get_u0() + frameCamera.get_px() * at.x() / at.z();
  const double v = frameCamera.get_v0() + frameCamera.get_py() * at.y() / at.z();
  const auto whole = [](double x) { return static_cast<int>(std::lround(std::min(std::max(x, -1e6), 1e6))); };
  return vpImageRegion(whole(u - size), whole(v - size), whole(2. * size), whole(2. * size));
}

// Features that were seen in a trusted view and are seen again are hardly ever so by chance; but they may be those of
// what hides the object.
double vpMbMultiCueTracker::Impl::explainedBy(const Share &cues, const vpHomogeneousMatrix &cMo) const
{
  Share all = cues;
  if (mostAgreeing > fewestAgreeing) {
    const double weight =
        std::min(1., static_cast<double>(mostAgreeing - fewestAgreeing) / (manyAgreeing - fewestAgreeing));
    all.sum +=
        mostOfAll * weight * cues.cues * std::min(1., static_cast<double>(keyframes.agreeing(cMo)) / mostAgreeing);
    all.cues += mostOfAll * weight * cues.cues;
  }
  return all.cues > 0. ? std::min(all.sum / all.cues, cues.most) : 0.;
}

// Starts from what is seen again of the views before. \return True where the pose that it leads to is enough.
bool vpMbMultiCueTracker::tryKeyframes(const vpCueFrame &frame, bool isNear)
{
  Impl &impl = *m_impl;
  if (!impl.searches || !impl.uses(KLT_TRACKER)) {
    return false;
  }
  vpKeyframes::Where where;
  where.expected = impl.expectedPose;
  vpImageRegion region(0, 0, static_cast<int>(frame.width()), static_cast<int>(frame.height()));
  if (isNear) {
    region = impl.regionAround(impl.expectedPose);
    where.shift = nearShift;
    where.turn = nearTurn;
  }
  const std::vector<vpKeyframePose> found = impl.keyframes.find(frame, region, where);
  for (const vpKeyframePose &pose : found) {
    impl.mostAgreeing = std::max(impl.mostAgreeing, pose.agreeing);
  }
  if (impl.best.explained >= 0.) { // The attempts before did not know.
    const double share = impl.explainedBy(impl.best.share, impl.best.cMo);
    impl.best.value += share - impl.best.explained;
    impl.best.explained = share;
  }
  return std::any_of(found.begin(), found.end(),
                     [&](const vpKeyframePose &pose) { return attemptFrom(frame, pose.cMo, false); });
}

END_VISP_NAMESPACE
