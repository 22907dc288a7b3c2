// SPDX-License-Identifier: GPL-2.0-or-later
#include "edgeScenes.h"

#include <visp3/core/vpExponentialMap.h>
#include <visp3/core/vpMath.h>

#include <catchMain.h>

#include <Eigen/Geometry>

using namespace edgeScenes;

namespace {
using Model = std::shared_ptr<const vpTrackedModel>;

Model build(const vpTrackedModelBuilder &builder)
{
  return std::make_shared<const vpTrackedModel>(builder.build("shape"));
}

Model makeBox()
{
  vpTrackedModelBuilder builder;
  addBox(builder, {0.06, 0.04, 0.05});
  return build(builder);
}

Model makeCylinder()
{
  vpTrackedModelBuilder builder;
  builder.addCylinder({0., 0., -0.06}, {0., 0., 0.06}, 0.05);
  return build(builder);
}

Model makeCircle()
{
  vpTrackedModelBuilder builder;
  builder.addCircle({0., 0., 0.}, {0.05, 0., 0.}, {0., 0.05, 0.}, 0.05);
  return build(builder);
}

class Random
{
public:
  explicit Random(unsigned int seed) : m_engine(seed) {}

  double uniform(double low, double high)
  {
    return low + (high - low) * (static_cast<double>(m_engine()) / 4294967295.);
  }

  vpHomogeneousMatrix pose()
  {
    const double z = uniform(0.3, 0.8);
    return vpHomogeneousMatrix(uniform(-0.1, 0.1) * z, uniform(-0.1, 0.1) * z, z, uniform(-2., 2.), uniform(-2., 2.),
                               uniform(-2., 2.));
  }

private:
  std::mt19937 m_engine;
};

// Noise, so that every control point has an edge near it, wherever the model is.
vpImage<unsigned char> drawNoise()
{
  vpImage<unsigned char> I(height, width, 128);
  addNoise(I, 60., 7);
  return I;
}

vpEdgeCue nearestOnly()
{
  vpEdgeCueSettings settings;
  settings.candidates = 1;
  return vpEdgeCue(settings);
}

// The pose after the camera moved for a second with one component of the velocity, the others 0.
vpHomogeneousMatrix movedBy(const vpHomogeneousMatrix &cMo, unsigned int component, double amount)
{
  vpColVector velocity(6, 0.);
  velocity[component] = amount;
  return vpExponentialMap::direct(velocity).inverse() * cMo;
}

Eigen::Vector2d project(const vpHomogeneousMatrix &cMo, const Eigen::Vector3d &point)
{
  Eigen::Vector3d c;
  for (unsigned int i = 0; i < 3; ++i) {
    c(i) = cMo[i][0] * point.x() + cMo[i][1] * point.y() + cMo[i][2] * point.z() + cMo[i][3];
  }
  return c.head<2>() / c.z();
}
} // namespace

TEST_CASE("interaction matrices are the derivatives of the errors", "[edge-jacobian]")
{
  const Model model = GENERATE(makeBox(), makeCylinder(), makeCircle());
  const vpImage<unsigned char> I = drawNoise();
  vpModelView view(model);
  vpEdgeCue cue = nearestOnly();
  Random random(3);
  vpResidualBlock block;
  vpResidualBlock before;
  vpResidualBlock after;
  std::size_t rows = 0;
  for (int k = 0; k < 80; ++k) {
    const vpHomogeneousMatrix cMo = random.pose();
    view.compute(cMo, makeCamera(), width, height, vpModelViewOptions(), nullptr);
    match(cue, I, view);
    // Away from the pose of the view, too.
    const vpHomogeneousMatrix cMoNear = movedBy(movedBy(cMo, 0, random.uniform(-0.01, 0.01)), 4, 0.01);
    cue.residuals(cMoNear, block);
    std::vector<Eigen::Matrix<double, 6, 1>> differences(block.rows.size());
    const double step = 1e-6;
    for (unsigned int i = 0; i < 6; ++i) {
      cue.residuals(movedBy(cMoNear, i, -step), before);
      cue.residuals(movedBy(cMoNear, i, step), after);
      REQUIRE(after.rows.size() == block.rows.size());
      for (std::size_t j = 0; j < block.rows.size(); ++j) {
        differences[j](i) = (after.rows[j].error - before.rows[j].error) / (2. * step);
      }
    }
    std::vector<double> weights;
    for (const vpEdgeCue::Match &found : cue.matches()) {
      if (found.count > 0) {
        REQUIRE(found.light == exactly(1.));
        weights.push_back(std::max(found.claim, 0.05));
      }
    }
    REQUIRE(weights.size() == block.rows.size());
    for (std::size_t j = 0; j < block.rows.size(); ++j) {
      REQUIRE(block.rows[j].weight == exactly(weights[j]));
      const double norm = block.rows[j].jacobian.norm();
      REQUIRE(norm > 0.1);
      CHECK((differences[j] - block.rows[j].jacobian).norm() < 1e-4 * norm);
    }
    rows += block.rows.size();
  }
  CHECK(rows > 1000);
}

