// SPDX-License-Identifier: GPL-2.0-or-later
#include <visp3/se3/vpPoseKalmanFilter.h>

#include <visp3/core/vpException.h>

#include <Eigen/Cholesky>

#include <cmath>

BEGIN_VISP_NAMESPACE

namespace {
using Matrix12 = Eigen::Matrix<double, 12, 12>;

// Relative to the deviations of the coordinates, because metres and radians may differ by orders of magnitude.
const double symmetryTolerance = 1e-6;
const double smallestConditionalDeviation = 1e-9;

void require(bool ok, const char *member, double value)
{
  if (!ok) {
    throw vpException(vpException::badValue, "vpPoseKalmanSettings::%s is %g, it must be finite and above 0", member,
                      value);
  }
}

void checkTime(double dt)
{
  if (!(dt >= 0.) || !std::isfinite(dt)) {
    throw vpException(vpException::badValue,
                      "The time step of a pose filter is %g s: give the seconds since the last update, >= 0", dt);
  }
}

void checkPose(const vpHomogeneousMatrix &cMo)
{
  for (unsigned int i = 0; i < 3; i++) {
    for (unsigned int j = 0; j < 4; j++) {
      if (!std::isfinite(cMo[i][j])) {
        throw vpException(vpException::badValue, "Element (%u, %u) of the pose given to a pose filter is %g", i, j,
                          cMo[i][j]);
      }
    }
  }
  if (!cMo.isAnHomogeneousMatrix(1e-5)) {
    const double determinant = vpPoseExponential::toEigen(cMo).linear().determinant();
    throw vpException(vpException::badValue,
                      "The pose given to a pose filter has no rotation (determinant %g): orthonormalise it",
                      determinant);
  }
}

void checkCovariance(const vpPoseMatrix6 &covariance)
{
  for (int i = 0; i < 6; i++) {
    for (int j = 0; j < 6; j++) {
      const double value = covariance(i, j);
      const bool isVariance = i == j;
      if (!std::isfinite(value) || (isVariance && !(value > 0.))) {
        throw vpException(vpException::badValue, "Element (%d, %d) of the covariance given to a pose filter is %g%s", i,
                          j, value, isVariance ? ": a variance has to be finite and above 0" : "");
      }
    }
  }
  const vpPoseTangent scale = covariance.diagonal().cwiseSqrt().cwiseInverse();
  const vpPoseMatrix6 correlation = scale.asDiagonal() * covariance * scale.asDiagonal();
  const double asymmetry = (correlation - correlation.transpose()).cwiseAbs().maxCoeff();
  if (asymmetry > symmetryTolerance) {
    throw vpException(vpException::badValue,
                      "The covariance given to a pose filter is not symmetric: two of its correlations differ by %g",
                      asymmetry);
  }
  const Eigen::LDLT<vpPoseMatrix6> factors(correlation);
  const double least = factors.vectorD().minCoeff();
  if (factors.info() != Eigen::Success || !(least > smallestConditionalDeviation * smallestConditionalDeviation)) {
    throw vpException(vpException::badValue,
                      "The covariance given to a pose filter is not positive definite (%g in the factors of its "
                      "correlations): give a variance to what was not observed",
                      least);
  }
}

// [xi]: the commutator of se(3), with exp([xi]) = adjoint(exp(xi)).
vpPoseMatrix6 commutator(const vpPoseTangent &xi)
{
  const auto cross = [](const Eigen::Vector3d &w) {
    Eigen::Matrix3d m;
    m << 0., -w.z(), w.y(), w.z(), 0., -w.x(), -w.y(), w.x(), 0.;
    return m;
  };
  vpPoseMatrix6 m = vpPoseMatrix6::Zero();
  m.topLeftCorner<3, 3>() = m.bottomRightCorner<3, 3>() = cross(xi.tail<3>());
  m.topRightCorner<3, 3>() = cross(xi.head<3>());
  return m;
}

// How exp(xi + d) = exp(xi) exp(J d) for small d: sum of (-[xi])^n / (n + 1)!.
vpPoseMatrix6 rightJacobian(const vpPoseTangent &xi)
{
  const vpPoseMatrix6 step = -commutator(xi);
  vpPoseMatrix6 term = vpPoseMatrix6::Identity();
  vpPoseMatrix6 sum = term;
  for (int n = 1; n < 60; n++) {
    term = (term * step / (n + 1.)).eval();
    sum += term;
    if (term.cwiseAbs().maxCoeff() < 1e-17 * sum.cwiseAbs().maxCoeff()) {
      break;
    }
  }
  return sum;
}

vpPoseMatrix6 turned(const vpHomogeneousMatrix &aMb, const vpPoseMatrix6 &covariance)
{
  const vpPoseMatrix6 adjoint = vpPoseExponential::adjoint(aMb);
  const vpPoseMatrix6 result = adjoint * covariance * adjoint.transpose();
  return 0.5 * (result + result.transpose());
}

vpPoseMatrix6 diagonal(double translation, double rotation)
{
  vpPoseTangent variance;
  variance << Eigen::Vector3d::Constant(translation * translation), Eigen::Vector3d::Constant(rotation * rotation);
  return variance.asDiagonal();
}
} // namespace

