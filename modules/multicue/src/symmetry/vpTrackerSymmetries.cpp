// SPDX-License-Identifier: GPL-2.0-or-later
#include "symmetry/vpTrackerSymmetries.h"

#include "motion/vpCentreFrame.h"

#include <visp3/multicue/vpModelSymmetriesReader.h>

#include <Eigen/LU>

BEGIN_VISP_NAMESPACE

namespace {
// Of a step's length; what is left of it is not worth an attempt.
const double littleLeft = 1. / 3.;

// Axes alone are asked for.
vpModelSymmetries axesOf(const vpTrackedModel &model, bool withColors)
{
  vpSymmetryOptions options;
  options.mostTurns = 2;
  options.colorTolerance = withColors ? options.colorTolerance : 1.;
  return vpFindSymmetries(model, options);
}
} // namespace

vpModelSymmetries vpTrackerSymmetries::read(const std::string &from, unsigned int object, const vpTrackedModel *model)
{
  if (from.empty() || from == none) {
    return vpModelSymmetries();
  }
  if (from == find) { // Without a model they are found when there is one.
    return model == nullptr ? vpModelSymmetries() : vpFindSymmetries(*model);
  }
  return vpModelSymmetriesReader::read(from, object);
}

void vpTrackerSymmetries::set(const vpModelSymmetries &symmetries, const std::string &from, unsigned int object,
                              const vpTrackedModel *model)
{
  m_known = symmetries;
  m_from = from;
  m_object = object;
  if (model != nullptr) {
    measure(*model);
  }
}

void vpTrackerSymmetries::setModel(const vpTrackedModel &model)
{
  if (m_from == find) {
    m_known = vpFindSymmetries(model);
  }
  m_shape = axesOf(model, false);
  m_isPrinted = !m_shape.axes().empty() && axesOf(model, true).axes().empty();
  measure(model);
}

void vpTrackerSymmetries::forget()
{
  m_known = vpModelSymmetries();
  m_shape = vpModelSymmetries();
  m_turns = vpModelSymmetries();
  m_from = m_from == find ? find : "";
}

vpHomogeneousMatrix vpTrackerSymmetries::nearest(const vpHomogeneousMatrix &cMo, const vpHomogeneousMatrix &reference,
                                                 const vpTrackedModel &model) const
{
  return m_known.nearest(cMo, reference, model.centre(), 0.5 * model.diameter());
}

vpHomogeneousMatrix vpTrackerSymmetries::unturned(const vpHomogeneousMatrix &cMo, const vpHomogeneousMatrix &reference,
                                                  const vpTrackedModel &model) const
{
  return m_turns.nearest(cMo, reference, model.centre(), 0.5 * model.diameter());
}

bool vpTrackerSymmetries::hides(const vpHomogeneousMatrix &cMo, const vpHomogeneousMatrix &reference,
                                const vpTrackedModel &model) const
{
  if (m_known.isEmpty()) {
    return false;
  }
  const double radius = 0.5 * model.diameter();
  const double step = vpModelSymmetries::distance(cMo, reference, model.centre(), radius);
  const vpHomogeneousMatrix alike = nearest(cMo, reference, model);
  return vpModelSymmetries::distance(alike, reference, model.centre(), radius) < littleLeft * step;
}

Eigen::Matrix<double, 6, Eigen::Dynamic> vpTrackerSymmetries::hiddenMotions() const
{
  const std::vector<vpSymmetryAxis> &axes = m_turns.axes();
  Eigen::Matrix<double, 6, Eigen::Dynamic> motions(6, static_cast<Eigen::Index>(axes.size()));
  for (std::size_t i = 0; i < axes.size(); ++i) {
    motions.col(static_cast<Eigen::Index>(i)) << axes[i].point.cross(axes[i].direction), axes[i].direction;
  }
  return motions;
}

vpPoseMatrix6 vpTrackerSymmetries::settled(const vpPoseMatrix6 &covariance, const vpHomogeneousMatrix &cMo) const
{
  const vpPoseMatrix6 visible = vpPoseExponential::adjoint(cMo) * m_visible * vpPoseExponential::adjoint(cMo.inverse());
  const vpPoseMatrix6 settled = visible * covariance * visible.transpose();
  return 0.5 * (settled + settled.transpose());
}

void vpTrackerSymmetries::measure(const vpTrackedModel &model)
{
  m_turns = vpModelSymmetries();
  for (const vpSymmetryAxis &axis : m_known.axes().empty() ? m_shape.axes() : m_known.axes()) {
    m_turns.addAxis(axis);
  }
  if (!hasAxis()) {
    return;
  }
  const Eigen::Matrix<double, 6, Eigen::Dynamic> V = hiddenMotions();
  const vpPoseMatrix6 toCentre = vpPoseExponential::adjoint(vpCentreFrame(model).inverse());
  vpPoseTangent metric = vpPoseTangent::Ones();
  metric.tail<3>().setConstant(0.25 * model.diameter() * model.diameter());
  const Eigen::Matrix<double, Eigen::Dynamic, 6> dual =
      V.transpose() * toCentre.transpose() * metric.asDiagonal() * toCentre;
  const Eigen::MatrixXd gram = dual * V;
  m_visible = vpPoseMatrix6::Identity() - V * gram.inverse() * dual;
}

END_VISP_NAMESPACE
