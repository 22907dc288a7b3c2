// SPDX-License-Identifier: GPL-2.0-or-later
#include <catchMain.h>

#ifdef CUES_TESTS_HAVE_POINTS

#include "pointScenes.h"

using namespace pointScenes;

namespace {
// A wall with a smaller one before it that hides a part: seen from the front.
Model makeWalls()
{
  std::vector<modelShapes::Polygon> polygons = modelShapes::boxPolygons({0.2, 0.16, 0.02}, {0., 0., 0.05});
  const std::vector<modelShapes::Polygon> front = modelShapes::boxPolygons({0.06, 0.16, 0.02}, {0., 0., -0.05});
  polygons.insert(polygons.end(), front.begin(), front.end());
  return std::make_shared<const vpTrackedModel>(modelShapes::build(polygons));
}

// Which side of the box around the origin a point is on: 0 to 5.
int sideOf(const vpTrackedModel &model, const Eigen::Vector3d &oX)
{
  int side = -1;
  for (int axis = 0; axis < 3; ++axis) {
    if (std::fabs(oX[axis] - model.boxMin()[axis]) < 1e-5) {
      side = 2 * axis;
    }
    if (std::fabs(oX[axis] - model.boxMax()[axis]) < 1e-5) {
      side = 2 * axis + 1;
    }
  }
  return side;
}

bool isInside(const vpPointCue::Match &match, int left, int top, int right, int bottom)
{
  return match.pixel.x() >= left && match.pixel.x() < right && match.pixel.y() >= top && match.pixel.y() < bottom;
}
} // namespace

TEST_CASE("Points lie on the surface, spread, and away from its edges", "[point-cue]")
{
  const Model model = makeBox();
  Painter painter(model);
  Follower follower(model);
  follower.start(painter.draw(startPose()), startPose());
  follower.match(painter.draw(startPose()), startPose());
  const std::vector<vpPointCue::Match> &matches = follower.cue.matches();
  REQUIRE(matches.size() == 100);
  std::vector<int> onSide(6, 0);
  for (std::size_t i = 0; i < matches.size(); ++i) {
    const int side = sideOf(*model, matches[i].position);
    REQUIRE(side >= 0);
    ++onSide[static_cast<std::size_t>(side)];
    // Five pixels are 6 mm at 0.5 m, and less where the side is seen at an angle.
    int distances = 0;
    for (int axis = 0; axis < 3; ++axis) {
      const double toEdge = std::min(matches[i].position[axis] - model->boxMin()[axis],
                                     model->boxMax()[axis] - matches[i].position[axis]);
      distances += toEdge > 0.004 ? 1 : 0;
    }
    CHECK(distances == 2);
    for (std::size_t j = 0; j < i; ++j) {
      CHECK((matches[i].pixel - matches[j].pixel).norm() > 4.5);
    }
  }
  CHECK(std::count_if(onSide.begin(), onSide.end(), [](int n) { return n >= 10; }) == 3);
}

TEST_CASE("Points of a side that turns away are dropped", "[point-cue]")
{
  const Model model = makeBox();
  Painter painter(model);
  Follower follower(model);
  follower.start(painter.draw(startPose()), startPose());
  std::vector<char> before(6, 0);
  std::vector<char> after(6, 0);
  for (int k = 0; k <= 40; ++k) {
    const vpHomogeneousMatrix truth(0., 0., 0.5, 0.5, 0.6 - 0.04 * k, 0.1);
    follower.track(painter.draw(truth), truth);
    for (const vpPointCue::Match &match : follower.cue.matches()) {
      std::vector<char> &seen = k == 0 ? before : after;
      seen[static_cast<std::size_t>(sideOf(*model, match.position))] = k == 0 || k == 40;
    }
  }
  CHECK(std::count(before.begin(), before.end(), 1) == 3);
  CHECK(std::count(after.begin(), after.end(), 1) >= 2);
  CHECK(before != after);
  CHECK(follower.cue.pointCount() > 60);
}

