// SPDX-License-Identifier: GPL-2.0-or-later
#include <visp3/se3/vpPoseMean.h>

#include <visp3/core/vpException.h>

#include <catchMain.h>
#include <particleSamples.h>
#include <poseSamples.h>

#include <cstring>
#include <limits>

using namespace particleSamples;

namespace {
const double infinity = std::numeric_limits<double>::infinity();
const double notANumber = std::numeric_limits<double>::quiet_NaN();

// All poses and weights of some frames, as bits.
std::vector<double> historyOf(const vpPoseParticleSettings &settings, std::size_t threads)
{
  vpPoseParticleFilter filter(settings);
  filter.start(cMo, startNoise);
  std::vector<double> history;
  for (unsigned int frame = 0; frame < 5; frame++) {
    filter.predict(0.03, vpHomogeneousMatrix(0.001, 0., 0., 0., 0.002, 0.));
    filter.weigh(logLikelihoods(filter, 0, threads));
    if (frame != 2) {
      filter.propose(optimisedPoses(10 + frame, frame));
      filter.weighProposals(logLikelihoods(filter, filter.predictedSize(), threads));
    }
    for (std::size_t i = 0; i < filter.size(); i++) {
      history.insert(history.end(), filter.pose(i).data, filter.pose(i).data + 16);
      history.push_back(filter.weights()[i]);
    }
    if (frame == 3) {
      filter.setNumber(70);
    } else {
      filter.resample();
    }
  }
  return history;
}

} // namespace

TEST_CASE("The same seed gives the same bits with any number of threads", "[particles]")
{
  vpPoseParticleSettings settings = settingsOf(50);
  settings.scatterProposals = true;
  const std::vector<double> one = historyOf(settings, 1);
  const std::vector<double> four = historyOf(settings, 4);
  REQUIRE(one.size() == four.size());
  CHECK(std::memcmp(one.data(), four.data(), one.size() * sizeof(double)) == 0);
  settings.seed = 2;
  CHECK(historyOf(settings, 1) != one);
}

TEST_CASE("A particle does not depend on how many there are", "[particles]")
{
  vpPoseParticleFilter few(settingsOf(10));
  vpPoseParticleFilter many(settingsOf(200));
  for (vpPoseParticleFilter *filter : {&few, &many}) {
    filter->start(cMo, startNoise);
    filter->predict(0.1);
  }
  for (std::size_t i = 0; i < 10; i++) {
    CHECK(maxDifference(few.pose(i), many.pose(i)) == exactly(0.));
    CHECK(maxDifference(few.pose(i), many.pose(i + 10)) > 0.);
  }
}

TEST_CASE("Particles move as told, and spread by the noise of the time step", "[particles]")
{
  const std::size_t count = 20000;
  const vpHomogeneousMatrix oMp(0.02, -0.03, 0.1, 0.1, 0.2, -0.3);
  for (const vpPoseNoise::Frame frame : {vpPoseNoise::Frame::OBJECT, vpPoseNoise::Frame::CAMERA}) {
    for (const double growth : {0., 0.5, 1.}) {
      vpPoseParticleSettings settings = settingsOf(count);
      settings.translationNoise = 0.005;
      settings.rotationNoise = 0.02;
      settings.noiseTime = 0.05;
      settings.noiseGrowth = growth;
      settings.noiseFrame = frame;
      vpPoseParticleFilter filter(settings);
      filter.start(cMo, vpPoseNoise::isotropic(1e-12, 1e-12));
      filter.predict(0.2, oMp);
      const vpHomogeneousMatrix moved = cMo * oMp;
      vpPoseTangent sum = vpPoseTangent::Zero();
      vpPoseMatrix6 products = vpPoseMatrix6::Zero();
      for (std::size_t i = 0; i < count; i++) {
        const vpHomogeneousMatrix apart =
            frame == vpPoseNoise::Frame::OBJECT ? moved.inverse() * filter.pose(i) : filter.pose(i) * moved.inverse();
        const vpPoseTangent alpha = vpPoseExponential::log(apart);
        sum += alpha;
        products += alpha * alpha.transpose();
      }
      vpPoseTangent deviation;
      deviation << Eigen::Vector3d::Constant(0.005), Eigen::Vector3d::Constant(0.02);
      deviation *= std::pow(4., growth);
      for (int i = 0; i < 6; i++) {
        CHECK(std::abs(sum[i] / count) < 4.5 * deviation[i] / std::sqrt(count));
        for (int j = 0; j <= i; j++) {
          const double expected = i == j ? deviation[i] * deviation[i] : 0.;
          const double error = deviation[i] * deviation[j] * std::sqrt((i == j ? 2. : 1.) / count);
          CHECK(std::abs(products(i, j) / count - expected) < 4.5 * error);
        }
      }
    }
  }
}

