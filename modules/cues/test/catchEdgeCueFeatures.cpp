// SPDX-License-Identifier: GPL-2.0-or-later
#include "edgeScenes.h"

#include <catchMain.h>
#include <countAllocations.h>

using namespace edgeScenes;

namespace {
using countAllocations::allocations;

const Line edge{Eigen::Vector2d(80., 60.), 0.};

std::size_t count(const std::vector<vpCueFeature> &features, vpFeatureState state)
{
  return static_cast<std::size_t>(
      std::count_if(features.begin(), features.end(), [state](const vpCueFeature &f) { return f.state == state; }));
}
} // namespace

TEST_CASE("features are where edges were found, with the state of their row", "[edge-features]")
{
  vpEdgeCue cue;
  // The right half shows no edge.
  const vpImage<unsigned char> I = draw([](const Eigen::Vector2d &pixel) {
    return pixel.x() < 82. ? 50. + 100. * blurredStep(edge.distance(pixel), 0.7) : 100.;
  });
  match(cue, I, viewOf({edge.moved(3.)}, 30.));
  std::vector<double> weights(found(cue), 1.);
  REQUIRE(weights.size() > 4);
  REQUIRE(weights.size() < cue.matches().size());
  weights[1] = 0.;
  std::vector<vpCueFeature> features(3);
  cue.getFeatures(vpHomogeneousMatrix(), weights, features);
  REQUIRE(features.size() == cue.matches().size());
  CHECK(count(features, vpFeatureState::OUTLIER) == 1);
  CHECK(count(features, vpFeatureState::GOOD) == weights.size() - 1);
  CHECK(count(features, vpFeatureState::THRESHOLD) == cue.matches().size() - weights.size());
  std::size_t row = 0;
  for (std::size_t i = 0; i < features.size(); ++i) {
    const vpEdgeCue::Match &match = cue.matches()[i];
    if (match.count > 0) {
      CHECK((features[i].state == vpFeatureState::OUTLIER) == (row == 1));
      ++row;
    }
    if (match.point.pixel.x() < 75.) {
      CHECK(features[i].u == Approx(match.point.pixel.x()).margin(0.01));
      CHECK(features[i].v == Approx(60.).margin(0.1));
    }
    if (match.count == 0) {
      CHECK(features[i].v == Approx(63.).margin(1e-6));
    }
  }
}

TEST_CASE("a contrast that changed too much is told from none", "[edge-features]")
{
  vpEdgeCue cue;
  const vpModelView view = viewOf({edge});
  match(cue, drawStep(edge, 150.), view);
  learn(cue);
  match(cue, drawStep(edge, 40.), view);
  std::vector<vpCueFeature> features;
  cue.getFeatures(vpHomogeneousMatrix(), {}, features);
  CHECK(count(features, vpFeatureState::CONTRAST) == view.points().size());
  match(cue, drawStep(edge, 2.), view);
  cue.getFeatures(vpHomogeneousMatrix(), {}, features);
  CHECK(count(features, vpFeatureState::THRESHOLD) == view.points().size());
}

TEST_CASE("features without weights, or behind the camera, are good where they were matched", "[edge-features]")
{
  vpEdgeCue cue;
  match(cue, drawStep(edge, 100.), viewOf({edge.moved(2.)}));
  std::vector<vpCueFeature> features;
  for (const double z : {0., -3.}) {
    cue.getFeatures(vpHomogeneousMatrix(0., 0., z, 0., 0., 0.), {}, features);
    CHECK(count(features, vpFeatureState::GOOD) == cue.matches().size());
    CHECK(features[0].v == Approx(z < 0. ? 62. : 60.).margin(0.1));
  }
}

TEST_CASE("nothing is allocated once the memory of an earlier frame suffices", "[edge-features]")
{
  const vpImage<unsigned char> I = drawStep(edge, 100., 1.);
  const vpModelView view = viewOf({edge.moved(1.), edge.moved(-2.)});
  vpFrameSource source;
  vpEdgeCue cue;
  vpResidualBlock block;
  std::vector<vpCueFeature> features;
  const vpHomogeneousMatrix cMo;
  std::vector<double> weights;
  const auto track = [&]() {
    cue.match(source.frame(I, makeCamera(), nullptr), view);
    cue.residuals(cMo, block);
    weights.assign(block.rows.size(), 1.);
    cue.updateReference(cMo, weights);
    cue.getFeatures(cMo, weights, features);
  };
  track();
  const std::size_t before = allocations;
  track();
  CHECK(allocations - before < 8); // ViSP's camera parameters may own a little.
  const std::size_t start = allocations;
  for (int i = 0; i < 20; ++i) {
    cue.residuals(cMo, block);
  }
  CHECK(allocations == start);
  CHECK(block.rows.size() > 20);
}
