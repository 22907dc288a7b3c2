// SPDX-License-Identifier: GPL-2.0-or-later
#include <catchMain.h>

#ifdef CUES_TESTS_HAVE_POINTS

#include "pointScenes.h"

#include <visp3/core/vpException.h>

#include <map>

using namespace pointScenes;

namespace {
// The getters of vpKltOpencv, which only some builds of ViSP have.
struct Klt
{
  int getMaxFeatures() const { return 60; }
  int getWindowSize() const { return 9; }
  double getQuality() const { return 0.05; }
  double getMinDistance() const { return 12.; }
  double getHarrisFreeParameter() const { return 0.03; }
  int getBlockSize() const { return 5; }
  int getPyramidLevels() const { return levels; }
  int levels = 2;
};

void checkRefused(void (*change)(vpPointCueSettings &), const std::string &name)
{
  vpPointCueSettings settings;
  change(settings);
  CHECK_THROWS_WITH(settings.check(), ContainsSubstring(name));
  CHECK_THROWS_WITH(vpPointCue(settings), ContainsSubstring(name));
  vpPointCue cue;
  CHECK_THROWS_WITH(cue.setSettings(settings), ContainsSubstring(name));
  CHECK(cue.settings().maxFeatures == 100);
}
} // namespace

TEST_CASE("Settings out of range are named", "[point-cue]")
{
  CHECK(vpPointCue::isAvailable());
  CHECK_NOTHROW(vpPointCueSettings().check());
  checkRefused([](vpPointCueSettings &s) { s.maxFeatures = 0; }, "maxFeatures is 0");
  checkRefused([](vpPointCueSettings &s) { s.windowSize = 2; }, "windowSize is 2");
  checkRefused([](vpPointCueSettings &s) { s.quality = 0.; }, "quality");
  checkRefused([](vpPointCueSettings &s) { s.minDistance = -1.; }, "minDistance");
  checkRefused([](vpPointCueSettings &s) { s.harris = std::nan(""); }, "harris");
  checkRefused([](vpPointCueSettings &s) { s.blockSize = 64; }, "blockSize is 64");
  checkRefused([](vpPointCueSettings &s) { s.pyramidLevels = 11; }, "pyramidLevels is 11");
  checkRefused([](vpPointCueSettings &s) { s.maskBorder = 101; }, "maskBorder is 101");
  checkRefused([](vpPointCueSettings &s) { s.leastWeight = 1.; }, "leastWeight is 1");
}

TEST_CASE("The parameters of ViSP's tracker are taken over and obeyed", "[point-cue]")
{
  vpPointCueSettings settings;
  settings.set(Klt());
  CHECK(settings.maxFeatures == 60);
  CHECK(settings.windowSize == 9);
  CHECK(settings.quality == exactly(0.05));
  CHECK(settings.minDistance == exactly(12.));
  CHECK(settings.harris == exactly(0.03));
  CHECK(settings.blockSize == 5);
  CHECK(settings.pyramidLevels == 2);
  Klt bad;
  bad.levels = -1;
  CHECK_THROWS_WITH(settings.set(bad), ContainsSubstring("pyramidLevels"));
  CHECK(settings.pyramidLevels == 2);

  const Model model = makeBox();
  Painter painter(model);
  Follower follower(model, settings);
  follower.start(painter.draw(startPose()), startPose());
  follower.match(painter.draw(startPose()), startPose());
  CHECK(follower.found() <= 60);
  CHECK(follower.found() > 30);
  for (const vpPointCue::Match &a : follower.cue.matches()) {
    for (const vpPointCue::Match &b : follower.cue.matches()) {
      CHECK((&a == &b || (a.pixel - b.pixel).norm() > 11.));
    }
  }
  // A wider border leaves less surface.
  settings.minDistance = 3.;
  settings.maxFeatures = 1000;
  settings.maskBorder = 2;
  follower.cue.setSettings(settings);
  CHECK(follower.cue.pointCount() == 0);
  follower.start(painter.draw(startPose()), startPose());
  const std::size_t narrow = follower.cue.pointCount();
  settings.maskBorder = 12;
  follower.cue.setSettings(settings);
  follower.start(painter.draw(startPose()), startPose());
  CHECK(10 * follower.cue.pointCount() < 8 * narrow);
  CHECK(follower.cue.pointCount() > 10);
}