TEST_CASE("errors are distances from the projected edge", "[edge-jacobian]")
{
  const vpImage<unsigned char> I = drawNoise();
  vpModelView view(makeBox());
  vpEdgeCue cue = nearestOnly();
  Random random(4);
  vpResidualBlock block;
  for (int k = 0; k < 20; ++k) {
    const vpHomogeneousMatrix cMo = random.pose();
    view.compute(cMo, makeCamera(), width, height, vpModelViewOptions(), nullptr);
    match(cue, I, view);
    cue.residuals(cMo, block);
    REQUIRE(block.rows.size() == found(cue));
    CHECK(block.noise > 0.);
    CHECK(block.noise < 1. / focal);
    std::size_t row = 0;
    for (const vpEdgeCue::Match &match : cue.matches()) {
      if (match.count == 0) {
        continue;
      }
      const vpControlPoint &point = match.point;
      const Eigen::Vector2d a = project(cMo, point.position);
      const Eigen::Vector2d along = (project(cMo, point.position + 1e-4 * point.direction) - a).normalized();
      const Eigen::Vector2d away = cue.candidates()[static_cast<std::size_t>(match.first)].place - a;
      const double distance = std::fabs(away.x() * along.y() - away.y() * along.x());
      CHECK(std::fabs(block.rows[row].error) == Approx(distance).margin(1e-9));
      // On the line that was searched, that is the candidate's offset.
      CHECK(distance * focal == Approx(std::fabs(cue.candidates()[static_cast<std::size_t>(match.first)].offset)));
      ++row;
    }
  }
}

TEST_CASE("steps against the error bring the pose back", "[edge-jacobian]")
{
  // Four lines of a plane seen obliquely: every degree of freedom shows.
  const vpHomogeneousMatrix cMo(0.01, -0.005, 0.5, 0.4, 0.5, 0.2);
  vpTrackedModelBuilder builder;
  const double h = 0.04;
  builder.addFace({{-h, -h, 0.}, {h, -h, 0.}, {h, h, 0.}, {-h, h, 0.}});
  builder.addFace({{-h, h, 0.}, {h, h, 0.}, {h, -h, 0.}, {-h, -h, 0.}});
  vpModelView view(build(builder));
  view.compute(cMo, makeCamera(), width, height, vpModelViewOptions(), nullptr);
  std::vector<Line> sides;
  const std::vector<Eigen::Vector3d> corners = {{-h, -h, 0.}, {h, -h, 0.}, {h, h, 0.}, {-h, h, 0.}};
  for (std::size_t i = 0; i < 4; ++i) {
    const Eigen::Vector2d a = focal * project(cMo, corners[i]) + Eigen::Vector2d(80., 60.);
    const Eigen::Vector2d b = focal * project(cMo, corners[(i + 1) % 4]) + Eigen::Vector2d(80., 60.);
    sides.push_back({a, std::atan2(b.y() - a.y(), b.x() - a.x())});
  }
  const vpImage<unsigned char> I = draw([&](const Eigen::Vector2d &pixel) {
    double inside = 1.;
    for (const Line &side : sides) {
      inside = std::min(inside, blurredStep(side.distance(pixel), 0.7));
    }
    return 60. + 130. * inside;
  });

  vpHomogeneousMatrix estimate = movedBy(movedBy(cMo, 0, 0.004), 5, 0.03);
  vpEdgeCue cue = nearestOnly();
  vpResidualBlock block;
  for (int k = 0; k < 6; ++k) {
    view.compute(estimate, makeCamera(), width, height, vpModelViewOptions(), nullptr);
    match(cue, I, view);
    cue.residuals(estimate, block);
    Eigen::Matrix<double, 6, 6> A = Eigen::Matrix<double, 6, 6>::Zero();
    Eigen::Matrix<double, 6, 1> b = Eigen::Matrix<double, 6, 1>::Zero();
    for (const vpResidual &row : block.rows) {
      if (std::fabs(row.error) < 4. / focal) {
        A += row.jacobian * row.jacobian.transpose();
        b -= row.jacobian * row.error;
      }
    }
    A.diagonal().array() += 1e-9;
    const Eigen::Matrix<double, 6, 1> step = Eigen::MatrixXd(A).inverse() * b;
    vpColVector velocity(6);
    for (unsigned int i = 0; i < 6; ++i) {
      velocity[i] = step(i);
    }
    estimate = vpExponentialMap::direct(velocity).inverse() * estimate;
  }
  for (const Eigen::Vector3d &corner : corners) {
    CHECK((project(cMo, corner) - project(estimate, corner)).norm() * focal < 0.15);
  }
}

