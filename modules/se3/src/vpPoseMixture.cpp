// SPDX-License-Identifier: GPL-2.0-or-later
#include "vpPoseMixtureSum.h"

#include <visp3/core/vpException.h>

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <limits>

BEGIN_VISP_NAMESPACE

namespace {
const double infinity = std::numeric_limits<double>::infinity();

// 1 / det V^2 of exp() is at most exp(curvature theta^2) up to half a turn: its logarithm is a series in theta^2 with
// positive coefficients, and so below its chord.
const double curvature = 4. * std::log(M_PI / 2.) / (M_PI * M_PI);

// (k - 1) / u with k = (theta / 2)^2 / u and u = sin^2(theta / 2) < 0.01, from the series of asin^2. The terms left out
// are below 1e-15.
template <typename Lanes> Lanes stretchSlope(const Lanes &u)
{
  return 1. / 3. + u * (8. / 45. + u * (4. / 35. + u * (128. / 1575. +
                                                        u * (128. / 2079. + u * (1024. / 21021. + u * 256. / 6435.)))));
}
const double largestSquaredSine = 0.01;

double largestEigenvalue(const Eigen::Matrix3d &m)
{
  return Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(m, Eigen::EigenvaluesOnly).eigenvalues()[2];
}
} // namespace

void vpPoseMixture::Block::set(int lane, const Eigen::Quaterniond &rotation, const Eigen::Vector3d &translation,
                               double kernelWeight)
{
  w[lane] = rotation.w();
  x[lane] = rotation.x();
  y[lane] = rotation.y();
  z[lane] = rotation.z();
  tx[lane] = translation.x();
  ty[lane] = translation.y();
  tz[lane] = translation.z();
  weight[lane] = kernelWeight;
}

vpPoseMixture::vpPoseMixture(const vpPoseNoise &kernel, double relativeError)
    : m_noise(kernel), m_relativeError(relativeError)
{
  if (!(relativeError > 0. && relativeError < 1.)) {
    throw vpException(vpException::badValue, "The relative error of a pose mixture is %g: give one between 0 and 1",
                      relativeError);
  }
  setBounds();
}

void vpPoseMixture::clear(const vpPoseNoise &kernel)
{
  m_noise = kernel;
  setBounds();
  m_kernels.clear();
  m_blocks.clear();
  m_totalWeight = 0.;
  m_isPrepared = true;
}

// For alpha = [v, omega] with noise on the right: v = V^-1 t, and V makes nothing longer, so |v| is at least the
// distance of the two translations. The largest variance of each half, and how much the two halves share, bound
// alpha^T Sigma^-1 alpha from below by a distance and an angle.
void vpPoseMixture::setBounds()
{
  const vpPoseMatrix6 &covariance = m_noise.covariance();
  const vpPoseTangent variances = covariance.diagonal();
  m_isIsotropic = covariance.isDiagonal(0.) && (variances.head<3>().array() == variances[0]).all() &&
                  (variances.tail<3>().array() == variances[3]).all();
  m_rotationFactor = 0.5 / variances[3];
  m_whitening = m_noise.root().triangularView<Eigen::Lower>().solve(vpPoseMatrix6::Identity());
  const double translation = largestEigenvalue(covariance.topLeftCorner<3, 3>());
  const double rotation = largestEigenvalue(covariance.bottomRightCorner<3, 3>());
  vpPoseTangent scale;
  scale << Eigen::Vector3d::Constant(1. / std::sqrt(translation)), Eigen::Vector3d::Constant(1. / std::sqrt(rotation));
  const vpPoseMatrix6 scaled = scale.asDiagonal() * covariance * scale.asDiagonal();
  const double shared = Eigen::SelfAdjointEigenSolver<vpPoseMatrix6>(scaled, Eigen::EigenvaluesOnly).eigenvalues()[5];
  m_translationBound = m_isIsotropic ? 0.5 / variances[0] : 0.5 / (shared * translation);
  const double rotationBound = 0.5 / (shared * rotation) - curvature;
  m_rotationBound = std::max(rotationBound, 0.);
  m_constantBound = std::min(rotationBound, 0.) * M_PI * M_PI;
}

// exp(alpha) cMo is the inverse of cMo^-1 exp(-alpha), and the density is even.
vpPoseMixture::Place vpPoseMixture::placeOf(const Eigen::Isometry3d &cMo) const
{
  Place place;
  place.rotation = Eigen::Quaterniond(cMo.linear()).normalized();
  place.translation = cMo.translation();
  if (m_noise.frame() == vpPoseNoise::Frame::CAMERA) {
    place.rotation = place.rotation.conjugate();
    place.translation = -(place.rotation * place.translation);
  }
  return place;
}