TEST_CASE("Depth is asked for at most once per frame, and only where points are wanted", "[point-cue]")
{
  const Model model = makeBox();
  Painter painter(model);
  const vpImage<unsigned char> I = painter.draw(startPose());
  Follower follower(model);
  CHECK_FALSE(follower.cue.wantsPoints());
  follower.match(I, startPose());
  CHECK(follower.cue.wantsPoints());
  CHECK(follower.renders == 0);
  follower.learn(startPose());
  CHECK(follower.renders == 1);
  CHECK_FALSE(follower.cue.wantsPoints());
  // The same match teaches once.
  follower.learn(startPose());
  CHECK(follower.renders == 1);
  for (int k = 0; k < 30; ++k) {
    follower.track(I, startPose());
  }
  CHECK(follower.renders == 1);

  vpPointCue cue;
  follower.cue.setDepthSource(nullptr);
  follower.cue.reset();
  follower.start(I, startPose());
  CHECK(follower.cue.pointCount() == 0);
  follower.cue.setDepthSource([](const vpHomogeneousMatrix &) { return nullptr; });
  follower.start(I, startPose());
  CHECK(follower.cue.pointCount() == 0);
}

TEST_CASE("Depth may be drawn smaller", "[point-cue]")
{
  const Model model = makeBox();
  Painter painter(model);
  vpCpuRenderer renderer(model);
  vpRenderedView small;
  Follower follower(model);
  follower.cue.setDepthSource([&](const vpHomogeneousMatrix &cMo) {
    vpRenderOptions options;
    options.scale = 0.37;
    renderer.render(cMo, makeCamera(), width, height, options, small);
    return &small;
  });
  follower.start(painter.draw(startPose()), startPose());
  REQUIRE(follower.cue.pointCount() > 50);
  const vpHomogeneousMatrix truth(0.01, -0.01, 0.5, 0.55, 0.62, 0.1);
  CHECK(imageError(*model, follower.track(painter.draw(truth), startPose()), truth) < 0.15);
  for (const vpPointCue::Match &match : follower.cue.matches()) {
    // On one of the sides, to a hundredth of a millimetre.
    const Eigen::Vector3d off = (match.position.cwiseAbs() - model->boxMax()).cwiseAbs();
    CHECK(off.minCoeff() < 1e-5);
  }
}

TEST_CASE("A border that is wider than the faces is the default one there", "[point-cue]")
{
  const Model model = makeBox();
  Painter painter(model);
  vpPointCueSettings settings;
  settings.minDistance = 3.;
  settings.maxFeatures = 1000;
  std::map<unsigned int, std::size_t> counts;
  for (const unsigned int border : {0U, 5U, 10U, 100U}) {
    settings.maskBorder = border;
    Follower follower(model, settings);
    follower.start(painter.draw(startPose()), startPose());
    counts[border] = follower.cue.pointCount();
  }
  CHECK(counts[0] > counts[5]);
  CHECK(counts[5] > counts[10]);
  CHECK(counts[10] > 20);
  CHECK(counts[100] == counts[5]);
}

TEST_CASE("New points are only where the filter allows them", "[point-cue]")
{
  const Model model = makeBox();
  Painter painter(model);
  Follower follower(model);
  follower.start(painter.draw(startPose()), startPose());
  const std::size_t everywhere = follower.cue.pointCount();
  follower.cue.setSurfaceFilter([](const Eigen::Vector3d &position) { return position.x() > 0.; });
  CHECK(follower.cue.pointCount() == 0);
  follower.start(painter.draw(startPose()), startPose());
  follower.match(painter.draw(startPose()), startPose());
  CHECK(follower.cue.pointCount() > 10);
  CHECK(follower.cue.pointCount() <= everywhere);
  for (const vpPointCue::Match &match : follower.cue.matches()) {
    CHECK(match.position.x() > 0.);
  }
  // Settings forget the points and not the filter.
  follower.cue.setSettings(vpPointCueSettings());
  follower.start(painter.draw(startPose()), startPose());
  follower.match(painter.draw(startPose()), startPose());
  for (const vpPointCue::Match &match : follower.cue.matches()) {
    CHECK(match.position.x() > 0.);
  }
}

#else
#include "pointCueMissing.h"
#endif
