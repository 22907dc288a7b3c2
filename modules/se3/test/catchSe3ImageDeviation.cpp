// SPDX-License-Identifier: GPL-2.0-or-later
#include <visp3/se3/vpPoseImageDeviation.h>

#include <visp3/se3/vpPoseNoise.h>

#include <catchMain.h>
#include <poseSamples.h>

namespace {
const vpCameraParameters cam(600., 580., 320., 240.);
const vpHomogeneousMatrix cMo(0.1, -0.05, 0.8, 0.5, -1.2, 0.4);
const Eigen::Vector3d corner(0.08, -0.03, 0.05);

Eigen::Vector2d project(const vpHomogeneousMatrix &pose, const Eigen::Vector3d &oX)
{
  const Eigen::Vector3d cX = vpPoseExponential::toEigen(pose) * oX;
  return {cam.get_px() * cX.x() / cX.z() + cam.get_u0(), cam.get_py() * cX.y() / cX.z() + cam.get_v0()};
}

vpPoseMatrix6 someCovariance()
{
  vpPoseTangent deviation;
  deviation << 0.002, 0.003, 0.004, 0.004, 0.003, 0.006;
  vpPoseMatrix6 covariance = deviation.cwiseAbs2().asDiagonal();
  covariance(0, 4) = covariance(4, 0) = -0.5 * deviation[0] * deviation[4];
  return covariance;
}
} // namespace

TEST_CASE("Projections of drawn poses spread as foretold", "[image-deviation]")
{
  const vpPoseNoise noise(someCovariance(), vpPoseNoise::Frame::CAMERA);
  const Eigen::Vector2d centre = project(cMo, corner);
  Eigen::Matrix2d sum = Eigen::Matrix2d::Zero();
  const int draws = 20000;
  for (unsigned int i = 0; i < draws; i++) {
    vpPoseRandom random(1, {i});
    const Eigen::Vector2d off = project(noise.draw(cMo, random), corner) - centre;
    sum += off * off.transpose();
  }
  const Eigen::Matrix2d expected = vpPoseImageDeviation::covariance(cam, cMo, someCovariance(), corner);
  CHECK((sum / draws - expected).norm() < 0.04 * expected.norm());
  CHECK(expected.norm() > 1.);
}

TEST_CASE("A search range is the deviation of the farthest-moving point", "[image-deviation]")
{
  vpPoseTangent variance = vpPoseTangent::Constant(1e-20);
  variance[0] = 0.003 * 0.003;
  const vpPoseMatrix6 sideways = variance.asDiagonal();
  const vpHomogeneousMatrix ahead(0., 0., 1., 0., 0., 0.);
  const Eigen::Vector3d nearer(0., 0., -0.5);
  CHECK(vpPoseImageDeviation::largest(cam, ahead, sideways, {Eigen::Vector3d::Zero()}) == Approx(1.8));
  CHECK(vpPoseImageDeviation::largest(cam, ahead, sideways, {nearer, Eigen::Vector3d::Zero()}) == Approx(3.6));
  CHECK(vpPoseImageDeviation::along(cam, ahead, sideways, nearer, {1., 0.}) == Approx(3.6));
  CHECK(vpPoseImageDeviation::along(cam, ahead, sideways, nearer, {0., 1.}) < 1e-6);
  CHECK(vpPoseImageDeviation::along(cam, ahead, sideways, nearer, {0.6, 0.8}) == Approx(0.6 * 3.6));
}

TEST_CASE("Points that the camera does not see have no deviation", "[image-deviation]")
{
  const Eigen::Vector3d behind(0., 0., -2.);
  CHECK(vpPoseImageDeviation::covariance(cam, vpHomogeneousMatrix(), someCovariance(), behind).norm() == exactly(0.));
  CHECK(vpPoseImageDeviation::largest(cam, vpHomogeneousMatrix(), someCovariance(), {behind}) == exactly(0.));
  CHECK(vpPoseImageDeviation::largest(cam, cMo, someCovariance(), {}) == exactly(0.));
}
