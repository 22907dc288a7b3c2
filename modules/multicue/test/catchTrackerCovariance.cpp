// SPDX-License-Identifier: GPL-2.0-or-later
#include <catchMain.h>

#include "covarianceTrials.h"

using namespace covarianceTrials;

TEST_CASE("Covariances agree with the errors of 200 noisy images", "[covariance]")
{
  checkConsistency(noisyBox::pose(), {6.}, 200);
}

TEST_CASE("Each cue has a covariance of its own, and all together know more than each", "[covariance]")
{
  Trials trials(noisyBox::pose());
  vpMbMultiCueTracker tracker;
  prepare(tracker, edge | color | klt);
  trials.run(tracker, 0, 5.);
  const double all = toEigen(tracker.getCovarianceMatrix()).trace();
  for (const int cue : {edge, color, klt}) {
    CHECK(tracker.getCueReason(cue).empty());
    const Matrix6 covariance = toEigen(tracker.getCovarianceMatrix(cue));
    CHECK(covariance.isApprox(covariance.transpose()));
    CHECK(covariance.llt().info() == Eigen::Success);
    CHECK(covariance.trace() > all);
    CHECK(covariance.trace() < 1e-3);
  }
}

TEST_CASE("Motions that are kept fixed have no error", "[covariance]")
{
  Trials trials(noisyBox::pose());
  vpMbMultiCueTracker tracker;
  prepare(tracker, edge | color);
  vpColVector estimated(6);
  estimated = 1.;
  estimated[3] = estimated[4] = estimated[5] = 0.;
  tracker.setEstimatedDoF(estimated);
  trials.run(tracker, 0, 5.);
  const Matrix6 covariance = toEigen(tracker.getCovarianceMatrix());
  CHECK(covariance.bottomRightCorner(3, 3).norm() < 1e-15);
  CHECK(covariance(0, 0) > 0.);
}

TEST_CASE("A cue without data drops out and says why, and the others track", "[covariance]")
{
  noisyBox box(false);
  const vpHomogeneousMatrix cMo = noisyBox::pose();
  const vpImage<vpRGBa> I = box.draw(cMo);
  vpMbMultiCueTracker tracker;
  prepare(tracker, edge | klt);
  CHECK_FALSE(tracker.getCueReason(edge).empty());
  tracker.initFromPose(I, cMo);
  CHECK_THAT(tracker.getCueReason(edge), ContainsSubstring("no image was tracked"));
  tracker.track(I);
  CHECK(tracker.getTrackingState() == vpTrackingState::TRACKING);
  CHECK(tracker.getCueReason(edge).empty());
  CHECK_THAT(tracker.getCueReason(klt), ContainsSubstring("no texture: 0 points"));
  CHECK_THAT(tracker.getCueReason(color), ContainsSubstring("setTrackerType"));
  CHECK_NOTHROW(tracker.getCovarianceMatrix(edge));
  CHECK_THROWS_AS(tracker.getCovarianceMatrix(klt), vpException);
  CHECK_THROWS_AS(tracker.getCovarianceMatrix(color), vpException);
  CHECK_THROWS_AS(tracker.getCovarianceMatrix(3), vpException);
  CHECK_THROWS_AS(tracker.getCueReason(0), vpException);
}

TEST_CASE("Where nothing is seen each cue says so", "[covariance]")
{
  Trials trials(noisyBox::pose());
  vpMbMultiCueTracker tracker;
  prepare(tracker, edge | color | klt);
  trials.run(tracker, 0, 5.);
  tracker.setCovarianceComputation(false);
  CHECK_THROWS_AS(tracker.getCovarianceMatrix(edge), vpException);
  tracker.setCovarianceComputation(true);
  tracker.track(vpImage<vpRGBa>(noisyBox::height, noisyBox::width, vpRGBa(90, 90, 90)));
  CHECK_FALSE(tracker.getCueReason(edge).empty());
  CHECK_FALSE(tracker.getCueReason(klt).empty());
}
