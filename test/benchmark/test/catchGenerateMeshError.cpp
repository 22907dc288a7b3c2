// SPDX-License-Identifier: GPL-2.0-or-later
#include <catchMain.h>

#include "generateChecks.h"

#include "dataset/sequence.h"
#include "generate/meshError.h"

#include <visp3/core/vpException.h>
#include <visp3/model/vpModelReader.h>

#include <algorithm>
#include <filesystem>
#include <map>

using bench::ColoredTriangle;
using bench::SceneOptions;

namespace {
using Triangles = std::vector<ColoredTriangle>;
using Place = std::array<double, 3>;

Place placeOf(const Eigen::Vector3d &p)
{
  return {{p.x(), p.y(), p.z()}};
}

// Each edge once in each direction.
bool isClosed(const Triangles &triangles)
{
  std::map<std::pair<Place, Place>, int> edges;
  for (const ColoredTriangle &triangle : triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      const Place from = placeOf(triangle.position[i]);
      const Place to = placeOf(triangle.position[(i + 1) % 3]);
      edges[from < to ? std::make_pair(from, to) : std::make_pair(to, from)] += from < to ? 1 : -1;
    }
  }
  return std::all_of(edges.begin(), edges.end(), [](const auto &edge) { return edge.second == 0; });
}

double area(const Triangles &triangles)
{
  double sum = 0.;
  for (const ColoredTriangle &t : triangles) {
    sum += 0.5 * (t.position[1] - t.position[0]).cross(t.position[2] - t.position[0]).norm();
  }
  return sum;
}

double longestEdge(const Triangles &triangles)
{
  double longest = 0.;
  for (const ColoredTriangle &t : triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      longest = std::max(longest, (t.position[i] - t.position[(i + 1) % 3]).norm());
    }
  }
  return longest;
}

struct Box
{
  Eigen::Vector3d low = Eigen::Vector3d::Constant(1e9);
  Eigen::Vector3d high = Eigen::Vector3d::Constant(-1e9);
};

Box boxOf(const Triangles &triangles)
{
  Box box;
  for (const ColoredTriangle &triangle : triangles) {
    for (const Eigen::Vector3d &p : triangle.position) {
      box.low = box.low.cwiseMin(p);
      box.high = box.high.cwiseMax(p);
    }
  }
  return box;
}

// How far the faces of the box are from where they were, away from its rounded edges: mean, and the largest difference
// from it, metres.
std::pair<double, double> faceError(const Triangles &triangles, const Box &right)
{
  const Eigen::Vector3d centre = 0.5 * (right.low + right.high);
  const Eigen::Vector3d half = 0.5 * (right.high - right.low);
  std::vector<double> errors;
  for (const ColoredTriangle &triangle : triangles) {
    for (const Eigen::Vector3d &p : triangle.position) {
      const Eigen::Array3d relative = ((p - centre).array() / half.array()).abs();
      Eigen::Index axis = 0;
      relative.maxCoeff(&axis);
      if ((relative < 0.6).count() == 2) {
        errors.push_back((relative(axis) - 1.) * half(axis));
      }
    }
  }
  double mean = 0.;
  for (const double error : errors) {
    mean += error / static_cast<double>(errors.size());
  }
  double most = 0.;
  for (const double error : errors) {
    most = std::max(most, std::abs(error - mean));
  }
  return {mean, most};
}
} // namespace

TEST_CASE("Subdivided meshes have short edges, the same surface and no gaps")
{
  const bench::SyntheticObject box = bench::makeBox(1);
  REQUIRE(isClosed(box.triangles));
  const Triangles parts = bench::subdivide(box.triangles, 0.02);
  CHECK(parts.size() > 10 * box.triangles.size());
  CHECK(longestEdge(parts) <= 0.02);
  CHECK(area(parts) == Approx(area(box.triangles)));
  CHECK(isClosed(parts));
}

