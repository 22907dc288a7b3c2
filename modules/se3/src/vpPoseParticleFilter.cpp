// SPDX-License-Identifier: GPL-2.0-or-later
#include <visp3/se3/vpPoseParticleFilter.h>

#include <visp3/se3/vpPoseMean.h>
#include <visp3/se3/vpPoseResampling.h>

#include <visp3/core/vpException.h>

#include <algorithm>
#include <cmath>

BEGIN_VISP_NAMESPACE

namespace {
const double leastNoise = 1e-3; // Of the deviations for noiseTime.

unsigned int toUnsigned(std::size_t count)
{
  return static_cast<unsigned int>(count);
}

Eigen::Isometry3d checkedPose(const vpHomogeneousMatrix &aMb, const char *what)
{
  const Eigen::Isometry3d pose = vpPoseExponential::toEigen(aMb);
  if (!pose.matrix().allFinite()) {
    throw vpException(vpException::badValue, "A pose given to a particle filter %s is not finite: leave it out", what);
  }
  return pose;
}

// A plain copy: ViSP's assignment may allocate.
void assign(vpHomogeneousMatrix &to, const vpHomogeneousMatrix &from)
{
  std::copy(from.data, from.data + 16, to.data);
}

// Products of rotations leave SO(3) by a rounding error each: a particle may live for hours.
void assign(vpHomogeneousMatrix &to, const Eigen::Isometry3d &from)
{
  Eigen::Map<Eigen::Matrix<double, 4, 4, Eigen::RowMajor>> matrix(to.data);
  matrix = from.matrix();
  matrix.topLeftCorner<3, 3>() = Eigen::Quaterniond(from.linear()).normalized().toRotationMatrix();
}

void checkCount(const char *function, std::size_t given, std::size_t wanted)
{
  if (given != wanted) {
    throw vpException(vpException::badValue, "vpPoseParticleFilter::%s got %u likelihoods for %u particles", function,
                      toUnsigned(given), toUnsigned(wanted));
  }
}
} // namespace

vpPoseParticleFilter::vpPoseParticleFilter(const vpPoseParticleSettings &settings)
    : m_settings((settings.check(), settings)), m_noise(noiseOf(settings.noiseTime, 1.)), m_jumpNoise(m_noise),
      m_prior(m_noise), m_jumps(m_noise), m_proposals(m_noise)
{
}

void vpPoseParticleFilter::setSettings(const vpPoseParticleSettings &settings)
{
  settings.check();
  m_settings = settings;
}

void vpPoseParticleFilter::requireStarted(const char *function) const
{
  if (!isStarted()) {
    throw vpException(vpException::notInitialized, "vpPoseParticleFilter::%s needs particles: call start() first",
                      function);
  }
}

vpPoseNoise vpPoseParticleFilter::noiseOf(double dt, double factor) const
{
  const double scale = factor * std::max(std::pow(dt / m_settings.noiseTime, m_settings.noiseGrowth), leastNoise);
  return vpPoseNoise::isotropic(scale * m_settings.translationNoise, scale * m_settings.rotationNoise,
                                m_settings.noiseFrame);
}

void vpPoseParticleFilter::reserve(std::size_t count)
{
  if (m_poses.size() < count) {
    m_poses.resize(count);
    m_spare.resize(count);
  }
}

void vpPoseParticleFilter::scatter(std::size_t i, const Eigen::Isometry3d &cMo, const vpPoseNoise &noise)
{
  vpPoseRandom random(m_settings.seed, {m_step, i});
  assign(m_poses[i], noise.draw(cMo, random));
}

void vpPoseParticleFilter::equaliseWeights()
{
  m_weights.assign(m_size, 1. / static_cast<double>(m_size));
}

void vpPoseParticleFilter::start(const vpHomogeneousMatrix &cMo, const vpPoseNoise &noise)
{
  start({cMo}, {1.}, noise);
}

void vpPoseParticleFilter::start(const std::vector<vpHomogeneousMatrix> &poses, const std::vector<double> &weights,
                                 const vpPoseNoise &noise)
{
  if (poses.empty() || poses.size() != weights.size()) {
    throw vpException(vpException::badValue,
                      "A particle filter starts from poses with a weight each, but got %u poses and %u weights",
                      toUnsigned(poses.size()), toUnsigned(weights.size()));
  }
  for (const vpHomogeneousMatrix &cMo : poses) {
    checkedPose(cMo, "to start from");
  }
  m_step++;
  const std::size_t number = m_settings.number;
  vpPoseResampling::systematic(weights, number, vpPoseRandom(m_settings.seed, {m_step, number}).uniform(), m_picks);
  reserve(number);
  m_size = m_predicted = number;
  for (std::size_t i = 0; i < number; i++) {
    scatter(i, vpPoseExponential::toEigen(poses[m_picks[i]]), noise);
  }
  equaliseWeights();
  m_priorWeights = m_weights;
  m_isWeighed = m_isProposed = false;
}

