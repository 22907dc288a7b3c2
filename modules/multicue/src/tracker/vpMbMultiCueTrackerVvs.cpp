// SPDX-License-Identifier: GPL-2.0-or-later
#include <visp3/multicue/vpMbMultiCueTracker.h>

#include "hypotheses/vpMotionFrame.h"
#include "tracker/vpMbTrackerNames.h"
#include "tracker/vpStopwatch.h"
#include "tracker/vpTrackerState.h"

#include <visp3/core/vpExponentialMap.h>
#include <visp3/core/vpTrackingException.h>
#include <visp3/core/vpVelocityTwistMatrix.h>

#include <Eigen/Eigenvalues>

#include <cmath>
#include <limits>

BEGIN_VISP_NAMESPACE

namespace {
const unsigned int minRows = 4;
// An iteration that moves no control point by more than this has converged.
const double convergedMotion = 0.005; // Pixels.
} // namespace

void vpMbMultiCueTracker::computeVVSInit()
{
  m_impl->edges.residuals(m_cMo, m_impl->block);
  const unsigned int rows = static_cast<unsigned int>(m_impl->block.rows.size());
  m_L.resize(rows, 6, false, false);
  m_error.resize(rows, false);
  m_w.resize(rows, false);
  m_w = 1.;
  m_impl->weightedError.resize(rows, false);
  m_impl->robust.setMinMedianAbsoluteDeviation(m_impl->block.noise);
  m_impl->mu = m_initialMu;
  m_impl->found = rows;
}

void vpMbMultiCueTracker::computeVVSInteractionMatrixAndResidu()
{
  m_impl->edges.residuals(m_cMo, m_impl->block);
  for (unsigned int i = 0; i < m_error.getRows(); ++i) {
    const vpResidual &row = m_impl->block.rows[i];
    m_error[i] = row.error;
    for (unsigned int j = 0; j < 6; ++j) {
      m_L[i][j] = row.jacobian[j];
    }
  }
}

bool vpMbMultiCueTracker::restrictToObserved()
{
  // Limbs and circles leave motions that nothing in the image shows: those are kept out of the estimation, in the
  // object's frame as the degrees of freedom that the user chose. Rotations count at the object's radius, so that units
  // do not matter.
  const vpPoseTangent scale = vpMotionFrame::scale(m_impl->model->diameter());
  const vpPoseMatrix6 S = vpPoseExponential::adjoint(m_cMo) * scale.asDiagonal();
  vpPoseMatrix6 information = vpPoseMatrix6::Zero();
  for (const vpResidual &row : m_impl->block.rows) {
    const vpPoseTangent j = S.transpose() * row.jacobian;
    information.noalias() += j * j.transpose();
  }
  const Eigen::SelfAdjointEigenSolver<vpPoseMatrix6> solver(information);
  const double least = vpMotionFrame::leastInformation * solver.eigenvalues()(5);
  if (solver.eigenvalues()(0) > least) {
    return false;
  }
  vpPoseMatrix6 seen = vpPoseMatrix6::Zero();
  for (int i = 0; i < 6; ++i) {
    if (solver.eigenvalues()(i) > least) {
      seen += solver.eigenvectors().col(i) * solver.eigenvectors().col(i).transpose();
    }
  }
  const vpPoseMatrix6 projector = scale.asDiagonal() * seen * scale.cwiseInverse().asDiagonal();
  const vpPoseMatrix6 chosen = vpMotionFrame::toEigen(oJo);
  const Eigen::Matrix<double, 6, 6, Eigen::RowMajor> both = projector * chosen;
  std::copy(both.data(), both.data() + 36, oJo.data);
  return true;
}

void vpMbMultiCueTracker::computeStep(unsigned int iteration, bool allDegreesOfFreedom)
{
  Impl &impl = *m_impl;
  computeVVSWeights(impl.robust, m_error, m_w);
  if (computeCovariance) {
    impl.LTrue = m_L;
    if (!allDegreesOfFreedom) {
      vpVelocityTwistMatrix cVo;
      cVo.buildFrom(m_cMo);
      impl.LVJTrue = m_L * (cVo * oJo);
    }
    impl.wTrue = m_w;
  }
  double squares = 0.;
  double sum = 0.;
  for (unsigned int i = 0; i < m_error.getRows(); ++i) {
    const double w = m_w[i] * impl.block.rows[i].weight;
    squares += w * m_error[i] * m_error[i];
    sum += w;
    impl.weightedError[i] = w * m_error[i];
    for (unsigned int j = 0; j < 6; ++j) {
      m_L[i][j] *= w;
    }
  }
  impl.residual = sum > 0. ? std::sqrt(squares / sum) : 0.;
  computeVVSPoseEstimation(allDegreesOfFreedom, iteration, m_L, impl.LTL, impl.weightedError, m_error, impl.errorBefore,
                           impl.LTR, impl.mu, impl.velocity);
  impl.lastStep = 0.;
  for (const vpResidual &row : impl.block.rows) {
    const double motion = row.jacobian.dot(Eigen::Map<const Eigen::Matrix<double, 6, 1>>(impl.velocity.data));
    impl.lastStep = std::max(impl.lastStep, std::fabs(motion) * m_cam.get_px());
  }
  impl.cMoBefore = m_cMo;
  m_cMo = vpExponentialMap::direct(impl.velocity).inverse() * m_cMo;
}

bool vpMbMultiCueTracker::computeVVS()
{
  Impl &impl = *m_impl;
  const vpStopwatch stage(impl.timings.pose);
  computeVVSInit();
  if (m_error.getRows() < minRows) {
    return false;
  }
  const vpMatrix chosen = oJo;
  const bool allChosen = m_isoJoIdentity;
  bool all = allChosen;
  double residualBefore = -1.;
  try {
    for (unsigned int iteration = 0; iteration < m_maxIter; ++iteration) {
      computeVVSInteractionMatrixAndResidu();
      bool restart = false;
      computeVVSCheckLevenbergMarquardt(iteration, m_error, impl.errorBefore, impl.cMoBefore, impl.mu, restart);
      if (restart) {
        continue;
      }
      if (iteration == 0 && restrictToObserved()) {
        all = false;
      }
      computeStep(iteration, all);
      if (impl.lastStep < convergedMotion || std::fabs(impl.residual - residualBefore) < m_stopCriteriaEpsilon) {
        break;
      }
      residualBefore = impl.residual;
    }
    computeCovarianceMatrixVVS(all, impl.wTrue, impl.cMoBefore, impl.LTrue, impl.LVJTrue, m_error);
  } catch (const vpTrackingException &) {
    m_cMo = impl.cMoBefore; // Levenberg and Marquardt's damping ran away: the best pose so far is the answer.
  }
  oJo = chosen;
  impl.weights.assign(m_w.data, m_w.data + m_w.getRows());
  return true;
}

END_VISP_NAMESPACE
