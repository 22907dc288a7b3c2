// SPDX-License-Identifier: GPL-2.0-or-later
// Poses whose coordinates are so small that SE(3) is flat: the particle filter has to agree with a Kalman filter.
#include <visp3/se3/vpPoseParticleFilter.h>

#include <catchMain.h>

#include <algorithm>
#include <numeric>

namespace {
using Prior = vpPoseParticleSettings::Prior;

const vpHomogeneousMatrix base(0.1, -0.05, 0.8, 0.5, -1.2, 0.4);
const double deviation = 1e-3; // Of noise and of observations, metres and radians.
const int frames = 30;
const unsigned int runs = 6;

vpPoseTangent coordinatesOf(const vpHomogeneousMatrix &cMo)
{
  return vpPoseExponential::log(base.inverse() * cMo) / deviation;
}

vpHomogeneousMatrix poseOf(const vpPoseTangent &coordinates)
{
  return base * vpPoseExponential::exp(deviation * coordinates);
}

// All six coordinates wander by 1 a frame and are observed to 1, in units of the deviation: one variance for all.
struct Kalman
{
  vpPoseTangent x = vpPoseTangent::Zero();
  double variance = 1.;
  vpPoseTangent innovation = vpPoseTangent::Zero();

  void update(const vpPoseTangent &observed)
  {
    const double predicted = variance + 1.;
    innovation = observed - x;
    x += predicted / (predicted + 1.) * innovation;
    variance = predicted / (predicted + 1.);
  }
};

// What the filter's answers differ by from the Kalman filter's.
struct Differences
{
  double square = 0.; // Mean squared difference of the means, in units of the variance.
  double pull = 0.; // Of the means' differences on the innovation: 0 without bias, > 0 where observations count twice.
  double variance = 0.; // Mean of the variance over the Kalman filter's.
  double evidence = 0.; // Mean difference of the logarithm of the observation's density.
};

double logEvidence(const Kalman &before, const vpPoseTangent &observed)
{
  const double variance = before.variance + 2.;
  return -0.5 * (observed - before.x).squaredNorm() / variance - 3. * std::log(2. * M_PI * variance);
}

// Each of the best particles moved most of the way to what is observed.
std::vector<vpHomogeneousMatrix> optimised(const vpPoseParticleFilter &filter, std::size_t count,
                                           const vpPoseTangent &observed)
{
  std::vector<std::size_t> order(filter.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t i, std::size_t j) { return filter.weights()[i] > filter.weights()[j]; });
  std::vector<vpHomogeneousMatrix> poses;
  for (std::size_t i = 0; i < count; i++) {
    const vpPoseTangent start = coordinatesOf(filter.pose(order[i]));
    poses.push_back(poseOf(start + 0.8 * (observed - start)));
  }
  return poses;
}

std::vector<double> logLikelihoods(const vpPoseParticleFilter &filter, std::size_t first, const vpPoseTangent &observed)
{
  std::vector<double> numbers;
  for (std::size_t i = first; i < filter.size(); i++) {
    const double squares = (coordinatesOf(filter.pose(i)) - observed).squaredNorm();
    numbers.push_back(-0.5 * squares - 3. * std::log(2. * M_PI));
  }
  return numbers;
}

Differences compare(vpPoseParticleSettings settings, std::size_t proposals)
{
  settings.translationNoise = settings.rotationNoise = deviation;
  settings.noiseTime = 0.1;
  Differences sum;
  double innovations = 0.;
  for (unsigned int run = 0; run < runs; run++) {
    settings.seed = 10 + run;
    vpPoseRandom random(99, {run});
    vpPoseParticleFilter filter(settings);
    filter.start(base, vpPoseNoise::isotropic(deviation, deviation));
    Kalman kalman;
    vpPoseTangent truth = random.normalTangent();
    for (int frame = 0; frame < frames; frame++) {
      truth += random.normalTangent();
      const vpPoseTangent observed = truth + random.normalTangent();
      filter.predict(0.1);
      double evidence = filter.weigh(logLikelihoods(filter, 0, observed));
      if (proposals > 0) {
        filter.propose(optimised(filter, proposals, observed));
        evidence = filter.weighProposals(logLikelihoods(filter, filter.predictedSize(), observed));
      }
      sum.evidence += evidence - logEvidence(kalman, observed);
      kalman.update(observed);
      const vpPoseTangent difference = coordinatesOf(filter.mean()) - kalman.x;
      sum.square += difference.squaredNorm() / (6. * kalman.variance);
      sum.pull += difference.dot(kalman.innovation);
      innovations += kalman.innovation.squaredNorm();
      sum.variance += filter.covariance().trace() / (deviation * deviation) / (6. * kalman.variance);
      filter.resample();
    }
  }
  sum.square /= runs * frames;
  sum.variance /= runs * frames;
  sum.evidence /= runs * frames;
  sum.pull /= innovations;
  return sum;
}
} // namespace

TEST_CASE("Dump", "[.dump]")
{
  for (const std::size_t number : {100, 400, 1600}) {
    for (int variant = 0; variant < 7; variant++) {
      if (number > 400 && variant != 0 && variant != 1 && variant != 2 && variant != 5)
        continue;
      vpPoseParticleSettings settings;
      settings.number = number;
      settings.scatterProposals = variant < 3 || variant == 6;
      settings.correctProposals = variant != 2 && variant != 5;
      settings.proposalSpread = variant == 6 ? 0.5 : 1.;
      settings.prior = variant == 4 ? Prior::PARTICLES : Prior::PREDICTION;
      const Differences d = compare(settings, variant == 0 ? 0 : number * 3 / 10);
      const char *names[] = {"none",
                             "scatter",
                             "scatter uncorrected",
                             "T10 points, f prediction",
                             "T10 points, f particles",
                             "T10 points uncorrected",
                             "scatter .5"};
      printf("%5zu %-26s square %.4f pull %+.4f variance %.4f evidence %+.4f\n", number, names[variant], d.square,
             d.pull, d.variance, d.evidence);
    }
  }
}
