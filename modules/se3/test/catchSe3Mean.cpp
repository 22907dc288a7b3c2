// SPDX-License-Identifier: GPL-2.0-or-later
#include <visp3/se3/vpPoseMean.h>

#include <visp3/core/vpException.h>

#include <catchMain.h>
#include <poseSamples.h>

#include <limits>

namespace {
vpHomogeneousMatrix rotated(double x, double y, double z)
{
  return vpPoseExponential::exp(tangentOf({0., 0., 0.}, {x, y, z}));
}

std::vector<vpHomogeneousMatrix> randomPoses(double scale)
{
  std::vector<vpHomogeneousMatrix> poses;
  vpPoseRandom random(1);
  for (int i = 0; i < 20; i++) {
    poses.push_back(vpPoseExponential::exp(scale * random.normalTangent()));
  }
  return poses;
}

std::vector<double> randomWeights()
{
  std::vector<double> weights;
  vpPoseRandom random(2);
  for (int i = 0; i < 20; i++) {
    weights.push_back(random.uniform());
  }
  return weights;
}

double weightedSquaredDistance(const std::vector<vpHomogeneousMatrix> &poses, const std::vector<double> &weights,
                               const vpHomogeneousMatrix &pose)
{
  double sum = 0.;
  for (std::size_t i = 0; i < poses.size(); i++) {
    const Eigen::Matrix3d rotation = vpPoseExponential::toEigen(poses[i]).linear();
    sum += weights[i] * (rotation - vpPoseExponential::toEigen(pose).linear()).squaredNorm();
  }
  return sum;
}
} // namespace

TEST_CASE("The mean of one pose is that pose", "[mean]")
{
  for (const vpPoseTangent &xi : awkwardTangents()) {
    const vpHomogeneousMatrix pose = vpPoseExponential::exp(xi);
    CHECK(maxDifference(vpPoseMean::weighted({pose}, {0.3}), pose) < 1e-14);
    CHECK(maxDifference(vpPoseMean::weighted({pose, pose, vpHomogeneousMatrix()}, {1., 2., 0.}), pose) < 1e-14);
  }
}

TEST_CASE("Rotations about one axis have the mean of unit complex numbers", "[mean]")
{
  const std::vector<double> angles = {0.3, 1.5, -2.};
  const std::vector<double> weights = {0.5, 2., 0.25};
  std::vector<vpHomogeneousMatrix> poses;
  double sine = 0., cosine = 0.;
  for (std::size_t i = 0; i < angles.size(); i++) {
    poses.push_back(rotated(0., 0., angles[i]));
    sine += weights[i] * std::sin(angles[i]);
    cosine += weights[i] * std::cos(angles[i]);
  }
  const vpHomogeneousMatrix expected = rotated(0., 0., std::atan2(sine, cosine));
  CHECK(maxDifference(vpPoseMean::weighted(poses, weights), expected) < 1e-14);
}

TEST_CASE("Translations have the weighted mean", "[mean]")
{
  const std::vector<vpHomogeneousMatrix> poses = {vpHomogeneousMatrix(1., 0., 4., 0., 0., 0.),
                                                  vpHomogeneousMatrix(0., 2., 8., 0.1, 0., 0.)};
  const vpHomogeneousMatrix mean = vpPoseMean::weighted(poses, {3., 1.});
  CHECK(mean[0][3] == Approx(0.75));
  CHECK(mean[1][3] == Approx(0.5));
  CHECK(mean[2][3] == Approx(5.));
}

TEST_CASE("The mean of half turns is a rotation though the determinant is negative", "[mean]")
{
  const std::vector<vpHomogeneousMatrix> halfTurns = {rotated(M_PI, 0., 0.), rotated(0., M_PI, 0.),
                                                      rotated(0., 0., M_PI)};
  // The mean matrix is diag(-0.2, -0.3, -0.5). Of the rotations, diag(1, -1, -1) has the largest product with it.
  CHECK(maxDifference(vpPoseMean::weighted(halfTurns, {0.4, 0.35, 0.25}), halfTurns[0]) < 1e-14);
  // Here it is diag(0, -0.4, -0.6), without a sign of the determinant.
  CHECK(maxDifference(vpPoseMean::weighted(halfTurns, {0.5, 0.3, 0.2}), halfTurns[0]) < 1e-14);
}

TEST_CASE("Two poses half a turn apart have a rotation as mean, whichever", "[mean]")
{
  const vpHomogeneousMatrix mean = vpPoseMean::weighted({vpHomogeneousMatrix(), rotated(0., 0., M_PI)}, {1., 1.});
  CHECK(mean.isAnHomogeneousMatrix());
  CHECK(std::abs(mean[2][2]) == Approx(1.));
}

TEST_CASE("The mean has the least weighted squared distance", "[mean]")
{
  const std::vector<vpHomogeneousMatrix> poses = randomPoses(1.5);
  const std::vector<double> weights = randomWeights();
  const vpHomogeneousMatrix mean = vpPoseMean::weighted(poses, weights);
  const double least = weightedSquaredDistance(poses, weights, mean);
  vpPoseRandom random(3);
  for (int i = 0; i < 200; i++) {
    const vpHomogeneousMatrix other = mean * vpPoseExponential::exp(random.uniform() * random.normalTangent());
    CHECK(weightedSquaredDistance(poses, weights, other) > least);
  }
}

TEST_CASE("The mean moves with the frames and does not depend on the weights' sum", "[mean]")
{
  std::vector<vpHomogeneousMatrix> poses = randomPoses(0.4);
  std::vector<double> weights = randomWeights();
  const vpHomogeneousMatrix mean = vpPoseMean::weighted(poses, weights);
  const vpHomogeneousMatrix aMb(0.1, 0.2, 0.3, 1., -2., 0.5);
  const vpHomogeneousMatrix turned = rotated(0.3, 2., -1.);
  for (std::size_t i = 0; i < poses.size(); i++) {
    poses[i] = aMb * poses[i] * turned;
    weights[i] *= 1e-200;
  }
  CHECK(maxDifference(vpPoseMean::weighted(poses, weights), aMb * mean * turned) < 1e-13);
}

TEST_CASE("The mean with equal weights is ViSP's", "[mean]")
{
  const std::vector<vpHomogeneousMatrix> poses = randomPoses(0.3);
  const vpHomogeneousMatrix mean = vpPoseMean::weighted(poses, std::vector<double>(poses.size(), 1.));
  CHECK(maxDifference(mean, vpHomogeneousMatrix::mean(poses)) < 1e-13);
}

TEST_CASE("What has no mean is refused", "[mean]")
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  const vpHomogeneousMatrix pose;
  vpHomogeneousMatrix broken;
  broken[0][3] = nan;
  CHECK_THROWS_AS(vpPoseMean::weighted({}, {}), vpException);
  CHECK_THROWS_AS(vpPoseMean::weighted({pose}, {}), vpException);
  CHECK_THROWS_AS(vpPoseMean::weighted({pose, pose}, {0., 0.}), vpException);
  CHECK_THROWS_AS(vpPoseMean::weighted({pose, pose}, {2., -1.}), vpException);
  CHECK_THROWS_AS(vpPoseMean::weighted({pose, pose}, {1., nan}), vpException);
  CHECK_THROWS_AS(vpPoseMean::weighted({pose, pose}, {1., infinity}), vpException);
  CHECK_THROWS_AS(vpPoseMean::weighted({pose, broken}, {1., 1.}), vpException);
}
