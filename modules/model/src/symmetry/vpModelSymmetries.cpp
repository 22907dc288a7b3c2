// SPDX-License-Identifier: GPL-2.0-or-later
#include <visp3/model/vpModelSymmetries.h>

#include <visp3/core/vpException.h>
#include <visp3/se3/vpPoseExponential.h>

#include <Eigen/SVD>

#include <algorithm>
#include <cmath>
#include <limits>

BEGIN_VISP_NAMESPACE

namespace {
const double sameAngle = 0.05; // Radians.
const double rotationTolerance = 1e-3;

double angleOf(const Eigen::Matrix3d &R)
{
  return Eigen::AngleAxisd(R).angle();
}

// Products of poses from files leave rotations by the last digits.
vpHomogeneousMatrix toVisp(const Eigen::Isometry3d &pose)
{
  Eigen::Isometry3d rigid = pose;
  rigid.linear() = Eigen::Quaterniond(pose.linear()).normalized().toRotationMatrix();
  return vpPoseExponential::fromEigen(rigid);
}

Eigen::Isometry3d turnAbout(const vpSymmetryAxis &axis, const Eigen::Matrix3d &R)
{
  Eigen::Isometry3d turn = Eigen::Isometry3d::Identity();
  turn.linear() = R;
  turn.translation() = axis.point - R * axis.point;
  return turn;
}

Eigen::Isometry3d checkedTurn(const vpHomogeneousMatrix &oTo)
{
  Eigen::Matrix4d M = Eigen::Map<const Eigen::Matrix<double, 4, 4, Eigen::RowMajor>>(oTo.data);
  const Eigen::Matrix3d R = M.topLeftCorner<3, 3>();
  if (!M.allFinite() || !(R * R.transpose()).isIdentity(rotationTolerance) || R.determinant() < 0.) {
    throw vpException(vpException::badValue,
                      "A symmetry has no rotation in its upper left 3 x 3: give a rigid motion, reflections are none");
  }
  Eigen::Isometry3d turn = Eigen::Isometry3d::Identity();
  turn.linear() = Eigen::Quaterniond(R).normalized().toRotationMatrix();
  turn.translation() = M.topRightCorner<3, 1>();
  return turn;
}

// The mean squared distance of the points of a sphere; weight: a third of its squared radius.
double squaredDistance(const Eigen::Isometry3d &a, const Eigen::Isometry3d &b, const Eigen::Vector3d &centre,
                       double weight)
{
  return (a * centre - b * centre).squaredNorm() + weight * (a.linear() - b.linear()).squaredNorm();
}

// The angle about an axis that brings a pose nearest to another one: the squared distance is a constant less
// 2 (c cos(angle) + s sin(angle)).
double bestAngle(const vpSymmetryAxis &axis, const Eigen::Isometry3d &pose, const Eigen::Isometry3d &reference,
                 const Eigen::Vector3d &centre, double weight)
{
  const Eigen::Vector3d &a = axis.direction;
  const Eigen::Vector3d arm = centre - axis.point;
  const Eigen::Vector3d across = arm - a.dot(arm) * a;
  const Eigen::Vector3d target = pose.linear().transpose() * (reference * centre - pose * axis.point);
  const Eigen::Matrix3d M = reference.linear().transpose() * pose.linear();
  const Eigen::Vector3d skew(M(1, 2) - M(2, 1), M(2, 0) - M(0, 2), M(0, 1) - M(1, 0));
  const double c = target.dot(across) + weight * (M.trace() - a.dot(M * a));
  const double s = target.dot(a.cross(arm)) + weight * a.dot(skew);
  return std::atan2(s, c);
}

// The rotation R for which |R q - target|^2 + weight |R - M|^2 is least.
Eigen::Matrix3d bestRotation(const Eigen::Vector3d &q, const Eigen::Vector3d &target, const Eigen::Matrix3d &M,
                             double weight)
{
  const Eigen::Matrix3d sum = target * q.transpose() + weight * M;
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(sum, Eigen::ComputeFullU | Eigen::ComputeFullV);
  Eigen::Vector3d signs = Eigen::Vector3d::Ones();
  signs.z() = (svd.matrixU() * svd.matrixV().transpose()).determinant() < 0. ? -1. : 1.;
  return svd.matrixU() * signs.asDiagonal() * svd.matrixV().transpose();
}

// The turn after which a pose is nearest to another one. Searches compare thousands of poses: only what depends on the
// turn is looked at, |R D c + t - target|^2 - 2 weight tr(M D).
std::size_t nearestTurn(const std::vector<Eigen::Isometry3d> &turns, const Eigen::Isometry3d &pose,
                        const Eigen::Isometry3d &reference, const Eigen::Vector3d &centre, double weight)
{
  const Eigen::Vector3d target = pose.linear().transpose() * (reference * centre - pose.translation());
  const Eigen::Matrix3d transposed = pose.linear().transpose() * reference.linear();
  std::size_t best = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < turns.size(); ++i) {
    const Eigen::Vector3d moved = turns[i].linear() * centre + turns[i].translation();
    const double trace = transposed.cwiseProduct(turns[i].linear()).sum();
    const double value = (moved - target).squaredNorm() - 2. * weight * trace;
    if (value < least) {
      least = value;
      best = i;
    }
  }
  return best;
}

