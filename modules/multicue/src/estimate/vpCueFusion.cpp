// SPDX-License-Identifier: GPL-2.0-or-later
#include "estimate/vpCueFusion.h"

#include <algorithm>

BEGIN_VISP_NAMESPACE

void vpCueFusion::add(int type, const vpPoseCue &cue)
{
  if (m_parts.size() == m_count) {
    m_parts.emplace_back();
  }
  Part &part = m_parts[m_count++].part;
  part.type = type;
  part.cue = &cue;
  part.block.rows.clear();
  part.weights.clear();
  part.scale = 0.;
  part.factor = 1.;
}

void vpCueFusion::setFactor(int type, double factor)
{
  for (std::size_t i = 0; i < m_count; ++i) {
    Part &part = m_parts[i].part;
    part.factor = part.type == type ? factor : part.factor;
  }
}

unsigned int vpCueFusion::cueRows() const
{
  std::size_t rows = 0;
  for (std::size_t i = 0; i < m_count; ++i) {
    rows += m_parts[i].part.block.rows.size();
  }
  return static_cast<unsigned int>(rows);
}

unsigned int vpCueFusion::start(const vpHomogeneousMatrix &cMo)
{
  for (std::size_t i = 0; i < m_count; ++i) {
    Memory &memory = m_parts[i];
    vpResidualBlock &block = memory.part.block;
    memory.part.cue->residuals(cMo, block);
    memory.error.resize(static_cast<unsigned int>(block.rows.size()), false);
    memory.w.resize(static_cast<unsigned int>(block.rows.size()), false);
    memory.w = 1.;
    memory.robust.setMinMedianAbsoluteDeviation(block.noise);
  }
  return cueRows() + (m_prior.isSet() ? vpPosePrior::rows : 0);
}

bool vpCueFusion::isHidden(const Part &part, const vpResidual &row) const
{
  return m_hides && !(row.onSurface && (m_allMarks || part.type == m_seeing));
}

bool vpCueFusion::showsAll() const
{
  for (std::size_t i = 0; i < m_count; ++i) {
    const Part &part = m_parts[i].part;
    const std::vector<vpResidual> &rows = part.block.rows;
    if (std::any_of(rows.begin(), rows.end(), [&](const vpResidual &row) { return !isHidden(part, row); })) {
      return true;
    }
  }
  return false;
}

// Takes motions that the object's shape hides out of the rows.
void vpCueFusion::hide(const vpHomogeneousMatrix &cMo, Part &part) const
{
  if (!m_hides) {
    return;
  }
  const vpPoseMatrix6 cVo = vpPoseExponential::adjoint(cMo);
  const vpPoseMatrix6 oVc = vpPoseExponential::adjoint(cMo.inverse());
  const vpPoseMatrix6 visible = (cVo * m_visible * oVc).transpose();
  for (vpResidual &row : part.block.rows) {
    if (isHidden(part, row)) {
      row.jacobian = visible * row.jacobian;
    }
  }
}

void vpCueFusion::evaluate(const vpHomogeneousMatrix &cMo, vpColVector &error, vpMatrix &L)
{
  unsigned int k = 0;
  m_pose = cMo;
  for (std::size_t i = 0; i < m_count; ++i) {
    Memory &memory = m_parts[i];
    memory.part.cue->residuals(cMo, memory.part.block);
    hide(cMo, memory.part);
    unsigned int own = 0;
    for (const vpResidual &row : memory.part.block.rows) {
      memory.error[own++] = row.error;
      error[k] = row.error;
      for (unsigned int j = 0; j < 6; ++j) {
        L[k][j] = row.jacobian[j];
      }
      ++k;
    }
  }
  if (!m_prior.isSet()) {
    return;
  }
  m_prior.residuals(cMo, m_priorRows);
  for (const vpResidual &row : m_priorRows) {
    error[k] = row.error;
    for (unsigned int j = 0; j < 6; ++j) {
      L[k][j] = row.jacobian[j];
    }
    ++k;
  }
}

void vpCueFusion::weigh(const Weigh &weigh, vpColVector &error, vpMatrix &L, vpColVector &w)
{
  double reference = 0.;
  unsigned int k = 0;
  for (std::size_t i = 0; i < m_count; ++i) {
    Memory &memory = m_parts[i];
    if (memory.part.block.rows.empty()) {
      continue;
    }
    weigh(memory.robust, memory.error, memory.w);
    const double scale = memory.robust.getMedianAbsoluteDeviation();
    memory.part.scale = scale;
    reference = reference > 0. ? reference : scale;
    const double factor = memory.part.factor * reference / scale;
    unsigned int own = 0;
    for (std::size_t row = 0; row < memory.part.block.rows.size(); ++row) {
      w[k] = memory.w[own++];
      error[k] *= factor;
      for (unsigned int j = 0; j < 6; ++j) {
        L[k][j] *= factor;
      }
      ++k;
    }
  }
  for (unsigned int i = 0; m_prior.isSet() && i < vpPosePrior::rows; ++i, ++k) {
    w[k] = 1.;
    error[k] *= reference;
    for (unsigned int j = 0; j < 6; ++j) {
      L[k][j] *= reference;
    }
  }
}

void vpCueFusion::keepWeights(const vpColVector &w)
{
  const double *next = w.data;
  for (std::size_t i = 0; i < m_count; ++i) {
    Part &part = m_parts[i].part;
    part.weights.assign(next, next + part.block.rows.size());
    next += part.block.rows.size();
  }
}

const vpCueFusion::Part *vpCueFusion::find(int type) const
{
  for (std::size_t i = 0; i < m_count; ++i) {
    if (m_parts[i].part.type == type) {
      return &m_parts[i].part;
    }
  }
  return nullptr;
}

END_VISP_NAMESPACE