TEST_CASE("Points that another part of the object hides are dropped", "[point-cue]")
{
  const Model model = makeWalls();
  Painter painter(model);
  const auto pose = [](int k) { return vpHomogeneousMatrix(0., 0., 0.5, 0., 0.02 * k, 0.); };
  vpPointCueSettings settings;
  settings.maxFeatures = 200;
  Follower follower(model, settings);
  follower.start(painter.draw(pose(-12)), pose(-12));
  const auto onWallBehind = [&]() {
    std::vector<Eigen::Vector3d> points;
    for (const vpPointCue::Match &match : follower.cue.matches()) {
      if (match.position.z() > 0. && match.found) {
        points.push_back(match.position);
      }
    }
    return points;
  };
  for (int k = -11; k <= 12; ++k) {
    follower.track(painter.draw(pose(k)), pose(k));
    // Not one is found where the front wall, at depth 0.44, covers it.
    const vpHomogeneousMatrix oMc = pose(k).inverse();
    for (const Eigen::Vector3d &oX : onWallBehind()) {
      const Eigen::Vector3d eye(oMc[0][3], oMc[1][3], oMc[2][3]);
      const Eigen::Vector3d crossing = eye + (oX - eye) * ((-0.06 - eye.z()) / (oX.z() - eye.z()));
      CHECK(std::fabs(crossing.x()) > 0.028);
    }
  }
  CHECK(onWallBehind().size() > 20);
}

TEST_CASE("What passes before the object takes its points away, and gives them back", "[point-cue]")
{
  const Model model = makeBox();
  Painter painter(model);
  Follower follower(model);
  const vpImage<unsigned char> I = painter.draw(startPose());
  follower.start(I, startPose());
  follower.cue.setDepthSource(nullptr); // No new points from here on.
  const std::size_t all = follower.cue.pointCount();
  REQUIRE(all == 100);
  // Marble of another kind before a half of the object.
  vpImage<unsigned char> covered = I;
  for (unsigned int i = 0; i < height; ++i) {
    for (unsigned int j = 0; j < 165; ++j) {
      covered[i][j] = static_cast<unsigned char>(40. + 170. * marble(Eigen::Vector3d(j, i, 7.5), 6.));
    }
  }
  for (int k = 0; k < 3; ++k) {
    const vpHomogeneousMatrix cMo = follower.track(covered, startPose());
    CHECK(imageError(*model, cMo, startPose()) < 0.2);
    // Two stones may look alike by chance, but not where the pose has them.
    std::size_t row = 0;
    int byChance = 0;
    for (const vpPointCue::Match &match : follower.cue.matches()) {
      if (match.found && isInside(match, 0, 0, 158, 240)) {
        ++byChance;
        CHECK(follower.weights[row] * follower.weights[row + 1] == exactly(0.));
      }
      row += match.found ? 2 : 0;
    }
    CHECK(byChance < 4);
    CHECK(follower.found() > 20);
    CHECK(follower.found() < 80);
  }
  follower.track(I, startPose());
  CHECK(follower.found() > 95);
  // After more frames than that they are lost.
  for (int k = 0; k < 5; ++k) {
    follower.track(covered, startPose());
  }
  CHECK(follower.cue.pointCount() < 80);
}

TEST_CASE("Images without anything in them give no rows", "[point-cue]")
{
  const Model model = makeBox();
  Painter painter(model);
  for (const int level : {0, 128, 255}) {
    Follower follower(model);
    const vpImage<unsigned char> I(height, width, static_cast<unsigned char>(level));
    for (int k = 0; k < 15; ++k) {
      CHECK_NOTHROW(follower.match(I, startPose()));
      CHECK_NOTHROW(follower.learn(startPose()));
      CHECK(follower.block.rows.empty());
    }
    CHECK(follower.cue.pointCount() == 0);
    CHECK(follower.renders < 4); // Nor are they looked at in every frame.
    // And where there were points before.
    follower.start(painter.draw(startPose()), startPose());
    follower.match(I, startPose());
    CHECK(follower.found() == 0);
  }
}

