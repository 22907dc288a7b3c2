// SPDX-License-Identifier: GPL-2.0-or-later
#include <catchMain.h>

#include "dataset/largestDistance.h"
#include "dataset/datasetFiles.h"
#include "datasetFolder.h"
#include "frames/filePattern.h"

#include <visp3/se3/vpPoseRandom.h>

namespace {
double longestOfAllPairs(const std::vector<Eigen::Vector3d> &points)
{
  double longest = 0.;
  for (const Eigen::Vector3d &a : points) {
    for (const Eigen::Vector3d &b : points) {
      longest = std::max(longest, (a - b).norm());
    }
  }
  return longest;
}
} // namespace

TEST_CASE("The largest distance of two points is that of all pairs", "[dataset]")
{
  CHECK(programs::largestDistance({}) == exactly(0.));
  CHECK(programs::largestDistance({Eigen::Vector3d(1., 2., 3.)}) == exactly(0.));
  vpPoseRandom random(7);
  for (int run = 0; run < 20; ++run) {
    // From flat over elongated to round, with a crowd on one side that pulls the centre away.
    std::vector<Eigen::Vector3d> points(30, Eigen::Vector3d(0.9, 0.1, 0.));
    for (int i = 0; i < 100; ++i) {
      points.emplace_back(random.uniform(), 0.1 * run * random.uniform(), 0.05 * run * random.uniform());
    }
    CHECK(programs::largestDistance(points) == Approx(longestOfAllPairs(points)).epsilon(1e-12));
  }
}

TEST_CASE("Numbered paths are those of printf", "[dataset]")
{
  CHECK(bench::numberedPath("a-%d.png", 12) == "a-12.png");
  CHECK(bench::numberedPath("a-%04d.png", 12) == "a-0012.png");
  CHECK(bench::numberedPath("a-%4d.png", 12) == "a-  12.png");
  CHECK(bench::numberedPath("100%%/%02d", 123) == "100%/123");
}

TEST_CASE("The files of a pattern are those whose name printf() would write", "[dataset]")
{
  const DatasetFolder folder;
  for (const char *name : {"a-0001.png", "a-0002.png", "a-3.png", "a-00004.png", "a-10000.png", "a-   7.png", "a-x.png",
                           "b/01/rgb.png", "b/02/rgb.png", "b/3/rgb.png", "50%-8.png"}) {
    folder.put(name);
  }
  const auto numbers = [&](const std::string &pattern) {
    std::string all;
    for (const auto &[number, file] : programs::FilePattern(folder.path(pattern)).existing()) {
      CHECK(std::filesystem::is_regular_file(file));
      all += std::to_string(number) + " ";
    }
    return all;
  };
  CHECK(numbers("a-%04d.png") == "1 2 10000 ");
  CHECK(numbers("a-%d.png") == "3 10000 ");
  CHECK(numbers("a-%4d.png") == "7 10000 ");
  CHECK(numbers("b/%02d/rgb.png") == "1 2 ");
  CHECK(numbers("50%%-%d.png") == "8 ");
  CHECK(numbers("none%d.png") == "");
}

TEST_CASE("Of two types of an image one is taken, and other files are left", "[dataset]")
{
  const DatasetFolder folder;
  for (const char *name : {"000002.jpg", "000002.png", "7.TIF", "depth.png", "000003.json", "12345678901.png"}) {
    folder.put(name);
  }
  const std::map<int, std::filesystem::path> images = bench::numberedImages(folder.path());
  REQUIRE(images.size() == 2);
  CHECK(images.at(2) == folder.path("000002.png"));
  CHECK(images.at(7) == folder.path("7.TIF"));
}