void vpPoseKalmanSettings::check() const
{
  const auto isPositive = [](double value) { return value > 0. && std::isfinite(value); };
  require(isPositive(translationWander), "translationWander", translationWander);
  require(isPositive(rotationWander), "rotationWander", rotationWander);
  require(isPositive(startTranslation), "startTranslation", startTranslation);
  require(isPositive(startRotation), "startRotation", startRotation);
  require(isPositive(longestGap), "longestGap", longestGap);
}

vpPoseKalmanFilter::vpPoseKalmanFilter(const vpPoseKalmanSettings &settings)
{
  setSettings(settings);
}

void vpPoseKalmanFilter::setSettings(const vpPoseKalmanSettings &settings)
{
  settings.check();
  m_settings = settings;
}

void vpPoseKalmanFilter::requireStarted(const char *function) const
{
  if (!m_isStarted) {
    throw vpException(vpException::notInitialized, "vpPoseKalmanFilter::%s needs a pose: call update() first",
                      function);
  }
}

vpPoseKalmanFilter::State vpPoseKalmanFilter::propagate(double dt) const
{
  const bool isGap = dt > m_settings.longestGap;
  State next;
  next.velocity = isGap ? vpPoseTangent(vpPoseTangent::Zero()) : m_velocity;
  Matrix12 covariance = m_covariance;
  if (isGap) {
    covariance.topRightCorner<6, 6>().setZero();
    covariance.bottomLeftCorner<6, 6>().setZero();
    covariance.bottomRightCorner<6, 6>() = diagonal(m_settings.startTranslation, m_settings.startRotation);
  }
  const vpPoseTangent step = next.velocity * dt;
  const vpHomogeneousMatrix moved = vpPoseExponential::exp(step);
  next.cMo = m_cMo * moved;
  // The pose's error seen from the moved frame, and what the velocity's error adds to it.
  Matrix12 F = Matrix12::Identity();
  F.topLeftCorner<6, 6>() = vpPoseExponential::adjoint(moved.inverse());
  F.topRightCorner<6, 6>() = rightJacobian(step) * dt;
  // White acceleration, integrated once and twice over dt.
  const vpPoseMatrix6 wander = diagonal(m_settings.translationWander, m_settings.rotationWander);
  Matrix12 Q;
  Q << wander * (dt * dt * dt / 3.), wander * (dt * dt / 2.), wander * (dt * dt / 2.), wander * dt;
  next.covariance = F * covariance * F.transpose() + Q;
  return next;
}

vpPoseKalmanFilter::Estimate vpPoseKalmanFilter::predict(double dt) const
{
  requireStarted("predict()");
  checkTime(dt);
  const State next = propagate(dt);
  Estimate estimate;
  estimate.cMo = next.cMo;
  estimate.covariance = turned(next.cMo, next.covariance.topLeftCorner<6, 6>());
  return estimate;
}

void vpPoseKalmanFilter::start(const vpHomogeneousMatrix &cMo, const vpPoseMatrix6 &covariance)
{
  m_isStarted = true;
  m_cMo = cMo;
  m_velocity.setZero();
  m_innovation.setZero();
  m_covariance.setZero();
  m_covariance.topLeftCorner<6, 6>() = covariance;
  m_covariance.bottomRightCorner<6, 6>() = diagonal(m_settings.startTranslation, m_settings.startRotation);
}

void vpPoseKalmanFilter::update(const vpHomogeneousMatrix &cMo, const vpPoseMatrix6 &covariance, double dt)
{
  checkPose(cMo);
  checkCovariance(covariance);
  if (m_isStarted) {
    checkTime(dt);
  }
  m_observed = cMo;
  const vpPoseMatrix6 R = turned(cMo.inverse(), covariance);
  if (!m_isStarted || dt > m_settings.longestGap) {
    start(cMo, R);
    return;
  }
  const State prior = propagate(dt);
  const vpPoseTangent innovation = vpPoseExponential::log(prior.cMo.inverse() * cMo);
  const Eigen::LLT<vpPoseMatrix6> S(prior.covariance.topLeftCorner<6, 6>() + R);
  m_innovation = S.matrixL().solve(innovation);
  const Eigen::Matrix<double, 12, 6> gain = S.solve(prior.covariance.topRows<6>()).transpose(); // [P14] eq. 21
  const Eigen::Matrix<double, 12, 1> correction = gain * innovation;
  m_cMo = prior.cMo * vpPoseExponential::exp(correction.head<6>()); // [P14] eq. 24
  m_velocity = prior.velocity + correction.tail<6>();               // [P14] eq. 22
  // [P14] eq. 23 in Joseph's form, which stays symmetric and positive definite.
  Matrix12 kept = Matrix12::Identity();
  kept.leftCols<6>() -= gain;
  m_covariance = kept * prior.covariance * kept.transpose() + gain * R * gain.transpose();
}

const vpHomogeneousMatrix &vpPoseKalmanFilter::pose() const
{
  requireStarted("pose()");
  return m_settings.smooth ? m_cMo : m_observed;
}

vpPoseKalmanFilter::Estimate vpPoseKalmanFilter::filtered() const
{
  requireStarted("filtered()");
  Estimate estimate;
  estimate.cMo = m_cMo;
  estimate.covariance = turned(m_cMo, m_covariance.topLeftCorner<6, 6>());
  return estimate;
}

vpPoseTangent vpPoseKalmanFilter::velocityInCamera() const
{
  return vpPoseExponential::adjoint(m_cMo) * m_velocity;
}

END_VISP_NAMESPACE
