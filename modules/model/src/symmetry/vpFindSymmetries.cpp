// SPDX-License-Identifier: GPL-2.0-or-later
#include "symmetry/vpSymmetryTest.h"

#include <visp3/core/vpException.h>
#include <visp3/se3/vpPoseExponential.h>

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <array>
#include <cmath>

BEGIN_VISP_NAMESPACE

namespace {
const std::size_t mostDirections = 400;
const double sameDirection = 0.9998; // Cosine of one degree.
// No small number of turns by these, in shares of a full one, comes back to where it started.
const std::array<double, 8> anyTurns = {{0.0902, 0.2361, 0.3820, 0.0557, 0.1459, 0.4721, 0.0344, 0.3065}};

// Mass, first and second moments of the surface, or of the edges where there is none.
struct Moments
{
  double mass = 0.;
  Eigen::Vector3d first = Eigen::Vector3d::Zero();
  Eigen::Matrix3d second = Eigen::Matrix3d::Zero();

  // A simplex with even mass: its second moments are those of its corners and of their sum.
  template <std::size_t N> void add(double own, const std::array<Eigen::Vector3d, N> &corners)
  {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();
    for (const Eigen::Vector3d &corner : corners) {
      sum += corner;
      squares += corner * corner.transpose();
    }
    mass += own;
    first += own / static_cast<double>(N) * sum;
    second += own / static_cast<double>(N * (N + 1)) * (squares + sum * sum.transpose());
  }
};

Moments momentsOf(const vpTrackedModel &model)
{
  Moments moments;
  const auto at = [&](int i) { return model.vertices()[static_cast<std::size_t>(i)]; };
  for (const vpModelTriangle &t : model.triangles()) {
    const std::array<Eigen::Vector3d, 3> corners = {{at(t.vertex[0]), at(t.vertex[1]), at(t.vertex[2])}};
    moments.add(0.5 * (corners[1] - corners[0]).cross(corners[2] - corners[0]).norm(), corners);
  }
  if (moments.mass > 0.) {
    return moments;
  }
  for (const vpModelEdge &edge : model.edges()) {
    const std::array<Eigen::Vector3d, 2> ends = {{at(edge.vertex[0]), at(edge.vertex[1])}};
    moments.add((ends[1] - ends[0]).norm(), ends);
  }
  return moments;
}

// Directions in which an axis through the centroid may run, each once.
class Directions
{
public:
  void add(const Eigen::Vector3d &direction)
  {
    const double length = direction.norm();
    if (!(length > 1e-9) || m_directions.size() == mostDirections) {
      return;
    }
    const Eigen::Vector3d unit = direction / length;
    const bool isKnown = std::any_of(m_directions.begin(), m_directions.end(), [&](const Eigen::Vector3d &other) {
      return std::fabs(unit.dot(other)) > sameDirection;
    });
    if (!isKnown) {
      m_directions.push_back(unit);
    }
  }
  const std::vector<Eigen::Vector3d> &all() const { return m_directions; }

private:
  std::vector<Eigen::Vector3d> m_directions;
};

Directions directionsOf(const vpTrackedModel &model, const Moments &moments, const Eigen::Vector3d &centre)
{
  Directions directions;
  const Eigen::Matrix3d covariance = moments.second / moments.mass - centre * centre.transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(covariance);
  for (int i = 0; i < 3; ++i) {
    directions.add(Eigen::Vector3d::Unit(i));
  }
  for (int i = 0; i < 3; ++i) {
    directions.add(solver.eigenvectors().col(i));
  }
  for (const vpModelCylinder &cylinder : model.cylinders()) {
    directions.add(cylinder.axis[1] - cylinder.axis[0]);
  }
  for (const vpModelCircle &circle : model.circles()) {
    directions.add(circle.normal);
  }
  for (const vpModelFace &face : model.faces()) {
    if (face.planar) {
      directions.add(face.normal);
    }
  }
  for (const vpModelEdge &edge : model.edges()) {
    const Eigen::Vector3d &a = model.vertices()[static_cast<std::size_t>(edge.vertex[0])];
    const Eigen::Vector3d &b = model.vertices()[static_cast<std::size_t>(edge.vertex[1])];
    directions.add(0.5 * (a + b) - centre);
    directions.add(a - centre);
    directions.add(b - centre);
    directions.add(b - a);
  }
  return directions;
}

class Search
{
public:
  Search(const vpTrackedModel &model, const vpSymmetryOptions &options, const Eigen::Vector3d &centre)
      : m_test(model, options), m_mostTurns(static_cast<int>(options.mostTurns)), m_centre(centre)
  {
  }

