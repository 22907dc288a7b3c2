// SPDX-License-Identifier: GPL-2.0-or-later
// Poses whose coordinates are so small that SE(3) is flat: the particle filter has to agree with a Kalman filter.
#include <visp3/se3/vpPoseParticleFilter.h>

#include <catchMain.h>

#include <algorithm>
#include <numeric>

namespace {
using Prior = vpPoseParticleSettings::Prior;

const double deviation = 1e-3; // Of the noise, metres and radians: the unit of all coordinates.
const int frames = 30;
const unsigned int runs = 6;

// Coordinates about a pose, for which the noise of the settings is the same everywhere, and what is observed of them.
struct Toy
{
  vpPoseNoise::Frame frame = vpPoseNoise::Frame::OBJECT;
  double observation = 1.; // Deviation of what is observed.
  vpHomogeneousMatrix base = vpHomogeneousMatrix(0.1, -0.05, 0.8, 0.5, -1.2, 0.4);

  vpPoseTangent coordinatesOf(const vpHomogeneousMatrix &cMo) const
  {
    const bool isInObject = frame == vpPoseNoise::Frame::OBJECT;
    return vpPoseExponential::log(isInObject ? base.inverse() * cMo : cMo * base.inverse()) / deviation;
  }

  vpHomogeneousMatrix poseOf(const vpPoseTangent &coordinates) const
  {
    const vpHomogeneousMatrix moved = vpPoseExponential::exp(deviation * coordinates);
    return frame == vpPoseNoise::Frame::OBJECT ? base * moved : moved * base;
  }

  double logLikelihood(const vpHomogeneousMatrix &cMo, const vpPoseTangent &observed) const
  {
    const vpPoseTangent error = (coordinatesOf(cMo) - observed) / observation;
    return -0.5 * error.squaredNorm() - 3. * std::log(2. * M_PI * observation * observation);
  }
};

// All six coordinates wander by 1 a frame: one variance for all.
struct Kalman
{
  vpPoseTangent x = vpPoseTangent::Zero();
  double variance = 1.;
  vpPoseTangent innovation = vpPoseTangent::Zero();

