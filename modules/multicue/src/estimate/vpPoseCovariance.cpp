// SPDX-License-Identifier: GPL-2.0-or-later
#include "estimate/vpPoseCovariance.h"
#include <visp3/se3/vpExactNumber.h>

#include <algorithm>
#include <cmath>

BEGIN_VISP_NAMESPACE

namespace {
// Deviation of a rotation about the object's centre of which nothing is known, radians. Of a translation: the distance.
const double unknownRotation = 1.;

Eigen::Matrix3d skew(const Eigen::Vector3d &a)
{
  Eigen::Matrix3d matrix;
  matrix << 0., -a.z(), a.y(), a.z(), 0., -a.x(), -a.y(), a.x(), 0.;
  return matrix;
}

// From alpha, where exp(alpha) cMo is the true pose, to the error of the pose's translation and theta-u vector: the
// parameters of vpMatrix::computeCovarianceMatrixVVS().
vpPoseMatrix6 toParameters(const vpHomogeneousMatrix &cMo)
{
  const vpThetaUVector tu = cMo.getThetaUVector();
  const Eigen::Matrix3d axis = skew(Eigen::Vector3d(tu[0], tu[1], tu[2]));
  const double half = 0.5 * tu.getTheta();
  // Inverse of the rotation's left Jacobian.
  const double factor = half < 1e-4 ? 1. / 12. : (1. - half / std::tan(half)) / (4. * half * half);
  vpPoseMatrix6 T = vpPoseMatrix6::Identity();
  T.topRightCorner<3, 3>() = -skew(Eigen::Vector3d(cMo[0][3], cMo[1][3], cMo[2][3]));
  T.bottomRightCorner<3, 3>() += -0.5 * axis + factor * axis * axis;
  return T;
}

// What is known without an image: nothing, but numbers stay finite. The frame b is at the object's centre.
vpPoseMatrix6 weakPrior(const vpHomogeneousMatrix &cMb)
{
  const double distance = std::max(std::fabs(cMb[2][3]), 1e-9);
  vpPoseTangent information;
  information << vpPoseTangent::Constant(1. / (distance * distance));
  information.tail<3>().setConstant(1. / (unknownRotation * unknownRotation));
  const vpPoseMatrix6 bVc = vpPoseExponential::adjoint(cMb.inverse());
  return bVc.transpose() * information.asDiagonal() * bVc;
}

vpMatrix toVisp(const vpPoseMatrix6 &matrix)
{
  vpMatrix result(6, 6);
  for (unsigned int i = 0; i < 6; ++i) {
    for (unsigned int j = 0; j < 6; ++j) {
      result[i][j] = matrix(static_cast<int>(i), static_cast<int>(j));
    }
  }
  return result;
}
} // namespace

void vpPoseCovariance::update(const vpCueFusion &fusion, const vpHomogeneousMatrix &cMo, const vpModelLooks &looks,
                              const vpMatrix &chosen)
{
  m_uncertainty.update(fusion, weakPrior(cMo * looks.centreFrame()));
  std::array<bool, 6> fixed{};
  for (unsigned int i = 0; i < 6; ++i) {
    fixed[i] = vpIsZero(chosen[i][i]); // See vpMbTracker::setEstimatedDoF().
  }
  m_uncertainty.setFrame(cMo, fixed);
  m_cMo = cMo;
}

vpMatrix vpPoseCovariance::ofParameters() const
{
  if (!m_cMo) {
    return vpMatrix();
  }
  const vpPoseMatrix6 T = toParameters(*m_cMo);
  return toVisp(T * m_uncertainty.covariance() * T.transpose());
}

vpMatrix vpPoseCovariance::ofParameters(const vpHomogeneousMatrix &cMo, std::size_t part) const
{
  const vpPoseMatrix6 T = toParameters(cMo);
  return toVisp(T * m_uncertainty.covariance(part) * T.transpose());
}

END_VISP_NAMESPACE