void vpPoseMixture::add(const vpHomogeneousMatrix &mean, double weight)
{
  add(vpPoseExponential::toEigen(mean), weight);
}

void vpPoseMixture::add(const Eigen::Isometry3d &mean, double weight)
{
  if (!(weight >= 0.) || !std::isfinite(weight)) {
    throw vpException(vpException::badValue, "A kernel of a pose mixture has the weight %g: give a finite one >= 0",
                      weight);
  }
  if (!mean.matrix().allFinite()) {
    throw vpException(vpException::badValue, "The mean of a kernel of a pose mixture is not finite");
  }
  if (!(weight > 0.)) {
    return;
  }
  m_totalWeight += weight;
  const Place place = placeOf(mean);
  if (!m_isPrepared && place.translation == m_kernels.back().mean.translation &&
      place.rotation.coeffs() == m_kernels.back().mean.rotation.coeffs()) {
    m_kernels.back().weight += weight;
    return;
  }
  m_kernels.push_back({place, weight});
  m_isPrepared = false;
}

void vpPoseMixture::prepare()
{
  Eigen::Array3d sum = Eigen::Array3d::Zero();
  Eigen::Array3d squares = Eigen::Array3d::Zero();
  for (const Kernel &kernel : m_kernels) {
    const Eigen::Array3d offset = kernel.mean.translation - m_kernels.front().mean.translation;
    sum += offset;
    squares += offset.square();
  }
  const double count = static_cast<double>(std::max<std::size_t>(m_kernels.size(), 1));
  (squares / count - (sum / count).square()).maxCoeff(&m_axis);
  const auto isBefore = [this](const Kernel &a, const Kernel &b) {
    return a.mean.translation[m_axis] < b.mean.translation[m_axis];
  };
  std::sort(m_kernels.begin(), m_kernels.end(), isBefore);
  m_blocks.resize((m_kernels.size() + lanes - 1) / lanes);
  for (std::size_t i = 0; i < m_blocks.size() * lanes; i++) {
    // The last block is filled up with copies of the last kernel that have no weight.
    const Kernel &kernel = m_kernels[std::min(i, m_kernels.size() - 1)];
    m_blocks[i / lanes].set(static_cast<int>(i % lanes), kernel.mean.rotation, kernel.mean.translation,
                            i < m_kernels.size() ? kernel.weight : 0.);
  }
  m_isPrepared = true;
}

// Half the squared length of the whitened coordinates of the pose about the kernel's mean.
vpPoseMixture::Term vpPoseMixture::termOf(const Place &place, const Kernel &kernel) const
{
  const Eigen::Quaterniond back = kernel.mean.rotation.conjugate();
  const Eigen::Quaterniond turned = back * place.rotation;
  const vpPoseTangent alpha = vpPoseExponential::log(turned, back * (place.translation - kernel.mean.translation));
  const vpPoseTangent white = m_whitening * alpha;
  // 1 / det V^2, as vpPoseExponential::logVolume() has it: (theta / 2)^4 / sin^4(theta / 2).
  const double squaredSine = turned.vec().squaredNorm();
  const double ratio = squaredSine > 1e-15 ? alpha.tail<3>().squaredNorm() / (4. * squaredSine) : 1.;
  return {0.5 * white.squaredNorm(), ratio * ratio};
}

// Of the kernels along the axis.
std::size_t vpPoseMixture::nearest(double position) const
{
  const auto isBelow = [this](const Kernel &kernel, double value) { return kernel.mean.translation[m_axis] < value; };
  const auto above = std::lower_bound(m_kernels.begin(), m_kernels.end(), position, isBelow);
  const std::size_t index = static_cast<std::size_t>(above - m_kernels.begin());
  if (index == 0) {
    return 0;
  }
  const bool isBelowNearer = above == m_kernels.end() || position - (above - 1)->mean.translation[m_axis] <
                                                             above->mean.translation[m_axis] - position;
  return isBelowNearer ? index - 1 : index;
}

