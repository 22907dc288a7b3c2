// SPDX-License-Identifier: GPL-2.0-or-later
#include "edgeScenes.h"

#include <visp3/core/vpException.h>

#include <catchMain.h>

#include <set>
#include <string>

using namespace edgeScenes;

namespace {
const Line edge{Eigen::Vector2d(80., 60.), 0.};

vpEdgeCueSettings tolerances(double mu1, double mu2)
{
  vpEdgeCueSettings settings;
  settings.mu1 = mu1;
  settings.mu2 = mu2;
  return settings;
}

// A horizontal edge of one contrast on the left, another on the right of column u.
vpImage<unsigned char> drawHalves(double left, double right, double u = 80.)
{
  return draw([&](const Eigen::Vector2d &pixel) {
    return 128. + (pixel.x() < u ? left : right) * (blurredStep(edge.distance(pixel), 0.7) - 0.5);
  });
}

bool allIn(const vpEdgeCue &cue, vpFeatureState state)
{
  return !cue.matches().empty() && inState(cue, state) == cue.matches().size();
}
} // namespace

TEST_CASE("contrasts outside the tolerances are no candidates, once", "[edge-memory]")
{
  const double side = GENERATE(1., -1.); // Dark to bright or bright to dark.
  vpEdgeCue cue(tolerances(0.4, 0.2));
  const vpModelView view = viewOf({edge.moved(1.)});
  const auto show = [&](double contrast) { match(cue, drawStep(edge, side * contrast), view); };

  SECTION("within")
  {
    for (const double contrast : {63., 117.}) {
      show(100.);
      learn(cue);
      show(contrast);
      CHECK(allIn(cue, vpFeatureState::GOOD));
      learn(cue);
      cue.reset();
    }
  }
  SECTION("outside")
  {
    for (const double contrast : {57., 123., -100.}) {
      show(100.);
      learn(cue);
      show(contrast);
      CHECK(allIn(cue, vpFeatureState::CONTRAST));
      CHECK(found(cue) == 0);
      learn(cue);
      show(contrast);
      CHECK(allIn(cue, vpFeatureState::GOOD));
      cue.reset();
    }
  }
  SECTION("the last contrast counts, not the first one")
  {
    for (const double contrast : {100., 115., 130., 150., 110., 70.}) {
      show(contrast);
      CHECK(allIn(cue, vpFeatureState::GOOD));
      learn(cue);
    }
  }
}

TEST_CASE("nothing is learnt from a frame that is not trusted, and outliers are forgotten", "[edge-memory]")
{
  vpEdgeCue cue(tolerances(0.2, 0.2));
  const vpModelView view = viewOf({edge});
  match(cue, drawStep(edge, 100.), view);
  match(cue, drawStep(edge, 50.), view);
  CHECK(allIn(cue, vpFeatureState::GOOD));
  learn(cue);
  match(cue, drawStep(edge, 50.), view);
  cue.updateReference(vpHomogeneousMatrix(), std::vector<double>(found(cue), 0.));
  match(cue, drawStep(edge, 100.), view);
  CHECK(allIn(cue, vpFeatureState::GOOD));
}

TEST_CASE("the contrast is remembered with the edge's direction, not with the normal's", "[edge-memory]")
{
  // Turned by half a turn in the image, the normal that is searched along points the other way on the edge.
  vpEdgeCue cue(tolerances(0.2, 0.2));
  vpModelView view = viewOf({edge});
  match(cue, drawStep(edge, 100.), view);
  learn(cue);
  const vpHomogeneousMatrix turned(0., 0., 0., 0., 0., M_PI);
  view.compute(turned, makeCamera(), width, height, vpModelViewOptions(), nullptr);
  match(cue, drawStep(edge, -100.), view);
  CHECK(allIn(cue, vpFeatureState::GOOD));
  match(cue, drawStep(edge, 100.), view);
  CHECK(allIn(cue, vpFeatureState::CONTRAST));
}

