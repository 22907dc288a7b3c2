// SPDX-License-Identifier: GPL-2.0-or-later
#include <catchMain.h>

#include "plainScene.h"

#include <visp3/core/vpException.h>

#include <algorithm>
#include <atomic>
#include <fstream>
#include <functional>
#include <thread>
#include <vector>

namespace {
const std::string &modelFile()
{
  static const std::string file = [] {
    const std::string name = meshFiles::temporaryFile("threads.stl");
    std::ofstream(name) << meshFiles::asciiStl(stepTriangles());
    return name;
  }();
  return file;
}

//! Drawn once. Some images do not show the object, so that it is searched for.
const std::vector<vpImage<vpRGBa>> &images()
{
  static const std::vector<vpImage<vpRGBa>> drawn = [] {
    plainScene scene(stepTriangles());
    std::vector<vpImage<vpRGBa>> all;
    for (int i = 0; i < 10; ++i) {
      all.push_back(i == 4 || i == 5 ? vpImage<vpRGBa>(plainScene::height, plainScene::width, vpRGBa(50, 90, 70))
                                     : scene.draw(plainScene::poseAt(i)));
    }
    return all;
  }();
  return drawn;
}

void prepare(vpMbMultiCueTracker &tracker, double deadline)
{
  tracker.setFrameDeadline(deadline);
  tracker.setCameraParameters(plainScene::camera());
  tracker.loadModel(modelFile());
  tracker.initFromPose(images()[0], plainScene::poseAt(0));
}

std::vector<vpHomogeneousMatrix> posesOf(vpMbMultiCueTracker &tracker)
{
  std::vector<vpHomogeneousMatrix> poses;
  for (const vpImage<vpRGBa> &I : images()) {
    tracker.track(I);
    poses.push_back(tracker.getTrackingResult().cMo);
  }
  return poses;
}

std::vector<vpHomogeneousMatrix> follow(double deadline)
{
  vpMbMultiCueTracker tracker;
  prepare(tracker, deadline);
  return posesOf(tracker);
}

bool isSame(const std::vector<vpHomogeneousMatrix> &a, const std::vector<vpHomogeneousMatrix> &b)
{
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const auto &first, const auto &second) {
    return std::equal(first.data, first.data + 16, second.data);
  });
}

//! Runs several at once. \return How many of them threw.
int runTogether(const std::vector<std::function<void()>> &works)
{
  std::atomic<int> thrown{0};
  std::vector<std::thread> threads;
  for (const std::function<void()> &work : works) {
    threads.emplace_back([&thrown, work] {
      try {
        work();
      } catch (const std::exception &) {
        ++thrown;
      }
    });
  }
  for (std::thread &thread : threads) {
    thread.join();
  }
  return thrown;
}

bool isNear(const vpHomogeneousMatrix &cMo, const vpHomogeneousMatrix &truth)
{
  return (cMo.getTranslationVector() - truth.getTranslationVector()).frobeniusNorm() < 0.01;
}
} // namespace

TEST_CASE("Trackers in threads of their own give the poses that one alone gives, to the last bit", "[threads]")
{
  const std::vector<vpHomogeneousMatrix> alone = follow(0.);
  std::vector<std::vector<vpHomogeneousMatrix>> found(3);
  std::vector<std::function<void()>> works;
  for (std::vector<vpHomogeneousMatrix> &poses : found) {
    works.emplace_back([&poses] { poses = follow(0.); });
  }
  CHECK(runTogether(works) == 0);
  for (const std::vector<vpHomogeneousMatrix> &poses : found) {
    CHECK(isSame(poses, alone));
  }
}

TEST_CASE("Trackers with a deadline, whose views are made beside their frames, do not disturb each other", "[threads]")
{
  std::vector<vpHomogeneousMatrix> last(3);
  std::vector<std::function<void()>> works;
  for (vpHomogeneousMatrix &cMo : last) {
    works.emplace_back([&cMo] {
      vpMbMultiCueTracker tracker;
      prepare(tracker, 10000.);
      for (int i = 0; i < 4; ++i) {
        tracker.track(images()[static_cast<std::size_t>(i)]);
      }
      cMo = tracker.getPose();
    });
  }
  CHECK(runTogether(works) == 0);
  for (const vpHomogeneousMatrix &cMo : last) {
    CHECK(isNear(cMo, plainScene::poseAt(3)));
  }
}

TEST_CASE("A tracker goes on in another thread than it was made in", "[threads]")
{
  const std::vector<vpHomogeneousMatrix> alone = follow(0.);
  vpMbMultiCueTracker tracker;
  prepare(tracker, 0.);
  std::vector<vpHomogeneousMatrix> poses;
  for (const vpImage<vpRGBa> &I : images()) { // Each frame in a thread of its own.
    CHECK(runTogether({[&] { tracker.track(I); }}) == 0);
    poses.push_back(tracker.getTrackingResult().cMo);
  }
  CHECK(isSame(poses, alone));
}

TEST_CASE("With a renderer of OpenGL, where there is one, a tracker goes on in another thread", "[threads]")
{
  vpMbMultiCueTracker tracker;
  tracker.setRenderer(vpModelRenderer::EGL);
  prepare(tracker, 0.);
  vpHomogeneousMatrix cMo;
  for (std::size_t i = 0; i < 4; ++i) {
    CHECK(runTogether({[&] { tracker.track(images()[i]); }}) == 0);
  }
  CHECK(isNear(tracker.getPose(), plainScene::poseAt(3)));
  std::vector<std::function<void()>> works(2, [] {
    vpMbMultiCueTracker own;
    own.setRenderer(vpModelRenderer::EGL);
    prepare(own, 0.);
    own.track(images()[1]);
  });
  CHECK(runTogether(works) == 0);
}

TEST_CASE("A tracker that ends, or gets another model, while views are made waits for one view at most", "[threads]")
{
  for (int i = 0; i < 5; ++i) {
    vpMbMultiCueTracker tracker;
    prepare(tracker, 33.);
    tracker.track(images()[1]);
    tracker.reInitModel(images()[1], modelFile(), plainScene::poseAt(1));
    tracker.track(images()[2]);
    tracker.setFrameDeadline(0.); // The views that are missing are made in the frame from now on.
    tracker.track(images()[3]);
    tracker.setFrameDeadline(33.);
    tracker.track(images()[4]);
    CHECK_NOTHROW(tracker.resetTracker());
  }
}
