// SPDX-License-Identifier: GPL-2.0-or-later
#include <visp3/model/vpCpuRenderer.h>

#include "renderModels.h"

#include <catchMain.h>

namespace {
//! A closed surface with hollows, of 8 rings^2 triangles; \e loose: and a triangle inside it, which opens it.
ModelPointer makeLump(int rings, bool loose)
{
  const auto at = [rings](int ring, int sector) {
    const double polar = pi * ring / rings;
    const double angle = pi * sector / rings;
    const double radius = 0.05 * (1. + 0.3 * std::sin(3. * polar) * std::cos(2. * angle) * std::sin(polar));
    const double across = ring == 0 || ring == rings ? 0. : radius * std::sin(polar);
    return Eigen::Vector3d(across * std::cos(angle), across * std::sin(angle), radius * std::cos(polar));
  };
  vpTrackedModelBuilder builder;
  for (int i = 0; i < rings; ++i) {
    for (int j = 0; j < 2 * rings; ++j) {
      const int next = (j + 1) % (2 * rings);
      if (i > 0) {
        builder.addFace({at(i, j), at(i + 1, next), at(i, next)});
      }
      if (i + 1 < rings) {
        builder.addFace({at(i, j), at(i + 1, j), at(i + 1, next)});
      }
    }
  }
  if (loose) {
    builder.addFace({{0., 0., 0.}, {0.01, 0., 0.}, {0., 0.01, 0.}});
  }
  return build(builder);
}
} // namespace

TEST_CASE("A fine mesh is the same whether what faces away is left out or drawn", "[renderer]")
{
  const ModelPointer closed = makeLump(40, false);
  const ModelPointer open = makeLump(40, true);
  REQUIRE(closed->report().closed);
  REQUIRE_FALSE(open->report().closed);
  vpCpuRenderer closedRenderer(closed);
  vpCpuRenderer openRenderer(open);
  vpRenderOptions options;
  vpRenderedView seen;
  vpRenderedView all;
  std::mt19937 random(3);
  for (const double distance : {0.08, 0.3, 1.}) {
    for (int i = 0; i < 10; ++i) {
      const vpHomogeneousMatrix cMo = randomPose(random, distance);
      closedRenderer.render(cMo, makeCamera(), 640, 480, options, seen);
      openRenderer.render(cMo, makeCamera(), 640, 480, options, all);
      REQUIRE(seen.depth.size() == all.depth.size());
      double worst = 0.;
      for (std::size_t k = 0; k < seen.depth.size(); ++k) {
        worst = std::max(worst, static_cast<double>(std::abs(seen.depth[k] - all.depth[k])));
      }
      CHECK(worst < 1e-5 * distance);
    }
  }
}
