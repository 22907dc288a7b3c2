// SPDX-License-Identifier: GPL-2.0-or-later
#include <visp3/multicue/vpMbMultiCueTracker.h>

#include "hypotheses/vpMotionFrame.h"
#include "facade/vpMbTrackerNames.h"
#include "frame/vpStopwatch.h"
#include "tracker/vpTrackerState.h"

#include <visp3/core/vpExponentialMap.h>
#include <visp3/core/vpTrackingException.h>

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
  const unsigned int rows = m_impl->fusion.start(m_cMo);
  for (const auto &[cue, factor] : m_impl->featureFactors) {
    m_impl->fusion.setFactor(cue, factor);
  }
  m_L.resize(rows, 6, false, false);
  m_error.resize(rows, false);
  m_w.resize(rows, false);
  m_w = 1.;
  m_impl->weightedError.resize(rows, false);
  m_impl->mu = m_initialMu;
}

void vpMbMultiCueTracker::computeVVSInteractionMatrixAndResidu()
{
  m_impl->fusion.evaluate(m_cMo, m_error, m_L);
}

bool vpMbMultiCueTracker::restrictToObserved()
{
  // Limbs and circles leave motions that nothing in the image shows: those are kept out of the estimation, in the
  // object's frame as the degrees of freedom that the user chose. Rotations count at the object's radius, so that units
  // do not matter.
  const vpPoseTangent scale = vpMotionFrame::scale(m_impl->model->diameter());
  const vpPoseMatrix6 S = vpPoseExponential::adjoint(m_cMo) * scale.asDiagonal();
  vpPoseMatrix6 information = vpPoseMatrix6::Zero();
  m_impl->fusion.forEachRow([&](const vpResidual &row) {
    const vpPoseTangent j = S.transpose() * row.jacobian;
    information.noalias() += j * j.transpose();
  });
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

// How far the farthest feature moves in the image, pixels.
double vpMbMultiCueTracker::imageMotion(const vpColVector &velocity) const
{
  const Eigen::Map<const vpPoseTangent> v(velocity.data);
  double largest = 0.;
  if (const vpCueFusion::Part *edges = m_impl->fusion.find(EDGE_TRACKER)) {
    for (const vpResidual &row : edges->block.rows) {
      largest = std::max(largest, std::fabs(row.jacobian.dot(v)));
    }
    return largest * m_cam.get_px();
  }
  // Other cues' errors are no distances: that of the object's origin, and of a turn at its radius.
  const Eigen::Vector3d centre(m_cMo[0][3], m_cMo[1][3], m_cMo[2][3]);
  const Eigen::Vector3d turn = v.tail<3>();
  const double moved = (v.head<3>() + turn.cross(centre)).norm() + 0.5 * m_impl->model->diameter() * turn.norm();
  return moved / std::max(centre.z(), 1e-9) * m_cam.get_px();
}

void vpMbMultiCueTracker::computeStep(unsigned int iteration, bool allDegreesOfFreedom)
{
  Impl &impl = *m_impl;
  impl.fusion.weigh(
      [this](vpRobust &robust, const vpColVector &error, vpColVector &w) { computeVVSWeights(robust, error, w); },
      m_error, m_L, m_w);
  double squares = 0.;
  double sum = 0.;
  unsigned int i = 0;
  impl.fusion.forEachRow([&](const vpResidual &row) {
    const double w = m_w[i] * row.weight;
    squares += w * m_error[i] * m_error[i];
    sum += w;
    impl.weightedError[i] = w * m_error[i];
    for (unsigned int j = 0; j < 6; ++j) {
      m_L[i][j] *= w;
    }
    ++i;
  });
  impl.residual = sum > 0. ? std::sqrt(squares / sum) : 0.;
  computeVVSPoseEstimation(allDegreesOfFreedom, iteration, m_L, impl.LTL, impl.weightedError, m_error, impl.errorBefore,
                           impl.LTR, impl.mu, impl.velocity);
  impl.lastStep = imageMotion(impl.velocity);
  impl.cMoBefore = m_cMo;
  m_cMo = vpExponentialMap::direct(impl.velocity).inverse() * m_cMo;
}

bool vpMbMultiCueTracker::computeVVS()
{
  Impl &impl = *m_impl;
  const vpStopwatch stage(impl.timings.pose);
  computeVVSInit();
  if (impl.fusion.cueRows() < minRows) {
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
  } catch (const vpTrackingException &) {
    m_cMo = impl.cMoBefore; // Levenberg and Marquardt's damping ran away: the best pose so far is the answer.
  }
  oJo = chosen;
  impl.fusion.keepWeights(m_w);
  return true;
}

END_VISP_NAMESPACE
