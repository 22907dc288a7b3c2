// SPDX-License-Identifier: GPL-2.0-or-later
#include <visp3/se3/vpPoseResampling.h>

#include <visp3/se3/vpPoseRandom.h>

#include <visp3/core/vpException.h>

#include <catchMain.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace {
const double infinity = std::numeric_limits<double>::infinity();
const double notANumber = std::numeric_limits<double>::quiet_NaN();

std::vector<std::size_t> copiesOf(const std::vector<double> &weights, std::size_t count, double shift)
{
  std::vector<std::size_t> picks;
  vpPoseResampling::systematic(weights, count, shift, picks);
  CHECK(picks.size() == count);
  CHECK(std::is_sorted(picks.begin(), picks.end()));
  std::vector<std::size_t> copies(weights.size(), 0);
  for (const std::size_t pick : picks) {
    copies.at(pick)++;
  }
  return copies;
}
} // namespace

TEST_CASE("Logarithms of any size become weights", "[resampling]")
{
  std::vector<double> weights;
  CHECK(vpPoseResampling::normalise({std::log(1.), std::log(3.)}, weights) == Approx(std::log(4.)));
  CHECK(weights[0] == Approx(0.25));
  CHECK(weights[1] == Approx(0.75));
  for (const double offset : {-1e6, 1e6}) {
    CHECK(vpPoseResampling::normalise({offset, offset + std::log(4.), -infinity}, weights) ==
          Approx(offset + std::log(5.)));
    CHECK(weights[0] == Approx(0.2));
    CHECK(weights[1] == Approx(0.8));
    CHECK(weights[2] == exactly(0.));
  }
}

TEST_CASE("Likelihoods that failed get out as weights of 0", "[resampling]")
{
  std::vector<double> weights;
  CHECK(vpPoseResampling::normalise({notANumber, 2., infinity, -infinity, 2.}, weights) == Approx(2. + std::log(2.)));
  CHECK(weights == std::vector<double>{0., 0.5, 0., 0., 0.5});
  for (const double bad : {notANumber, infinity, -infinity}) {
    CHECK(vpPoseResampling::normalise({bad, bad, bad, bad}, weights) == exactly(-infinity));
    CHECK(weights == std::vector<double>(4, 0.25));
  }
  CHECK(vpPoseResampling::normalise({}, weights) == exactly(-infinity));
  CHECK(weights.empty());
}

TEST_CASE("The effective size counts the weights that matter", "[resampling]")
{
  CHECK(vpPoseResampling::effectiveSize({}) == exactly(0.));
  CHECK(vpPoseResampling::effectiveSize({0., 0.}) == exactly(0.));
  CHECK(vpPoseResampling::effectiveSize({0., 3., 0.}) == Approx(1.));
  CHECK(vpPoseResampling::effectiveSize({2., 2., 2., 0.}) == Approx(3.));
  CHECK(vpPoseResampling::effectiveSize({1e-200, 1e-200}) == Approx(2.));
  CHECK(vpPoseResampling::effectiveSize({1., 3.}) == Approx(1.6));
}

TEST_CASE("Systematic resampling has known answers", "[resampling]")
{
  CHECK(copiesOf({1., 2., 1.}, 4, 0.5) == std::vector<std::size_t>{1, 2, 1});
  CHECK(copiesOf({1., 2., 1.}, 4, 0.) == std::vector<std::size_t>{1, 2, 1});
  CHECK(copiesOf({0., 1., 0., 1., 0.}, 6, 0.9) == std::vector<std::size_t>{0, 3, 0, 3, 0});
  CHECK(copiesOf({0.5, 0.5}, 1, 0.4) == std::vector<std::size_t>{1, 0});
  CHECK(copiesOf({0.5, 0.5}, 1, 0.6) == std::vector<std::size_t>{0, 1});
  CHECK(copiesOf({1.}, 0, 0.) == std::vector<std::size_t>{0});
}

TEST_CASE("Copies are the share of the weight, rounded down or up", "[resampling]")
{
  for (unsigned int run = 0; run < 200; run++) {
    vpPoseRandom random(1, {run});
    std::vector<double> weights(1 + random.index(200));
    for (double &weight : weights) {
      weight = random.index(3) == 0 ? 0. : std::exp(3. * random.normal());
    }
    weights.back() += 1e-3;
    const double sum = std::accumulate(weights.begin(), weights.end(), 0.);
    const std::size_t count = 1 + random.index(300);
    const std::vector<std::size_t> copies = copiesOf(weights, count, random.uniform());
    for (std::size_t i = 0; i < weights.size(); i++) {
      const double share = static_cast<double>(count) * weights[i] / sum;
      CHECK(static_cast<double>(copies[i]) >= std::floor(share - 1e-9));
      CHECK(static_cast<double>(copies[i]) <= std::ceil(share + 1e-9));
      CHECK((weights[i] > 0. || copies[i] == 0));
    }
  }
}

// Each single pick of a set is at its place with a probability that the shift alone decides; over many shifts, picks
// one by one have to follow the weights.
TEST_CASE("Picks follow the weights", "[resampling]")
{
  std::vector<double> weights(51);
  for (std::size_t i = 0; i < weights.size(); i++) {
    weights[i] = 1. + static_cast<double>(i % 7);
  }
  const double sum = std::accumulate(weights.begin(), weights.end(), 0.);
  const unsigned int draws = 100000;
  std::vector<double> single(weights.size(), 0.);
  std::vector<double> ofTwenty(weights.size(), 0.);
  std::vector<std::size_t> picks;
  for (unsigned int i = 0; i < draws; i++) {
    vpPoseRandom random(2, {i});
    vpPoseResampling::systematic(weights, 1, random.uniform(), picks);
    single[picks[0]]++;
    vpPoseResampling::systematic(weights, 20, random.uniform(), picks);
    ofTwenty[picks[random.index(20)]]++;
  }
  for (const std::vector<double> *counts : {&single, &ofTwenty}) {
    double chiSquare = 0.;
    for (std::size_t i = 0; i < weights.size(); i++) {
      const double expected = draws * weights[i] / sum;
      chiSquare += ((*counts)[i] - expected) * ((*counts)[i] - expected) / expected;
    }
    CHECK(chiSquare < 86.7); // Exceeded once in a thousand times with 50 degrees of freedom.
    CHECK(chiSquare > 24.);  // And not reached as often.
  }
}

TEST_CASE("Weights and shifts out of range are refused", "[resampling]")
{
  std::vector<std::size_t> picks;
  CHECK_THROWS_AS(vpPoseResampling::systematic({}, 3, 0.5, picks), vpException);
  CHECK_THROWS_AS(vpPoseResampling::systematic({0., 0.}, 3, 0.5, picks), vpException);
  CHECK_THROWS_WITH(vpPoseResampling::systematic({1., -2.}, 3, 0.5, picks), ContainsSubstring("-2"));
  CHECK_THROWS_AS(vpPoseResampling::systematic({1., notANumber}, 3, 0.5, picks), vpException);
  CHECK_THROWS_AS(vpPoseResampling::systematic({1., infinity}, 3, 0.5, picks), vpException);
  CHECK_THROWS_AS(vpPoseResampling::systematic({1.}, 3, 1., picks), vpException);
  CHECK_THROWS_AS(vpPoseResampling::systematic({1.}, 3, notANumber, picks), vpException);
}
