// SPDX-License-Identifier: GPL-2.0-or-later
#include <visp3/cues/vpKeyframes.h>

#include <catchMain.h>

#ifdef CUES_TESTS_HAVE_POINTS
#include "pointScenes.h"

#include <visp3/se3/vpPoseExponential.h>

#include <Eigen/Geometry>
#include <opencv2/core.hpp>

namespace {
using pointScenes::makeCamera;
using pointScenes::startPose;

const vpImageRegion everywhere(0, 0, pointScenes::width, pointScenes::height);

//! A box of marble, and keyframes of it.
struct Scene
{
  Scene() { keyframes.setObject(model->centre(), model->diameter()); }

  vpCueFrame frameOf(const vpImage<unsigned char> &I) { return source.frame(I, makeCamera(), nullptr); }
  const vpRenderedView &depthAt(const vpHomogeneousMatrix &cMo)
  {
    renderer.render(cMo, makeCamera(), pointScenes::width, pointScenes::height, vpRenderOptions(), depth);
    return depth;
  }
  void learn(const vpHomogeneousMatrix &cMo)
  {
    const vpImage<unsigned char> I = painter.draw(cMo);
    keyframes.learn(frameOf(I), cMo, depthAt(cMo));
  }
  std::vector<vpKeyframePose> find(const vpImage<unsigned char> &I, const vpHomogeneousMatrix &expected)
  {
    vpKeyframes::Where where;
    where.expected = expected;
    return keyframes.find(frameOf(I), everywhere, where);
  }
  double error(const vpHomogeneousMatrix &cMo, const vpHomogeneousMatrix &truth) const
  {
    return pointScenes::imageError(*model, cMo, truth);
  }

  pointScenes::Model model = pointScenes::makeBox();
  pointScenes::Painter painter{model};
  vpCpuRenderer renderer{model};
  vpRenderedView depth;
  vpFrameSource source;
  vpKeyframes keyframes;
};

//! Turned about the box's middle, which is the origin of its frame.
vpHomogeneousMatrix turned(double x, double y, double z, double shift = 0.)
{
  return vpHomogeneousMatrix(shift, -shift, 0., 0., 0., 0.) * startPose() * vpHomogeneousMatrix(0., 0., 0., x, y, z);
}

vpImage<unsigned char> noise()
{
  vpImage<unsigned char> I(pointScenes::height, pointScenes::width);
  for (unsigned int i = 0; i < I.getHeight(); ++i) {
    for (unsigned int j = 0; j < I.getWidth(); ++j) {
      I[i][j] = static_cast<unsigned char>(255. * pointScenes::hashed(static_cast<int>(i), static_cast<int>(j), 7));
    }
  }
  return I;
}

//! Squares of 8 pixels.
vpImage<unsigned char> blocks()
{
  vpImage<unsigned char> I(pointScenes::height, pointScenes::width);
  for (unsigned int i = 0; i < I.getHeight(); ++i) {
    for (unsigned int j = 0; j < I.getWidth(); ++j) {
      I[i][j] =
          static_cast<unsigned char>(255. * pointScenes::hashed(static_cast<int>(i / 8), static_cast<int>(j / 8), 5));
    }
  }
  return I;
}

//! A board with a pattern of its own in front of the left part of an image. \param shift Of the board, pixels.
void hideLeft(vpImage<unsigned char> &I, int shift)
{
  const vpImage<unsigned char> pattern = blocks();
  for (unsigned int i = 0; i < I.getHeight(); ++i) {
    for (unsigned int j = 0; j < I.getWidth() / 2; ++j) {
      const int from = static_cast<int>(i) - shift;
      if (from >= 0 && from < static_cast<int>(I.getHeight())) {
        I[i][j] = pattern[static_cast<unsigned int>(from)][j];
      }
    }
  }
}
} // namespace

TEST_CASE("The pose is found again after jumps and turns that no cue follows", "[keyframes]")
{
  Scene scene;
  scene.learn(startPose());
  REQUIRE(scene.keyframes.size() == 1);
  // About the line of sight, half a turn included; out of it; far in the image.
  const vpHomogeneousMatrix cRo = startPose();
  const std::vector<vpHomogeneousMatrix> truths = {startPose(),
                                                   turned(0., 0.3, 0.),
                                                   turned(-0.3, 0., 0.2),
                                                   turned(0.2, 0.2, 0., 0.05),
                                                   vpHomogeneousMatrix(0., 0., 0., 0., 0., 1.5) * cRo,
                                                   vpHomogeneousMatrix(0., 0., 0., 0., 0., M_PI) * cRo};
  for (std::size_t i = 0; i < truths.size(); ++i) {
    CAPTURE(i);
    const std::vector<vpKeyframePose> found = scene.find(scene.painter.draw(truths[i]), startPose());
    REQUIRE_FALSE(found.empty());
    REQUIRE(found.size() <= 2);
    CHECK(scene.error(found[0].cMo, truths[i]) < 3.);
    CHECK(found[0].agreeing >= 12);
    CHECK(found[0].agreeing <= found[0].matched);
    CHECK(scene.keyframes.agreeing(found[0].cMo) >= found[0].agreeing);
    CHECK(scene.keyframes.agreeing(turned(0.3, 0.3, 0.7, -0.1)) < found[0].agreeing / 3);
  }
}

