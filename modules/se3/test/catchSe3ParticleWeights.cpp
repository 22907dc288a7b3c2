// SPDX-License-Identifier: GPL-2.0-or-later
#include <countAllocations.h>

#include <catchMain.h>
#include <particleSamples.h>

#include <limits>

using countAllocations::allocations;
using namespace particleSamples;

namespace {
const double infinity = std::numeric_limits<double>::infinity();
const double notANumber = std::numeric_limits<double>::quiet_NaN();
} // namespace

TEST_CASE("Weights are kept from frame to frame where nothing is resampled", "[particles]")
{
  vpPoseParticleFilter filter(settingsOf(3));
  filter.start(cMo, startNoise);
  CHECK(filter.weigh({0., std::log(2.), std::log(3.)}) == Approx(std::log(2.)));
  CHECK(filter.weights()[2] == Approx(0.5));
  filter.predict(0.03);
  CHECK(filter.weights()[2] == Approx(0.5));
  filter.weigh({5., 5., 5.});
  CHECK(filter.weigh({std::log(2.), 0., 0.}) == Approx(std::log(7. / 6.))); // The second call replaces the first.
  CHECK(filter.weights()[0] == Approx(2. / 7.));
  CHECK(filter.weights()[2] == Approx(3. / 7.));
}

TEST_CASE("Likelihoods that fail never get out", "[particles]")
{
  vpPoseParticleFilter filter(settingsOf(4));
  filter.start(cMo, startNoise);
  filter.weigh({0., notANumber, infinity, std::log(3.)});
  CHECK(filter.weights()[1] == exactly(0.));
  CHECK(filter.weights()[2] == exactly(0.));
  CHECK(filter.weights()[3] == Approx(0.75));
  filter.predict(0.03);
  CHECK(filter.weigh({notANumber, -infinity, infinity, notANumber}) == exactly(-infinity));
  CHECK(filter.weights()[3] == Approx(0.75)); // As predicted.
  filter.propose(optimisedPoses(2, 0));
  CHECK(filter.weighProposals({notANumber, -infinity}) == exactly(-infinity));
  CHECK(filter.weights()[3] == Approx(0.75));
  CHECK(filter.weights()[4] == exactly(0.));
  CHECK(sumOf(filter.weights()) == Approx(1.));
  filter.resample();
  CHECK(std::isfinite(filter.mean()[0][3]));
}

TEST_CASE("A proposal too far for the prediction does not count, however likely", "[particles]")
{
  vpPoseParticleFilter filter(settingsOf(50));
  filter.start(cMo, startNoise);
  filter.predict(1. / 30.);
  filter.weigh(std::vector<double>(50, 0.));
  filter.propose({vpHomogeneousMatrix(5., 5., 5., 1., 1., 1.)});
  filter.weighProposals({50.});
  CHECK(filter.weights()[50] < 1e-12);
  CHECK(sumOf(filter.weights()) == Approx(1.));

  vpPoseParticleSettings settings = filter.settings();
  settings.correctProposals = false;
  filter.setSettings(settings);
  filter.weighProposals({50.});
  CHECK(filter.weights()[50] > 0.999);
}

TEST_CASE("Weights of the union are likelihood times f / g", "[particles]")
{
  for (const vpPoseParticleSettings::Prior prior :
       {vpPoseParticleSettings::Prior::PREDICTION, vpPoseParticleSettings::Prior::PARTICLES}) {
    vpPoseParticleSettings settings = settingsOf(20);
    settings.prior = prior;
    settings.proposalSpread = 0.5;
    vpPoseParticleFilter filter(settings);
    filter.start(cMo, startNoise);
    filter.weigh(logLikelihoods(filter));
    const std::vector<double> priorWeights = filter.weights();
    const vpHomogeneousMatrix oMp(0.002, 0.001, 0., 0., 0.01, 0.);
    std::vector<vpHomogeneousMatrix> centres;
    for (std::size_t i = 0; i < 20; i++) {
      centres.push_back(filter.pose(i) * oMp);
    }
    filter.predict(1. / 30., oMp);
    filter.weigh(logLikelihoods(filter));
    const std::vector<vpHomogeneousMatrix> optimised = optimisedPoses(5, 0);
    filter.propose(optimised);
    const double logMean = filter.weighProposals(logLikelihoods(filter, 20));
    const vpPoseNoise kernel = vpPoseNoise::isotropic(settings.translationNoise, settings.rotationNoise);
    const vpPoseNoise narrow = vpPoseNoise::isotropic(0.5 * settings.translationNoise, 0.5 * settings.rotationNoise);
    std::vector<double> expected;
    for (std::size_t i = 0; i < 25; i++) {
      double f = 0.;
      for (std::size_t k = 0; k < 20; k++) {
        const bool isAtCentre = prior == vpPoseParticleSettings::Prior::PREDICTION;
        const vpHomogeneousMatrix &mean = isAtCentre ? centres[k] : filter.pose(k);
        f += priorWeights[k] * std::exp(kernel.logDensity(filter.pose(i), mean));
      }
      double g = 20. / 25. * f;
      for (const vpHomogeneousMatrix &mean : optimised) {
        g += 1. / 25. * std::exp(narrow.logDensity(filter.pose(i), mean));
      }
      const double drawn = i < 20 ? 20. / 25. * priorWeights[i] : 1. / 25.;
      expected.push_back(drawn * f / g * std::exp(likelihood.logDensity(filter.pose(i), cMo)));
    }
    const double sum = sumOf(expected);
    CHECK(logMean == Approx(std::log(sum)).margin(2e-3));
    for (std::size_t i = 0; i < 25; i++) {
      CHECK(filter.weights()[i] == Approx(expected[i] / sum).epsilon(4e-3).margin(1e-12));
    }
    CHECK(filter.effort().evaluated > 0);
  }
}

TEST_CASE("A frame allocates nothing once the numbers were seen", "[particles]")
{
  vpPoseParticleSettings settings = settingsOf(100);
  settings.scatterProposals = true;
  vpPoseParticleFilter filter(settings);
  filter.start(cMo, startNoise);
  const vpHomogeneousMatrix oMp(0.001, 0., 0., 0., 0.002, 0.);
  for (unsigned int frame = 0; frame < 4; frame++) {
    std::size_t inside = 0;
    std::size_t before = allocations;
    filter.predict(0.03, oMp);
    inside += allocations - before;
    const std::vector<double> numbers = logLikelihoods(filter);
    const std::vector<vpHomogeneousMatrix> optimised = optimisedPoses(frame == 2 ? 20 : 30, frame);
    before = allocations;
    filter.weigh(numbers);
    filter.propose(optimised);
    inside += allocations - before;
    const std::vector<double> others = logLikelihoods(filter, filter.predictedSize());
    before = allocations;
    filter.weighProposals(others);
    filter.resample();
    inside += allocations - before;
    if (frame > 0) {
      CHECK(inside == 0);
    }
  }
}
