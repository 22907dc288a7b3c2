// SPDX-License-Identifier: GPL-2.0-or-later
#include <catchMain.h>

#include <visp3/core/vpException.h>
#include <visp3/cues/vpEdgeClustering.h>
#include <visp3/se3/vpPoseRandom.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <vector>

namespace {
const double step = 5.;   // Between control points, pixels.
const double noise = 0.7; // Of candidates, pixels.
const double missing = 0.3;

// A contour whose candidates come from known curves.
struct Scene
{
  struct Point
  {
    double arcLength = 0.;
    std::vector<double> offsets;
    std::vector<int> truth; // Curve of each candidate, -1 for clutter.
  };
  std::vector<Point> points;
  int curves = 0;
};

// Straight lines at random, nowhere closer to each other than 5 pixels and nowhere farther from the contour than 20.
Scene drawLines(vpPoseRandom &random, int count)
{
  Scene scene;
  scene.curves = count;
  const int n = 15 + static_cast<int>(random.index(30));
  std::vector<double> ends[2];
  double at[2] = {-18. + 4. * random.uniform(), -18. + 4. * random.uniform()};
  for (int line = 0; line < count; ++line) {
    for (int end = 0; end < 2; ++end) {
      ends[end].push_back(at[end]);
      at[end] += 5. + 4. * random.uniform();
    }
  }
  for (int j = 0; j < n; ++j) {
    Scene::Point point;
    point.arcLength = (j + 0.5) * step;
    const double s = (j + 0.5) / n;
    for (int line = 0; line < count; ++line) {
      if (random.uniform() >= missing) {
        const std::size_t l = static_cast<std::size_t>(line);
        point.offsets.push_back((1. - s) * ends[0][l] + s * ends[1][l] + noise * random.normal());
        point.truth.push_back(line);
      }
    }
    scene.points.push_back(point);
  }
  return scene;
}

void cluster(vpEdgeClustering &clustering, const Scene &scene,
             vpEdgeClustering::Shape shape = vpEdgeClustering::Shape::STRAIGHT, double turn = 0.)
{
  clustering.begin(shape, turn);
  for (const Scene::Point &point : scene.points) {
    clustering.add(point.arcLength, point.offsets.data(), static_cast<int>(point.offsets.size()));
  }
  clustering.compute();
}

struct Score
{
  int right = 0;
  int all = 0;

  double share() const { return static_cast<double>(right) / all; }

  // Each curve is the class that most of its points are in; its other points are wrong, and so are those of a class
  // that stands for two curves.
  void add(const vpEdgeClustering &clustering, const Scene &scene)
  {
    const int k = static_cast<int>(clustering.classes().size());
    std::vector<char> taken(static_cast<std::size_t>(k), 0);
    for (int curve = 0; curve < scene.curves; ++curve) {
      std::vector<int> votes(static_cast<std::size_t>(k), 0);
      for (std::size_t j = 0; j < scene.points.size(); ++j) {
        for (int label = 0; label < k; ++label) {
          const int member = clustering.member(label, static_cast<int>(j));
          votes[static_cast<std::size_t>(label)] +=
              member >= 0 && scene.points[j].truth[static_cast<std::size_t>(member)] == curve ? 1 : 0;
        }
        all += static_cast<int>(std::count(scene.points[j].truth.begin(), scene.points[j].truth.end(), curve));
      }
      const auto most = std::max_element(votes.begin(), votes.end());
      if (most != votes.end() && taken[static_cast<std::size_t>(most - votes.begin())] == 0) {
        taken[static_cast<std::size_t>(most - votes.begin())] = 1;
        right += *most;
      }
    }
  }
};
} // namespace

TEST_CASE("Two to four lines with gaps and noise are told apart in few iterations", "[clustering]")
{
  vpEdgeClustering clustering;
  for (const int lines : {2, 3, 4}) {
    CAPTURE(lines);
    Score score;
    int iterations = 0;
    const int scenes = 300;
    for (int i = 0; i < scenes; ++i) {
      vpPoseRandom random(1, {static_cast<std::uint64_t>(lines), static_cast<std::uint64_t>(i)});
      const Scene scene = drawLines(random, lines);
      cluster(clustering, scene);
      score.add(clustering, scene);
      iterations += clustering.iterations();
    }
    std::cout << lines << " lines: " << 100. * score.share() << " % right, " << static_cast<double>(iterations) / scenes
              << " iterations" << std::endl;
    CHECK(score.share() > 0.98);
    CHECK(static_cast<double>(iterations) / scenes < 4.);
  }
}

TEST_CASE("Clutter belongs to no class and does not hide the lines", "[clustering]")
{
  vpEdgeClustering clustering;
  Score score;
  for (int i = 0; i < 200; ++i) {
    vpPoseRandom random(2, {static_cast<std::uint64_t>(i)});
    Scene scene = drawLines(random, 2);
    for (Scene::Point &point : scene.points) {
      if (random.uniform() < 0.3) {
        point.offsets.push_back(-20. + 40. * random.uniform());
        point.truth.push_back(-1);
      }
    }
    cluster(clustering, scene);
    score.add(clustering, scene);
  }
  CHECK(score.share() > 0.93);
}

