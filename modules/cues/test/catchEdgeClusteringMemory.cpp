// SPDX-License-Identifier: GPL-2.0-or-later
#include <catchMain.h>
#include <countAllocations.h>

#include <visp3/core/vpTime.h>
#include <visp3/cues/vpEdgeClustering.h>
#include <visp3/se3/vpPoseRandom.h>

#include <algorithm>
#include <iostream>

namespace {
using countAllocations::allocations;

// Forty control points, three parallel lines 7 pixels apart.
void cluster(vpEdgeClustering &clustering)
{
  vpPoseRandom random(1);
  clustering.begin(vpEdgeClustering::Shape::STRAIGHT);
  for (int j = 0; j < 40; ++j) {
    const double offsets[] = {-7. + random.uniform(), random.uniform(), 7. + random.uniform()};
    clustering.add(5. * j, offsets, random.uniform() < 0.3 ? 2 : 3);
  }
  clustering.compute();
}
} // namespace

TEST_CASE("A contour is segmented in microseconds, without allocation", "[clustering]")
{
  vpEdgeClustering clustering;
  cluster(clustering);
  REQUIRE(clustering.classes().size() == 3);
  const std::size_t before = allocations;
  double least = 1e9; // Others may be busy on this machine.
  for (int i = 0; i < 200; ++i) {
    const double begin = vpTime::measureTimeMicros();
    cluster(clustering);
    least = std::min(least, vpTime::measureTimeMicros() - begin);
  }
  CHECK(allocations == before);
  std::cout << "40 control points, 3 lines: " << least << " us" << std::endl;
  CHECK(least < 100.);
}
