// SPDX-License-Identifier: GPL-2.0-or-later
#include <visp3/se3/vpPoseExponential.h>

#include <visp3/core/vpExponentialMap.h>
#include <visp3/core/vpVelocityTwistMatrix.h>

#include <catchMain.h>
#include <poseSamples.h>

namespace {
// The series of the matrix exponential, which knows nothing of rotations.
Eigen::Matrix4d seriesOfExp(const vpPoseTangent &xi)
{
  Eigen::Matrix4d generator = Eigen::Matrix4d::Zero();
  generator.topLeftCorner<3, 3>() << 0., -xi[5], xi[4], xi[5], 0., -xi[3], -xi[4], xi[3], 0.;
  generator.topRightCorner<3, 1>() = xi.head<3>();
  Eigen::Matrix4d sum = Eigen::Matrix4d::Identity();
  Eigen::Matrix4d term = Eigen::Matrix4d::Identity();
  for (int i = 1; i < 40; i++) {
    term = term * generator / i;
    sum += term;
  }
  return sum;
}

vpColVector toVisp(const vpPoseTangent &xi)
{
  vpColVector v(6);
  for (unsigned int i = 0; i < 6; i++) {
    v[i] = xi[i];
  }
  return v;
}
} // namespace

TEST_CASE("exp is the matrix exponential and ViSP's map", "[exponential]")
{
  for (const vpPoseTangent &xi : awkwardTangents()) {
    CAPTURE(xi.transpose());
    const vpHomogeneousMatrix pose = vpPoseExponential::exp(xi);
    CHECK((vpPoseExponential::toEigen(pose).matrix() - seriesOfExp(xi)).cwiseAbs().maxCoeff() < 1e-12);
    CHECK(maxDifference(pose, vpExponentialMap::direct(toVisp(xi))) == exactly(0.));
  }
}

TEST_CASE("exp and log of Eigen's types are those of ViSP's", "[exponential]")
{
  for (const vpPoseTangent &xi : awkwardTangents()) {
    CAPTURE(xi.transpose());
    const Eigen::Isometry3d pose = vpPoseExponential::expEigen(xi);
    CHECK((pose.matrix() - seriesOfExp(xi)).cwiseAbs().maxCoeff() < 1e-12);
    CHECK((vpPoseExponential::log(pose) - xi).cwiseAbs().maxCoeff() < 1e-12);
    Eigen::Quaterniond rotation(pose.linear());
    rotation.normalize();
    CHECK((vpPoseExponential::log(rotation, pose.translation()) - xi).cwiseAbs().maxCoeff() < 1e-12);
    rotation.coeffs() *= -1.;
    CHECK((vpPoseExponential::log(rotation, pose.translation()) - xi).cwiseAbs().maxCoeff() < 1e-12);
  }
}

TEST_CASE("exp of a screw about the z axis runs along an arc", "[exponential]")
{
  const vpHomogeneousMatrix pose = vpPoseExponential::exp(tangentOf({M_PI / 2., 0., 0.1}, {0., 0., M_PI / 2.}));
  const vpHomogeneousMatrix expected(vpTranslationVector(1., 1., 0.1), vpRotationMatrix(0., 0., M_PI / 2.));
  CHECK(maxDifference(pose, expected) < 1e-15);
}

TEST_CASE("log undoes exp", "[exponential]")
{
  for (const vpPoseTangent &xi : awkwardTangents()) {
    CAPTURE(xi.transpose());
    const vpHomogeneousMatrix pose = vpPoseExponential::exp(xi);
    CHECK((vpPoseExponential::log(pose) - xi).cwiseAbs().maxCoeff() < 1e-12);
    CHECK(maxDifference(vpPoseExponential::exp(vpPoseExponential::log(pose)), pose) < 1e-12);
  }
}

TEST_CASE("log keeps the leading digits of tangents of 1e-8", "[exponential]")
{
  vpPoseRandom random(2);
  for (int i = 0; i < 20; i++) {
    const vpPoseTangent xi = 1e-8 * random.normalTangent();
    CHECK((vpPoseExponential::log(vpPoseExponential::exp(xi)) - xi).norm() < 1e-13 * xi.norm());
  }
}