TEST_CASE("A reconstruction is uneven and of another size, without gaps, and the same for the same seed")
{
  const bench::SyntheticObject box = bench::makeBox(1);
  const Box right = boxOf(box.triangles);
  const double diameter = (right.high - right.low).norm();
  const Triangles wrong = bench::reconstructed(box.triangles, 1., 5);
  CHECK(isClosed(wrong));
  const std::pair<double, double> error = faceError(wrong, right);
  CHECK(error.second > 0.002 * diameter);
  CHECK(error.second < 0.02 * diameter);
  const Triangles again = bench::reconstructed(box.triangles, 1., 5);
  CHECK(again[100].position[1] == wrong[100].position[1]);
  const Triangles other = bench::reconstructed(box.triangles, 1., 6);
  CHECK(other[100].position[1] != wrong[100].position[1]);
  const Triangles strong = bench::reconstructed(box.triangles, 3., 5);
  CHECK(faceError(strong, right).second > 2. * error.second);
}

TEST_CASE("A reconstruction's corners are round, and keep their pictures")
{
  const bench::SyntheticObject box = bench::makeBox(1);
  const Box right = boxOf(box.triangles);
  const Eigen::Vector3d half = 0.5 * (right.high - right.low);
  const Eigen::Vector3d centre = 0.5 * (right.high + right.low);
  for (const std::uint64_t seed : {1U, 2U, 3U, 4U}) {
    Eigen::Matrix<double, 8, 1> reach = Eigen::Matrix<double, 8, 1>::Zero(); // Towards each corner.
    bool hasPictures = true;
    for (const ColoredTriangle &triangle : bench::reconstructed(box.triangles, 1., seed)) {
      hasPictures = hasPictures && triangle.image >= 0 && triangle.texture[0].minCoeff() >= 0.F &&
                    triangle.texture[2].maxCoeff() <= 1.F;
      for (int k = 0; k < 8; ++k) {
        const Eigen::Vector3d corner(k & 1 ? 1. : -1., k & 2 ? 1. : -1., k & 4 ? 1. : -1.);
        const Eigen::Vector3d direction = half.cwiseProduct(corner).normalized();
        for (const Eigen::Vector3d &p : triangle.position) {
          reach(k) = std::max(reach(k), direction.dot(p - centre));
        }
      }
    }
    CHECK(hasPictures);
    // Sharp corners would reach 1 % farther where the mesh is too large.
    INFO(seed);
    CHECK(reach.mean() < 1.003 * half.norm());
    CHECK(reach.mean() > 0.95 * half.norm());
  }
}

TEST_CASE("Trackers find the wrong mesh, and images and poses are those of the right one")
{
  const meshFiles::TemporaryFolder folder;
  for (const std::string object : {"box", "figurine"}) {
    SceneOptions options = generateChecks::options(folder.path("right"), object, "regular", 3);
    bench::generateScene(options);
    options.dataset = folder.path("wrong");
    options.meshError = 1.;
    bench::generateScene(options);
    const std::string scene = bench::sceneName(options);
    for (const std::string name : {"/rgb/000002.png", "/scene_gt.json"}) {
      CHECK(generateChecks::bytesOf(folder.path("right/" + scene + name)) ==
            generateChecks::bytesOf(folder.path("wrong/" + scene + name)));
    }
    const bench::SequenceObject right = bench::openSequence(folder.path("right"), scene).object;
    const bench::SequenceObject wrong = bench::openSequence(folder.path("wrong"), scene).object;
    CHECK(generateChecks::bytesOf(right.mesh) != generateChecks::bytesOf(wrong.mesh));
    CHECK(wrong.cao.empty());
    CHECK(wrong.diameter == Approx(right.diameter).epsilon(0.06));
    CHECK(std::abs(wrong.diameter / right.diameter - 1.) > 0.002);
    CHECK(std::filesystem::exists(folder.path("wrong/models_rendered")));
    CHECK(bench::listScenes(folder.path("wrong")).size() == (object == "box" ? 1 : 2));
  }
}

TEST_CASE("An exact .cao of an earlier scene does not stay beside a wrong mesh")
{
  const meshFiles::TemporaryFolder folder;
  SceneOptions options = generateChecks::options(folder.path("data"), "box", "regular", 2);
  const bench::Scene right(options);
  CHECK(std::filesystem::exists(folder.path("data/models/obj_000001.cao")));
  options.meshError = 1.;
  const bench::Scene wrong(options);
  CHECK_FALSE(std::filesystem::exists(folder.path("data/models/obj_000001.cao")));
  options.meshError = -1.;
  CHECK_THROWS_WITH(bench::Scene(options), ContainsSubstring("--mesh-error: -1"));
}
