// SPDX-License-Identifier: GPL-2.0-or-later
#include <visp3/se3/vpPoseNoise.h>

#include <visp3/core/vpException.h>

#include <catchMain.h>
#include <poseSamples.h>

#include <limits>

namespace {
const unsigned int drawCount = 20000;
const vpHomogeneousMatrix cMo(0.1, -0.05, 0.8, 0.5, -1.2, 2.);

// Correlated, with deviations of 2 cm to 5 cm and 0.05 rad to 0.1 rad.
vpPoseMatrix6 correlatedCovariance()
{
  vpPoseMatrix6 mixing = 0.3 * vpPoseMatrix6::Ones();
  mixing.diagonal() << 1., -1., 1.5, 1., 2., -1.5;
  vpPoseTangent scale;
  scale << 0.02, 0.02, 0.02, 0.05, 0.05, 0.05;
  return scale.asDiagonal() * mixing * mixing.transpose() * scale.asDiagonal();
}

vpPoseTangent relativeTangent(const vpHomogeneousMatrix &pose, vpPoseNoise::Frame frame)
{
  return vpPoseExponential::log(frame == vpPoseNoise::Frame::OBJECT ? cMo.inverse() * pose : pose * cMo.inverse());
}
} // namespace

TEST_CASE("The covariance of draws is the one given", "[noise]")
{
  for (const vpPoseNoise::Frame frame : {vpPoseNoise::Frame::OBJECT, vpPoseNoise::Frame::CAMERA}) {
    const vpPoseNoise noise(correlatedCovariance(), frame);
    vpPoseTangent sum = vpPoseTangent::Zero();
    vpPoseMatrix6 products = vpPoseMatrix6::Zero();
    for (unsigned int i = 0; i < drawCount; i++) {
      vpPoseRandom random(1, {i});
      const vpPoseTangent alpha = relativeTangent(noise.draw(cMo, random), frame);
      sum += alpha;
      products += alpha * alpha.transpose();
    }
    const vpPoseMatrix6 &covariance = noise.covariance();
    for (int i = 0; i < 6; i++) {
      // Four deviations of each estimate.
      CHECK(std::abs(sum[i] / drawCount) < 4. * std::sqrt(covariance(i, i) / drawCount));
      for (int j = 0; j <= i; j++) {
        const double variance = covariance(i, i) * covariance(j, j) + covariance(i, j) * covariance(i, j);
        CHECK(std::abs(products(i, j) / drawCount - covariance(i, j)) < 4. * std::sqrt(variance / drawCount));
      }
    }
  }
}

TEST_CASE("The same stream gives the same pose", "[noise]")
{
  const vpPoseNoise noise = vpPoseNoise::isotropic(0.01, 0.1);
  vpPoseRandom first(1, {2});
  vpPoseRandom second(1, {2});
  CHECK(maxDifference(noise.draw(cMo, first), noise.draw(cMo, second)) == exactly(0.));
  CHECK(maxDifference(noise.draw(cMo, first), cMo) > 0.);
}

TEST_CASE("A rotation moves the origin in the camera's frame, and not in the object's", "[noise]")
{
  const double deviation = 0.01;
  const vpPoseNoise inObject = vpPoseNoise::isotropic(1e-9, deviation);
  const vpPoseNoise inCamera = vpPoseNoise::isotropic(1e-9, deviation, vpPoseNoise::Frame::CAMERA);
  CHECK(inObject.frame() == vpPoseNoise::Frame::OBJECT);
  const vpHomogeneousMatrix far(0., 0., 10., 0.3, 0.2, 0.1);
  double squares = 0.;
  for (unsigned int i = 0; i < 2000; i++) {
    vpPoseRandom random(3, {i});
    const vpHomogeneousMatrix still = inObject.draw(far, random);
    CHECK(std::abs(still[0][3]) + std::abs(still[1][3]) + std::abs(still[2][3] - 10.) < 1e-7);
    squares += vpMath::sqr(inCamera.draw(far, random)[0][3]);
  }
  CHECK(std::sqrt(squares / 2000.) == Approx(10. * deviation).epsilon(0.06));
}

TEST_CASE("Translations of the object's frame follow the object's axes", "[noise]")
{
  vpPoseTangent variance = vpPoseTangent::Constant(1e-18);
  variance[0] = 1e-4;
  vpPoseRandom random(4);
  const vpHomogeneousMatrix drawn = vpPoseNoise(variance.asDiagonal()).draw(cMo, random);
  const Eigen::Vector3d moved =
      vpPoseExponential::toEigen(drawn).translation() - vpPoseExponential::toEigen(cMo).translation();
  CHECK(moved.norm() > 1e-4);
  CHECK(moved.normalized().cross(vpPoseExponential::toEigen(cMo).linear().col(0)).norm() < 1e-4);
}

