// SPDX-License-Identifier: GPL-2.0-or-later
#include "searchScenes.h"

// The library keeps them to itself.
#include "frame/vpFrameDeadline.cpp"
#include "search/vpContourAligner.cpp"
#include "search/vpPointProjection.cpp"
#include "search/vpPoseScore.cpp"
#include "search/vpPoseSearch.cpp"
#include "search/vpSameSide.cpp"

#include <catchMain.h>

#include <limits>

namespace {
using searchScenes::BoxScene;
using searchScenes::differenceOf;

const vpHomogeneousMatrix truth = searchScenes::truePose();

//! A scene and what its poses are judged with.
struct Judged : BoxScene
{
  Judged()
  {
    score.setSphere(&sphere);
    score.setImage(&edges, &odds, nullptr, camera, width, height);
    aligner.setSphere(&sphere);
    aligner.setImage(&odds, nullptr, camera, width, height);
  }

  //! What the tracker does where the object was lost, on a smaller scale.
  std::vector<vpPoseCandidate> searchFrom(const vpHomogeneousMatrix &start, std::uint64_t seed)
  {
    vpPoseSearch search(score, *model, seed);
    search.scatter({start}, {0.12, 0.35, 0.15}, 60);
    search.alignByColors(aligner, 0.15, 2);
    search.alignByColors(aligner, 0.08, 1);
    search.score();
    search.keepBest(24, {0.04, 0.12, 0.08});
    search.alignByColors(aligner, 0.05, 2);
    search.score();
    search.anneal({0.05, 0.15, 0.08}, 12, 60, 2);
    return search.candidates();
  }

  vpPoseScore score;
  vpContourAligner aligner;
};

bool isSame(const vpPoseCandidate &a, const vpPoseCandidate &b)
{
  return a.score == exactly(b.score) && std::equal(a.cMo.data, a.cMo.data + 16, b.cMo.data);
}
} // namespace

TEST_CASE("The true pose scores best", "[pose-score]")
{
  Judged scene;
  const vpPoseScore::Value best = scene.score(truth);
  CHECK(best.inside == exactly(1.));
  CHECK(best.distance < 0.45); // The edges inside the outline are not seen: all sides have one colour.
  CHECK(best.color > 0.8);
  CHECK(best.total > 0.75);
  for (const Eigen::Vector3d &axis : searchScenes::axes()) {
    double last = best.total;
    for (const double degrees : {5., 10., 20.}) {
      CAPTURE(axis.transpose(), degrees);
      const double total = scene.score(searchScenes::displaced(truth, axis, degrees, Eigen::Vector3d::Zero())).total;
      CHECK(total < best.total - 0.002 * degrees);
      last = total;
    }
    CHECK(last < best.total - 0.1);
  }
  CHECK(scene.score(searchScenes::displaced(truth, Eigen::Vector3d::UnitX(), 0., {0.01, 0., 0.})).total < best.total);
}

TEST_CASE("Edges alone and colours alone tell the true pose too", "[pose-score]")
{
  Judged scene;
  const vpHomogeneousMatrix wrong = searchScenes::displaced(truth, {1., 1., 0.}, 15., Eigen::Vector3d::Zero());
  scene.score.setImage(&scene.edges, nullptr, nullptr, scene.camera, scene.width, scene.height);
  CHECK(scene.score(truth).total > scene.score(wrong).total + 0.05);
  CHECK(scene.score(truth).color == exactly(0.));
  scene.score.setImage(nullptr, &scene.odds, nullptr, scene.camera, scene.width, scene.height);
  CHECK(scene.score(truth).total > scene.score(wrong).total + 0.05);
  scene.score.setImage(nullptr, nullptr, nullptr, scene.camera, scene.width, scene.height);
  CHECK(scene.score(truth).total == exactly(0.));
}

TEST_CASE("A pose with the object outside the image or behind the camera has the lowest score", "[pose-score]")
{
  Judged scene;
  std::vector<vpHomogeneousMatrix> poses(4, truth);
  poses[0][0][3] = 5.;
  poses[1][2][3] = -0.6;
  poses[2][1][3] = -5.;
  poses[3][2][3] = std::numeric_limits<double>::quiet_NaN();
  for (const vpHomogeneousMatrix &cMo : poses) {
    CHECK(scene.score(cMo).total == exactly(-1.));
    CHECK(scene.score(cMo).inside == exactly(0.));
  }
  vpHomogeneousMatrix partly = truth;
  partly[0][3] = 0.3;
  CHECK(scene.score(partly).inside > 0.2);
  CHECK(scene.score(partly).inside < 0.8);
}

