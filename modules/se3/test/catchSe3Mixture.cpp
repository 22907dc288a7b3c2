// SPDX-License-Identifier: GPL-2.0-or-later
#include <visp3/se3/vpPoseMixture.h>

#include <visp3/core/vpException.h>

#include <countAllocations.h>

#include <catchMain.h>
#include <poseSamples.h>

#include <limits>
#include <vector>

using countAllocations::allocations;

namespace {
const vpHomogeneousMatrix cMo(0.1, -0.05, 0.8, 0.5, -1.2, 2.);

vpPoseMatrix6 correlatedCovariance()
{
  vpPoseMatrix6 mixing = 0.3 * vpPoseMatrix6::Ones();
  mixing.diagonal() << 1., -1., 1.5, 1., 2., -1.5;
  vpPoseTangent scale;
  scale << 0.02, 0.02, 0.02, 0.05, 0.05, 0.05;
  return scale.asDiagonal() * mixing * mixing.transpose() * scale.asDiagonal();
}

// One direction is known a thousand times better than the others.
vpPoseMatrix6 thinCovariance()
{
  vpPoseTangent deviation;
  deviation << 2e-5, 0.02, 0.02, 0.05, 0.05, 0.05;
  const vpPoseMatrix6 turn = vpPoseExponential::adjoint(vpHomogeneousMatrix(0.01, 0.02, 0., 0.3, 0.2, 0.1));
  const vpPoseMatrix6 covariance = turn * deviation.cwiseAbs2().asDiagonal() * turn.transpose();
  return 0.5 * (covariance + covariance.transpose());
}

std::vector<vpPoseNoise> kernels()
{
  std::vector<vpPoseNoise> list;
  for (const vpPoseNoise::Frame frame : {vpPoseNoise::Frame::OBJECT, vpPoseNoise::Frame::CAMERA}) {
    list.push_back(vpPoseNoise::isotropic(0.01, 0.03, frame));
    list.push_back(vpPoseNoise::isotropic(0.05, 0.7, frame));
    list.push_back(vpPoseNoise::isotropic(0.01, 3., frame)); // Wider than half a turn: the angle bounds nothing.
    list.emplace_back(correlatedCovariance(), frame);
    list.emplace_back(thinCovariance(), frame);
  }
  return list;
}

struct Samples
{
  std::vector<vpHomogeneousMatrix> means;
  std::vector<double> weights;
  std::vector<vpHomogeneousMatrix> poses;
};

// Means in three places, and poses near them, between them and far from all of them.
Samples samplesOf(const vpPoseNoise &kernel)
{
  Samples samples;
  const vpPoseMatrix6 wide = 4. * kernel.covariance();
  const vpPoseNoise spread(wide, kernel.frame());
  for (unsigned int i = 0; i < 60; i++) {
    vpPoseRandom random(3, {i});
    vpPoseTangent apart = vpPoseTangent::Zero();
    apart[0] = 0.3 * (i % 3);
    apart[4] = 0.5 * (i % 3);
    samples.means.push_back(spread.draw(cMo * vpPoseExponential::exp(apart), random));
    samples.weights.push_back(i == 7 ? 0. : random.uniform());
    samples.poses.push_back(spread.draw(samples.means.back(), random));
  }
  samples.poses.push_back(samples.means[0]);
  samples.poses.emplace_back(0.2, 0., 0.8, 0.5, -1.2, 2.);
  samples.poses.emplace_back(5., 0., -10., -2., 1.2, 0.1);
  return samples;
}

vpPoseMixture mixtureOf(const vpPoseNoise &kernel, const Samples &samples, double relativeError)
{
  vpPoseMixture mixture(kernel, relativeError);
  for (std::size_t i = 0; i < samples.means.size(); i++) {
    mixture.add(samples.means[i], samples.weights[i]);
  }
  mixture.prepare();
  return mixture;
}

double directSum(const vpPoseNoise &kernel, const Samples &samples, const vpHomogeneousMatrix &pose)
{
  std::vector<double> terms;
  double total = 0.;
  for (std::size_t i = 0; i < samples.means.size(); i++) {
    total += samples.weights[i];
    terms.push_back(std::log(samples.weights[i]) + kernel.logDensity(pose, samples.means[i]));
  }
  const double largest = *std::max_element(terms.begin(), terms.end());
  double sum = 0.;
  for (const double term : terms) {
    sum += std::exp(term - largest);
  }
  return largest + std::log(sum / total);
}
} // namespace

