// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef particleSamples_h
#define particleSamples_h

#include <visp3/se3/vpPoseParticleFilter.h>

#include <thread>
#include <vector>

/*!
  \file particleSamples.h
  An object that stands still, and what a tracker might say of particles about it.
*/

namespace particleSamples {
const vpHomogeneousMatrix cMo(0.1, -0.05, 0.8, 0.5, -1.2, 2.);
const vpPoseNoise startNoise = vpPoseNoise::isotropic(0.01, 0.03);
const vpPoseNoise likelihood = vpPoseNoise::isotropic(0.008, 0.02);

inline vpPoseParticleSettings settingsOf(std::size_t number)
{
  vpPoseParticleSettings settings;
  settings.number = number;
  return settings;
}

// \param threads Each takes every so many-th particle.
inline std::vector<double> logLikelihoods(const vpPoseParticleFilter &filter, std::size_t first = 0,
                                          std::size_t threads = 1)
{
  std::vector<double> numbers(filter.size() - first);
  std::vector<std::thread> workers;
  for (std::size_t worker = 0; worker < threads; worker++) {
    workers.emplace_back([&, worker] {
      for (std::size_t i = worker; i < numbers.size(); i += threads) {
        numbers[i] = likelihood.logDensity(filter.pose(first + i), cMo);
      }
    });
  }
  for (std::thread &worker : workers) {
    worker.join();
  }
  return numbers;
}

inline std::vector<vpHomogeneousMatrix> optimisedPoses(std::size_t count, std::uint64_t frame)
{
  std::vector<vpHomogeneousMatrix> poses;
  for (std::size_t i = 0; i < count; i++) {
    vpPoseRandom random(21, {frame, i});
    poses.push_back(vpPoseNoise::isotropic(0.002, 0.005).draw(cMo, random));
  }
  return poses;
}

inline double sumOf(const std::vector<double> &weights)
{
  double sum = 0.;
  for (const double weight : weights) {
    sum += weight;
  }
  return sum;
}

} // namespace particleSamples
#endif
