// SPDX-License-Identifier: GPL-2.0-or-later
#include <visp3/se3/vpPoseKalmanFilter.h>

#include <visp3/core/vpException.h>

#include <catchMain.h>
#include <movingPoses.h>
#include <poseSamples.h>

#include <limits>

namespace {
const vpHomogeneousMatrix start(0.1, -0.05, 0.8, 0.5, -1.2, 0.4);
const vpPoseMatrix6 exact = 1e-10 * vpPoseMatrix6::Identity();

vpPoseTangent someVelocity()
{
  return tangentOf({0.3, -0.2, 0.5}, {0.4, 1.1, -0.7});
}

vpHomogeneousMatrix moved(const vpHomogeneousMatrix &cMo, const vpPoseTangent &velocity, double time)
{
  return cMo * vpPoseExponential::exp(velocity * time);
}

// Follows a constant velocity from time 0 on.
vpPoseKalmanFilter following(const vpPoseTangent &velocity, double dt, int count,
                             const vpPoseKalmanSettings &settings = vpPoseKalmanSettings())
{
  vpPoseKalmanFilter filter(settings);
  for (int i = 0; i < count; i++) {
    filter.update(moved(start, velocity, i * dt), exact, dt);
  }
  return filter;
}

double distance(const vpHomogeneousMatrix &a, const vpHomogeneousMatrix &b)
{
  return vpPoseExponential::log(a.inverse() * b).norm();
}

bool isSame(const vpPoseKalmanFilter &a, const vpPoseKalmanFilter &b)
{
  return maxDifference(a.pose(), b.pose()) == exactly(0.) && a.velocity() == b.velocity() &&
         a.velocityCovariance() == b.velocityCovariance() && a.filtered().covariance == b.filtered().covariance;
}
} // namespace

TEST_CASE("A constant velocity is predicted", "[kalman]")
{
  const double dt = 1. / 30.;
  const vpPoseKalmanFilter filter = following(someVelocity(), dt, 30);
  CHECK((filter.velocity() - someVelocity()).norm() < 1e-3);
  for (const double ahead : {0., dt, 3. * dt, 0.5}) {
    const vpHomogeneousMatrix expected = moved(start, someVelocity(), 29 * dt + ahead);
    CHECK(distance(filter.predict(ahead).cMo, expected) < 1e-4 + 1e-3 * ahead);
  }
  // In the camera's frame the same motion is a displacement on the left.
  const vpHomogeneousMatrix left = vpPoseExponential::exp(filter.velocityInCamera() * dt) * filter.pose();
  CHECK(maxDifference(left, filter.predict(dt).cMo) < 1e-12);
}

TEST_CASE("A turntable is a constant velocity wherever the object's frame is", "[kalman]")
{
  // About an axis 0.3 m beside the object's origin, then about the camera.
  const vpPoseTangent spin = tangentOf({0., 0., 0.}, {0., 0., 2.});
  const vpHomogeneousMatrix aside(0.3, 0., 0., 0., 0., 0.);
  CHECK(distance(following(vpPoseExponential::adjoint(aside) * spin, 0.02, 30).predict(0.2).cMo,
                 moved(start, vpPoseExponential::adjoint(aside) * spin, 29 * 0.02 + 0.2)) < 1e-3);
  const vpPoseTangent pan = vpPoseExponential::adjoint(start.inverse()) * spin;
  CHECK(distance(following(pan, 0.02, 30).predict(0.2).cMo, vpPoseExponential::exp(spin * (29 * 0.02 + 0.2)) * start) <
        1e-3);
}

TEST_CASE("Every frame rate gives the same velocity in metres and radians per second", "[kalman]")
{
  for (const int every : {1, 2, 7, 15}) {
    const double dt = every / 60.;
    const vpPoseKalmanFilter filter = following(someVelocity(), dt, 90 / every);
    CHECK((filter.velocity() - someVelocity()).norm() < 5e-3);
  }
}

TEST_CASE("Two steps predict what one step of twice the time predicts", "[kalman]")
{
  const vpPoseKalmanFilter filter = following(someVelocity(), 0.03, 5);
  // Nothing is learnt in between from an observation that says nothing.
  vpPoseKalmanFilter between = filter;
  between.update(filter.predict(0.04).cMo, 1e12 * vpPoseMatrix6::Identity(), 0.04);
  const vpPoseKalmanFilter::Estimate once = filter.predict(0.1);
  const vpPoseKalmanFilter::Estimate twice = between.predict(0.06);
  CHECK(maxDifference(once.cMo, twice.cMo) < 1e-9);
  // To first order in the angle that is turned through while the velocity wanders.
  CHECK((once.covariance - twice.covariance).norm() < 0.02 * once.covariance.norm());
}

TEST_CASE("The uncertainty grows with the time ahead", "[kalman]")
{
  const vpPoseKalmanFilter filter = following(someVelocity(), 0.03, 10);
  double before = filter.filtered().covariance.trace();
  for (const double ahead : {0.01, 0.03, 0.1, 0.3, 0.9, 1.1, 10.}) {
    const double trace = filter.predict(ahead).covariance.trace();
    CHECK(trace > before);
    before = trace;
  }
}