TEST_CASE("A mixture is the sum of its kernels, to within the error asked for", "[mixture]")
{
  for (const vpPoseNoise &kernel : kernels()) {
    const Samples samples = samplesOf(kernel);
    for (const double error : {1e-13, 1e-3, 0.3}) {
      const vpPoseMixture mixture = mixtureOf(kernel, samples, error);
      CHECK(mixture.size() == 59);
      for (const vpHomogeneousMatrix &pose : samples.poses) {
        const double direct = directSum(kernel, samples, pose);
        CAPTURE(kernel.covariance()(0, 0), kernel.covariance()(3, 3), error, direct);
        const double rounding = 1e-9 + 1e-9 * std::abs(direct); // Thin kernels have exponents of 1e6.
        CHECK(mixture.logDensity(pose) < direct + rounding);
        CHECK(mixture.logDensity(pose) > direct - std::log1p(error) - rounding);
      }
    }
  }
}

TEST_CASE("A mixture of one kernel is the kernel", "[mixture]")
{
  for (const vpPoseNoise &kernel : kernels()) {
    vpPoseMixture mixture(kernel);
    mixture.add(cMo, 0.01);
    mixture.prepare();
    CHECK(mixture.logDensity(cMo) == Approx(kernel.logPeak()).epsilon(1e-12));
    for (const vpPoseTangent &xi : awkwardTangents()) {
      if (xi.tail<3>().norm() < 3.1 && kernel.covariance()(0, 0) > 1e-5) {
        const vpHomogeneousMatrix pose = cMo * vpPoseExponential::exp(xi);
        CHECK(mixture.logDensity(pose) == Approx(kernel.logDensity(pose, cMo)).epsilon(1e-8));
      }
    }
  }
}

// The mean of p / q over draws of q is the integral of p.
TEST_CASE("A mixture integrates to one", "[mixture]")
{
  const unsigned int drawCount = 20000;
  const vpPoseNoise wide = vpPoseNoise::isotropic(0.2, 0.6);
  for (const vpPoseNoise::Frame frame : {vpPoseNoise::Frame::OBJECT, vpPoseNoise::Frame::CAMERA}) {
    vpPoseMixture mixture(vpPoseNoise::isotropic(0.12, 0.35, frame));
    mixture.add(vpHomogeneousMatrix(0.1, 0.05, -0.02, 0., 0.4, 0.), 3.);
    mixture.add(vpHomogeneousMatrix(-0.1, 0.05, 0., 0., -0.4, 0.2), 5.);
    mixture.prepare();
    double sum = 0., squares = 0.;
    for (unsigned int i = 0; i < drawCount; i++) {
      vpPoseRandom random(5, {i});
      const vpHomogeneousMatrix pose = wide.draw(vpHomogeneousMatrix(), random);
      const double ratio = std::exp(mixture.logDensity(pose) - wide.logDensity(pose, vpHomogeneousMatrix()));
      sum += ratio;
      squares += ratio * ratio;
    }
    const double mean = sum / drawCount;
    const double error = std::sqrt((squares / drawCount - mean * mean) / drawCount);
    CAPTURE(mean, error);
    CHECK(error < 0.02);
    CHECK(std::abs(mean - 1.) < 3. * error);
  }
}

