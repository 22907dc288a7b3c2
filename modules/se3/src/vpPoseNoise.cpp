// SPDX-License-Identifier: GPL-2.0-or-later
#include <visp3/se3/vpPoseNoise.h>

#include <visp3/core/vpException.h>
#include <visp3/core/vpMath.h>

#include <Eigen/Cholesky>

#include <cmath>

BEGIN_VISP_NAMESPACE

namespace {
// Relative to the deviations of the coordinates, because metres and radians may differ by orders of magnitude.
const double symmetryTolerance = 1e-9;
const double smallestConditionalDeviation = 1e-6;

bool isSymmetric(const vpPoseMatrix6 &covariance)
{
  const vpPoseTangent deviation = covariance.diagonal().cwiseSqrt();
  const vpPoseMatrix6 difference = (covariance - covariance.transpose()).cwiseAbs();
  return (difference.array() <= symmetryTolerance * (deviation * deviation.transpose()).array()).all();
}

vpPoseMatrix6 choleskyRoot(const vpPoseMatrix6 &covariance)
{
  if (!covariance.allFinite()) {
    throw vpException(vpException::badValue, "A pose covariance has a value that is not finite");
  }
  if ((covariance.diagonal().array() <= 0.).any()) {
    throw vpException(vpException::badValue,
                      "A pose covariance has a variance that is not positive: give a fixed degree of freedom "
                      "a small one");
  }
  if (!isSymmetric(covariance)) {
    throw vpException(vpException::badValue, "A pose covariance is not symmetric");
  }
  const Eigen::LLT<vpPoseMatrix6> cholesky(covariance);
  const vpPoseMatrix6 root = cholesky.matrixL();
  // The diagonal of the root holds each coordinate's deviation when the coordinates before it are known.
  const vpPoseTangent smallest = smallestConditionalDeviation * covariance.diagonal().cwiseSqrt();
  if (cholesky.info() != Eigen::Success || (root.diagonal().array() <= smallest.array()).any()) {
    throw vpException(vpException::badValue,
                      "A pose covariance is not positive definite: enlarge its diagonal, or give noise to the "
                      "coordinates that it fixes");
  }
  return root;
}
} // namespace

vpPoseNoise::vpPoseNoise(const vpPoseMatrix6 &covariance, Frame frame)
    : m_covariance(covariance), m_root(choleskyRoot(covariance)),
      m_logPeak(-3. * std::log(2. * M_PI) - m_root.diagonal().array().log().sum()), m_frame(frame)
{
}

vpPoseNoise vpPoseNoise::isotropic(double translation, double rotation, Frame frame)
{
  if (!(translation > 0.) || !(rotation > 0.)) {
    throw vpException(vpException::badValue,
                      "The deviations of a pose noise have to be > 0, but they are %g m and %g rad", translation,
                      rotation);
  }
  vpPoseTangent variance;
  variance << Eigen::Vector3d::Constant(translation * translation), Eigen::Vector3d::Constant(rotation * rotation);
  return vpPoseNoise(variance.asDiagonal(), frame);
}

vpHomogeneousMatrix vpPoseNoise::draw(const vpHomogeneousMatrix &cMo, vpPoseRandom &random) const
{
  const vpPoseTangent alpha = m_root.triangularView<Eigen::Lower>() * random.normalTangent();
  const vpHomogeneousMatrix displacement = vpPoseExponential::exp(alpha);
  return m_frame == Frame::OBJECT ? cMo * displacement : displacement * cMo; // [T10] eq. 6 is the latter
}

Eigen::Isometry3d vpPoseNoise::draw(const Eigen::Isometry3d &cMo, vpPoseRandom &random) const
{
  const vpPoseTangent alpha = m_root.triangularView<Eigen::Lower>() * random.normalTangent();
  const Eigen::Isometry3d displacement = vpPoseExponential::expEigen(alpha);
  return m_frame == Frame::OBJECT ? cMo * displacement : displacement * cMo;
}

double vpPoseNoise::logDensity(const vpHomogeneousMatrix &cMo, const vpHomogeneousMatrix &mean) const
{
  // Mixtures ask for every pair of two sets of poses: Eigen's types have no memory to allocate.
  const Eigen::Isometry3d pose = vpPoseExponential::toEigen(cMo);
  const Eigen::Isometry3d back = vpPoseExponential::toEigen(mean).inverse();
  const Eigen::Isometry3d displacement = m_frame == Frame::OBJECT ? back * pose : pose * back;
  const vpPoseTangent alpha = vpPoseExponential::log(displacement);
  const vpPoseTangent white = m_root.triangularView<Eigen::Lower>().solve(alpha);
  return m_logPeak - 0.5 * white.squaredNorm() - vpPoseExponential::logVolume(alpha);
}

END_VISP_NAMESPACE
