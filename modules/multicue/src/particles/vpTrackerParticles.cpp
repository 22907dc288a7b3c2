// SPDX-License-Identifier: GPL-2.0-or-later
#include "particles/vpTrackerParticles.h"

#include <visp3/se3/vpPoseModes.h>
#include <visp3/se3/vpExactNumber.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

BEGIN_VISP_NAMESPACE

namespace {
// The deviations grow no larger than this, diameters and radians: beyond, a hundred particles meet nothing.
const double mostTranslation = 0.1;
const double mostRotation = 0.35;
// Growth of the deviations for each frame without the object.
const double lostGrowth = 1.2;
// Where the particles start, in deviations of the noise.
const double startSpread = 1.;
// Particles that are optimised are this far apart, in widths of a mode.
const double leastDistance = 0.5;
// A pose that is farther away than this is not theirs, in widths of a mode.
const double farthest = 3.;
// The measured time decides by this share, so that a slow frame does not.
const double numberRate = 0.3;
// Modes with less of the weight are noise.
const double leastMass = 0.02;
// Streams of random numbers that the estimation of the pose never gets to.
const std::uint64_t firstDraw = std::uint64_t(1) << 40;

const double nothing = -std::numeric_limits<double>::infinity();
} // namespace

void vpTrackerParticles::setSettings(const vpParticleSettings &settings)
{
  settings.check();
  m_settings = settings;
  m_number = settings.number;
  if (settings.budget > 0.) {
    m_number = std::min(std::max(settings.number, settings.leastNumber), settings.mostNumber);
  }
}

void vpTrackerParticles::clear()
{
  m_filter.reset();
  m_modes.clear();
  m_mean.eye();
  m_spread = 1.;
  rivals.clear();
  followedMotion.eye();
  isCalm = false;
  isViewed.clear();
  before = Before();
  blindFrames = 0;
  draws = firstDraw;
  frame = 0;
}

void vpTrackerParticles::restart(const vpHomogeneousMatrix &cMb, double diameter)
{
  vpPoseParticleSettings settings = m_filter.settings();
  settings.number = m_number;
  settings.seed = m_settings.seed;
  m_filter = vpPoseParticleFilter(settings); // The random numbers begin anew, too.
  m_filter.start(cMb, vpPoseNoise::isotropic(startSpread * m_settings.translationNoise * diameter,
                                             startSpread * m_settings.rotationNoise));
  m_spread = 1.;
  findModes(diameter);
}

void vpTrackerParticles::follow(const vpHomogeneousMatrix &cMb)
{
  rivals.clear();
  followed = explained = cMb;
  followedMotion.eye();
  isCalm = false;
  blindFrames = 0;
}

void vpTrackerParticles::widen()
{
  m_spread = std::min(m_spread * lostGrowth, 100.);
}

void vpTrackerParticles::move(double dt, const vpHomogeneousMatrix &bMp, const std::array<double, 2> &surprise,
                              double diameter)
{
  const auto deviation = [this](double least, double squared, double most) {
    const double axis = std::sqrt(squared / 3.); // A distance has three.
    return std::min(m_spread * std::max(least, m_settings.motionNoise * axis), std::max(least, most));
  };
  vpPoseParticleSettings settings = m_filter.settings();
  settings.number = m_number;
  settings.translationNoise = diameter * deviation(m_settings.translationNoise, surprise[0], mostTranslation);
  settings.rotationNoise = deviation(m_settings.rotationNoise, surprise[1], mostRotation);
  settings.noiseFrame =
      m_settings.noiseFrame == vpParticleSettings::CAMERA ? vpPoseNoise::Frame::CAMERA : vpPoseNoise::Frame::OBJECT;
  settings.jumpShare = m_settings.jumpShare;
  settings.jumpFactor = m_settings.jumpFactor;
  m_filter.setSettings(settings);
  m_filter.resample(); // What the last frame weighed.
  m_filter.predict(dt, bMp);
}

double vpTrackerParticles::likelihood(double distance, double least, double range) const
{
  if (vpIsSame(distance, impossible)) {
    return nothing;
  }
  const double share = range > 0. ? (distance - least) / range : 0.;
  return -m_settings.lambda * share * share;
}