TEST_CASE("A start from several poses shares the particles out", "[particles]")
{
  vpPoseParticleFilter filter(settingsOf(100));
  const vpHomogeneousMatrix other(-1., 0., 2., 0., 0., 0.);
  filter.start({cMo, other, cMo}, {1., 3., 0.}, startNoise);
  CHECK(filter.size() == 100);
  std::size_t near = 0;
  for (std::size_t i = 0; i < 100; i++) {
    near += std::abs(filter.pose(i)[0][3] + 1.) < 0.1;
  }
  CHECK(near == 75);
  vpPoseModes finder(0.06, 0.2);
  const std::vector<vpPoseMode> modes = filter.modes(finder);
  REQUIRE(modes.size() >= 2);
  CHECK(modes[0].mass == Approx(0.75).epsilon(0.1));
  CHECK(maxDifference(modes[0].cMo, other) < 0.02);
  CHECK(std::abs(filter.mean()[0][3] - (0.25 * 0.1 - 0.75)) < 0.01); // Where no particle is.
}

TEST_CASE("Mean and covariance are those of the weighted particles", "[particles]")
{
  vpPoseParticleFilter filter(settingsOf(50));
  filter.start(cMo, startNoise);
  filter.weigh(logLikelihoods(filter));
  std::vector<vpHomogeneousMatrix> poses;
  for (std::size_t i = 0; i < filter.size(); i++) {
    poses.push_back(filter.pose(i));
  }
  const vpHomogeneousMatrix mean = vpPoseMean::weighted(poses, filter.weights());
  CHECK(maxDifference(filter.mean(), mean) < 1e-15);
  vpPoseMatrix6 sum = vpPoseMatrix6::Zero();
  for (std::size_t i = 0; i < filter.size(); i++) {
    const vpPoseTangent alpha = vpPoseExponential::log(mean.inverse() * poses[i]);
    sum += filter.weights()[i] * alpha * alpha.transpose();
  }
  CHECK((filter.covariance() - sum).cwiseAbs().maxCoeff() < 1e-12);
}

// f and g from vpPoseNoise, as [T10] eq. 8-9 would have them with g as the density of the union.
TEST_CASE("The number of particles may change", "[particles]")
{
  vpPoseParticleFilter filter(settingsOf(100));
  filter.start(cMo, startNoise);
  filter.predict(0.03);
  filter.weigh(logLikelihoods(filter));
  const vpHomogeneousMatrix mean = filter.mean();
  filter.setNumber(1000);
  CHECK(filter.size() == 1000);
  CHECK(filter.effectiveSize() == Approx(1000.));
  CHECK(maxDifference(filter.mean(), mean) < 2e-3);
  filter.setNumber(7);
  CHECK(filter.size() == 7);
  filter.predict(0.03);
  CHECK(filter.weigh(logLikelihoods(filter)) > -infinity);
  CHECK_THROWS_WITH(filter.setNumber(0), ContainsSubstring("number"));
  CHECK(filter.size() == 7);
}