TEST_CASE("Nothing is found where there is nothing", "[keyframes]")
{
  Scene scene;
  vpImage<unsigned char> gray(pointScenes::height, pointScenes::width, 128);
  CHECK(scene.find(scene.painter.draw(startPose()), startPose()).empty()); // Nothing was learnt.
  scene.learn(startPose());
  CHECK(scene.find(gray, startPose()).empty());
  CHECK(scene.find(noise(), startPose()).empty());
  // A region beside the object, one outside the image, and one too small for a descriptor.
  const vpImage<unsigned char> I = scene.painter.draw(startPose());
  vpKeyframes::Where where;
  where.expected = startPose();
  for (const vpImageRegion &region : {vpImageRegion(0, 0, 70, 240), vpImageRegion(-500, 0, 100, 100),
                                      vpImageRegion(160, 120, 20, 20), vpImageRegion()}) {
    CHECK(scene.keyframes.find(scene.frameOf(I), region, where).empty());
  }
}

TEST_CASE("Poses beyond what is allowed are not returned", "[keyframes]")
{
  Scene scene;
  scene.learn(startPose());
  const vpImage<unsigned char> I = scene.painter.draw(turned(0., 0.4, 0., 0.05));
  vpKeyframes::Where where;
  where.expected = startPose();
  where.shift = 0.5;
  where.turn = 0.6;
  REQUIRE_FALSE(scene.keyframes.find(scene.frameOf(I), everywhere, where).empty());
  where.turn = 0.1;
  for (const vpKeyframePose &pose : scene.keyframes.find(scene.frameOf(I), everywhere, where)) {
    CHECK(scene.error(pose.cMo, turned(0., 0.4, 0., 0.05)) > 3.); // Another one, of chance.
  }
}

TEST_CASE("Views that are known, or show nothing, take no room", "[keyframes]")
{
  Scene scene;
  CHECK(scene.keyframes.wants(startPose()));
  scene.learn(startPose());
  CHECK_FALSE(scene.keyframes.wants(startPose()));
  CHECK_FALSE(scene.keyframes.wants(turned(0., 0.1, 0.)));
  CHECK_FALSE(scene.keyframes.wants(vpHomogeneousMatrix(0., 0., 0., 0., 0., 1.5) * startPose())); // The same side.
  CHECK(scene.keyframes.wants(turned(0., 0.4, 0.)));
  CHECK(scene.keyframes.wants(vpHomogeneousMatrix(0., 0., 0.4, 0., 0., 0.) * startPose()));
  for (int i = 0; i < 40; ++i) {
    scene.learn(turned(0., 0.1 * i, 0.));
  }
  CHECK(scene.keyframes.size() == 16);
  scene.keyframes.reset();
  CHECK(scene.keyframes.size() == 0);
  CHECK(scene.keyframes.wants(startPose()));
}

TEST_CASE("Nothing is kept of what passes in front of the object", "[keyframes]")
{
  const bool isProposed = GENERATE(true, false);
  CAPTURE(isProposed);
  Scene scene;
  vpImage<unsigned char> I = scene.painter.draw(startPose());
  hideLeft(I, 0);
  const vpRenderedView &depth = scene.depthAt(startPose());
  if (isProposed) {
    scene.keyframes.propose(scene.frameOf(I), startPose(), depth);
  } else {
    scene.keyframes.learn(scene.frameOf(I), startPose(), depth);
  }
  for (int i = 1; i <= 4; ++i) {
    CHECK(scene.find(I, startPose()).empty() == isProposed);
    vpImage<unsigned char> next = scene.painter.draw(turned(0., 0.02 * i, 0.));
    hideLeft(next, 3 * i);
    scene.keyframes.confirm(scene.frameOf(next), turned(0., 0.02 * i, 0.));
  }
  // The board alone, and the object alone.
  vpImage<unsigned char> board(pointScenes::height, pointScenes::width, 128);
  hideLeft(board, 0);
  CHECK(scene.find(board, startPose()).empty() == isProposed);
  const std::vector<vpKeyframePose> found = scene.find(scene.painter.draw(turned(0., 0.3, 0.)), startPose());
  REQUIRE_FALSE(found.empty());
  CHECK(scene.error(found[0].cMo, turned(0., 0.3, 0.)) < 3.);
}

TEST_CASE("A proposed view of which nothing is seen again is wanted again", "[keyframes]")
{
  Scene scene;
  const vpImage<unsigned char> I = scene.painter.draw(startPose());
  scene.keyframes.propose(scene.frameOf(I), startPose(), scene.depthAt(startPose()));
  CHECK_FALSE(scene.keyframes.wants(startPose()));
  const vpImage<unsigned char> other = noise();
  for (int i = 0; i < 4; ++i) {
    CHECK(scene.keyframes.size() == 1);
    scene.keyframes.confirm(scene.frameOf(other), startPose());
  }
  CHECK(scene.keyframes.size() == 0);
  CHECK(scene.keyframes.wants(startPose()));
}

TEST_CASE("The result does not depend on the number of threads", "[keyframes]")
{
  const int before = cv::getNumThreads();
  std::vector<vpHomogeneousMatrix> poses;
  for (const int threads : {1, 4}) {
    cv::setNumThreads(threads);
    Scene scene;
    scene.learn(startPose());
    const std::vector<vpKeyframePose> found = scene.find(scene.painter.draw(turned(0.1, 0.3, 0.)), startPose());
    REQUIRE_FALSE(found.empty());
    poses.push_back(found[0].cMo);
  }
  cv::setNumThreads(before);
  for (unsigned int i = 0; i < 16; ++i) {
    CHECK(poses[0].data[i] == exactly(poses[1].data[i]));
  }
}
#else
TEST_CASE("Without OpenCV's modules nothing is learnt and nothing found", "[keyframes]")
{
  vpKeyframes keyframes;
  CHECK_FALSE(vpKeyframes::isAvailable());
  CHECK_FALSE(keyframes.wants(vpHomogeneousMatrix()));
  CHECK(keyframes.size() == 0);
}
#endif
