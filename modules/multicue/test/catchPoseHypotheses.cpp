// SPDX-License-Identifier: GPL-2.0-or-later
#include <catchMain.h>

#include "stripedBox.h"

#include <meshFiles.h>

#include <visp3/core/vpExponentialMap.h>
#include <visp3/cues/vpFrameSource.h>
#include <visp3/multicue/vpMbMultiCueTracker.h>

#include <opencv2/core/utility.hpp>

#include <algorithm>
#include <cmath>
#include <thread>

namespace {
double translationError(const vpHomogeneousMatrix &cMo, const vpHomogeneousMatrix &truth)
{
  return (cMo.getTranslationVector() - truth.getTranslationVector()).frobeniusNorm();
}

double rotationError(const vpHomogeneousMatrix &cMo, const vpHomogeneousMatrix &truth)
{
  return vpMath::deg((truth.inverse() * cMo).getThetaUVector().getTheta());
}

bool isRight(const vpHomogeneousMatrix &cMo, const vpHomogeneousMatrix &truth)
{
  return translationError(cMo, truth) < 0.003 && rotationError(cMo, truth) < 1.5;
}

bool isSame(const vpHomogeneousMatrix &a, const vpHomogeneousMatrix &b)
{
  return std::equal(a.data, a.data + 16, b.data);
}

void prepare(vpMbMultiCueTracker &tracker, bool several)
{
  tracker.setCameraParameters(renderedBox::camera());
  tracker.loadModel(renderedBox::writeCao(meshFiles::temporaryFile("hypotheses-box.cao")));
  vpEdgeCueSettings edge = tracker.getEdgeSettings();
  edge.range = 14.;
  edge.candidates = 5;
  tracker.setEdgeSettings(edge);
  vpPoseHypothesisSettings settings;
  settings.enabled = several;
  tracker.setPoseHypothesisSettings(settings);
}

// The start is nearer to the stripe's border than to the right border of the box.
vpHomogeneousMatrix moved(const vpHomogeneousMatrix &cMo, double x)
{
  return vpHomogeneousMatrix(x, 0., 0., 0., 0., 0.) * cMo;
}
} // namespace

TEST_CASE("Beside a stronger parallel neighbour one hypothesis takes the wrong edge, several have the right pose",
          "[hypotheses]")
{
  stripedBox box;
  int wrong = 0;
  int among = 0;
  int best = 0;
  int count = 0;
  for (int i = 0; i < 8; ++i) {
    const vpHomogeneousMatrix truth = stripedBox::frontal(i);
    const vpImage<unsigned char> I = box.draw(truth);
    vpMbMultiCueTracker single(vpMbMultiCueTracker::EDGE_TRACKER), several(vpMbMultiCueTracker::EDGE_TRACKER);
    for (vpMbMultiCueTracker *tracker : {&single, &several}) {
      prepare(*tracker, tracker == &several);
      const vpImage<unsigned char> blank(I.getHeight(), I.getWidth(), 128); // Else the start would be captured.
      tracker->initFromPose(blank, moved(truth, -0.006));                   // 6 pixels.
      tracker->track(I);
    }
    ++count;
    wrong += isRight(single.getPose(), truth) ? 0 : 1;
    best += isRight(several.getPose(), truth) ? 1 : 0;
    const std::vector<vpPoseHypothesis> &found = several.getPoseHypotheses();
    const auto end = found.begin() + static_cast<std::ptrdiff_t>(std::min<std::size_t>(found.size(), 2));
    among += std::any_of(found.begin(), end, [&](const vpPoseHypothesis &h) { return isRight(h.cMo, truth); });
  }
  CHECK(wrong == count);
  CHECK(among == count);
  CHECK(best == count);
}

TEST_CASE("The poses do not depend on the number of threads", "[hypotheses]")
{
  stripedBox box;
  std::vector<vpImage<unsigned char>> images;
  for (int i = 0; i < 4; ++i) {
    images.push_back(box.draw(moved(stripedBox::frontal(0), 0.006 * (i % 2))));
  }
  const int threadsBefore = cv::getNumThreads();
  std::vector<vpPoseHypothesis> expected[4];
  for (const int threads : {1, 2, 4}) {
    CAPTURE(threads);
    cv::setNumThreads(threads);
    vpMbMultiCueTracker tracker(vpMbMultiCueTracker::EDGE_TRACKER);
    prepare(tracker, true);
    tracker.initFromPose(images[0], moved(stripedBox::frontal(0), -0.006));
    bool several = false;
    for (std::size_t i = 0; i < 4; ++i) {
      tracker.track(images[i]);
      const std::vector<vpPoseHypothesis> &found = tracker.getPoseHypotheses();
      several = several || tracker.getNbPoseMinimisations() > 1;
      if (threads == 1) {
        expected[i] = found;
      }
      REQUIRE(found.size() == expected[i].size());
      for (std::size_t k = 0; k < found.size(); ++k) {
        CHECK(isSame(found[k].cMo, expected[i][k].cMo));
        CHECK(found[k].residue == exactly(expected[i][k].residue));
        CHECK(found[k].weight == exactly(expected[i][k].weight));
        CHECK(found[k].classes == expected[i][k].classes);
      }
    }
    CHECK(several);
  }
  cv::setNumThreads(threadsBefore);
}

