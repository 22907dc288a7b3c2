// SPDX-License-Identifier: GPL-2.0-or-later
#include <catchMain.h>

#ifdef CUES_TESTS_HAVE_POINTS

#include "pointScenes.h"

#include <visp3/core/vpException.h>

using namespace pointScenes;

namespace {
vpHomogeneousMatrix movedCamera(const vpHomogeneousMatrix &cMo, int axis, double step)
{
  vpColVector velocity(6, 0.);
  velocity[static_cast<unsigned int>(axis)] = step;
  return vpExponentialMap::direct(velocity).inverse() * cMo;
}

// A cue that has matched the second of two images.
struct Matched
{
  Matched() : model(makeBox()), painter(model), follower(model)
  {
    follower.start(painter.draw(startPose()), startPose());
    follower.match(painter.draw(next), next);
  }

  vpHomogeneousMatrix next = vpHomogeneousMatrix(0.01, -0.005, 0.49, 0.52, 0.58, 0.12);
  Model model;
  Painter painter;
  Follower follower;
};
} // namespace

TEST_CASE("The interaction matrix is the derivative of the error", "[point-cue]")
{
  Matched m;
  REQUIRE(m.follower.found() > 50);
  const vpHomogeneousMatrix cMo(0.02, -0.01, 0.47, 0.6, 0.5, 0.2);
  m.follower.cue.residuals(cMo, m.follower.block);
  const std::vector<vpResidual> rows = m.follower.block.rows;
  CHECK(rows.size() == 2 * m.follower.found());
  const double step = 1e-6;
  for (int axis = 0; axis < 6; ++axis) {
    vpResidualBlock before;
    vpResidualBlock after;
    m.follower.cue.residuals(movedCamera(cMo, axis, -step), before);
    m.follower.cue.residuals(movedCamera(cMo, axis, step), after);
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const double slope = (after.rows[i].error - before.rows[i].error) / (2. * step);
      CHECK(rows[i].jacobian[axis] == Approx(slope).margin(1e-7));
    }
  }
}

TEST_CASE("The error is the distance in the image over the focal length", "[point-cue]")
{
  Matched m;
  m.follower.cue.residuals(m.next, m.follower.block);
  CHECK(m.follower.block.noise == Approx(0.3 / 400.));
  std::size_t row = 0;
  for (const vpPointCue::Match &match : m.follower.cue.matches()) {
    if (match.found) {
      const Eigen::Vector2d error = (project(m.next, match.position) - match.pixel) / 400.;
      CHECK(m.follower.block.rows[row++].error == Approx(error.x()).margin(1e-12));
      CHECK(m.follower.block.rows[row++].error == Approx(error.y()).margin(1e-12));
      CHECK(error.norm() < 0.5 / 400.); // Found where they are.
    }
  }
}

TEST_CASE("Behind the camera the rows stay and count for nothing", "[point-cue]")
{
  Matched m;
  m.follower.cue.residuals(vpHomogeneousMatrix(0., 0., -1., 0., 0., 0.), m.follower.block);
  CHECK(m.follower.block.rows.size() == 2 * m.follower.found());
  for (const vpResidual &row : m.follower.block.rows) {
    CHECK(row.weight == exactly(0.));
    CHECK(row.error == exactly(0.));
  }
}

TEST_CASE("Weights have to be one for each row", "[point-cue]")
{
  Matched m;
  std::vector<double> weights(2 * m.follower.found() - 1, 1.);
  CHECK_THROWS_WITH(m.follower.cue.updateReference(m.next, weights), ContainsSubstring("weights for"));
}

TEST_CASE("The last match outlives what was learnt", "[point-cue]")
{
  Matched m;
  const std::size_t found = m.follower.found();
  m.follower.cue.reset();
  CHECK(m.follower.cue.pointCount() == 0);
  m.follower.cue.residuals(m.next, m.follower.block);
  CHECK(m.follower.block.rows.size() == 2 * found);
  CHECK_NOTHROW(m.follower.cue.updateReference(m.next, std::vector<double>(2 * found, 1.)));
  m.follower.match(m.painter.draw(m.next), m.next);
  CHECK(m.follower.found() == 0);
}

TEST_CASE("Features are where points were found, with the state of their rows", "[point-cue]")
{
  Matched m;
  vpImage<unsigned char> I = m.painter.draw(m.next);
  fill(I, 0, 0, 150, 240, 128);
  m.follower.match(I, m.next);
  std::vector<double> weights(2 * m.follower.found(), 1.);
  REQUIRE(weights.size() > 20);
  weights[5] = 0.05;
  std::vector<vpCueFeature> features;
  m.follower.cue.getFeatures(m.next, weights, features);
  REQUIRE(features.size() == m.follower.cue.matches().size());
  std::size_t found = 0;
  std::size_t lost = 0;
  for (std::size_t i = 0; i < features.size(); ++i) {
    const vpPointCue::Match &match = m.follower.cue.matches()[i];
    CHECK(features[i].u == exactly(match.pixel.x()));
    CHECK(features[i].v == exactly(match.pixel.y()));
    const vpFeatureState good = found == 2 ? vpFeatureState::OUTLIER : vpFeatureState::GOOD;
    CHECK(features[i].state == (match.found ? good : vpFeatureState::CONTRAST));
    found += match.found ? 1 : 0;
    lost += match.found ? 0 : 1;
  }
  CHECK(lost > 5);
}

#else
#include "pointCueMissing.h"
#endif
