// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpHalfTurns_h
#define vpHalfTurns_h

#include <visp3/core/vpHomogeneousMatrix.h>
#include <visp3/model/vpSurfaceSamples.h>
#include <visp3/model/vpTrackedModel.h>

#include <Eigen/Core>

#include <optional>
#include <vector>

BEGIN_VISP_NAMESPACE

// Many an object looks nearly the same when it is turned by half: a frame from both sides, a box upside down. Such
// poses are far from each other, so that a search which finds one of them never looks at the other.
class vpHalfTurns
{
public:
  // samples: of the model's surface. The turns are those about the axes of its frame, of which files make use, and
  // about the principal axes of the surface, through the middle of its box.
  void setModel(const vpTrackedModel &model, const std::vector<vpSurfaceSample> &samples);
  // A pose turned by half, where one is much nearer in its orientation to one of the expected ones than the pose is.
  std::optional<vpHomogeneousMatrix> nearer(const vpHomogeneousMatrix &cMo,
                                            const std::vector<vpHomogeneousMatrix> &expected) const;

  // The pose turned by half about each of the axes.
  std::vector<vpHomogeneousMatrix> turned(const vpHomogeneousMatrix &cMo) const;

private:
  Eigen::Vector3d m_centre = Eigen::Vector3d::Zero();
  std::vector<Eigen::Matrix3d> m_turns;
};

END_VISP_NAMESPACE
#endif
