// SPDX-License-Identifier: GPL-2.0-or-later
#include "generate/oscillations.h"

#include <visp3/se3/vpPoseRandom.h>

#include <cmath>

#ifdef ENABLE_VISP_NAMESPACE
using namespace VISP_NAMESPACE_NAME;
#endif

namespace bench {
namespace {
const double turn = 2. * M_PI;
// Multiples of the middle frequency, none of them a simple fraction of another: no two swings are alike.
const std::array<double, 3> frequencies = {{0.61, 1., 1.37}};
// How much the speed changes, and periods in frames: between a fifth of the mean and nearly twice of it, so that a
// tenth of the predictions is off by more than twice the mean, as in real motion of hands.
const std::array<double, 2> speedChanges = {{0.5, 0.3}};
const std::array<double, 2> speedPeriods = {{47., 19.}};
} // namespace

Oscillations::Oscillations(int count, std::uint64_t seed)
{
  vpPoseRandom random(seed, {0x68616e64});
  for (std::size_t k = 0; k < m_speed.size(); ++k) {
    m_speed[k] = {speedChanges[k], turn / speedPeriods[k] * (0.9 + 0.2 * random.uniform()), turn * random.uniform()};
  }
  for (int i = 0; i < count; ++i) {
    std::array<Wave, 3> waves;
    for (std::size_t k = 0; k < waves.size(); ++k) {
      // Slower swings reach farther.
      waves[k] = {1. / frequencies[k], frequencies[k] * (0.9 + 0.2 * random.uniform()), turn * random.uniform()};
    }
    double square = 0.;
    for (const Wave &wave : waves) {
      square += 0.5 * wave.amplitude * wave.amplitude;
    }
    for (Wave &wave : waves) {
      wave.amplitude /= std::sqrt(square);
    }
    m_waves.push_back(waves);
  }
}

// The integral of the speed.
double Oscillations::passed(double time) const
{
  double sum = time;
  for (const Wave &speed : m_speed) {
    sum -= speed.amplitude / speed.frequency * std::cos(speed.frequency * time + speed.phase);
  }
  return sum;
}

Eigen::VectorXd Oscillations::at(double time, double tempo) const
{
  const double phase = tempo * passed(time);
  Eigen::VectorXd values = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(m_waves.size()));
  for (std::size_t i = 0; i < m_waves.size(); ++i) {
    for (const Wave &wave : m_waves[i]) {
      values(static_cast<Eigen::Index>(i)) += wave.amplitude * std::sin(wave.frequency * phase + wave.phase);
    }
  }
  return values;
}

} // namespace bench
