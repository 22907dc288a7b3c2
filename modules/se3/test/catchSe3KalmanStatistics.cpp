// SPDX-License-Identifier: GPL-2.0-or-later
#include <visp3/se3/vpPoseKalmanFilter.h>

#include <catchMain.h>
#include <movingPoses.h>

#include <algorithm>

using movingPoses::Sample;

namespace {
const unsigned int runs = 200;
const int frames = 30;
const vpPoseMatrix6 R = movingPoses::observationCovariance();

// Squared error in units of the covariance that the filter gives: 6 on average for a consistent one.
double squaredError(const vpPoseKalmanFilter::Estimate &estimate, const vpHomogeneousMatrix &truth)
{
  const vpPoseTangent alpha = vpPoseExponential::log(truth * estimate.cMo.inverse());
  return alpha.dot(estimate.covariance.ldlt().solve(alpha));
}

struct Statistics
{
  double predicted = 0.;
  double filtered = 0.;
  double velocity = 0.;
  double innovation = 0.;  // Mean square of the six white numbers, summed: 6.
  double correlation = 0.; // Of white innovations one frame apart: 0.
};

// \param swapped Gives the filter every pair of frames in the wrong order.
Statistics measure(const vpPoseKalmanSettings &settings, double dt, bool swapped = false)
{
  Statistics sum;
  for (unsigned int run = 0; run < runs; run++) {
    std::vector<Sample> samples = movingPoses::wander(settings, dt, frames, run);
    for (std::size_t i = 2; swapped && i + 1 < samples.size(); i += 2) {
      std::swap(samples[i], samples[i + 1]);
    }
    vpPoseKalmanFilter filter(settings);
    vpPoseTangent before = vpPoseTangent::Zero();
    for (std::size_t i = 0; i < samples.size(); i++) {
      if (i + 1 == samples.size()) {
        sum.predicted += squaredError(filter.predict(dt), samples[i].cMo);
      }
      filter.update(samples[i].observed, R, dt);
      sum.innovation += filter.whiteInnovation().squaredNorm();
      sum.correlation += filter.whiteInnovation().dot(before);
      before = filter.whiteInnovation();
    }
    sum.filtered += squaredError(filter.filtered(), samples.back().cMo);
    const vpPoseTangent error = filter.velocity() - samples.back().velocity;
    sum.velocity += error.dot(filter.velocityCovariance().ldlt().solve(error));
  }
  sum.predicted /= runs;
  sum.filtered /= runs;
  sum.velocity /= runs;
  sum.innovation /= runs * (frames - 1);
  sum.correlation /= runs * (frames - 2) * 6;
  return sum;
}
} // namespace

TEST_CASE("Errors are as large as the filter says, at any frame rate", "[kalman]")
{
  // The deviation of a mean over the runs is 0.25.
  for (const double dt : {1. / 120., 1. / 30., 1. / 8.}) {
    const Statistics s = measure(vpPoseKalmanSettings(), dt);
    CAPTURE(dt, s.predicted, s.filtered, s.velocity, s.innovation, s.correlation);
    CHECK(std::fabs(s.predicted - 6.) < 1.2);
    CHECK(std::fabs(s.filtered - 6.) < 1.2);
    CHECK(std::fabs(s.velocity - 6.) < 1.5);
    CHECK(std::fabs(s.innovation - 6.) < 0.3);
  }
}

TEST_CASE("Innovations are white, and are not where frames come in the wrong order", "[kalman]")
{
  const Statistics right = measure(vpPoseKalmanSettings(), 1. / 30.);
  CAPTURE(right.correlation);
  CHECK(std::fabs(right.correlation) < 0.02);
  const Statistics wrong = measure(vpPoseKalmanSettings(), 1. / 30., true);
  CAPTURE(wrong.correlation, wrong.innovation);
  CHECK(wrong.correlation < -0.1);
  CHECK(wrong.innovation > 12.);
}

TEST_CASE("A filter that is told the wrong time step is found out", "[kalman]")
{
  double squares = 0.;
  for (unsigned int run = 0; run < runs; run++) {
    vpPoseKalmanFilter filter;
    for (const Sample &sample : movingPoses::wander(vpPoseKalmanSettings(), 0.1, frames, run)) {
      filter.update(sample.observed, R, 0.02);
      squares += filter.whiteInnovation().squaredNorm();
    }
  }
  CHECK(squares / (runs * (frames - 1)) > 12.);
}

TEST_CASE("The same observations give the same state", "[kalman]")
{
  vpPoseKalmanFilter first;
  vpPoseKalmanFilter second;
  for (vpPoseKalmanFilter *filter : {&first, &second}) {
    for (const Sample &sample : movingPoses::wander(vpPoseKalmanSettings(), 0.03, 50, 3)) {
      filter->update(sample.observed, R, 0.03);
    }
  }
  CHECK(first.velocity() == second.velocity());
  CHECK(first.filtered().covariance == second.filtered().covariance);
  CHECK((vpPoseExponential::toEigen(first.pose()).matrix() == vpPoseExponential::toEigen(second.pose()).matrix()));
}
