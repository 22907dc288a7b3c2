// SPDX-License-Identifier: GPL-2.0-or-later
#include <visp3/se3/vpPoseRandom.h>

#include <visp3/core/vpException.h>

#include <catchMain.h>

#include <cmath>

namespace {
const unsigned int sampleCount = 100000;

double normalDistribution(double x)
{
  return 0.5 * std::erfc(-x / std::sqrt(2.));
}

// Pearson's statistic of numbers of [0, 1) that should be uniform: 50 is its mean, and 10 its deviation.
template <class Draw> double chiSquareOf51Bins(Draw draw)
{
  std::vector<unsigned int> bins(51, 0);
  for (unsigned int i = 0; i < sampleCount; i++) {
    bins.at(static_cast<std::size_t>(draw(i) * 51.))++;
  }
  const double expected = sampleCount / 51.;
  double sum = 0.;
  for (const unsigned int count : bins) {
    sum += (count - expected) * (count - expected) / expected;
  }
  return sum;
}

// The probability to exceed this with 50 degrees of freedom is one in a thousand.
const double chiSquareLimit = 86.7;
} // namespace

TEST_CASE("The numbers are the same on every platform", "[random]")
{
  // From a second implementation in another language, whose generator was checked against the authors' numbers.
  vpPoseRandom uniforms(1, {2, 3});
  CHECK(uniforms.uniform() == exactly(1764278285351961. / 9007199254740992.));
  vpPoseRandom normals(1, {2, 3});
  for (const double expected : {0x1.76ce74e1614d7p-1, -0x1.3befe494a5464p-3, 0x1.c506129d7f7fap-1, 0x1.9c28157adc641p-1,
                                0x1.311c33eea5816p+1, 0x1.00eaf6b771948p+0}) {
    CHECK(normals.normal() == exactly(expected));
  }
}

TEST_CASE("A stream depends on its names and on nothing else", "[random]")
{
  vpPoseRandom first(7, {1, 2});
  vpPoseRandom other(7, {1, 3});
  const double expected = first.normal();
  other.normal();
  CHECK(vpPoseRandom(7, {1, 2}).normal() == exactly(expected));

  const std::vector<vpPoseRandom> others = {
      vpPoseRandom(8, {1, 2}), vpPoseRandom(7, {2, 1}),    vpPoseRandom(7, {1, 3}), vpPoseRandom(7, {1}),
      vpPoseRandom(7),         vpPoseRandom(7, {1, 2, 0}), vpPoseRandom(7, {0, 0}), vpPoseRandom(7, {0})};
  for (std::size_t i = 0; i < others.size(); i++) {
    vpPoseRandom random = others[i];
    const double number = random.normal();
    CHECK(number != exactly(expected));
    for (std::size_t j = 0; j < i; j++) {
      CHECK(vpPoseRandom(others[j]).normal() != exactly(number));
    }
  }
}

TEST_CASE("Uniform numbers are uniform", "[random]")
{
  vpPoseRandom random(3);
  CHECK(chiSquareOf51Bins([&](unsigned int) { return random.uniform(); }) < chiSquareLimit);
  CHECK(chiSquareOf51Bins([&](unsigned int) { return static_cast<double>(random.index(51)) / 51. + 1e-9; }) <
        chiSquareLimit);
}

TEST_CASE("Normal numbers are normal, along a stream and across streams", "[random]")
{
  vpPoseRandom random(4);
  CHECK(chiSquareOf51Bins([&](unsigned int) { return normalDistribution(random.normal()); }) < chiSquareLimit);
  const auto acrossParticles = [](unsigned int i) { return normalDistribution(vpPoseRandom(5, {0, i}).normal()); };
  CHECK(chiSquareOf51Bins(acrossParticles) < chiSquareLimit);
  const auto acrossFrames = [](unsigned int i) { return normalDistribution(vpPoseRandom(5, {i, 0}).normal()); };
  CHECK(chiSquareOf51Bins(acrossFrames) < chiSquareLimit);
}

TEST_CASE("Normal numbers have the right moments, tails and no memory", "[random]")
{
  vpPoseRandom random(6);
  double sum = 0., squares = 0., fourthPowers = 0., products = 0., last = 0.;
  unsigned int beyondThree = 0;
  for (unsigned int i = 0; i < sampleCount; i++) {
    const double x = random.normal();
    sum += x;
    squares += x * x;
    fourthPowers += x * x * x * x;
    products += x * last;
    beyondThree += std::abs(x) > 3.;
    last = x;
  }
  // Four deviations of each estimate.
  const double tolerance = 4. / std::sqrt(sampleCount);
  CHECK(std::abs(sum / sampleCount) < tolerance);
  CHECK(std::abs(squares / sampleCount - 1.) < std::sqrt(2.) * tolerance);
  CHECK(std::abs(fourthPowers / sampleCount - 3.) < std::sqrt(96.) * tolerance);
  CHECK(std::abs(products / sampleCount) < tolerance);
  CHECK(std::abs(beyondThree - 0.0026998 * sampleCount) < 4. * std::sqrt(0.0026998 * sampleCount));
}

TEST_CASE("The coordinates of a normal tangent are the next six normal numbers", "[random]")
{
  vpPoseRandom random(9);
  vpPoseRandom same(9);
  for (const double coordinate : random.normalTangent()) {
    CHECK(coordinate == exactly(same.normal()));
  }
}

TEST_CASE("An index is below the count", "[random]")
{
  vpPoseRandom random(10);
  for (int i = 0; i < 100; i++) {
    CHECK(random.index(1) == 0);
    CHECK(random.index(3) < 3);
  }
  CHECK_THROWS_AS(random.index(0), vpException);
}