TEST_CASE("Off, hypotheses change nothing, whatever their settings were", "[hypotheses]")
{
  stripedBox box;
  vpMbMultiCueTracker never(vpMbMultiCueTracker::EDGE_TRACKER), was(vpMbMultiCueTracker::EDGE_TRACKER);
  prepare(never, false);
  CHECK_FALSE(vpMbMultiCueTracker().getPoseHypothesisSettings().enabled);
  prepare(was, true);
  const vpImage<unsigned char> first = box.draw(stripedBox::frontal(0));
  never.initFromPose(first, stripedBox::frontal(0));
  was.initFromPose(first, stripedBox::frontal(0));
  was.track(first);
  CHECK_FALSE(was.getPoseHypotheses().empty());
  vpPoseHypothesisSettings off;
  off.draws = 3;
  was.setPoseHypothesisSettings(off);
  CHECK(was.getPoseHypotheses().empty());
  was.initFromPose(first, stripedBox::frontal(0));
  for (int i = 0; i < 3; ++i) {
    const vpImage<unsigned char> I = box.draw(moved(stripedBox::frontal(0), 0.004 * i));
    never.track(I);
    was.track(I);
    CHECK(isSame(never.getPose(), was.getPose()));
    CHECK(was.getNbPoseMinimisations() == 0);
  }
  off.minimisations = 0;
  CHECK_THROWS_AS(was.setPoseHypothesisSettings(off), vpException);
  CHECK(was.getPoseHypothesisSettings().draws == 3);
}

TEST_CASE("Any pose can be started from without a tracker, in threads that share one match", "[hypotheses]")
{
  stripedBox box;
  vpMbMultiCueTracker tracker(vpMbMultiCueTracker::EDGE_TRACKER);
  prepare(tracker, true);
  const vpHomogeneousMatrix truth = stripedBox::frontal(1);
  const vpHomogeneousMatrix start = moved(truth, -0.006);
  const vpImage<unsigned char> I = box.draw(truth);
  vpFrameSource source;
  vpEdgeCue edges(tracker.getEdgeSettings());
  vpModelView view(tracker.getModel());
  view.compute(start, renderedBox::camera(), renderedBox::width, renderedBox::height, vpModelViewOptions(), nullptr);
  edges.match(source.frame(I, renderedBox::camera(), nullptr), view);

  vpPoseHypotheses workers[4];
  std::vector<std::thread> threads;
  for (vpPoseHypotheses &worker : workers) {
    threads.emplace_back([&] {
      for (int i = 0; i < 5; ++i) {
        worker.find(edges, view, start, 7);
      }
    });
  }
  for (std::thread &thread : threads) {
    thread.join();
  }
  double sum = 0.;
  for (const vpPoseHypothesis &hypothesis : workers[0].hypotheses()) {
    CHECK(hypothesis.classes.size() == workers[0].contours().size());
    CHECK(hypothesis.residue > 0.);
    sum += hypothesis.weight;
  }
  CHECK(sum == Approx(1.));
  CHECK(isRight(workers[0].hypotheses().front().cMo, truth));
  CHECK(workers[0].minimisations() <= workers[0].settings().minimisations);
  CHECK(workers[0].lines().size() >= workers[0].contours().size());
  for (const vpPoseHypotheses &worker : workers) {
    REQUIRE(worker.hypotheses().size() == workers[0].hypotheses().size());
    CHECK(isSame(worker.hypotheses().front().cMo, workers[0].hypotheses().front().cMo));
  }
}

TEST_CASE("An image that shows nothing has no hypotheses", "[hypotheses]")
{
  vpMbMultiCueTracker tracker(vpMbMultiCueTracker::EDGE_TRACKER);
  prepare(tracker, true);
  const vpImage<unsigned char> blank(renderedBox::height, renderedBox::width, 100);
  tracker.initFromPose(blank, renderedBox::pose());
  CHECK_NOTHROW(tracker.track(blank));
  CHECK(tracker.getPoseHypotheses().empty());
  CHECK(tracker.getTrackingState() == vpTrackingState::LOST);
}