void vpPoseParticleFilter::predict(double dt)
{
  predict(dt, Eigen::Isometry3d::Identity());
}

void vpPoseParticleFilter::predict(double dt, const vpHomogeneousMatrix &oMp)
{
  predict(dt, checkedPose(oMp, "as motion"));
}

void vpPoseParticleFilter::predict(double dt, const Eigen::Isometry3d &oMp)
{
  requireStarted("predict()");
  if (!(dt >= 0.) || !std::isfinite(dt)) {
    throw vpException(vpException::badValue,
                      "The time step of a particle filter is %g s: give the seconds since the last one, >= 0", dt);
  }
  if (m_isProposed) {
    throw vpException(vpException::fatalError,
                      "vpPoseParticleFilter::predict() after propose() needs resample() in between");
  }
  m_step++;
  m_noise = noiseOf(dt, 1.);
  m_jumpNoise = noiseOf(dt, m_settings.jumpFactor);
  clearPrior();
  const bool mayJump = m_settings.jumpShare > 0.;
  for (std::size_t i = 0; i < m_size; i++) {
    const Eigen::Isometry3d moved = vpPoseExponential::toEigen(m_poses[i]) * oMp;
    if (m_settings.prior == vpPoseParticleSettings::Prior::PREDICTION) {
      addPrior(moved, m_weights[i]);
    }
    // Of a stream of its own, so that jumps do not change the noise of the others.
    const bool jumps = mayJump && vpPoseRandom(m_settings.seed, {m_step, i, 1}).uniform() < m_settings.jumpShare;
    scatter(i, moved, jumps ? m_jumpNoise : m_noise);
  }
  m_priorWeights = m_weights;
  m_isWeighed = false;
}

double vpPoseParticleFilter::weigh(const std::vector<double> &logLikelihoods)
{
  requireStarted("weigh()");
  checkCount("weigh()", logLikelihoods.size(), m_predicted);
  if (m_isProposed) {
    throw vpException(vpException::fatalError, "vpPoseParticleFilter::weigh() has to come before propose()");
  }
  m_logLikelihoods = logLikelihoods;
  m_logWeights.resize(m_size);
  for (std::size_t i = 0; i < m_size; i++) {
    m_logWeights[i] = std::log(m_priorWeights[i]) + logLikelihoods[i];
  }
  m_isWeighed = true;
  const double logMean = vpPoseResampling::normalise(m_logWeights, m_weights);
  if (!std::isfinite(logMean)) {
    m_weights = m_priorWeights;
  }
  return logMean;
}

void vpPoseParticleFilter::propose(const std::vector<vpHomogeneousMatrix> &optimised)
{
  if (!m_isWeighed || m_isProposed) {
    throw vpException(vpException::fatalError,
                      "vpPoseParticleFilter::propose() may come once a frame, after predict() and weigh()");
  }
  for (const vpHomogeneousMatrix &cMo : optimised) {
    checkedPose(cMo, "as proposal");
  }
  m_isProposed = true;
  reserve(m_predicted + optimised.size());
  m_size = m_predicted + optimised.size();
  m_weights.resize(m_size, 0.);
  const double spread = m_settings.proposalSpread;
  m_proposals.clear(vpPoseNoise(spread * spread * m_noise.covariance(), m_noise.frame()));
  for (std::size_t i = 0; i < optimised.size(); i++) {
    m_proposals.add(optimised[i]);
    if (m_settings.scatterProposals) {
      scatter(m_predicted + i, vpPoseExponential::toEigen(optimised[i]), m_proposals.kernel());
    } else {
      assign(m_poses[m_predicted + i], optimised[i]);
    }
  }
}

void vpPoseParticleFilter::makeMixtures()
{
  if (m_settings.prior == vpPoseParticleSettings::Prior::PARTICLES) {
    clearPrior();
    for (std::size_t i = 0; i < m_predicted; i++) {
      addPrior(vpPoseExponential::toEigen(m_poses[i]), m_priorWeights[i]);
    }
  }
  m_prior.prepare();
  m_jumps.prepare();
  m_proposals.prepare();
  m_effort = vpPoseMixture::Effort();
}

void vpPoseParticleFilter::clearPrior()
{
  m_prior.clear(m_noise);
  m_jumps.clear(m_jumpNoise);
}

