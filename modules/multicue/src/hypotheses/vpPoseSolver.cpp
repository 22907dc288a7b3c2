// SPDX-License-Identifier: GPL-2.0-or-later
#include "hypotheses/vpPoseSolver.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>

BEGIN_VISP_NAMESPACE

namespace {
const std::size_t minRows = 6;
// An iteration that moves the control points by less than this in the mean has converged.
const double convergedMotion = 0.05; // Pixels.
} // namespace

bool vpPoseSolver::step(const vpPoseMatrix6 &toCamera, vpPoseTangent &velocity)
{
  vpPoseMatrix6 information = vpPoseMatrix6::Zero();
  vpPoseTangent gradient = vpPoseTangent::Zero();
  for (std::size_t i = 0; i < m_block.rows.size(); ++i) {
    const vpResidual &row = m_block.rows[i];
    const double w = m_weights[static_cast<unsigned int>(i)] * row.weight;
    const double w2 = w * w; // ViSP weights errors and interaction matrix both.
    if (w2 > 0.) {
      const vpPoseTangent weighted = w2 * row.jacobian;
      for (int k = 0; k < 6; ++k) {
        information.col(k).noalias() += row.jacobian(k) * weighted;
      }
      gradient.noalias() += row.error * weighted;
    }
  }
  const Eigen::SelfAdjointEigenSolver<vpPoseMatrix6> solver(toCamera.transpose() * information * toCamera);
  const double least = vpMotionFrame::leastInformation * solver.eigenvalues()(5);
  if (!(least > 0.)) {
    return false;
  }
  vpPoseTangent y = solver.eigenvectors().transpose() * (toCamera.transpose() * gradient);
  for (int k = 0; k < 6; ++k) {
    y(k) = solver.eigenvalues()(k) > least ? -y(k) / solver.eigenvalues()(k) : 0.;
  }
  velocity = toCamera * (solver.eigenvectors() * y);
  return velocity.allFinite();
}

bool vpPoseSolver::minimise(const vpEdgeCue &edges, const std::vector<int> *choices, const vpPoseMatrix6 &freeMotions,
                            double diameter, vpHomogeneousMatrix &cMo, unsigned int iterations)
{
  const double px = edges.camera().get_px();
  const vpPoseTangent scale = vpMotionFrame::scale(diameter);
  for (unsigned int i = 0; i < iterations; ++i) {
    choices == nullptr ? edges.residuals(cMo, m_block) : edges.residuals(cMo, *choices, m_block);
    const std::size_t rows = m_block.rows.size();
    if (rows < minRows) {
      return false;
    }
    m_error.resize(static_cast<unsigned int>(rows), false);
    std::transform(m_block.rows.begin(), m_block.rows.end(), m_error.data,
                   [](const vpResidual &row) { return row.error; });
    m_robust.setMinMedianAbsoluteDeviation(m_block.noise);
    m_robust.MEstimator(vpRobust::TUKEY, m_error, m_weights);
    vpPoseTangent velocity;
    const vpPoseMatrix6 toCamera = vpPoseExponential::adjoint(cMo) * freeMotions * scale.asDiagonal();
    if (!step(toCamera, velocity)) {
      return false;
    }
    double motion = 0.;
    for (const vpResidual &row : m_block.rows) {
      motion += std::fabs(row.jacobian.dot(velocity));
    }
    cMo = vpPoseExponential::exp(velocity).inverse() * cMo;
    if (motion * px < convergedMotion * static_cast<double>(rows)) {
      break;
    }
  }
  return std::all_of(cMo.data, cMo.data + 16, [](double value) { return std::isfinite(value); }) && cMo[2][3] > 0.;
}

vpPoseMatrix6 vpPoseSolver::observed(const vpEdgeCue &edges, const vpPoseMatrix6 &freeMotions, double diameter,
                                     const vpHomogeneousMatrix &cMo)
{
  edges.residuals(cMo, m_block);
  vpPoseMatrix6 information = vpPoseMatrix6::Zero();
  for (const vpResidual &row : m_block.rows) {
    for (int k = 0; k < 6; ++k) {
      information.col(k) += row.jacobian(k) * row.jacobian;
    }
  }
  const vpPoseTangent scale = vpMotionFrame::scale(diameter);
  const vpPoseMatrix6 toCamera = vpPoseExponential::adjoint(cMo) * scale.asDiagonal();
  const Eigen::SelfAdjointEigenSolver<vpPoseMatrix6> solver(toCamera.transpose() * information * toCamera);
  vpPoseMatrix6 seen = vpPoseMatrix6::Zero();
  for (int k = 0; k < 6; ++k) {
    if (solver.eigenvalues()(k) > vpMotionFrame::leastInformation * solver.eigenvalues()(5)) {
      seen += solver.eigenvectors().col(k) * solver.eigenvectors().col(k).transpose();
    }
  }
  return scale.asDiagonal() * seen * scale.cwiseInverse().asDiagonal() * freeMotions;
}

double vpPoseSolver::error(const vpEdgeCue &edges, const vpHomogeneousMatrix &cMo, double cutoff)
{
  edges.residuals(cMo, m_block);
  const double px = edges.camera().get_px();
  const std::size_t points = edges.matches().size();
  double sum = static_cast<double>(points - m_block.rows.size()) * cutoff * cutoff;
  for (const vpResidual &row : m_block.rows) {
    const double distance = row.weight > 0. ? std::min(px * std::fabs(row.error), cutoff) : cutoff;
    sum += distance * distance;
  }
  return points > 0 ? sum / static_cast<double>(points) : cutoff * cutoff;
}

END_VISP_NAMESPACE
