// SPDX-License-Identifier: GPL-2.0-or-later
#include "starts/vpWhereabouts.h"

#include "judge/vpRecallPlan.h"
#include "motion/vpTurnBetween.h"

#include <algorithm>
#include <cmath>

BEGIN_VISP_NAMESPACE

namespace {
// An object that was hidden for some time goes on as it moved: at the end of 197 hidden times of rendered sequences it
// was turned by 20 degrees from the nearest of the expected poses (median), by less than 57 in 95 % of them. So much,
// of half a turn, for a turn farther than that (radians), and the time after which half of it is left (seconds).
const double unlikelyTurn = 2.;
const double likelyTurn = 1.;
const double likelyGap = 3.;
const double mostShift = 1.5; // Of two diameters; beyond it, shifts are equally unlikely.

// Of half a turn. \param unlikely What a turn counts beside that which is far beyond the likely ones.
double changeOfTurn(double angle, double unlikely)
{
  const double share = angle / likelyTurn;
  return angle / M_PI + unlikely * (1. - std::exp(-share * share));
}
} // namespace

std::vector<vpHomogeneousMatrix> vpWhereabouts::poses() const
{
  const Eigen::Vector3d centre = m_looks.model().centre();
  std::vector<vpHomogeneousMatrix> poses;
  if (m_proof.hasFailed()) { // The last pose was mistaken for one that looks much alike.
    poses = m_halfTurns.turned(m_motion.trusted.cMo);
  } else {
    const std::array<vpHomogeneousMatrix, 3> last = m_motion.whereaboutsOf(m_motion.trusted, centre);
    poses.assign(last.begin(), last.end());
  }
  if (m_motion.trustedBefore) {
    const std::array<vpHomogeneousMatrix, 3> before = m_motion.whereaboutsOf(*m_motion.trustedBefore, centre);
    poses.insert(poses.end(), before.begin(), before.end());
  }
  return poses;
}

// Either of them in two searches on end, one by colours and one by edges. Of an object that was lost at once the last
// one is right, most likely.
const vpObjectMotion::Trusted &vpWhereabouts::searchOrigin() const
{
  const unsigned int frames = m_situation.framesSinceLoss;
  const bool isDoubtful = m_motion.trustedBefore && (!m_situation.wasSudden || vpRecallPlan::isLong(frames));
  return isDoubtful && (frames - 1) / 2 % 2 == 1 ? *m_motion.trustedBefore : m_motion.trusted;
}

std::array<vpHomogeneousMatrix, 3> vpWhereabouts::fromOrigin() const
{
  return m_motion.whereaboutsOf(searchOrigin(), m_looks.model().centre());
}

// Of half a turn, and of two diameters; from where the object was, may have moved to, or was detected, whichever is
// nearest.
double vpWhereabouts::changeSince(const vpHomogeneousMatrix &cMo) const
{
  const Eigen::Isometry3d now = vpPoseExponential::toEigen(cMo);
  const Eigen::Vector3d centre = m_looks.model().centre();
  const double gap = (m_motion.time - m_motion.trusted.time) / likelyGap;
  const double unlikely = unlikelyTurn / (1. + gap * gap);
  const auto changeFrom = [&](const vpHomogeneousMatrix &pose) {
    const Eigen::Isometry3d before = vpPoseExponential::toEigen(pose);
    const double shift = (now * centre - before * centre).norm() / (2. * m_looks.model().diameter());
    return changeOfTurn(vpTurnBetween(pose, cMo), unlikely) + std::min(shift, mostShift);
  };
  double least = HUGE_VAL;
  for (const vpHomogeneousMatrix &pose : poses()) {
    least = std::min(least, changeFrom(pose));
  }
  for (const vpWeightedPose &pose : m_rough.detected) {
    least = std::min(least, changeFrom(pose.cMo));
  }
  return least;
}

// Logarithm of the factor between the distances now and when it was trusted, or where it was told to be, 1 at most: a
// pose far behind what the image shows fits into it, and drifts away.
double vpWhereabouts::depthChange(const vpHomogeneousMatrix &cMo) const
{
  const double now = m_looks.depthOf(cMo);
  const auto changeFrom = [now](double before) {
    return now > 0. && before > 0. ? std::min(std::fabs(std::log(now / before)), 1.) : 1.;
  };
  double least = changeFrom(m_looks.depthOf(m_motion.trusted.cMo));
  if (m_motion.trustedBefore) {
    least = std::min(least, changeFrom(m_looks.depthOf(m_motion.trustedBefore->cMo)));
  }
  for (const double depth : m_rough.depths) {
    least = std::min(least, changeFrom(depth));
  }
  return least;
}

END_VISP_NAMESPACE
