// SPDX-License-Identifier: GPL-2.0-or-later
#include "motion/vpObjectMotion.h"

#include "estimate/vpModelLooks.h"
#include "symmetry/vpTrackerSymmetries.h"

#include <visp3/cues/vpEdgeCue.h>
#include <visp3/se3/vpPoseImageDeviation.h>
#include <visp3/se3/vpExactNumber.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

BEGIN_VISP_NAMESPACE

namespace {
// Squared, in diameters or radians: nothing is known of the object's motion yet.
const double firstSurprise = 0.05 * 0.05;
const double motionRate = 0.2;
// Of the distance from the expected pose, in diameters and radians: no object moves more evenly than that.
const std::array<double, 2> leastDeviation = {{0.02, 0.04}};
// Of the poses that vpJudgedPose::oddsOf() tells of, those beside the expected one were wrong more often than right by
// this power of their squared distance, in deviations.
const double tail = 0.6;
// The pose's deviation is not believed to be below this share of the diameter, and this angle.
const double leastTranslation = 5e-4;
const double leastRotation = 1e-3; // Radians.
const double halfWay = 0.5;        // An object that went on while it was hidden may have slowed down.
// A search for edges reaches as many standard deviations of where a point is expected.
const double reach = 3.;
// Shorter searches miss what the contour's own inaccuracy moves, pixels.
const double leastRange = 6.;
// Of the default range, where the user set none.
const double mostOfRange = 2.;
} // namespace

void vpObjectMotion::forgetImages()
{
  trustedBefore.reset();
  m_surprise.fill(firstSurprise);
  forget();
}

void vpObjectMotion::forget()
{
  kalman.reset();
  inertia.reset();
  m_sinceUpdate = 0.;
}

void vpObjectMotion::predict(const Situation &situation, const vpModelLooks &looks,
                             const vpTrackerSymmetries &symmetries, bool holdsTurns, vpHomogeneousMatrix &cMo)
{
  const vpTrackedModel &model = looks.model();
  time += frameInterval;
  m_sinceUpdate += frameInterval;
  const bool isFound = situation.mustConfirm && !situation.isLost;
  const bool isStale = situation.isSearched && !mayCoast();
  m_isPredicted = predicts && kalman.isStarted() && !isFound && !isStale;
  m_holdsPrediction = m_isPredicted && !situation.mustConfirm;
  if (m_isPredicted) {
    const vpPoseKalmanFilter::Estimate expected = kalman.predict(m_sinceUpdate);
    // Of a turn that nothing shows, the filter would go on with what tilting the axis made it believe.
    cMo = holdsTurns ? symmetries.unturned(expected.cMo, cMo, model) : expected.cMo;
    m_predicted = cMo;
    m_expectedCovariance = expected.covariance;
  }
  if (m_holdsPrediction) {
    inertia.predict(time, model.centre(), model.diameter());
  } else {
    inertia.skip();
  }
  m_expected = cMo;
}

// By the corner of the object's box whose place is known least.
double vpObjectMotion::predictedRange(const vpModelLooks &looks, double set) const
{
  if (!m_isPredicted || !rangeIsPredicted) {
    return 0.;
  }
  const Eigen::Vector3d low = looks.model().boxMin();
  const Eigen::Vector3d high = looks.model().boxMax();
  double largest = 0.;
  for (unsigned int i = 0; i < 8; ++i) {
    const Eigen::Vector3d corner(((i & 1U) ? high : low).x(), ((i & 2U) ? high : low).y(), ((i & 4U) ? high : low).z());
    // The trace bounds the variance in any direction, and needs no eigenvalues.
    const auto inImage = vpPoseImageDeviation::covariance(looks.camera(), m_predicted, m_expectedCovariance, corner);
    largest = std::max(largest, inImage.trace());
  }
  const double usual = vpEdgeCueSettings().range;
  const double longest = vpIsSame(set, usual) ? mostOfRange * usual : set;
  return std::min(std::max(reach * std::sqrt(largest), leastRange), longest);
}

std::array<double, 2> vpObjectMotion::offExpected(const vpHomogeneousMatrix &cMo, const vpTrackedModel &model) const
{
  const Eigen::Isometry3d moved = vpPoseExponential::toEigen(m_expected.inverse() * cMo);
  const Eigen::Vector3d centre = model.centre();
  return {(moved * centre - centre).norm() / model.diameter(), Eigen::AngleAxisd(moved.linear()).angle()};
}

double vpObjectMotion::surpriseAt(const vpHomogeneousMatrix &cMo, const vpTrackedModel &model) const
{
  const std::array<double, 2> off = offExpected(cMo, model);
  double sum = 0.;
  for (std::size_t i = 0; i < off.size(); ++i) {
    sum += off[i] * off[i] / std::max(m_surprise[i], leastDeviation[i] * leastDeviation[i]);
  }
  return sum;
}

double vpObjectMotion::oddsAt(const vpHomogeneousMatrix &cMo, const vpTrackedModel &model) const
{
  return -tail * std::log1p(surpriseAt(cMo, model));
}

void vpObjectMotion::expectJumps()
{
  for (double &surprise : m_surprise) {
    surprise = std::max(surprise, firstSurprise);
  }
}

void vpObjectMotion::learnSurprise(const vpHomogeneousMatrix &cMo, const vpTrackedModel &model)
{
  const std::array<double, 2> off = offExpected(cMo, model);
  for (std::size_t i = 0; i < off.size(); ++i) {
    m_surprise[i] += motionRate * (off[i] * off[i] - m_surprise[i]);
  }
}

void vpObjectMotion::update(const vpHomogeneousMatrix &cMo, vpPoseMatrix6 covariance, double doubt, double diameter)
{
  const double translation = leastTranslation * diameter;
  covariance.diagonal().head<3>().array() += translation * translation;
  covariance.diagonal().tail<3>().array() += leastRotation * leastRotation;
  covariance *= doubt;
  kalman.update(cMo, covariance, m_sinceUpdate);
  m_sinceUpdate = 0.;
}

void vpObjectMotion::updateInertia(const vpHomogeneousMatrix &cMo)
{
  if (kalman.isStarted()) {
    inertia.update({cMo, kalman.velocity(), time, {std::sqrt(m_surprise[0]), std::sqrt(m_surprise[1])}});
  }
}

void vpObjectMotion::trust(const vpHomogeneousMatrix &cMo, const vpPoseTangent &velocity)
{
  trusted = {cMo, velocity, time};
}

vpHomogeneousMatrix vpObjectMotion::movedOn(const Trusted &from, double share, const Eigen::Vector3d &centre) const
{
  const double gone = std::min(time - from.time, kalman.settings().longestGap);
  return vpEvenMotion(from.cMo, from.velocity, centre, share * gone);
}

std::array<vpHomogeneousMatrix, 3> vpObjectMotion::whereaboutsOf(const Trusted &from,
                                                                 const Eigen::Vector3d &centre) const
{
  return {{from.cMo, movedOn(from, 1., centre), movedOn(from, halfWay, centre)}};
}

END_VISP_NAMESPACE