  // Returns the logarithm of the density of what is observed.
  double update(const vpPoseTangent &observed, double noise)
  {
    const double predicted = variance + 1.;
    const double expected = predicted + noise;
    innovation = observed - x;
    x += predicted / expected * innovation;
    variance = predicted * noise / expected;
    return -0.5 * innovation.squaredNorm() / expected - 3. * std::log(2. * M_PI * expected);
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

// Each of the best particles moved most of the way to what is observed.
std::vector<vpHomogeneousMatrix> optimised(const Toy &toy, const vpPoseParticleFilter &filter, std::size_t count,
                                           const vpPoseTangent &observed)
{
  std::vector<std::size_t> order(filter.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t i, std::size_t j) { return filter.weights()[i] > filter.weights()[j]; });
  std::vector<vpHomogeneousMatrix> poses;
  for (std::size_t i = 0; i < count; i++) {
    const vpPoseTangent start = toy.coordinatesOf(filter.pose(order[i]));
    poses.push_back(toy.poseOf(start + (1. - 0.2 * toy.observation * toy.observation) * (observed - start)));
  }
  return poses;
}

std::vector<double> logLikelihoods(const Toy &toy, const vpPoseParticleFilter &filter, std::size_t first,
                                   const vpPoseTangent &observed)
{
  std::vector<double> numbers;
  for (std::size_t i = first; i < filter.size(); i++) {
    numbers.push_back(toy.logLikelihood(filter.pose(i), observed));
  }
  return numbers;
}

Differences compare(vpPoseParticleSettings settings, std::size_t proposals, const Toy &toy = Toy())
{
  settings.translationNoise = settings.rotationNoise = deviation;
  settings.noiseTime = 0.1;
  settings.noiseFrame = toy.frame;
  Differences sum;
  double innovations = 0.;
  for (unsigned int run = 0; run < runs; run++) {
    settings.seed = 10 + run;
    vpPoseRandom random(99, {run});
    vpPoseParticleFilter filter(settings);
    filter.start(toy.base, vpPoseNoise::isotropic(deviation, deviation, toy.frame));
    Kalman kalman;
    vpPoseTangent truth = random.normalTangent();
    for (int frame = 0; frame < frames; frame++) {
      truth += random.normalTangent();
      const vpPoseTangent observed = truth + toy.observation * random.normalTangent();
      filter.predict(0.1);
      double evidence = filter.weigh(logLikelihoods(toy, filter, 0, observed));
      if (proposals > 0) {
        filter.propose(optimised(toy, filter, proposals, observed));
        evidence = filter.weighProposals(logLikelihoods(toy, filter, filter.predictedSize(), observed));
      }
      sum.evidence += evidence - kalman.update(observed, toy.observation * toy.observation);
      const vpPoseTangent mean = toy.coordinatesOf(filter.mean());
      const vpPoseTangent difference = mean - kalman.x;
      sum.square += difference.squaredNorm() / (6. * kalman.variance);
      sum.pull += difference.dot(kalman.innovation);
      innovations += kalman.innovation.squaredNorm();
      double squares = 0.;
      for (std::size_t i = 0; i < filter.size(); i++) {
        squares += filter.weights()[i] * (toy.coordinatesOf(filter.pose(i)) - mean).squaredNorm();
      }
      sum.variance += squares / (6. * kalman.variance);
      filter.resample();
    }
  }
  sum.square /= runs * frames;
  sum.variance /= runs * frames;
  sum.evidence /= runs * frames;
  sum.pull /= innovations;
  return sum;
}

vpPoseParticleSettings scattered(std::size_t number)
{
  vpPoseParticleSettings settings;
  settings.number = number;
  settings.scatterProposals = true;
  return settings;
}
} // namespace

TEST_CASE("Predicted particles alone are a Kalman filter", "[particles]")
{
  vpPoseParticleSettings settings;
  settings.number = 1600;
  const Differences d = compare(settings, 0);
  CAPTURE(d.square, d.pull, d.variance, d.evidence);
  CHECK(d.square < 0.1);
  CHECK(std::abs(d.pull) < 0.05);
  CHECK(std::abs(d.variance - 1.) < 0.06);
  CHECK(std::abs(d.evidence) < 0.25);
}

TEST_CASE("With optimised particles it is one too, and closer with fewer of them", "[particles]")
{
  const Differences d = compare(scattered(400), 120);
  CAPTURE(d.square, d.pull, d.variance, d.evidence);
  CHECK(d.square < 0.03);
  CHECK(std::abs(d.pull) < 0.015);
  CHECK(std::abs(d.variance - 1.) < 0.03);
  CHECK(std::abs(d.evidence) < 0.05);
}

TEST_CASE("Noise in the camera's frame has the same answer", "[particles]")
{
  Toy toy;
  toy.frame = vpPoseNoise::Frame::CAMERA;
  const Differences d = compare(scattered(200), 60, toy);
  CAPTURE(d.square, d.pull, d.variance, d.evidence);
  CHECK(d.square < 0.06);
  CHECK(std::abs(d.pull) < 0.02);
  CHECK(std::abs(d.variance - 1.) < 0.04);
  CHECK(std::abs(d.evidence) < 0.1);
}

TEST_CASE("Without f / g the observation counts twice", "[particles]")
{
  vpPoseParticleSettings settings = scattered(400);
  settings.correctProposals = false;
  const Differences d = compare(settings, 120);
  CAPTURE(d.square, d.pull, d.variance, d.evidence);
  CHECK(d.square > 0.3);
  CHECK(d.pull > 0.2);
  CHECK(d.variance < 0.9);
  CHECK(d.evidence > 2.);
}

TEST_CASE("Observations much sharper than the noise need narrow kernels about the optimised poses", "[particles]")
{
  Toy toy;
  toy.observation = 0.2;
  vpPoseParticleSettings settings = scattered(100);
  settings.proposalSpread = 0.3;
  const Differences guided = compare(settings, 30, toy);
  CAPTURE(guided.square, guided.pull, guided.variance, guided.evidence);
  CHECK(guided.square < 0.12);
  CHECK(std::abs(guided.pull) < 0.015);
  CHECK(std::abs(guided.variance - 1.) < 0.06);
  CHECK(std::abs(guided.evidence) < 0.15);

  const Differences alone = compare(settings, 0, toy);
  CAPTURE(alone.square);
  CHECK(alone.square > 5.);
}

// The optimised poses themselves are no draws of g: they lie too close together.
TEST_CASE("Optimised poses as they are ([T10]) get near the answer, and nearer with f / g", "[particles]")
{
  vpPoseParticleSettings settings;
  settings.number = 100;
  const Differences corrected = compare(settings, 30);
  CAPTURE(corrected.square, corrected.pull, corrected.variance, corrected.evidence);
  settings.prior = Prior::PARTICLES;
  const Differences particles = compare(settings, 30);
  CAPTURE(particles.square, particles.pull, particles.variance, particles.evidence);
  settings.correctProposals = false;
  const Differences uncorrected = compare(settings, 30);
  CAPTURE(uncorrected.square, uncorrected.pull, uncorrected.variance, uncorrected.evidence);
  CHECK(corrected.square < 0.5 * uncorrected.square);
  CHECK(corrected.pull < 0.6 * uncorrected.pull);
  CHECK(corrected.variance > 3. * uncorrected.variance);
  CHECK(particles.pull < 0.9 * uncorrected.pull);
  CHECK(particles.variance > 3. * uncorrected.variance);
}
