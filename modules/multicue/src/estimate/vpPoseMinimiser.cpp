// SPDX-License-Identifier: GPL-2.0-or-later
#include "estimate/vpPoseMinimiser.h"

#include "frame/vpStopwatch.h"
#include "hypotheses/vpMotionFrame.h"

#include <visp3/core/vpExponentialMap.h>
#include <visp3/core/vpTrackingException.h>

#include <Eigen/Eigenvalues>

#include <cmath>

BEGIN_VISP_NAMESPACE

namespace {
const unsigned int minRows = 4;
// An iteration that moves no control point by more than this has converged.
const double convergedMotion = 0.005; // Pixels.

// Puts the chosen motions back, whatever happens meanwhile.
class ChosenMotions
{
public:
  explicit ChosenMotions(vpMatrix &motions) : m_motions(motions), m_asChosen(motions) {}
  ~ChosenMotions() { m_motions = m_asChosen; }
  ChosenMotions(const ChosenMotions &) = delete;
  ChosenMotions &operator=(const ChosenMotions &) = delete;

private:
  vpMatrix &m_motions;
  const vpMatrix m_asChosen;
};
} // namespace

bool vpPoseMinimiser::minimise(const vpFrameContext &frame, const Equations &equations, vpCueSet &cues,
                               const vpTrackerSymmetries &symmetries, double diameter, vpHomogeneousMatrix &cMo)
{
  m_fusion.clear();
  for (const vpCueSet::Used &used : cues.used()) {
    if ((equations.cues & used.kind->type) != 0) {
      m_fusion.add(used.kind->type, used.cue->cue());
    }
  }
  if (symmetries.hasAxis()) { // Only marks on the surface may show a turn.
    m_fusion.setVisibleMotions(symmetries.visibleMotions(), vpCueSet::POINT, symmetries.printShowsTurns());
  }
  if (equations.prior != nullptr) {
    m_fusion.setPrior(*equations.prior);
  }
  const vpStopwatch stage(frame.timings.pose);
  m_focal = frame.image.camera().get_px();
  m_servoing.pose() = cMo;
  const bool isDone = iterate(diameter);
  cMo = m_servoing.pose();
  return isDone;
}

void vpPoseMinimiser::takeAsTheyAre(const std::vector<vpCueSet::Used> &cues, const vpHomogeneousMatrix &cMo)
{
  m_fusion.clear();
  for (const vpCueSet::Used &used : cues) {
    m_fusion.add(used.kind->type, used.cue->cue());
  }
  vpColVector believed(m_fusion.start(cMo));
  believed = 1.;
  m_fusion.keepWeights(believed);
}

void vpPoseMinimiser::start(const std::map<int, double> &factors)
{
  const unsigned int rows = m_fusion.start(m_servoing.pose());
  for (const auto &[cue, factor] : factors) {
    m_fusion.setFactor(cue, factor);
  }
  m_servoing.interaction().resize(rows, 6, false, false);
  m_servoing.error().resize(rows, false);
  m_servoing.weights().resize(rows, false);
  m_servoing.weights() = 1.;
  m_step.weightedError.resize(rows, false);
  m_step.damping = m_servoing.firstDamping();
}

// Limbs and circles leave motions that nothing in the image shows: those are kept out of the estimation, in the
// object's frame as the degrees of freedom that the user chose. Rotations count at the object's radius, so that units
// do not matter.
bool vpPoseMinimiser::restrictToObserved(double diameter)
{
  const vpPoseTangent scale = vpMotionFrame::scale(diameter);
  const vpPoseMatrix6 S = vpPoseExponential::adjoint(m_servoing.pose()) * scale.asDiagonal();
  vpPoseMatrix6 information = vpPoseMatrix6::Zero();
  m_fusion.forEachRow([&](const vpResidual &row) {
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
  const vpPoseMatrix6 chosen = vpMotionFrame::toEigen(m_servoing.chosenMotions());
  const Eigen::Matrix<double, 6, 6, Eigen::RowMajor> both = projector * chosen;
  std::copy(both.data(), both.data() + 36, m_servoing.chosenMotions().data);
  return true;
}

// How far the farthest feature moves in the image, pixels.
double vpPoseMinimiser::imageMotion(double diameter) const
{
  const Eigen::Map<const vpPoseTangent> v(m_step.velocity.data);
  double largest = 0.;
  if (const vpCueFusion::Part *edges = m_fusion.find(vpCueSet::EDGE)) {
    for (const vpResidual &row : edges->block.rows) {
      largest = std::max(largest, std::fabs(row.jacobian.dot(v)));
    }
    return largest * m_focal;
  }
  // Other cues' errors are no distances: that of the object's origin, and of a turn at its radius.
  const vpHomogeneousMatrix &cMo = m_servoing.pose();
  const Eigen::Vector3d centre(cMo[0][3], cMo[1][3], cMo[2][3]);
  const Eigen::Vector3d turn = v.tail<3>();
  const double moved = (v.head<3>() + turn.cross(centre)).norm() + 0.5 * diameter * turn.norm();
  return moved / std::max(centre.z(), 1e-9) * m_focal;
}

void vpPoseMinimiser::step(unsigned int iteration, bool allMotions)
{
  vpColVector &error = m_servoing.error();
  vpColVector &weights = m_servoing.weights();
  vpMatrix &L = m_servoing.interaction();
  m_fusion.weigh([this](vpRobust &robust, const vpColVector &e, vpColVector &w) { m_servoing.weigh(robust, e, w); },
                 error, L, weights);
  double squares = 0.;
  double sum = 0.;
  unsigned int i = 0;
  m_fusion.forEachRow([&](const vpResidual &row) {
    const double w = weights[i] * row.weight;
    squares += w * error[i] * error[i];
    sum += w;
    m_step.weightedError[i] = w * error[i];
    for (unsigned int j = 0; j < 6; ++j) {
      L[i][j] *= w;
    }
    ++i;
  });
  m_residual = sum > 0. ? std::sqrt(squares / sum) : 0.;
  m_servoing.solve(allMotions, iteration, m_step);
}

bool vpPoseMinimiser::iterate(double diameter)
{
  m_servoing.init();
  if (m_fusion.cueRows() < minRows) {
    return false;
  }
  const ChosenMotions asChosen(m_servoing.chosenMotions());
  vpHomogeneousMatrix &cMo = m_servoing.pose();
  bool all = m_servoing.areAllChosen();
  double residualBefore = -1.;
  try {
    for (unsigned int iteration = 0; iteration < m_servoing.mostIterations(); ++iteration) {
      m_servoing.evaluate();
      if (m_servoing.mustRestart(iteration, m_step)) {
        continue;
      }
      if (iteration == 0 && restrictToObserved(diameter)) {
        all = false;
      }
      step(iteration, all);
      const double moved = imageMotion(diameter);
      m_step.cMoBefore = cMo;
      cMo = vpExponentialMap::direct(m_step.velocity).inverse() * cMo;
      if (moved < convergedMotion || std::fabs(m_residual - residualBefore) < m_servoing.convergence()) {
        break;
      }
      residualBefore = m_residual;
    }
  } catch (const vpTrackingException &) {
    cMo = m_step.cMoBefore; // Levenberg and Marquardt's damping ran away: the best pose so far is the answer.
  }
  m_fusion.keepWeights(m_servoing.weights());
  return true;
}

END_VISP_NAMESPACE