TEST_CASE("each part of an edge has its own contrast", "[edge-memory]")
{
  vpEdgeCue cue(tolerances(0.2, 0.2));
  vpModelView view = viewOf({edge}, 50.);
  match(cue, drawHalves(60., 150.), view);
  learn(cue);

  // Nearer and farther the points lie elsewhere on the edge and are more or fewer, the halves meet in the same column.
  for (const double z : {0., -0.3, 0.8}) {
    vpModelViewOptions options;
    options.sampleStep = z > 0. ? 2. : 5.;
    view.compute(vpHomogeneousMatrix(0., 0., z, 0., 0., 0.), makeCamera(), width, height, options, nullptr);
    match(cue, drawHalves(60., 150.), view);
    INFO("z " << z);
    CHECK(found(cue) + 2 >= cue.matches().size());
    match(cue, drawHalves(150., 60.), view);
    CHECK(inState(cue, vpFeatureState::CONTRAST) + 2 >= cue.matches().size());
  }
}

TEST_CASE("a point at a change of contrast keeps its own", "[edge-memory]")
{
  vpEdgeCue cue(tolerances(0.2, 0.2));
  vpModelViewOptions options;
  for (const double step : {1.7, 2.3, 3.1, 4.}) {
    options.sampleStep = step;
    const vpModelView view = viewOf({edge}, 50., options);
    for (std::size_t i = view.points().size() / 2; i < view.points().size() / 2 + 6; ++i) {
      // Between two control points.
      const double border = 0.5 * (view.points()[i - 1].pixel.x() + view.points()[i].pixel.x());
      const vpImage<unsigned char> I = drawHalves(60., 150., border);
      cue.reset();
      match(cue, I, view);
      learn(cue);
      match(cue, I, view);
      INFO("step " << step << " border " << border);
      CHECK(found(cue) == cue.matches().size());
    }
  }
}

TEST_CASE("an edge keeps its contrast when its other face comes into view and leaves it", "[edge-memory]")
{
  vpTrackedModelBuilder builder;
  addBox(builder, {0.05, 0.05, 0.05});
  vpModelView view(std::make_shared<const vpTrackedModel>(builder.build("box")));
  const auto look = [&view](const vpHomogeneousMatrix &cMo) {
    view.compute(cMo, makeCamera(), width, height, vpModelViewOptions(), nullptr);
  };
  const vpHomogeneousMatrix front(0., 0., 0.8, 0., 0., 0.);
  look(front);
  const std::vector<vpControlPoint> points = view.points();
  std::set<int> edgesDone;
  std::size_t sidesTurned = 0;
  for (const vpControlPoint &point : points) {
    if (!edgesDone.insert(point.edge).second) {
      continue;
    }
    const vpImage<unsigned char> I = drawStep({point.pixel, std::atan2(-point.normal.x(), point.normal.y())}, 100.);
    // Turned about the edge, which so stays where it is in the image, until the face behind it is seen.
    const Eigen::Vector3d axis = Eigen::Vector3d(-point.normal.y(), point.normal.x(), 0.);
    const Eigen::Vector3d t = Eigen::AngleAxisd(0.7, axis) * -point.position + point.position;
    const vpHomogeneousMatrix corner(t.x(), t.y(), t.z() + 0.8, 0.7 * axis.x(), 0.7 * axis.y(), 0.);
    vpEdgeCue cue(tolerances(0.2, 0.2));
    for (const vpHomogeneousMatrix &cMo : {front, corner, front}) {
      look(cMo);
      match(cue, I, view);
      for (const vpEdgeCue::Match &match : cue.matches()) {
        if (match.point.edge == point.edge) {
          CHECK(match.state == vpFeatureState::GOOD);
          sidesTurned += match.point.side != exactly(point.side);
        }
      }
      learn(cue, cMo);
    }
  }
  CHECK(edgesDone.size() == 4);
  CHECK(sidesTurned > 10);
}