  void lookAt(const Eigen::Vector3d &direction)
  {
    const bool isContinuous =
        std::all_of(anyTurns.begin(), anyTurns.end(), [&](double share) { return m_test(turn(direction, share)); });
    if (isContinuous) {
      add([&] { m_symmetries.addAxis({direction, m_centre}); });
      return;
    }
    for (int n = m_mostTurns; n > 1; --n) {
      const Eigen::Isometry3d once = turn(direction, 1. / n);
      if (isNew(once) && m_test(once)) {
        add([&] { m_symmetries.addDiscrete(vpPoseExponential::fromEigen(once)); });
        return;
      }
    }
  }

  bool isSphere() const { return m_symmetries.axes().size() > 1; }

  const vpModelSymmetries &symmetries() const { return m_symmetries; }

private:
  // With a wide tolerance turns are found that are those of no object: they are left out.
  template <typename Add> static void add(const Add &add)
  {
    try {
      add();
    } catch (const vpException &) {
      return;
    }
  }

  Eigen::Isometry3d turn(const Eigen::Vector3d &direction, double share) const
  {
    Eigen::Isometry3d turn = Eigen::Isometry3d::Identity();
    turn.linear() = Eigen::AngleAxisd(2. * M_PI * share, direction).toRotationMatrix();
    turn.translation() = m_centre - turn.linear() * m_centre;
    return turn;
  }

  // Turns beside those that are known already would be the same ones, found less exactly.
  bool isNew(const Eigen::Isometry3d &once) const { return !m_symmetries.contains(vpPoseExponential::fromEigen(once)); }

  vpSymmetryTest m_test;
  int m_mostTurns;
  Eigen::Vector3d m_centre;
  vpModelSymmetries m_symmetries;
};
} // namespace

void vpSymmetryOptions::check() const
{
  if (!(tolerance > 0. && tolerance <= 0.1)) {
    throw vpException(vpException::badValue,
                      "vpSymmetryOptions::tolerance is %g, it must be above 0 and at most 0.1 diameters", tolerance);
  }
  if (mostTurns < 2 || mostTurns > 100) {
    throw vpException(vpException::badValue, "vpSymmetryOptions::mostTurns is %u, it must be in [2, 100]", mostTurns);
  }
  if (!(colorTolerance >= 0. && colorTolerance <= 1.)) {
    throw vpException(vpException::badValue, "vpSymmetryOptions::colorTolerance is %g, it must be in [0, 1]",
                      colorTolerance);
  }
}

vpModelSymmetries vpFindSymmetries(const vpTrackedModel &model, const vpSymmetryOptions &options)
{
  options.check();
  const Moments moments = momentsOf(model);
  if (!(moments.mass > 0.) || model.report().missingImages > 0) {
    return vpModelSymmetries();
  }
  const Eigen::Vector3d centre = moments.first / moments.mass;
  Search search(model, options, centre);
  const Directions directions = directionsOf(model, moments, centre);
  for (const Eigen::Vector3d &direction : directions.all()) {
    if (!search.isSphere()) {
      search.lookAt(direction);
    }
  }
  return search.symmetries();
}

END_VISP_NAMESPACE