void vpPoseParticleFilter::addPrior(const Eigen::Isometry3d &mean, double weight)
{
  m_prior.add(mean, weight);
  if (m_settings.jumpShare > 0.) {
    m_jumps.add(mean, weight);
  }
}

// log f
double vpPoseParticleFilter::logPrior(const vpHomogeneousMatrix &cMo)
{
  const double plain = m_prior.logDensity(cMo, &m_effort);
  const double share = m_settings.jumpShare;
  if (!(share > 0.)) {
    return plain;
  }
  const double a = std::log(1. - share) + plain;
  const double b = std::log(share) + m_jumps.logDensity(cMo, &m_effort);
  const double larger = std::max(a, b);
  return std::isfinite(larger) ? larger + std::log1p(std::exp(std::min(a, b) - larger)) : larger;
}

// log(f / g) with g = share f + (1 - share) proposals, from the densities' ratio alone.
double vpPoseParticleFilter::logCorrection(std::size_t i)
{
  const double share = static_cast<double>(m_predicted) / static_cast<double>(m_size);
  const double ratio = m_proposals.logDensity(m_poses[i], &m_effort) - logPrior(m_poses[i]);
  return ratio > 0. ? -ratio - std::log(1. - share + share * std::exp(-ratio))
                    : -std::log(share + (1. - share) * std::exp(ratio));
}

double vpPoseParticleFilter::weighProposals(const std::vector<double> &logLikelihoods)
{
  requireStarted("weighProposals()");
  if (!m_isProposed) {
    throw vpException(vpException::fatalError, "vpPoseParticleFilter::weighProposals() needs propose() first");
  }
  checkCount("weighProposals()", logLikelihoods.size(), m_size - m_predicted);
  const bool isCorrected = m_settings.correctProposals && m_size > m_predicted;
  if (isCorrected) {
    makeMixtures();
  }
  m_logLikelihoods.resize(m_predicted);
  m_logLikelihoods.insert(m_logLikelihoods.end(), logLikelihoods.begin(), logLikelihoods.end());
  m_logWeights.resize(m_size);
  const double each = 1. / static_cast<double>(m_size);
  const double share = static_cast<double>(m_predicted) * each;
  for (std::size_t i = 0; i < m_size; i++) {
    const double drawn = i < m_predicted ? share * m_priorWeights[i] : each;
    m_logWeights[i] = std::log(drawn) + m_logLikelihoods[i] + (isCorrected ? logCorrection(i) : 0.);
  }
  const double logMean = vpPoseResampling::normalise(m_logWeights, m_weights);
  if (!std::isfinite(logMean)) {
    std::copy(m_priorWeights.begin(), m_priorWeights.end(), m_weights.begin());
    std::fill(m_weights.begin() + static_cast<std::ptrdiff_t>(m_predicted), m_weights.end(), 0.);
  }
  return logMean;
}

void vpPoseParticleFilter::resample()
{
  requireStarted("resample()");
  m_step++;
  const std::size_t number = m_settings.number;
  const double shift = vpPoseRandom(m_settings.seed, {m_step, 0}).uniform();
  vpPoseResampling::systematic(m_weights, number, shift, m_picks);
  reserve(number);
  for (std::size_t i = 0; i < number; i++) {
    assign(m_spare[i], m_poses[m_picks[i]]);
  }
  m_poses.swap(m_spare);
  m_size = m_predicted = number;
  equaliseWeights();
  m_priorWeights = m_weights;
  m_isWeighed = m_isProposed = false;
}

void vpPoseParticleFilter::setNumber(std::size_t number)
{
  vpPoseParticleSettings settings = m_settings;
  settings.number = number;
  setSettings(settings);
  if (isStarted() && m_size != number) {
    resample();
  }
}

double vpPoseParticleFilter::effectiveSize() const
{
  return vpPoseResampling::effectiveSize(m_weights);
}

vpHomogeneousMatrix vpPoseParticleFilter::mean() const
{
  requireStarted("mean()");
  return vpPoseMean::weighted(m_poses.data(), m_weights.data(), m_size);
}

vpPoseMatrix6 vpPoseParticleFilter::covariance() const
{
  return vpPoseModes::covariance(mean(), m_poses.data(), m_weights.data(), m_size);
}

std::vector<vpPoseMode> vpPoseParticleFilter::modes(vpPoseModes &finder, double leastMass) const
{
  requireStarted("modes()");
  return finder.find(m_poses.data(), m_weights.data(), m_size, leastMass);
}

END_VISP_NAMESPACE