void vpPoseMixture::visit(const Place &place, const Kernel &kernel, Sum &sum, Effort &effort) const
{
  effort.visited++;
  const double squaredDistance = (place.translation - kernel.mean.translation).squaredNorm();
  // 8 (1 - cos(theta / 2)) is at most theta^2.
  const double squaredAngle = 8. * (1. - std::min(std::fabs(place.rotation.dot(kernel.mean.rotation)), 1.));
  if (m_translationBound * squaredDistance + m_rotationBound * squaredAngle + m_constantBound >= sum.limit()) {
    return;
  }
  effort.evaluated++;
  const Term term = termOf(place, kernel);
  sum.add(term.exponent, kernel.weight * term.factor);
}

// The same for a block of kernels where only the lengths of v and omega matter. V^-1 stretches what is normal to the
// axis of rotation by (theta / 2) / sin(theta / 2), so |v| follows from the distance and its part along the axis.
bool vpPoseMixture::visitTogether(const Place &place, const Block &block, Sum &sum) const
{
  const double aw = place.rotation.w(), ax = place.rotation.x(), ay = place.rotation.y(), az = place.rotation.z();
  const Lanes tx = place.translation.x() - block.tx;
  const Lanes ty = place.translation.y() - block.ty;
  const Lanes tz = place.translation.z() - block.tz;
  const Lanes squaredDistance = tx * tx + ty * ty + tz * tz;
  const Lanes cosine = (aw * block.w + ax * block.x + ay * block.y + az * block.z).abs();
  const Lanes bound = m_translationBound * squaredDistance + 8. * m_rotationBound * (1. - cosine) + m_constantBound;
  if (bound.minCoeff() >= sum.limit()) {
    return true;
  }
  // The axis in the frame of the translations, times sin(theta / 2).
  const Lanes nx = ax * block.w - aw * block.x - (ay * block.z - az * block.y);
  const Lanes ny = ay * block.w - aw * block.y - (az * block.x - ax * block.z);
  const Lanes nz = az * block.w - aw * block.z - (ax * block.y - ay * block.x);
  const Lanes squaredSine = nx * nx + ny * ny + nz * nz;
  if (squaredSine.maxCoeff() > largestSquaredSine) {
    return false;
  }
  const Lanes slope = stretchSlope(squaredSine);
  const Lanes ratio = 1. + squaredSine * slope;
  const Lanes along = nx * tx + ny * ty + nz * tz;
  const Lanes exponent = m_translationBound * (ratio * squaredDistance - slope * along * along) +
                         4. * m_rotationFactor * ratio * squaredSine;
  const double least = exponent.minCoeff();
  sum.add(least, (block.weight * ratio * ratio * (least - exponent).exp()).sum());
  return true;
}

void vpPoseMixture::visitBlock(const Place &place, std::size_t index, Sum &sum, Effort &effort) const
{
  const std::size_t first = index * lanes;
  const std::size_t last = std::min(first + lanes, m_kernels.size());
  if (m_isIsotropic && visitTogether(place, m_blocks[index], sum)) {
    effort.visited += last - first;
    effort.evaluated += last - first;
    return;
  }
  for (std::size_t i = first; i < last; i++) {
    visit(place, m_kernels[i], sum, effort);
  }
}

double vpPoseMixture::logDensity(const vpHomogeneousMatrix &cMo, Effort *effort) const
{
  if (!m_isPrepared) {
    throw vpException(vpException::notInitialized, "vpPoseMixture::logDensity() needs prepare() after the last add()");
  }
  const Eigen::Isometry3d pose = vpPoseExponential::toEigen(cMo);
  if (m_kernels.empty() || !pose.matrix().allFinite()) {
    return -infinity;
  }
  const Place place = placeOf(pose);
  const double position = place.translation[m_axis];
  Sum sum(std::log(m_totalWeight / m_relativeError));
  Effort work;
  // All kernels behind one that is too far away along the axis are.
  const auto isFar = [&](const Kernel &kernel) {
    const double gap = kernel.mean.translation[m_axis] - position;
    return m_translationBound * gap * gap + m_constantBound >= sum.limit();
  };
  const std::size_t home = nearest(position) / lanes;
  visitBlock(place, home, sum, work);
  for (std::size_t i = home + 1; i < m_blocks.size() && !isFar(m_kernels[i * lanes]); i++) {
    visitBlock(place, i, sum, work);
  }
  for (std::size_t i = home; i > 0 && !isFar(m_kernels[i * lanes - 1]); i--) {
    visitBlock(place, i - 1, sum, work);
  }
  if (effort != nullptr) {
    effort->visited += work.visited;
    effort->evaluated += work.evaluated;
  }
  return m_noise.logPeak() + sum.logarithm() - std::log(m_totalWeight);
}

END_VISP_NAMESPACE