TEST_CASE("log is ViSP's inverse away from half a turn", "[exponential]")
{
  for (const vpPoseTangent &xi : awkwardTangents()) {
    if (xi.tail<3>().norm() < 3.) {
      CAPTURE(xi.transpose());
      const vpHomogeneousMatrix pose = vpPoseExponential::exp(xi);
      const vpColVector v = vpExponentialMap::inverse(pose);
      CHECK((vpPoseExponential::log(pose) - Eigen::Map<const vpPoseTangent>(v.data)).cwiseAbs().maxCoeff() < 1e-8);
    }
  }
}

TEST_CASE("log takes the shorter way round, and either sign at half a turn", "[exponential]")
{
  const vpPoseTangent beyond = vpPoseExponential::log(vpPoseExponential::exp(tangentOf({0., 0., 0.}, {0., 4., 0.})));
  CHECK((beyond - tangentOf({0., 0., 0.}, {0., 4. - 2. * M_PI, 0.})).norm() < 1e-14);

  for (const Eigen::Vector3d &axis : {Eigen::Vector3d(1., 0., 0.), Eigen::Vector3d(0.6, 0., -0.8)}) {
    Eigen::Isometry3d halfTurn = Eigen::Isometry3d::Identity();
    halfTurn.linear() = 2. * axis * axis.transpose() - Eigen::Matrix3d::Identity();
    halfTurn.translation() << 0.1, 0.2, 0.3;
    const vpHomogeneousMatrix pose = vpPoseExponential::fromEigen(halfTurn);
    const vpPoseTangent xi = vpPoseExponential::log(pose);
    CHECK(std::abs(xi.tail<3>().dot(axis)) == Approx(M_PI).epsilon(1e-14));
    CHECK(maxDifference(vpPoseExponential::exp(xi), pose) < 1e-14);
  }
}

TEST_CASE("The adjoint carries a tangent to another frame", "[exponential]")
{
  const vpPoseTangent small = tangentOf({0.1, -0.2, 0.05}, {0.3, 0.1, -0.2});
  for (const vpPoseTangent &xi : awkwardTangents()) {
    CAPTURE(xi.transpose());
    const vpHomogeneousMatrix aMb = vpPoseExponential::exp(xi);
    const vpHomogeneousMatrix left = vpPoseExponential::exp(vpPoseExponential::adjoint(aMb) * small) * aMb;
    CHECK(maxDifference(left, aMb * vpPoseExponential::exp(small)) < 1e-12);
  }
}

TEST_CASE("logVolume is the determinant of the derivative of exp", "[exponential]")
{
  const double step = 1e-5;
  for (const vpPoseTangent &xi : awkwardTangents()) {
    if (xi.tail<3>().norm() > 3.1) {
      continue; // the differences would cross half a turn
    }
    const vpHomogeneousMatrix back = vpPoseExponential::exp(xi).inverse();
    vpPoseMatrix6 derivative;
    for (int i = 0; i < 6; i++) {
      const vpPoseTangent h = step * vpPoseTangent::Unit(i);
      derivative.col(i) = (vpPoseExponential::log(vpPoseExponential::exp(xi + h) * back) -
                           vpPoseExponential::log(vpPoseExponential::exp(xi - h) * back)) /
                          (2. * step);
    }
    CAPTURE(xi.transpose());
    CHECK(vpPoseExponential::logVolume(xi) == Approx(std::log(derivative.determinant())).margin(1e-8));
  }
  const vpPoseTangent halfTurn = tangentOf({1., 2., 3.}, {0., M_PI, 0.});
  CHECK(vpPoseExponential::logVolume(halfTurn) == Approx(2. * std::log(4. / (M_PI * M_PI))));
}

TEST_CASE("Poses go to Eigen and back unchanged", "[exponential]")
{
  const vpHomogeneousMatrix pose(0.1, 0.2, 0.3, 0.4, -0.5, 0.6);
  const Eigen::Isometry3d same = vpPoseExponential::toEigen(pose);
  CHECK(same.translation() == Eigen::Vector3d(0.1, 0.2, 0.3));
  CHECK(same.linear()(0, 2) == exactly(pose[0][2]));
  CHECK(maxDifference(vpPoseExponential::fromEigen(same), pose) == exactly(0.));

  Eigen::Isometry3d scaled = same;
  scaled.linear() *= 1.1;
  CHECK_THROWS_AS(vpPoseExponential::fromEigen(scaled), vpException);
}
