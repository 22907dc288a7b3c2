// SPDX-License-Identifier: GPL-2.0-or-later
#include <visp3/se3/vpPoseModes.h>

#include <visp3/se3/vpPoseMean.h>
#include <visp3/se3/vpPoseNoise.h>

#include <visp3/core/vpException.h>

#include <catchMain.h>
#include <poseSamples.h>

#include <algorithm>
#include <limits>

namespace {
const vpHomogeneousMatrix cMo(0.1, -0.05, 0.8, 0.5, -1.2, 2.);
const vpHomogeneousMatrix farther(0.22, -0.05, 0.8, 0.5, -1.2, 2.);
const vpHomogeneousMatrix turned = cMo * vpHomogeneousMatrix(0., 0., 0., 0., 0.5, 0.);

struct Samples
{
  std::vector<vpHomogeneousMatrix> poses;
  std::vector<double> weights;
};

// 60 poses each about the places given, with the masses given: deviations of 1 cm and 0.03 rad.
Samples samplesOf(const std::vector<vpHomogeneousMatrix> &places, const std::vector<double> &masses)
{
  const vpPoseNoise noise = vpPoseNoise::isotropic(0.01, 0.03);
  Samples samples;
  for (unsigned int i = 0; i < 60 * places.size(); i++) {
    vpPoseRandom random(8, {i});
    const std::size_t place = i % places.size();
    samples.poses.push_back(noise.draw(places[place], random));
    samples.weights.push_back(masses[place] / 60. * (0.5 + random.uniform()));
  }
  return samples;
}

std::vector<vpPoseMode> modesOf(const Samples &samples, double leastMass = 0.05)
{
  return vpPoseModes(0.04, 0.12).find(samples.poses.data(), samples.weights.data(), samples.poses.size(), leastMass);
}
} // namespace

TEST_CASE("Places that differ in translation or in rotation are modes", "[modes]")
{
  const std::vector<vpHomogeneousMatrix> places = {cMo, farther, turned};
  const std::vector<double> masses = {2., 5., 3.};
  const std::vector<vpPoseMode> modes = modesOf(samplesOf(places, masses));
  REQUIRE(modes.size() == 3);
  const std::vector<std::size_t> order = {1, 2, 0};
  double mass = 0.;
  for (std::size_t i = 0; i < 3; i++) {
    const vpPoseTangent error = vpPoseExponential::log(places[order[i]].inverse() * modes[i].cMo);
    CHECK(error.head<3>().norm() < 0.005);
    CHECK(error.tail<3>().norm() < 0.015);
    CHECK(modes[i].mass == Approx(masses[order[i]] / 10.).epsilon(0.1));
    CHECK(modes[i].count >= 55);
    CHECK(modes[i].peak % 3 == order[i]);
    mass += modes[i].mass;
  }
  CHECK(mass > 0.97);
  CHECK(mass < 1. + 1e-12);
}

TEST_CASE("Where poses gather in one place, the mode is their mean and covariance", "[modes]")
{
  const Samples samples = samplesOf({cMo}, {7.});
  const std::vector<vpPoseMode> modes =
      vpPoseModes(0.2, 0.6).find(samples.poses.data(), samples.weights.data(), samples.poses.size());
  REQUIRE(modes.size() == 1);
  CHECK(modes[0].mass == Approx(1.));
  CHECK(modes[0].count == 60);
  CHECK(maxDifference(modes[0].cMo, vpPoseMean::weighted(samples.poses, samples.weights)) < 1e-15);
  vpPoseMatrix6 sum = vpPoseMatrix6::Zero();
  double total = 0.;
  for (std::size_t i = 0; i < samples.poses.size(); i++) {
    const vpPoseTangent alpha = vpPoseExponential::log(modes[0].cMo.inverse() * samples.poses[i]);
    sum += samples.weights[i] * alpha * alpha.transpose();
    total += samples.weights[i];
  }
  CHECK((modes[0].covariance - sum / total).cwiseAbs().maxCoeff() < 1e-12);
  CHECK(std::sqrt(modes[0].covariance(0, 0)) == Approx(0.01).epsilon(0.25));
  CHECK(std::sqrt(modes[0].covariance(4, 4)) == Approx(0.03).epsilon(0.25));
}

TEST_CASE("The mean of two modes is no mode", "[modes]")
{
  const Samples samples = samplesOf({cMo, farther}, {1., 1.1});
  const vpHomogeneousMatrix mean = vpPoseMean::weighted(samples.poses, samples.weights);
  CHECK(std::abs(mean[0][3] - 0.16) < 0.01);
  CHECK(std::abs(modesOf(samples).front().cMo[0][3] - 0.22) < 0.005);
}

TEST_CASE("The order of the poses and poses of weight 0 do not matter", "[modes]")
{
  Samples samples = samplesOf({cMo, farther, turned}, {2., 5., 3.});
  const std::vector<vpPoseMode> modes = modesOf(samples, 0.);
  std::reverse(samples.poses.begin(), samples.poses.end());
  std::reverse(samples.weights.begin(), samples.weights.end());
  for (unsigned int i = 0; i < 20; i++) { // A bridge between two modes.
    samples.poses.emplace_back(0.1 + 0.006 * i, -0.05, 0.8, 0.5, -1.2, 2.);
    samples.weights.push_back(0.);
  }
  const std::vector<vpPoseMode> others = modesOf(samples, 0.);
  REQUIRE(modes.size() == others.size());
  for (std::size_t i = 0; i < modes.size(); i++) {
    CHECK(modes[i].mass == Approx(others[i].mass));
    CHECK(modes[i].count == others[i].count);
    CHECK(maxDifference(modes[i].cMo, others[i].cMo) < 1e-12);
  }
}

TEST_CASE("The same pose many times is one mode, the lower index its peak", "[modes]")
{
  const std::vector<vpHomogeneousMatrix> poses(5, cMo);
  const std::vector<double> weights = {0., 1., 1., 1., 1.};
  const std::vector<vpPoseMode> modes = vpPoseModes(0.01, 0.01).find(poses.data(), weights.data(), 5);
  REQUIRE(modes.size() == 1);
  CHECK(modes[0].peak == 1);
  CHECK(modes[0].count == 4);
  CHECK(modes[0].covariance.cwiseAbs().maxCoeff() < 1e-20);
}

TEST_CASE("Light modes are left out, but never all", "[modes]")
{
  const Samples samples = samplesOf({cMo, farther}, {1., 20.});
  CHECK(modesOf(samples, 0.2).size() == 1);
  CHECK(modesOf(samples, 1.).size() == 1);
  CHECK(modesOf(samples, 0.02).size() >= 2);
}

TEST_CASE("Modes of nothing are refused", "[modes]")
{
  const double notANumber = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_AS(vpPoseModes(0., 1.), vpException);
  CHECK_THROWS_WITH(vpPoseModes(1., -2.), ContainsSubstring("rotation"));
  CHECK_THROWS_AS(vpPoseModes(notANumber, 1.), vpException);
  vpPoseModes modes(0.1, 0.1);
  for (const std::vector<double> &weights :
       std::vector<std::vector<double>>{{}, {0.}, {-1., 2.}, {notANumber, 1.}, {1., INFINITY}}) {
    const std::vector<vpHomogeneousMatrix> poses(weights.size(), cMo);
    CHECK_THROWS_AS(modes.find(poses.data(), weights.data(), poses.size()), vpException);
  }
}