TEST_CASE("After a long gap the object is expected where it was, and the velocity is unknown", "[kalman]")
{
  vpPoseKalmanFilter filter = following(someVelocity(), 0.03, 10);
  CHECK(distance(filter.predict(1.5).cMo, filter.pose()) < 1e-12);
  const vpHomogeneousMatrix elsewhere(0.4, 0.3, 1.2, -0.5, 0.3, 2.);
  filter.update(elsewhere, exact, 60.);
  CHECK(maxDifference(filter.pose(), elsewhere) == exactly(0.));
  CHECK(filter.velocity().norm() == exactly(0.));
  CHECK(filter.velocityCovariance()(5, 5) == Approx(4.));
  // A gap that is shorter keeps the velocity.
  vpPoseKalmanFilter shorter = following(someVelocity(), 0.03, 10);
  shorter.update(moved(start, someVelocity(), 9 * 0.03 + 0.9), exact, 0.9);
  CHECK((shorter.velocity() - someVelocity()).norm() < 0.02);
}

TEST_CASE("A velocity is learnt from the second pose, as far as its uncertainty allows", "[kalman]")
{
  vpPoseKalmanFilter sure = following(someVelocity(), 0.1, 2);
  CHECK((sure.velocity() - someVelocity()).norm() < 0.4);
  vpPoseKalmanFilter unsure;
  unsure.update(start, exact, 0.);
  unsure.update(moved(start, someVelocity(), 0.1), 1e4 * vpPoseMatrix6::Identity(), 0.1);
  CHECK(unsure.velocity().norm() < 1e-3);
}

TEST_CASE("Without smoothing the pose is the one observed, and the prediction is the same", "[kalman]")
{
  vpPoseKalmanSettings raw;
  raw.smooth = false;
  vpPoseKalmanFilter smooth;
  vpPoseKalmanFilter observed(raw);
  double errorSmooth = 0.;
  double errorObserved = 0.;
  vpPoseKalmanSettings calm;
  calm.translationWander = 0.05;
  calm.rotationWander = 0.1;
  smooth.setSettings(calm);
  calm.smooth = false;
  observed.setSettings(calm);
  for (const movingPoses::Sample &sample : movingPoses::wander(calm, 1. / 30., 100, 1)) {
    smooth.update(sample.observed, movingPoses::observationCovariance(), 1. / 30.);
    observed.update(sample.observed, movingPoses::observationCovariance(), 1. / 30.);
    CHECK(maxDifference(observed.pose(), sample.observed) == exactly(0.));
    CHECK(maxDifference(observed.filtered().cMo, smooth.pose()) == exactly(0.));
    errorSmooth += distance(smooth.pose(), sample.cMo);
    errorObserved += distance(observed.pose(), sample.cMo);
  }
  CHECK(maxDifference(observed.predict(0.1).cMo, smooth.predict(0.1).cMo) == exactly(0.));
  CHECK(errorSmooth < 0.7 * errorObserved);
}

TEST_CASE("What cannot be used is refused by its value, and the state stays", "[kalman]")
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  vpPoseKalmanFilter filter = following(someVelocity(), 0.03, 10);
  const vpPoseKalmanFilter before = filter;
  const auto refuses = [&](const vpHomogeneousMatrix &cMo, const vpPoseMatrix6 &covariance, double dt,
                           const std::string &text) {
    CHECK_THROWS_WITH(filter.update(cMo, covariance, dt), ContainsSubstring(text));
    CHECK(isSame(filter, before));
  };
  refuses(start, exact, nan, "nan");
  refuses(start, exact, -0.5, "-0.5 s");
  refuses(start, exact, std::numeric_limits<double>::infinity(), "inf");
  vpPoseMatrix6 bad = exact;
  bad(1, 4) = nan;
  refuses(start, bad, 0.03, "(1, 4)");
  bad = exact;
  bad(2, 2) = -3e-7;
  refuses(start, bad, 0.03, "-3e-07");
  bad = exact;
  bad(0, 1) = 0.5e-10;
  refuses(start, bad, 0.03, "0.5");
  bad(1, 0) = 0.5e-10;
  CHECK_NOTHROW(vpPoseKalmanFilter(before).update(start, bad, 0.03));
  bad(0, 1) = bad(1, 0) = 1.5e-10;
  refuses(start, bad, 0.03, "not positive definite");
  refuses(start, vpPoseMatrix6::Zero(), 0.03, "(0, 0)");
  vpHomogeneousMatrix lost = start;
  lost[1][3] = nan;
  refuses(lost, exact, 0.03, "(1, 3)");
  lost = start;
  lost[0][0] = 3.;
  refuses(lost, exact, 0.03, "determinant");

  CHECK_THROWS_WITH(filter.predict(nan), ContainsSubstring("nan"));
  filter.reset();
  CHECK_FALSE(filter.isStarted());
  CHECK_THROWS_WITH(filter.predict(0.1), ContainsSubstring("predict()"));
  CHECK_THROWS_WITH(filter.pose(), ContainsSubstring("pose()"));
  CHECK_THROWS_WITH(filter.filtered(), ContainsSubstring("filtered()"));
  CHECK_NOTHROW(filter.update(start, exact, nan)); // No time has passed since nothing.
}

TEST_CASE("A setting out of range is named, and the old ones stay", "[kalman]")
{
  vpPoseKalmanFilter filter;
  vpPoseKalmanSettings settings;
  settings.rotationWander = -2.;
  CHECK_THROWS_WITH(filter.setSettings(settings), ContainsSubstring("rotationWander is -2"));
  CHECK(filter.settings().rotationWander == exactly(3.));
  settings = vpPoseKalmanSettings();
  settings.longestGap = std::numeric_limits<double>::infinity();
  CHECK_THROWS_WITH(vpPoseKalmanFilter(settings), ContainsSubstring("longestGap"));
}