TEST_CASE("What is remembered of the surface tells half a turn", "[pose-score]")
{
  Judged scene;
  colorScenes::Paint paint = searchScenes::plainPaint();
  paint.object = [](const Eigen::Vector3d &oX) {
    const double level =
        100. + 120. * colorScenes::hashed(colorScenes::cell(oX.x(), 0.022), colorScenes::cell(oX.y(), 0.022),
                                          colorScenes::cell(oX.z(), 0.022));
    return colorScenes::Color(level, 0.3 * level, 0.3 * level);
  };
  const vpHomogeneousMatrix halfTurn = truth * vpHomogeneousMatrix(0., 0., 0., 0., 0., M_PI);
  colorScenes::Scene drawn(*scene.model);
  vpSurfaceMemory memory;
  memory.setSamples(vpSampleSurface(*scene.model, 500));
  for (const vpHomogeneousMatrix &cMo : {halfTurn, truth}) {
    memory.setFrame(scene.source.frame(drawn.draw(cMo, paint), scene.camera, nullptr));
    memory.learn(cMo, nullptr);
  }
  CHECK(std::fabs(scene.score(truth).total - scene.score(halfTurn).total) < 0.02);
  scene.score.setImage(&scene.edges, &scene.odds, &memory, scene.camera, scene.width, scene.height);
  CHECK(scene.score(truth).surface > 0.75);
  CHECK(scene.score(truth).total > scene.score(halfTurn).total + 0.15);
}

TEST_CASE("A search keeps poses that are apart, the best ones first", "[pose-search]")
{
  Judged scene;
  vpPoseSearch search(scene.score, *scene.model, 1);
  search.scatter({truth}, {0.1, 0.3, 0.1}, 100);
  REQUIRE(search.candidates().size() == 101);
  search.score();
  CHECK(search.scored() == 101);
  const vpPoseSearch::Spread apart = {0.08, 0.2, 0.08};
  search.keepBest(10, apart);
  const std::vector<vpPoseCandidate> &kept = search.candidates();
  REQUIRE(kept.size() <= 10);
  REQUIRE(kept.size() >= 3);
  CHECK(differenceOf(kept[0].cMo, truth, *scene.model).degrees < 5.);
  for (std::size_t i = 1; i < kept.size(); ++i) {
    CHECK(kept[i].score <= kept[i - 1].score);
    for (std::size_t j = 0; j < i; ++j) {
      const searchScenes::Difference d = differenceOf(kept[i].cMo, kept[j].cMo, *scene.model);
      CHECK(std::hypot(d.diameters / apart.translation, d.degrees * M_PI / 180. / apart.rotation) >= 1.);
    }
  }
}

TEST_CASE("Distances along the line of sight have a unit of their own", "[pose-search]")
{
  Judged scene;
  const Eigen::Vector3d at = vpPoseExponential::toEigen(truth) * scene.model->centre();
  const Eigen::Vector3d sight = at.normalized();
  const Eigen::Vector3d across = sight.cross(Eigen::Vector3d::UnitX()).normalized();
  const auto kept = [&](const Eigen::Vector3d &direction, const vpPoseSearch::Spread &apart) {
    const Eigen::Vector3d shift = 0.1 * scene.model->diameter() * direction;
    vpPoseSearch search(scene.score, *scene.model, 1);
    search.scatter({truth, searchScenes::displaced(truth, Eigen::Vector3d::UnitX(), 0., shift)}, apart, 0);
    search.score();
    search.keepBest(10, apart);
    return search.candidates().size();
  };
  const vpPoseSearch::Spread roughDepth = {0.05, 0.1, 0.2};
  CHECK(kept(sight, roughDepth) == 1);
  CHECK(kept(across, roughDepth) == 2);
  const vpPoseSearch::Spread fineDepth = {0.2, 0.1, 0.05};
  CHECK(kept(sight, fineDepth) == 2);
  CHECK(kept(across, fineDepth) == 1);
}

TEST_CASE("A search whose time is over keeps those that it looked at", "[pose-search]")
{
  Judged scene;
  for (const double time : {0., 1e4}) {
    CAPTURE(time);
    vpFrameDeadline deadline;
    deadline.set(1e4);
    deadline.startFrame();
    vpPoseSearch search(scene.score, *scene.model, 1);
    search.scatter({truth}, {0.1, 0.3, 0.1}, 5);
    search.score();
    search.setLimit(deadline.after(time));
    search.scatter({truth}, {0.1, 0.3, 0.1}, 500);
    search.mix();
    search.score();
    CHECK(search.isCutShort() == (time < 1.));
    CHECK(search.scored() == (time < 1. ? 6U : 6U + 507U));
    search.keepBest(1000, {1e-9, 1e-9, 1e-9});
    CHECK(search.candidates().size() == (time < 1. ? 6U : 506U));
  }
}