bool vpTrackerParticles::weighDistances(const std::vector<double> &distances,
                                        const std::vector<vpHomogeneousMatrix> &optimised,
                                        const std::vector<double> &optimisedDistances)
{
  double least = HUGE_VAL;
  double largest = 0.;
  for (const std::vector<double> *part : {&distances, &optimisedDistances}) {
    for (const double distance : *part) {
      if (vpIsOther(distance, impossible)) {
        least = std::min(least, distance);
        largest = std::max(largest, distance);
      }
    }
  }
  std::vector<double> logs;
  std::vector<double> optimisedLogs;
  for (const double distance : distances) {
    logs.push_back(likelihood(distance, least, largest - least));
  }
  for (const double distance : optimisedDistances) {
    optimisedLogs.push_back(likelihood(distance, least, largest - least));
  }
  return weigh(logs, optimised, optimisedLogs);
}

bool vpTrackerParticles::weigh(const std::vector<double> &logs, const std::vector<vpHomogeneousMatrix> &optimised,
                               const std::vector<double> &optimisedLogs)
{
  m_filter.weigh(logs);
  m_filter.propose(optimised);
  return std::isfinite(m_filter.weighProposals(optimisedLogs));
}

void vpTrackerParticles::findModes(double diameter)
{
  vpPoseModes finder(m_settings.modeTranslation * diameter, m_settings.modeRotation);
  m_modes = m_filter.modes(finder, leastMass);
  m_mean = m_filter.mean();
}

double vpTrackerParticles::distance(const vpHomogeneousMatrix &c1Mb, const vpHomogeneousMatrix &c2Mb,
                                    double diameter) const
{
  double moved = 0.;
  double trace = 0.;
  for (unsigned int i = 0; i < 3; ++i) {
    moved += (c1Mb[i][3] - c2Mb[i][3]) * (c1Mb[i][3] - c2Mb[i][3]);
    for (unsigned int j = 0; j < 3; ++j) {
      trace += c1Mb[i][j] * c2Mb[i][j];
    }
  }
  const double translation = m_settings.modeTranslation * diameter;
  return moved / (translation * translation) +
         std::max(3. - trace, 0.) / (m_settings.modeRotation * m_settings.modeRotation);
}

bool vpTrackerParticles::reach(const vpHomogeneousMatrix &cMb, double diameter) const
{
  for (std::size_t i = 0; i < m_filter.predictedSize(); ++i) {
    if (distance(m_filter.pose(i), cMb, diameter) < farthest * farthest) {
      return true;
    }
  }
  return false;
}

std::vector<std::size_t> vpTrackerParticles::best(const std::vector<double> &distances, const vpHomogeneousMatrix &cMb,
                                                  double diameter, unsigned int most) const
{
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < distances.size(); ++i) {
    if (vpIsOther(distances[i], impossible)) {
      order.push_back(i);
    }
  }
  std::vector<std::size_t> chosen;
  if (order.empty()) {
    return chosen;
  }
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return distances[a] < distances[b]; });
  const double least = distances[order.front()];
  const double range = distances[order.back()] - least;
  const double needed = m_settings.bestShare > 0. ? std::log(m_settings.bestShare) : nothing;
  for (const std::size_t i : order) {
    if (chosen.size() == most || likelihood(distances[i], least, range) < needed) {
      break;
    }
    const vpHomogeneousMatrix &pose = m_filter.pose(i);
    const auto isNear = [&](const vpHomogeneousMatrix &other) {
      return distance(pose, other, diameter) < leastDistance * leastDistance;
    };
    if (!isNear(cMb) &&
        std::none_of(chosen.begin(), chosen.end(), [&](std::size_t k) { return isNear(m_filter.pose(k)); })) {
      chosen.push_back(i);
    }
  }
  return chosen;
}

void vpTrackerParticles::adaptNumber(const vpTrackingTimings &timings)
{
  if (!(m_settings.budget > 0.) || !(timings.particles > 0.) || !isStarted()) {
    return;
  }
  const double each = timings.particles / static_cast<double>(m_filter.predictedSize());
  const double wanted = (m_settings.budget - (timings.total - timings.particles)) / each;
  const double number = static_cast<double>(m_number);
  const double next = number + numberRate * (std::min(std::max(wanted, 0.5 * number), 2. * number) - number);
  const double least = m_settings.leastNumber;
  const double most = m_settings.mostNumber;
  m_number = static_cast<std::size_t>(std::min(std::max(next, least), most));
}

END_VISP_NAMESPACE