vpSymmetryAxis checkedAxis(const vpSymmetryAxis &axis)
{
  const double length = axis.direction.norm();
  if (!(length > 0.) || !std::isfinite(length) || !axis.point.allFinite()) {
    throw vpException(vpException::badValue,
                      "An axis of symmetry needs a direction of a length above 0 and a finite point");
  }
  return {axis.direction / length, axis.point};
}

// The three axes of a sphere, about the middle of the shortest way between two lines.
std::vector<vpSymmetryAxis> sphereAxes(const vpSymmetryAxis &a, const vpSymmetryAxis &b)
{
  const double cosine = a.direction.dot(b.direction);
  const Eigen::Vector3d between = b.point - a.point;
  const double scale = 1. - cosine * cosine;
  const double s = (between.dot(a.direction) - cosine * between.dot(b.direction)) / scale;
  const double t = (cosine * between.dot(a.direction) - between.dot(b.direction)) / scale;
  const Eigen::Vector3d middle = 0.5 * (a.point + s * a.direction + b.point + t * b.direction);
  return {{Eigen::Vector3d::UnitX(), middle}, {Eigen::Vector3d::UnitY(), middle}, {Eigen::Vector3d::UnitZ(), middle}};
}
} // namespace

vpModelSymmetries::vpModelSymmetries() : m_discrete{Eigen::Isometry3d::Identity()}
{
}

bool vpModelSymmetries::keepsAxis(const Eigen::Isometry3d &turn) const
{
  if (m_axes.size() != 1) {
    return true;
  }
  const Eigen::Vector3d &a = m_axes.front().direction;
  return std::fabs(a.dot(turn.linear() * a)) > std::cos(sameAngle);
}

// But for turns about the axes.
bool vpModelSymmetries::isSame(const Eigen::Isometry3d &a, const Eigen::Isometry3d &b) const
{
  if (isSphere()) {
    return true;
  }
  if (m_axes.empty()) {
    const double trace = a.linear().cwiseProduct(b.linear()).sum();
    return trace > 1. + 2. * std::cos(sameAngle);
  }
  const Eigen::Vector3d &axis = m_axes.front().direction;
  return (a.linear() * axis).dot(b.linear() * axis) > std::cos(sameAngle);
}

bool vpModelSymmetries::isKnown(const Turns &turns, const Eigen::Isometry3d &turn) const
{
  return std::any_of(turns.begin(), turns.end(), [&](const Eigen::Isometry3d &other) { return isSame(other, turn); });
}

bool vpModelSymmetries::contains(const vpHomogeneousMatrix &oTo) const
{
  const Eigen::Isometry3d turn = checkedTurn(oTo);
  return keepsAxis(turn) && isKnown(m_discrete, turn);
}

// The group that some turns generate.
vpModelSymmetries::Turns vpModelSymmetries::completed(const Turns &generators) const
{
  Turns turns = {Eigen::Isometry3d::Identity()};
  for (std::size_t i = 0; i < turns.size(); ++i) {
    for (const Eigen::Isometry3d &generator : generators) {
      if (!keepsAxis(generator)) {
        throw vpException(vpException::badValue, "A symmetry turns the axis of the object to another direction: an "
                                                 "object with both would be a sphere");
      }
      const Eigen::Isometry3d next = turns[i] * generator;
      if (isKnown(turns, next)) {
        continue;
      }
      if (turns.size() == mostDiscrete) {
        throw vpException(
            vpException::badValue,
            "More than %u turns follow from the symmetries: check that their angles are exact, or give an "
            "axis for an object that looks the same at every angle",
            static_cast<unsigned int>(mostDiscrete));
      }
      turns.push_back(next);
    }
  }
  return turns;
}