TEST_CASE("The density has closed forms at the mean, for translations and for rotations", "[noise]")
{
  const vpPoseMatrix6 covariance = correlatedCovariance();
  const vpPoseNoise noise(covariance);
  const double peak = -3. * std::log(2. * M_PI) - 0.5 * std::log(covariance.determinant());
  CHECK(noise.logDensity(cMo, cMo) == Approx(peak).epsilon(1e-12));

  vpPoseTangent alpha = tangentOf({0.02, -0.01, 0.03}, {0., 0., 0.});
  const double translated = peak - 0.5 * alpha.dot(covariance.inverse() * alpha);
  CHECK(noise.logDensity(cMo * vpPoseExponential::exp(alpha), cMo) == Approx(translated).epsilon(1e-9));

  const double angle = 1.2;
  alpha = tangentOf({0., 0., 0.}, {0., angle, 0.});
  const double volume = 2. * std::log(2. * (1. - std::cos(angle)) / (angle * angle));
  const double rotated = -3. * std::log(2. * M_PI) - 3. * std::log(0.1 * 0.5) - 0.5 * vpMath::sqr(angle / 0.5) - volume;
  CHECK(vpPoseNoise::isotropic(0.1, 0.5).logDensity(cMo * vpPoseExponential::exp(alpha), cMo) ==
        Approx(rotated).epsilon(1e-9));
}

// The mean of p / q over draws of q is the integral of p. The means are 0.9 rad apart: densities on the coordinates
// about each mean, without the volume of exp(), would be 15 % off here.
TEST_CASE("The density integrates to one", "[noise]")
{
  const vpPoseNoise wide = vpPoseNoise::isotropic(0.15, 0.6);
  const vpHomogeneousMatrix narrowMean(0.02, 0.05, -0.02, 0., 0.9, 0.);
  for (const vpPoseNoise::Frame frame : {vpPoseNoise::Frame::OBJECT, vpPoseNoise::Frame::CAMERA}) {
    const vpPoseNoise narrow = vpPoseNoise::isotropic(0.12, 0.35, frame);
    double sum = 0., squares = 0.;
    for (unsigned int i = 0; i < drawCount; i++) {
      vpPoseRandom random(5, {i});
      const vpHomogeneousMatrix pose = wide.draw(vpHomogeneousMatrix(), random);
      const double ratio = std::exp(narrow.logDensity(pose, narrowMean) - wide.logDensity(pose, vpHomogeneousMatrix()));
      sum += ratio;
      squares += ratio * ratio;
    }
    const double mean = sum / drawCount;
    const double error = std::sqrt((squares / drawCount - mean * mean) / drawCount);
    CAPTURE(mean, error);
    CHECK(error < 0.03);
    CHECK(std::abs(mean - 1.) < 3. * error);
  }
}

TEST_CASE("A covariance that has no density is refused", "[noise]")
{
  const vpPoseMatrix6 good = correlatedCovariance();
  CHECK_NOTHROW(vpPoseNoise(good));

  vpPoseMatrix6 bad = good;
  bad(0, 4) += 1e-6;
  CHECK_THROWS_WITH(vpPoseNoise(bad), ContainsSubstring("symmetric"));
  bad = good;
  bad(2, 2) = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_WITH(vpPoseNoise(bad), ContainsSubstring("finite"));
  bad = good;
  bad(3, 3) = 0.;
  CHECK_THROWS_WITH(vpPoseNoise(bad), ContainsSubstring("variance"));
  bad = good;
  bad(0, 1) = bad(1, 0) = 1.01 * std::sqrt(good(0, 0) * good(1, 1));
  CHECK_THROWS_WITH(vpPoseNoise(bad), ContainsSubstring("positive definite"));
  bad = 1e-4 * vpPoseMatrix6::Ones();
  CHECK_THROWS_WITH(vpPoseNoise(bad), ContainsSubstring("positive definite"));

  CHECK_THROWS_AS(vpPoseNoise::isotropic(0., 0.1), vpException);
  CHECK_THROWS_AS(vpPoseNoise::isotropic(0.1, -1.), vpException);
  CHECK_THROWS_AS(vpPoseNoise::isotropic(std::numeric_limits<double>::quiet_NaN(), 0.1), vpException);
}
