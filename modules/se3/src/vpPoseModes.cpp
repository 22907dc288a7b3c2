// SPDX-License-Identifier: GPL-2.0-or-later
#include <visp3/se3/vpPoseModes.h>

#include <visp3/se3/vpPoseMean.h>

#include <visp3/core/vpException.h>

#include <algorithm>
#include <cmath>
#include <numeric>

BEGIN_VISP_NAMESPACE

namespace {
void requireTolerance(const char *name, double value)
{
  if (!(value > 0.) || !std::isfinite(value)) {
    throw vpException(vpException::badValue, "The %s tolerance of pose modes is %g, it must be finite and above 0",
                      name, value);
  }
}
} // namespace

vpPoseModes::vpPoseModes(double translation, double rotation) : m_translation(translation), m_rotation(rotation)
{
  requireTolerance("translation", translation);
  requireTolerance("rotation", rotation);
}

// In units of the tolerances. 8 (1 - cos(theta / 2)) is theta^2 without an arc cosine for each pair.
double vpPoseModes::squaredDistance(std::size_t i, std::size_t j) const
{
  const double squaredAngle = 8. * (1. - std::fabs(m_rotations[i].dot(m_rotations[j])));
  return (m_translations[i] - m_translations[j]).squaredNorm() / (m_translation * m_translation) +
         squaredAngle / (m_rotation * m_rotation);
}

void vpPoseModes::findDensities(const double *weights, std::size_t count)
{
  m_densities.assign(weights, weights + count);
  m_squares.resize(count * count);
  for (std::size_t i = 0; i < count; i++) {
    for (std::size_t j = 0; j < i; j++) {
      const double squared = squaredDistance(i, j);
      m_squares[i * count + j] = m_squares[j * count + i] = squared;
      if (squared < 20.) { // Farther ones add less than 1e-17.
        const double share = std::exp(-2. * squared);
        m_densities[i] += weights[j] * share;
        m_densities[j] += weights[i] * share;
      }
    }
  }
}

void vpPoseModes::climb(const double *weights, std::size_t count)
{
  // A total order, so that poses of equal density cannot climb in circles.
  const auto isDenser = [this](std::size_t i, std::size_t j) {
    return m_densities[i] > m_densities[j] || (!(m_densities[i] < m_densities[j]) && i < j);
  };
  m_peaks.resize(count);
  for (std::size_t i = 0; i < count; i++) {
    m_peaks[i] = i;
    double least = 1.;
    for (std::size_t j = 0; j < count; j++) {
      if (weights[j] > 0. && isDenser(j, i)) {
        const double squared = m_squares[i * count + j];
        if (squared < least) {
          least = squared;
          m_peaks[i] = j;
        }
      }
    }
  }
  for (std::size_t &peak : m_peaks) {
    while (m_peaks[peak] != peak) {
      peak = m_peaks[peak];
    }
  }
}

vpPoseMode vpPoseModes::modeOf(std::size_t peak, const vpHomogeneousMatrix *poses, const double *weights,
                               std::size_t count)
{
  vpPoseMode mode;
  mode.peak = peak;
  m_masked.assign(count, 0.);
  for (std::size_t i = 0; i < count; i++) {
    if (m_peaks[i] == peak && weights[i] > 0.) {
      m_masked[i] = weights[i];
      mode.count++;
    }
  }
  mode.mass = std::accumulate(m_masked.begin(), m_masked.end(), 0.);
  mode.cMo = vpPoseMean::weighted(poses, m_masked.data(), count);
  mode.covariance = covariance(mode.cMo, poses, m_masked.data(), count);
  return mode;
}

std::vector<vpPoseMode> vpPoseModes::find(const vpHomogeneousMatrix *poses, const double *weights, std::size_t count,
                                          double leastMass)
{
  double total = 0.;
  for (std::size_t i = 0; i < count; i++) {
    total += weights[i] >= 0. ? weights[i] : NAN;
  }
  if (!(total > 0.) || !std::isfinite(total)) {
    throw vpException(vpException::badValue,
                      "The weights of poses to find modes of sum up to %g: all have to be finite and >= 0, and one > 0",
                      total);
  }
  m_rotations.resize(count);
  m_translations.resize(count);
  for (std::size_t i = 0; i < count; i++) {
    const Eigen::Isometry3d pose = vpPoseExponential::toEigen(poses[i]);
    m_rotations[i] = Eigen::Quaterniond(pose.linear()).normalized();
    m_translations[i] = pose.translation();
  }
  findDensities(weights, count);
  climb(weights, count);
  std::vector<vpPoseMode> modes;
  for (std::size_t i = 0; i < count; i++) {
    if (m_peaks[i] == i && weights[i] > 0.) {
      modes.push_back(modeOf(i, poses, weights, count));
      modes.back().mass /= total;
    }
  }
  const auto isHeavier = [](const vpPoseMode &a, const vpPoseMode &b) { return a.mass > b.mass; };
  std::stable_sort(modes.begin(), modes.end(), isHeavier);
  while (modes.size() > 1 && modes.back().mass < leastMass) {
    modes.pop_back();
  }
  return modes;
}

vpPoseMatrix6 vpPoseModes::covariance(const vpHomogeneousMatrix &cMo, const vpHomogeneousMatrix *poses,
                                      const double *weights, std::size_t count)
{
  const Eigen::Isometry3d back = vpPoseExponential::toEigen(cMo).inverse();
  vpPoseMatrix6 sum = vpPoseMatrix6::Zero();
  double total = 0.;
  for (std::size_t i = 0; i < count; i++) {
    if (weights[i] > 0.) {
      const vpPoseTangent alpha = vpPoseExponential::log(back * vpPoseExponential::toEigen(poses[i]));
      sum += weights[i] * alpha * alpha.transpose();
      total += weights[i];
    }
  }
  return sum / total;
}

END_VISP_NAMESPACE