void vpModelSymmetries::addDiscrete(const vpHomogeneousMatrix &oTo)
{
  const Eigen::Isometry3d turn = checkedTurn(oTo);
  if (turn.isApprox(Eigen::Isometry3d::Identity(), 1e-9)) {
    return;
  }
  const double angle = angleOf(turn.linear());
  if (angle < sameAngle) {
    throw vpException(
        vpException::badValue,
        "A symmetry turns the object by %g degrees and shifts it by %g m: give an axis for an object that "
        "looks the same after small turns; after a shift alone none does",
        angle * 180. / M_PI, turn.translation().norm());
  }
  Turns generators = m_discrete;
  generators.push_back(turn);
  m_discrete = completed(generators);
}

void vpModelSymmetries::addAxis(const vpSymmetryAxis &axis)
{
  const vpSymmetryAxis added = checkedAxis(axis);
  vpModelSymmetries both;
  both.m_axes = m_axes;
  if (m_axes.empty()) {
    both.m_axes = {added};
  } else if (!isSphere() && added.direction.cross(m_axes.front().direction).norm() > std::sin(sameAngle)) {
    both.m_axes = sphereAxes(m_axes.front(), added);
  }
  both.m_discrete = both.completed(m_discrete);
  *this = both;
}

std::vector<vpHomogeneousMatrix> vpModelSymmetries::discrete() const
{
  std::vector<vpHomogeneousMatrix> turns;
  for (const Eigen::Isometry3d &turn : m_discrete) {
    turns.push_back(toVisp(turn));
  }
  return turns;
}

// The best of the turns about the axes.
Eigen::Isometry3d vpModelSymmetries::turned(const Eigen::Isometry3d &pose, const Eigen::Isometry3d &reference,
                                            const Eigen::Vector3d &centre, double weight) const
{
  if (m_axes.empty()) {
    return pose;
  }
  const vpSymmetryAxis &axis = m_axes.front();
  if (!isSphere()) {
    const double angle = bestAngle(axis, pose, reference, centre, weight);
    return pose * turnAbout(axis, Eigen::AngleAxisd(angle, axis.direction).toRotationMatrix());
  }
  const Eigen::Vector3d middle = pose * axis.point;
  Eigen::Isometry3d best = Eigen::Isometry3d::Identity();
  best.linear() = bestRotation(centre - axis.point, reference * centre - middle, reference.linear(), weight);
  best.translation() = middle - best.linear() * axis.point;
  return best;
}

vpHomogeneousMatrix vpModelSymmetries::nearest(const vpHomogeneousMatrix &cMo, const vpHomogeneousMatrix &reference,
                                               const Eigen::Vector3d &centre, double radius) const
{
  if (isEmpty()) {
    return cMo;
  }
  const double weight = radius * radius / 3.;
  const Eigen::Isometry3d pose = vpPoseExponential::toEigen(cMo);
  const Eigen::Isometry3d target = vpPoseExponential::toEigen(reference);
  if (m_axes.empty()) {
    const std::size_t turn = nearestTurn(m_discrete, pose, target, centre, weight);
    return turn == 0 ? cMo : toVisp(pose * m_discrete[turn]);
  }
  Eigen::Isometry3d best = pose;
  double least = std::numeric_limits<double>::infinity();
  for (const Eigen::Isometry3d &turn : m_discrete) {
    const Eigen::Isometry3d candidate = turned(pose * turn, target, centre, weight);
    const double distance = squaredDistance(candidate, target, centre, weight);
    if (distance < least) {
      least = distance;
      best = candidate;
    }
  }
  return toVisp(best);
}

double vpModelSymmetries::distance(const vpHomogeneousMatrix &cMo, const vpHomogeneousMatrix &reference,
                                   const Eigen::Vector3d &centre, double radius)
{
  return std::sqrt(squaredDistance(vpPoseExponential::toEigen(cMo), vpPoseExponential::toEigen(reference), centre,
                                   radius * radius / 3.));
}

END_VISP_NAMESPACE
