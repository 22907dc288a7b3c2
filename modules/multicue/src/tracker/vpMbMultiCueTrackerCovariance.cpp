// SPDX-License-Identifier: GPL-2.0-or-later
#include <visp3/multicue/vpMbMultiCueTracker.h>

#include "hypotheses/vpMotionFrame.h"
#include "tracker/vpTrackerState.h"

#include <visp3/core/vpException.h>

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

const char *nameOf(int cue)
{
  return cue == vpMbMultiCueTracker::EDGE_TRACKER  ? "EDGE_TRACKER"
         : cue == vpMbMultiCueTracker::KLT_TRACKER ? "KLT_TRACKER"
                                                   : "COLOR_TRACKER";
}

void requireCue(int cue)
{
  if (cue != vpMbMultiCueTracker::EDGE_TRACKER && cue != vpMbMultiCueTracker::KLT_TRACKER &&
      cue != vpMbMultiCueTracker::COLOR_TRACKER) {
    throw vpException(vpException::badValue,
                      "%d is no cue: use one of vpMbMultiCueTracker::EDGE_TRACKER (1), KLT_TRACKER (2) and "
                      "COLOR_TRACKER (16)",
                      cue);
  }
}

std::string count(std::size_t number, const char *what)
{
  return std::to_string(number) + ' ' + what;
}
} // namespace

void vpMbMultiCueTracker::updateCovariance()
{
  Impl &impl = *m_impl;
  if (!computeCovariance && !impl.usesVelocity()) {
    return;
  }
  impl.uncertainty.update(impl.fusion, weakPrior(m_cMo * impl.centreFrame()));
  std::array<bool, 6> fixed{};
  for (unsigned int i = 0; i < 6; ++i) {
    fixed[i] = oJo[i][i] == 0.; // See vpMbTracker::setEstimatedDoF().
  }
  impl.uncertainty.setFrame(m_cMo, fixed);
  if (computeCovariance) {
    const vpPoseMatrix6 T = toParameters(m_cMo);
    covarianceMatrix = toVisp(T * impl.uncertainty.covariance() * T.transpose());
  }
}

vpMatrix vpMbMultiCueTracker::getCovarianceMatrix(int cue) const
{
  requireCue(cue);
  if (!computeCovariance) {
    throw vpException(vpException::notInitialized,
                      "No covariance was computed: call setCovarianceComputation(true) before track()");
  }
  const std::string reason = getCueReason(cue);
  if (!reason.empty()) {
    throw vpException(vpException::notInitialized, std::string(nameOf(cue)) + " has no covariance: " + reason);
  }
  const vpPoseMatrix6 T = toParameters(m_cMo);
  std::size_t part = 0;
  while (m_impl->fusion[part].type != cue) { // It is there: there is no reason against it.
    ++part;
  }
  return toVisp(T * m_impl->uncertainty.covariance(part) * T.transpose());
}

std::string vpMbMultiCueTracker::getCueReason(int cue) const
{
  requireCue(cue);
  const Impl &impl = *m_impl;
  if (!impl.uses(cue)) {
    return "it is not among the cues chosen by setTrackerType()";
  }
  if (!impl.isJudged) {
    return "no image was tracked yet";
  }
  const vpCueFusion::Part *part = impl.fusion.find(cue);
  if (part == nullptr) {
    return cue == KLT_TRACKER && !impl.usesPoints ? "the points contradict the other cues" : "no pose was estimated";
  }
  if (part->block.rows.empty()) {
    return impl.missingRows(cue);
  }
  const bool isRefused = std::all_of(part->weights.begin(), part->weights.end(), [](double w) { return w <= 0.; });
  return isRefused ? "the robust estimation refused all of its " + count(part->block.rows.size(), "rows") : "";
}

// Why a cue that was matched has no equation.
std::string vpMbMultiCueTracker::Impl::missingRows(int cue) const
{
  if (cue == EDGE_TRACKER) {
    const std::size_t searched = edges.matches().size();
    return searched == 0 ? "no visible edge of the model is inside the image"
                         : "no edge of the image was found near any of " + count(searched, "control points");
  }
  if (cue == COLOR_TRACKER) {
    return "no silhouette point is inside the image with room on both sides";
  }
  const std::size_t known = points->pointCount();
  if (known == 0) {
    return "no texture: 0 points on the surface";
  }
  return "none of " + count(known, "points on the surface was found in the image");
}

END_VISP_NAMESPACE
