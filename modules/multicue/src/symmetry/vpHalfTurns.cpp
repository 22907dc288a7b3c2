// SPDX-License-Identifier: GPL-2.0-or-later
#include "symmetry/vpHalfTurns.h"

#include "motion/vpTurnBetween.h"

#include <visp3/se3/vpExactNumber.h>

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <utility>

BEGIN_VISP_NAMESPACE

namespace {
const double muchNearer = 0.5; // Radians.

// To align the surface with itself: the share of it that may be what is not symmetric, steps, and how much nearer it
// has to come, how far in diameters and radians.
const double keptShare = 0.6;
const int steps = 15;
const double muchBetter = 0.7;
const double mostShift = 0.25;
const double mostTilt = 0.4;
const double damping = 1e-6;
// Two turns are the same one that differ by less, in diameters and radians.
const double sameShift = 0.02;
const double sameTilt = 0.1;

Eigen::Isometry3d halfTurn(const Eigen::Vector3d &axis, const Eigen::Vector3d &centre)
{
  Eigen::Isometry3d turn = Eigen::Isometry3d::Identity();
  turn.linear() = 2. * axis * axis.transpose() - Eigen::Matrix3d::Identity();
  turn.translation() = centre - turn.linear() * centre;
  return turn;
}

double angleBetween(const Eigen::Isometry3d &a, const Eigen::Isometry3d &b)
{
  return Eigen::AngleAxisd(a.linear().transpose() * b.linear()).angle();
}

// A place of the surface and the one that is nearest to where a turn brings it.
struct Pair
{
  Eigen::Vector3d turned;
  std::size_t nearest = 0;
  double distance = 0.; // Squared.
};

// Along no edge and across no face that objects are likely to have, unit length.
const Eigen::Vector3d &alongAll()
{
  static const Eigen::Vector3d direction = Eigen::Vector3d(0.81, 0.47, 0.35).normalized();
  return direction;
}

// The place nearest to a point; of several the first. Outwards from the point along a direction, until no place can be
// nearer: with 500 places four times as fast as looking at all of them.
Pair pairAt(const vpHalfTurns::Surface &surface, const Eigen::Vector3d &point)
{
  const double rounding = 1. + 1e-9; // What is as far along as it is away may be computed to be farther.
  const double own = alongAll().dot(point);
  Pair pair;
  pair.turned = point;
  pair.distance = HUGE_VAL;
  const auto look = [&](Eigen::Index column) {
    const double distance = (surface.places.col(column) - point).squaredNorm();
    const auto index = static_cast<std::size_t>(column);
    if (distance < pair.distance || (vpIsSame(distance, pair.distance) && index < pair.nearest)) {
      pair.distance = distance;
      pair.nearest = index;
    }
  };
  const auto isOut = [&](double along) { return (along - own) * (along - own) > rounding * pair.distance; };
  const auto &all = surface.along;
  auto above = std::lower_bound(all.begin(), all.end(), std::make_pair(own, Eigen::Index(0)));
  auto below = above;
  while (true) {
    const bool goesOn = above != all.end() && !isOut(above->first);
    if (goesOn) {
      look((above++)->second);
    }
    const bool goesBack = below != all.begin() && !isOut((below - 1)->first);
    if (goesBack) {
      look((--below)->second);
    }
    if (!goesOn && !goesBack) {
      return pair;
    }
  }
}

// The nearest ones of them.
std::vector<Pair> pairsOf(const vpHalfTurns::Surface &surface, const Eigen::Isometry3d &turn)
{
  std::vector<Pair> pairs(static_cast<std::size_t>(surface.places.cols()));
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    pairs[i] = pairAt(surface, turn * surface.places.col(static_cast<Eigen::Index>(i)));
  }
  const auto kept = static_cast<std::ptrdiff_t>(keptShare * static_cast<double>(pairs.size()));
  std::nth_element(pairs.begin(), pairs.begin() + kept, pairs.end(),
                   [](const Pair &a, const Pair &b) { return a.distance < b.distance; });
  pairs.resize(static_cast<std::size_t>(kept));
  return pairs;
}

// Along the normal: places that lie beside each other on the same face are no distance.
double offFace(const Pair &pair, const vpHalfTurns::Surface &surface)
{
  const auto nearest = static_cast<Eigen::Index>(pair.nearest);
  return surface.normals.col(nearest).dot(pair.turned - surface.places.col(nearest));
}

double distanceOf(const vpHalfTurns::Surface &surface, const Eigen::Isometry3d &turn)
{
  const std::vector<Pair> pairs = pairsOf(surface, turn);
  double sum = 0.;
  for (const Pair &pair : pairs) {
    sum += std::fabs(offFace(pair, surface));
  }
  return sum / static_cast<double>(pairs.size());
}