namespace {
// Two curves beside each other, the second one 6 pixels farther out.
template <typename Displacement> Scene drawCurves(vpPoseRandom &random, int n, const Displacement &displacement)
{
  Scene scene;
  scene.curves = 2;
  for (int j = 0; j < n; ++j) {
    Scene::Point point;
    point.arcLength = (j + 0.5) * step;
    for (int curve = 0; curve < 2; ++curve) {
      if (random.uniform() >= missing) {
        point.offsets.push_back(displacement((j + 0.5) / n) + 6. * curve + noise * random.normal());
        point.truth.push_back(curve);
      }
    }
    scene.points.push_back(point);
  }
  return scene;
}
} // namespace

TEST_CASE("A closed curve that moved as a whole, and the halves of one, are followed where a line would not do",
          "[clustering]")
{
  vpEdgeClustering clustering;
  Score closed, open, line;
  for (int i = 0; i < 100; ++i) {
    vpPoseRandom random(3, {static_cast<std::uint64_t>(i)});
    const double direction = 2. * M_PI * random.uniform();
    const Scene round = drawCurves(random, 40, [&](double s) { return 8. * std::cos(2. * M_PI * s - direction); });
    cluster(clustering, round, vpEdgeClustering::Shape::CLOSED_CURVE, 2. * M_PI);
    closed.add(clustering, round);
    cluster(clustering, round);
    line.add(clustering, round);
    const Scene half = drawCurves(random, 25, [&](double s) { return 8. * std::cos(M_PI * s - direction); });
    cluster(clustering, half, vpEdgeClustering::Shape::OPEN_CURVE, M_PI);
    open.add(clustering, half);
  }
  CHECK(closed.share() > 0.98);
  CHECK(open.share() > 0.98);
  CHECK(line.share() < 0.7);
}

TEST_CASE("Two candidates of one control point are never in one class, and members are told by their index",
          "[clustering]")
{
  vpEdgeClustering clustering;
  clustering.begin(vpEdgeClustering::Shape::STRAIGHT);
  for (int j = 0; j < 10; ++j) {
    const double offsets[] = {1., 0.}; // One line for a k-means without the constraint.
    clustering.add(step * j, offsets, 2);
  }
  clustering.compute();
  REQUIRE(clustering.classes().size() == 2);
  CHECK(clustering.displacement(0, 12.) == Approx(0.).margin(1e-6));
  CHECK(clustering.displacement(1, 12.) == Approx(1.));
  for (int j = 0; j < 10; ++j) {
    CHECK(clustering.member(0, j) == 1);
    CHECK(clustering.member(1, j) == 0);
  }
}

TEST_CASE("Draw weights follow equation 4, and what has few members is dropped", "[clustering]")
{
  vpEdgeClustering clustering;
  clustering.begin(vpEdgeClustering::Shape::STRAIGHT);
  for (int j = 0; j < 20; ++j) {
    const double offsets[] = {-6., 0., 7.};
    clustering.add(step * j, offsets, j < 4 ? 3 : j < 10 ? 2 : 0);
  }
  clustering.compute();
  REQUIRE(clustering.classes().size() == 2);
  CHECK(clustering.classes()[0].size == 10);
  // Half of the control points without a member: they count the cut-off of 3 pixels.
  CHECK(clustering.classes()[0].residue == Approx(3. * std::sqrt(0.5)));
  std::vector<double> weights;
  clustering.drawWeights(2., weights);
  CHECK(weights == std::vector<double>{1., 1.}); // Alike.

  clustering.begin(vpEdgeClustering::Shape::STRAIGHT);
  for (int j = 0; j < 20; ++j) {
    const double offsets[] = {-6., 0., 7.};
    clustering.add(step * j, offsets, j < 8 ? 3 : j < 12 ? 2 : 1);
  }
  clustering.compute();
  REQUIRE(clustering.classes().size() == 3);
  clustering.drawWeights(2., weights);
  const auto residue = [&](std::size_t c) { return clustering.classes()[c].residue; };
  const double share = (residue(1) - residue(0)) / (residue(2) - residue(0));
  CHECK(weights[0] == exactly(1.));
  CHECK(weights[1] == Approx(std::exp(-2. * share * share)));
  CHECK(weights[2] == Approx(std::exp(-2.)));
}

TEST_CASE("Contours without candidates, or with one control point, have no class; bad settings are refused",
          "[clustering]")
{
  vpEdgeClustering clustering;
  clustering.begin(vpEdgeClustering::Shape::STRAIGHT);
  clustering.compute();
  CHECK(clustering.classes().empty());
  const double offset = 1.;
  clustering.begin(vpEdgeClustering::Shape::CLOSED_CURVE);
  clustering.add(0., &offset, 0);
  clustering.compute();
  CHECK(clustering.classes().empty());
  clustering.begin(vpEdgeClustering::Shape::OPEN_CURVE, 1.);
  clustering.add(0., &offset, 1);
  clustering.compute();
  CHECK(clustering.classes().empty());
  vpEdgeClustering::Settings settings;
  settings.cutoff = 0.;
  CHECK_THROWS_AS(vpEdgeClustering(settings), vpException);
}