TEST_CASE("the nearest candidate counts, at each pose anew", "[edge-jacobian]")
{
  const Line line{Eigen::Vector2d(80., 60.), M_PI / 2.};
  // Along u, the normal of the line points towards -u.
  const vpImage<unsigned char> I = draw([&](const Eigen::Vector2d &pixel) {
    return 40. + 60. * blurredStep(pixel.x() - 76., 0.7) + 100. * blurredStep(pixel.x() - 85., 0.7);
  });
  vpEdgeCue cue;
  match(cue, I, viewOf({line}));
  REQUIRE(found(cue) == cue.matches().size());
  vpResidualBlock block;
  for (const double shift : {-6., -3., 0., 0.4, 0.6, 2., 5., 9.}) {
    cue.residuals(vpHomogeneousMatrix(shift / focal, 0., 0., 0., 0., 0.), block);
    const double distance = std::min(std::fabs(-4. - shift), std::fabs(5. - shift));
    for (const vpResidual &row : block.rows) {
      CHECK(std::fabs(row.error) * focal == Approx(distance).margin(0.1));
    }
  }
}

TEST_CASE("edges behind the camera or seen end-on have no weight", "[edge-jacobian]")
{
  const Line line{Eigen::Vector2d(80., 60.), 0.2};
  vpEdgeCue cue;
  match(cue, drawStep(line, 100.), viewOf({line}));
  REQUIRE(found(cue) > 0);
  vpResidualBlock block;
  const vpHomogeneousMatrix behind(0., 0., -2., 0., 0., 0.);
  cue.residuals(behind, block);
  REQUIRE(block.rows.size() == found(cue));
  for (const vpResidual &row : block.rows) {
    CHECK(row.weight == exactly(0.));
    CHECK(row.error == exactly(0.));
    CHECK(row.jacobian.isZero());
  }
  // The line's direction points at the camera's centre: a quarter of a turn about the middle of the line.
  const vpControlPoint &point = cue.matches()[0].point;
  const Eigen::Quaterniond turn = Eigen::Quaterniond::FromTwoVectors(point.direction, Eigen::Vector3d::UnitZ());
  const Eigen::AngleAxisd axis(turn);
  const Eigen::Vector3d t = Eigen::Vector3d::UnitZ() - turn * point.position;
  const Eigen::Vector3d tu = axis.angle() * axis.axis();
  cue.residuals(vpHomogeneousMatrix(t.x(), t.y(), t.z(), tu.x(), tu.y(), tu.z()), block);
  for (const vpResidual &row : block.rows) {
    CHECK(row.weight == exactly(0.));
  }
  learn(cue, behind);
  match(cue, drawStep(line, -100.), viewOf({line}));
  CHECK(found(cue) == cue.matches().size());
}