TEST_CASE("a point stands for the stretch to its nearer neighbour, alone for the whole edge", "[edge-memory]")
{
  vpEdgeCue cue;
  vpModelViewOptions options;
  match(cue, drawStep(edge, 100.), viewOf({edge}, 50., options));
  const std::size_t points = cue.matches().size();
  for (const vpEdgeCue::Match &match : cue.matches()) {
    CHECK(match.reach == Approx(1. / static_cast<double>(points)).epsilon(1e-6));
  }

  cue.setSettings(tolerances(0.2, 0.2));
  cue.reset();
  options.sampleStep = 90.;
  vpModelView view = viewOf({edge}, 50., options);
  match(cue, drawStep(edge, 100.), view);
  REQUIRE(cue.matches().size() == 1);
  CHECK(cue.matches()[0].reach >= 1.);
  learn(cue);
  view.compute(vpHomogeneousMatrix(), makeCamera(), width, height, vpModelViewOptions(), nullptr);
  match(cue, drawStep(edge, 150.), view);
  CHECK(allIn(cue, vpFeatureState::CONTRAST));
}

TEST_CASE("rims that slide over a surface have no memory", "[edge-memory]")
{
  // A ball of many triangles: its rim is another line on it in every view.
  vpTrackedModelBuilder builder;
  const int rings = 24;
  const auto at = [&](int ring, int sector) {
    const double polar = M_PI * ring / rings;
    const double s = ring == 0 || ring == rings ? 0. : 0.1 * std::sin(polar);
    vpTrackedModelBuilder::Corner corner;
    corner.position = Eigen::Vector3d(s * std::cos(M_PI * sector / rings), s * std::sin(M_PI * sector / rings),
                                      0.1 * std::cos(polar));
    return corner;
  };
  for (int i = 0; i < rings; ++i) {
    for (int j = 0; j < 2 * rings; ++j) {
      if (i > 0) {
        builder.addTriangle({{at(i, j), at(i + 1, (j + 1) % (2 * rings)), at(i, (j + 1) % (2 * rings))}});
      }
      if (i + 1 < rings) {
        builder.addTriangle({{at(i, j), at(i + 1, j), at(i + 1, (j + 1) % (2 * rings))}});
      }
    }
  }
  vpModelView view(std::make_shared<const vpTrackedModel>(builder.build("ball")));
  view.compute(vpHomogeneousMatrix(0., 0., 1., 0., 0., 0.), makeCamera(), width, height, vpModelViewOptions(), nullptr);
  const double radius = focal * 0.1 / std::sqrt(1. - 0.01);
  const auto drawDisc = [&](double contrast) {
    return draw([&](const Eigen::Vector2d &pixel) {
      return 20. + contrast * blurredStep(radius - (pixel - Eigen::Vector2d(80., 60.)).norm(), 0.7);
    });
  };
  vpEdgeCue cue(tolerances(0.2, 0.2));
  match(cue, drawDisc(200.), view);
  REQUIRE(cue.matches().size() > 30);
  CHECK(allIn(cue, vpFeatureState::GOOD));
  learn(cue);
  match(cue, drawDisc(80.), view);
  CHECK(allIn(cue, vpFeatureState::GOOD));
}

TEST_CASE("reset and another model start afresh", "[edge-memory]")
{
  vpEdgeCue cue(tolerances(0.2, 0.2));
  match(cue, drawStep(edge, 100.), viewOf({edge}));
  learn(cue);

  SECTION("reset")
  {
    cue.reset();
    CHECK_FALSE(cue.matches().empty()); // What was matched last is still there to be shown.
    learn(cue);
    match(cue, drawStep(edge, 200.), viewOf({edge}));
  }
  SECTION("another model")
  {
    match(cue, drawStep(edge, 200.), viewOf({edge, edge.moved(1.)}));
  }
  SECTION("no model edge at all in view")
  {
    vpModelView view = viewOf({edge});
    view.compute(vpHomogeneousMatrix(0., 0., -5., 0., 0., 0.), makeCamera(), width, height, vpModelViewOptions(),
                 nullptr);
    match(cue, drawStep(edge, 200.), view);
    CHECK(cue.matches().empty());
    learn(cue);
    return;
  }
  CHECK(allIn(cue, vpFeatureState::GOOD));
}

TEST_CASE("a wrong number of weights is refused", "[edge-memory]")
{
  vpEdgeCue cue;
  match(cue, drawStep(edge, 100.), viewOf({edge}));
  CHECK_THROWS_WITH(cue.updateReference(vpHomogeneousMatrix(), std::vector<double>(1, 1.)),
                    ContainsSubstring("1 weights for " + std::to_string(found(cue)) + " rows"));
}