// One step of Gauss and Newton towards the faces. \param tilts The axis may change its direction, too.
Eigen::Isometry3d stepOf(const vpHalfTurns::Surface &surface, const Eigen::Isometry3d &turn,
                         const Eigen::Vector3d &centre, bool tilts)
{
  using Vector6 = Eigen::Matrix<double, 6, 1>;
  Eigen::Matrix<double, 6, 6> products = Eigen::Matrix<double, 6, 6>::Zero();
  Vector6 errors = Vector6::Zero();
  for (const Pair &pair : pairsOf(surface, turn)) {
    const Eigen::Vector3d normal = surface.normals.col(static_cast<Eigen::Index>(pair.nearest));
    Vector6 row = Vector6::Zero();
    row.head<3>() = normal;
    if (tilts) {
      row.tail<3>() = (pair.turned - centre).cross(normal);
    }
    products += row * row.transpose();
    errors += row * offFace(pair, surface);
  }
  // What no face holds stays as it is.
  products.diagonal().array() += damping * std::max(products.diagonal().maxCoeff(), 1e-300);
  const Vector6 step = products.ldlt().solve(-errors);
  Eigen::Isometry3d moved = Eigen::Isometry3d::Identity();
  moved.linear() = Eigen::AngleAxisd(step.tail<3>().norm(), step.tail<3>().stableNormalized()).toRotationMatrix();
  moved.translation() = centre + step.head<3>() - moved.linear() * centre;
  return moved * turn;
}

// Most of the surface moved to where other parts of it are.
Eigen::Isometry3d aligned(const vpHalfTurns::Surface &surface, const Eigen::Isometry3d &first,
                          const Eigen::Vector3d &centre, bool tilts)
{
  Eigen::Isometry3d turn = first;
  for (int i = 0; i < steps; ++i) {
    turn = stepOf(surface, turn, centre, tilts);
  }
  return turn;
}

double leastAngle(const vpHomogeneousMatrix &cMo, const std::vector<vpHomogeneousMatrix> &expected)
{
  double least = HUGE_VAL;
  for (const vpHomogeneousMatrix &pose : expected) {
    least = std::min(least, vpTurnBetween(pose, cMo));
  }
  return least;
}
} // namespace

void vpHalfTurns::setModel(const vpTrackedModel &model, const std::vector<vpSurfaceSample> &samples)
{
  m_centre = model.centre();
  m_diameter = model.diameter();
  m_turns.clear();
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();
  for (int i = 0; i < 3; ++i) {
    add(halfTurn(axes.col(i), m_centre));
  }
  if (samples.empty()) {
    return;
  }
  Surface surface;
  surface.places.resize(3, static_cast<Eigen::Index>(samples.size()));
  surface.normals.resize(3, static_cast<Eigen::Index>(samples.size()));
  for (std::size_t i = 0; i < samples.size(); ++i) {
    surface.places.col(static_cast<Eigen::Index>(i)) = samples[i].position.cast<double>();
    surface.normals.col(static_cast<Eigen::Index>(i)) = samples[i].normal.cast<double>();
  }
  for (Eigen::Index i = 0; i < surface.places.cols(); ++i) {
    surface.along.emplace_back(alongAll().dot(surface.places.col(i)), i);
  }
  std::sort(surface.along.begin(), surface.along.end());
  const Eigen::Matrix3Xd fromMean = surface.places.colwise() - surface.places.rowwise().mean();
  axes = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(fromMean * fromMean.transpose()).eigenvectors();
  for (int i = 0; i < 3; ++i) {
    add(halfTurn(axes.col(i), m_centre));
  }
  const std::vector<Eigen::Isometry3d> turns = std::move(m_turns);
  m_turns.clear();
  for (const Eigen::Isometry3d &turn : turns) {
    const Eigen::Isometry3d shifted = better(turn, aligned(surface, turn, m_centre, false), surface);
    add(shifted);
    add(better(shifted, aligned(surface, shifted, m_centre, true), surface));
  }
}

// The second one, where it is near to the first and brings the surface much nearer to itself.
Eigen::Isometry3d vpHalfTurns::better(const Eigen::Isometry3d &first, const Eigen::Isometry3d &second,
                                      const Surface &surface) const
{
  const bool isNear =
      (second * m_centre - first * m_centre).norm() < mostShift * m_diameter && angleBetween(second, first) < mostTilt;
  const bool isBetter = distanceOf(surface, second) < muchBetter * distanceOf(surface, first) - 1e-9 * m_diameter;
  return isNear && isBetter ? second : first;
}

void vpHalfTurns::add(const Eigen::Isometry3d &turn)
{
  const bool isKnown = std::any_of(m_turns.begin(), m_turns.end(), [&](const Eigen::Isometry3d &other) {
    return angleBetween(turn, other) < sameTilt && (turn * m_centre - other * m_centre).norm() < sameShift * m_diameter;
  });
  if (!isKnown) {
    m_turns.push_back(turn);
  }
}

std::vector<vpHomogeneousMatrix> vpHalfTurns::turned(const vpHomogeneousMatrix &cMo) const
{
  std::vector<vpHomogeneousMatrix> poses;
  for (const Eigen::Isometry3d &turn : m_turns) {
    poses.push_back(vpPoseExponential::fromEigen(vpPoseExponential::toEigen(cMo) * turn));
  }
  return poses;
}

std::optional<vpHomogeneousMatrix> vpHalfTurns::nearer(const vpHomogeneousMatrix &cMo,
                                                       const std::vector<vpHomogeneousMatrix> &expected) const
{
  std::optional<vpHomogeneousMatrix> found;
  double least = leastAngle(cMo, expected) - muchNearer;
  for (const vpHomogeneousMatrix &pose : turned(cMo)) {
    const double angle = leastAngle(pose, expected);
    if (angle < least) {
      least = angle;
      found = pose;
    }
  }
  return found;
}

END_VISP_NAMESPACE
