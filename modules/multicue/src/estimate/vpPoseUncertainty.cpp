// SPDX-License-Identifier: GPL-2.0-or-later
#include "estimate/vpPoseUncertainty.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>

BEGIN_VISP_NAMESPACE

namespace {
// Of errors, as a share of the cue's own idea of its noise: images without noise do not make a pose exact.
const double leastDeviation = 0.1;
// Fewer rows than this beyond those that the fit used up tell no variance.
const double leastFreeRows = 1.;
// Rows further apart are not taken to be wrong together.
const std::size_t farthestRows = 30;

// The estimation multiplies errors by Tukey's weight w twice: this is the derivative of w(e)^2 e, a function of w.
double influenceSlope(double w)
{
  return w * w - 8. * (1. - std::sqrt(w)) * w * std::sqrt(w);
}

// How far two samples of white noise seem correlated, with a probability of one sixth.
double correlationNoise(std::size_t rows)
{
  return 1. / std::sqrt(static_cast<double>(std::max<std::size_t>(rows, 1)));
}
} // namespace

void vpPoseUncertainty::weigh(const vpCueFusion::Part &part, Share &share) const
{
  share = Share();
  double slopes = 0.;
  double squares = 0.;
  for (std::size_t i = 0; i < part.weights.size(); ++i) {
    const vpResidual &row = part.block.rows[i];
    const double w = part.weights[i];
    const double factor = w * row.weight / part.scale;
    share.weighed.noalias() += (factor * factor) * row.jacobian * row.jacobian.transpose();
    slopes += row.weight > 0. ? influenceSlope(w) : 0.;
    squares += row.weight > 0. ? w * w : 0.;
  }
  // A robust estimator gives way less to errors than its weights say; the spread is taken out of the same sum.
  share.spread = share.weighed;
  share.weighed *= squares > 0. ? std::max(slopes / squares, 0.1) : 0.;
}

// How many rows count as one.
double vpPoseUncertainty::correlatedRows()
{
  const std::size_t rows = m_pulls.size();
  double own = 0.;
  for (const double pull : m_pulls) {
    own += pull * pull;
  }
  double count = 1.;
  for (std::size_t apart = 1; own > 0. && apart < std::min(rows / 2, farthestRows); ++apart) {
    double sum = 0.;
    for (std::size_t i = 0; i + apart < rows; ++i) {
      sum += m_pulls[i] * m_pulls[i + apart];
    }
    if (sum / own < correlationNoise(rows)) {
      break;
    }
    count += 2. * sum / own;
  }
  return count;
}

void vpPoseUncertainty::spread(const vpCueFusion::Part &part, double fitted, Share &share)
{
  m_pulls.clear();
  vpPoseTangent shift = vpPoseTangent::Zero();
  vpPoseMatrix6 own = vpPoseMatrix6::Zero();
  double squares = 0.;
  for (std::size_t i = 0; i < part.weights.size(); ++i) {
    const vpResidual &row = part.block.rows[i];
    const double w = part.weights[i] * row.weight;
    const double pull = w * w * row.error / part.scale;
    m_pulls.push_back(pull);
    own.noalias() += (pull * pull / (part.scale * part.scale)) * row.jacobian * row.jacobian.transpose();
    shift += (w * w / (part.scale * part.scale)) * part.block.bias * row.jacobian;
    squares += w * w;
  }
  if (!(squares > 0.)) {
    return;
  }
  const double together = correlatedRows();
  const double freeRows = std::max(squares / together - fitted, leastFreeRows) * together;
  const double least = leastDeviation * part.block.noise / part.scale;
  // Of what is seen better the errors are smaller: each row counts with its own, but none is taken for exact.
  share.spread *= together * least * least;
  share.spread += together * (squares / freeRows) * own;
  share.spread.noalias() += shift * shift.transpose();
}

void vpPoseUncertainty::update(const vpCueFusion &fusion, const vpPoseMatrix6 &prior)
{
  m_prior = prior;
  m_count = std::min(fusion.size(), m_shares.size());
  vpPoseMatrix6 all = prior;
  for (std::size_t i = 0; i < m_count; ++i) {
    weigh(fusion[i], m_shares[i]);
    all += m_shares[i].weighed;
  }
  const vpPoseMatrix6 inverse = all.inverse();
  for (std::size_t i = 0; i < m_count; ++i) {
    spread(fusion[i], (inverse * m_shares[i].weighed).trace(), m_shares[i]);
  }
}

void vpPoseUncertainty::setFrame(const vpHomogeneousMatrix &cMo, const std::array<bool, 6> &fixed)
{
  m_cVo = vpPoseExponential::adjoint(cMo);
  m_fixed = fixed;
}

// In the object's frame, where some motions may be fixed.
vpPoseMatrix6 vpPoseUncertainty::invert(const vpPoseMatrix6 &weighed, const vpPoseMatrix6 &spread) const
{
  using Basis = Eigen::Matrix<double, 6, Eigen::Dynamic, 0, 6, 6>;
  Basis basis(6, std::count(m_fixed.begin(), m_fixed.end(), false));
  for (int i = 0, k = 0; i < 6; ++i) {
    if (!m_fixed[static_cast<std::size_t>(i)]) {
      basis.col(k++) = m_cVo.col(i);
    }
  }
  using Square = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 6, 6>;
  const Square H = basis.transpose() * (weighed + m_prior) * basis;
  const Square G = basis.transpose() * (spread + m_prior) * basis;
  const Square inverse = H.inverse();
  const vpPoseMatrix6 covariance = basis * (inverse * G * inverse) * basis.transpose();
  return 0.5 * (covariance + covariance.transpose());
}

vpPoseMatrix6 vpPoseUncertainty::covariance() const
{
  Share all;
  for (std::size_t i = 0; i < m_count; ++i) {
    all.weighed += m_shares[i].weighed;
    all.spread += m_shares[i].spread;
  }
  return invert(all.weighed, all.spread);
}

vpPoseMatrix6 vpPoseUncertainty::covariance(std::size_t part) const
{
  return invert(m_shares[part].weighed, m_shares[part].spread);
}

END_VISP_NAMESPACE