TEST_CASE("A search that is to keep nothing keeps nothing", "[pose-search]")
{
  Judged scene;
  vpPoseSearch search(scene.score, *scene.model, 1);
  search.scatter({truth}, {0.1, 0.3, 0.1}, 5);
  search.score();
  search.anneal({0.1, 0.3, 0.1}, 0, 10, 2);
  CHECK(search.candidates().empty());
  search.scatter({truth}, {0.1, 0.3, 0.1}, 5);
  search.keepBest(1, {0.1, 0.3, 0.1});
  CHECK(search.candidates().empty()); // Nobody looked at them.
  search.scatter({truth}, {0.1, 0.3, 0.1}, 5);
  search.score();
  search.keepBest(1, {0.1, 0.3, 0.1});
  CHECK(search.candidates().size() == 1);
  search.keepBest(0, {0.1, 0.3, 0.1});
  CHECK(search.candidates().empty());
}

TEST_CASE("Poses near the expected one are likelier than those far from it", "[pose-search]")
{
  Judged scene;
  scene.score.setImage(nullptr, nullptr, nullptr, scene.camera, scene.width, scene.height);
  vpPoseSearch search(scene.score, *scene.model, 1);
  search.setPrior({truth}, {0.1, 0.3, 0.1}, vpPoseSearch::Tail::LIGHT);
  search.scatter({truth}, {0.1, 0.3, 0.1}, 20);
  search.score();
  search.keepBest(30, {1e-9, 1e-9, 1e-9});
  CHECK(search.candidates().front().score == exactly(0.));
  CHECK(differenceOf(search.candidates().front().cMo, truth, *scene.model).degrees < 1e-6);
  CHECK(search.candidates().back().score < -0.01);
}

TEST_CASE("Poses are scattered around a point on another line of sight", "[pose-search]")
{
  Judged scene;
  vpPoseSearch search(scene.score, *scene.model, 1);
  const Eigen::Vector3d centre(0.1, -0.05, 0.7);
  search.scatterAround(centre, truth, {0.05, 0.2, 0.05}, 50);
  REQUIRE(search.candidates().size() == 51);
  double worst = 0.;
  for (const vpPoseCandidate &candidate : search.candidates()) {
    const Eigen::Vector3d at = vpPoseExponential::toEigen(candidate.cMo) * scene.model->centre();
    worst = std::max(worst, (at - centre).norm() / scene.model->diameter());
  }
  CHECK(worst < 0.05 * 5.);
  // The same side of the object is seen there.
  CHECK(scene.sphere.directionOf(scene.sphere.nearest(search.candidates().front().cMo))
            .dot(scene.sphere.directionOf(scene.sphere.nearest(truth))) > 0.995);
}

TEST_CASE("The same seed gives the same bits, another one does not", "[pose-search]")
{
  Judged scene;
  const vpHomogeneousMatrix start = searchScenes::displaced(truth, {1., 0.3, 0.2}, 12., {0.01, 0., 0.});
  const std::vector<vpPoseCandidate> first = scene.searchFrom(start, 7);
  const std::vector<vpPoseCandidate> second = scene.searchFrom(start, 7);
  REQUIRE(first.size() == second.size());
  CHECK(std::equal(first.begin(), first.end(), second.begin(), isSame));
  const std::vector<vpPoseCandidate> other = scene.searchFrom(start, 8);
  CHECK_FALSE((other.size() == first.size() && std::equal(first.begin(), first.end(), other.begin(), isSame)));
}

TEST_CASE("A search finds the pose from 25 degrees and 0.15 diameters off", "[pose-search]")
{
  Judged scene;
  const double shift = 0.15 * scene.model->diameter() / std::sqrt(3.);
  for (const Eigen::Vector3d &axis : searchScenes::axes()) {
    CAPTURE(axis.transpose());
    const vpHomogeneousMatrix start = searchScenes::displaced(truth, axis, 25., {shift, -shift, shift});
    const std::vector<vpPoseCandidate> found = scene.searchFrom(start, 1);
    REQUIRE_FALSE(found.empty());
    const searchScenes::Difference left = differenceOf(found[0].cMo, truth, *scene.model);
    CHECK(left.degrees < 5.);
    CHECK(left.diameters < 0.05);
  }
}
