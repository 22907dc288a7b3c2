// SPDX-License-Identifier: GPL-2.0-or-later
#include <visp3/cues/vpEdgeClustering.h>
#include <visp3/core/vpException.h>
#include <visp3/core/vpTime.h>
#include <visp3/se3/vpPoseRandom.h>

#include <catchMain.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <new>
#include <vector>

#ifdef ENABLE_VISP_NAMESPACE
using namespace VISP_NAMESPACE_NAME;
#endif

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

  // Each curve is the class that most of its points are in; its other points are wrong, and so are those of a class that
  // stands for two curves.
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
        all += static_cast<int>(
            std::count(scene.points[j].truth.begin(), scene.points[j].truth.end(), curve));
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
    std::cout << lines << " lines: " << 100. * score.share() << " % right, "
              << static_cast<double>(iterations) / scenes << " iterations" << std::endl;
    CHECK(score.share() > 0.98);
    CHECK(static_cast<double>(iterations) / scenes < 4.);
  }
}