TEST_CASE("Kernels that are far away cost nothing", "[mixture]")
{
  const unsigned int count = 400;
  for (const vpPoseNoise::Frame frame : {vpPoseNoise::Frame::OBJECT, vpPoseNoise::Frame::CAMERA}) {
    const vpPoseNoise kernel = vpPoseNoise::isotropic(0.01, 0.03, frame);
    Samples samples;
    for (unsigned int i = 0; i < count; i++) {
      vpPoseRandom random(6, {i});
      // Along any axis, in any order.
      const double place = 0.1 * ((i * 37) % count);
      samples.means.emplace_back(0.1, frame == vpPoseNoise::Frame::OBJECT ? place : -place, 0.8, 0., 0., 0.);
      samples.weights.push_back(1.);
      samples.poses.push_back(kernel.draw(samples.means.back(), random));
    }
    const vpPoseMixture mixture = mixtureOf(kernel, samples, 1e-3);
    vpPoseMixture::Effort effort;
    for (const vpHomogeneousMatrix &pose : samples.poses) {
      CHECK(mixture.logDensity(pose, &effort) == Approx(directSum(kernel, samples, pose)).margin(1.1e-3));
    }
    CAPTURE(effort.visited, effort.evaluated);
    CHECK(effort.evaluated >= count);
    CHECK(effort.visited < 20 * count); // Of count * count.
  }
}

TEST_CASE("Copies in a row are one kernel", "[mixture]")
{
  const vpPoseNoise kernel = vpPoseNoise::isotropic(0.01, 0.03);
  Samples samples;
  vpPoseMixture mixture(kernel);
  for (unsigned int i = 0; i < 30; i++) {
    samples.means.emplace_back(0.01 * (i / 3), 0., 1., 0., 0., 0.);
    samples.weights.push_back(1. + i);
    mixture.add(samples.means.back(), samples.weights.back());
  }
  mixture.prepare();
  CHECK(mixture.size() == 10);
  const vpHomogeneousMatrix pose(0.033, 0.005, 1., 0.01, 0.02, 0.);
  CHECK(mixture.logDensity(pose) == Approx(directSum(kernel, samples, pose)).margin(1.1e-3));
}

TEST_CASE("A mixture allocates nothing after its first use", "[mixture]")
{
  const vpPoseNoise kernel = vpPoseNoise::isotropic(0.01, 0.03);
  const Samples samples = samplesOf(kernel);
  vpPoseMixture mixture = mixtureOf(kernel, samples, 1e-3);
  const std::size_t before = allocations;
  mixture.clear(kernel);
  double sum = 0.;
  for (std::size_t i = 0; i < samples.means.size(); i++) {
    mixture.add(samples.means[i], samples.weights[i]);
  }
  mixture.prepare();
  for (const vpHomogeneousMatrix &pose : samples.poses) {
    sum += mixture.logDensity(pose);
  }
  const std::size_t after = allocations;
  CHECK(after == before);
  CHECK(std::isfinite(sum));
}

TEST_CASE("A mixture without kernels has no density, and what is out of range is refused", "[mixture]")
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  const vpPoseNoise kernel = vpPoseNoise::isotropic(0.01, 0.03);
  vpPoseMixture mixture(kernel);
  mixture.prepare();
  CHECK(mixture.logDensity(cMo) == exactly(-infinity));
  mixture.add(cMo, 0.);
  CHECK(mixture.size() == 0);
  CHECK(mixture.logDensity(cMo) == exactly(-infinity));

  mixture.add(cMo);
  CHECK_THROWS_WITH(mixture.logDensity(cMo), ContainsSubstring("prepare()"));
  CHECK_THROWS_WITH(mixture.add(cMo, -1.), ContainsSubstring("-1"));
  CHECK_THROWS_AS(mixture.add(cMo, nan), vpException);
  CHECK_THROWS_AS(mixture.add(cMo, infinity), vpException);
  vpHomogeneousMatrix bad = cMo;
  bad[1][3] = nan;
  CHECK_THROWS_WITH(mixture.add(bad), ContainsSubstring("finite"));
  mixture.prepare();
  CHECK(mixture.logDensity(bad) == exactly(-infinity));
  bad[1][3] = infinity;
  CHECK(mixture.logDensity(bad) == exactly(-infinity));

  CHECK_THROWS_AS(vpPoseMixture(kernel, 0.), vpException);
  CHECK_THROWS_AS(vpPoseMixture(kernel, 1.), vpException);
  CHECK_THROWS_AS(vpPoseMixture(kernel, nan), vpException);
}