TEST_CASE("Nothing is looked for where the object is not in the image", "[point-cue]")
{
  const Model model = makeBox();
  Painter painter(model);
  Follower follower(model);
  const vpImage<unsigned char> I = painter.draw(startPose());
  for (const vpHomogeneousMatrix &cMo :
       {vpHomogeneousMatrix(5., 0., 0.5, 0., 0., 0.), vpHomogeneousMatrix(0., 0., -0.5, 0., 0., 0.),
        vpHomogeneousMatrix(0., 0., 0., 0., 0., 0.), vpHomogeneousMatrix(0., 0., 50., 0., 0., 0.)}) {
    follower.start(I, startPose());
    CHECK_NOTHROW(follower.match(I, cMo));
    CHECK_NOTHROW(follower.learn(cMo));
    follower.cue.reset();
  }
  // At the border of the image.
  const vpHomogeneousMatrix aside(0.2, 0.1, 0.5, 0.5, 0.6, 0.1);
  const vpImage<unsigned char> cut = painter.draw(aside);
  follower.start(cut, aside);
  follower.match(cut, aside);
  CHECK(follower.found() > 10);
  CHECK(follower.found() == follower.cue.pointCount());
}

TEST_CASE("Nothing is used that the mask hides", "[point-cue]")
{
  const Model model = makeBox();
  Painter painter(model);
  const vpImage<unsigned char> I = painter.draw(startPose());
  vpImage<bool> mask(height, width, true);
  for (unsigned int i = 0; i < height; ++i) {
    for (unsigned int j = 140; j < 185; ++j) {
      mask[i][j] = false;
    }
  }
  Follower masked(model);
  masked.start(I, startPose(), &mask);
  masked.match(I, startPose());
  CHECK(masked.found() > 50);
  for (const vpPointCue::Match &match : masked.cue.matches()) {
    CHECK_FALSE(isInside(match, 140 - 4, 0, 185 + 4, 240)); // Nor what is beside it.
  }
  Follower follower(model);
  follower.start(I, startPose());
  follower.match(I, startPose(), &mask);
  CHECK(follower.found() > 30);
  for (const vpPointCue::Match &match : follower.cue.matches()) {
    CHECK_FALSE((match.found && isInside(match, 140, 0, 185, 240)));
  }
}

TEST_CASE("An image of another size starts anew", "[point-cue]")
{
  const Model model = makeBox();
  Painter painter(model);
  Follower follower(model);
  follower.start(painter.draw(startPose()), startPose());
  const vpImage<unsigned char> larger = painter.draw(startPose(), width + 40, height + 30);
  follower.match(larger, startPose());
  CHECK(follower.found() == 0);
  CHECK(follower.cue.pointCount() == 0);
  CHECK(follower.cue.wantsPoints());
  follower.learn(startPose());
  follower.match(larger, startPose());
  CHECK(follower.found() == 100);
}

TEST_CASE("An object that comes near is followed over areas of different size", "[point-cue]")
{
  const Model model = makeBox();
  Painter painter(model);
  Follower follower(model);
  const auto pose = [](int k) { return vpHomogeneousMatrix(0., 0., 1.2 * std::pow(0.96, k), 0.5, 0.6, 0.1); };
  follower.start(painter.draw(pose(0)), pose(0));
  vpHomogeneousMatrix cMo = pose(0);
  for (const int direction : {1, -1}) {
    for (int k = direction > 0 ? 1 : 29; k <= 30 && k >= 0; k += direction) {
      cMo = follower.track(painter.draw(pose(k)), cMo);
      CHECK(imageError(*model, cMo, pose(k)) < 1.);
      CHECK(follower.found() > 20);
    }
  }
}

#else
#include "pointCueMissing.h"
#endif