TEST_CASE("Rotations stay rotations over a long time", "[particles]")
{
  vpPoseParticleFilter filter(settingsOf(2));
  filter.start(cMo, startNoise);
  for (int i = 0; i < 20000; i++) {
    filter.predict(0.03);
  }
  const Eigen::Matrix3d rotation = vpPoseExponential::toEigen(filter.pose(0)).linear();
  CHECK((rotation * rotation.transpose() - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff() < 1e-14);
}

TEST_CASE("Steps in the wrong order and values out of range are refused", "[particles]")
{
  vpPoseParticleFilter filter(settingsOf(5));
  CHECK_FALSE(filter.isStarted());
  CHECK_THROWS_WITH(filter.predict(0.03), ContainsSubstring("start()"));
  CHECK_THROWS_WITH(filter.weigh({}), ContainsSubstring("start()"));
  CHECK_THROWS_WITH(filter.resample(), ContainsSubstring("start()"));
  CHECK_THROWS_WITH(filter.mean(), ContainsSubstring("start()"));
  CHECK_THROWS_AS(filter.start({}, {}, startNoise), vpException);
  CHECK_THROWS_AS(filter.start({cMo}, {1., 2.}, startNoise), vpException);
  CHECK_THROWS_AS(filter.start({cMo}, {0.}, startNoise), vpException);
  vpHomogeneousMatrix bad = cMo;
  bad[0][3] = notANumber;
  CHECK_THROWS_AS(filter.start(bad, startNoise), vpException);
  CHECK_FALSE(filter.isStarted());

  filter.start(cMo, startNoise);
  CHECK_THROWS_WITH(filter.predict(-1.), ContainsSubstring("-1"));
  CHECK_THROWS_AS(filter.predict(notANumber), vpException);
  CHECK_THROWS_WITH(filter.predict(0.03, bad), ContainsSubstring("motion"));
  CHECK_NOTHROW(filter.predict(0.));
  CHECK_THROWS_WITH(filter.propose({cMo}), ContainsSubstring("weigh()"));
  CHECK_THROWS_WITH(filter.weigh({1., 2.}), ContainsSubstring("2 likelihoods for 5"));
  filter.weigh(std::vector<double>(5, 0.));
  CHECK_THROWS_WITH(filter.weighProposals({}), ContainsSubstring("propose()"));
  CHECK_THROWS_WITH(filter.propose({cMo, bad}), ContainsSubstring("finite"));
  filter.propose({cMo});
  CHECK_THROWS_WITH(filter.propose({cMo}), ContainsSubstring("once"));
  CHECK_THROWS_WITH(filter.weigh(std::vector<double>(5, 0.)), ContainsSubstring("before propose()"));
  CHECK_THROWS_WITH(filter.predict(0.03), ContainsSubstring("resample()"));
  CHECK_THROWS_WITH(filter.weighProposals({}), ContainsSubstring("0 likelihoods for 1"));
  CHECK_NOTHROW(filter.weighProposals({0.}));
  filter.resample();
  CHECK_NOTHROW(filter.predict(0.03));
  filter.weigh(std::vector<double>(5, 0.));
  filter.propose({});
  CHECK(filter.weighProposals({}) == Approx(0.).margin(1e-12));
  filter.reset();
  CHECK_FALSE(filter.isStarted());
}

TEST_CASE("Particle settings out of range are named", "[particles]")
{
  const auto check = [](const char *name, void (*spoil)(vpPoseParticleSettings &)) {
    vpPoseParticleSettings settings;
    spoil(settings);
    CHECK_THROWS_WITH(settings.check(), ContainsSubstring(name));
    CHECK_THROWS_WITH(vpPoseParticleFilter(settings), ContainsSubstring(name));
  };
  check("number", [](vpPoseParticleSettings &s) { s.number = 0; });
  check("translationNoise", [](vpPoseParticleSettings &s) { s.translationNoise = 0.; });
  check("rotationNoise", [](vpPoseParticleSettings &s) { s.rotationNoise = -1.; });
  check("noiseTime", [](vpPoseParticleSettings &s) { s.noiseTime = notANumber; });
  check("noiseGrowth", [](vpPoseParticleSettings &s) { s.noiseGrowth = 2.; });
  check("proposalSpread", [](vpPoseParticleSettings &s) { s.proposalSpread = infinity; });
}
