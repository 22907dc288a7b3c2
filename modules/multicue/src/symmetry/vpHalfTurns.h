// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpHalfTurns_h
#define vpHalfTurns_h

#include <visp3/core/vpHomogeneousMatrix.h>
#include <visp3/model/vpSurfaceSamples.h>
#include <visp3/model/vpTrackedModel.h>

#include <Eigen/Geometry>

#include <optional>
#include <utility>
#include <vector>

BEGIN_VISP_NAMESPACE

// Many an object looks nearly the same when it is turned by half: a frame from both sides, a box upside down. Such
// poses are far from each other, so that a search which finds one of them never looks at the other.
class vpHalfTurns
{
public:
  // One place in each column.
  struct Surface
  {
    Eigen::Matrix3Xd places;
    Eigen::Matrix3Xd normals;
    // The columns, by how far their places are along a direction, and how far that is.
    std::vector<std::pair<double, Eigen::Index>> along;
  };

  // samples: of the model's surface. The turns are those about the axes of its frame, of which files make use, and
  // about the principal axes of the surface, through the middle of its box; where axes beside it bring most of the
  // surface much nearer to other parts of it, as where something sticks out on one side, about these, and about those
  // which do so in another direction.
  void setModel(const vpTrackedModel &model, const std::vector<vpSurfaceSample> &samples);
  // A pose turned by half, where one is much nearer in its orientation to one of the expected ones than the pose is.
  std::optional<vpHomogeneousMatrix> nearer(const vpHomogeneousMatrix &cMo,
                                            const std::vector<vpHomogeneousMatrix> &expected) const;

  // The pose turned by half about each of the axes; those that differ.
  std::vector<vpHomogeneousMatrix> turned(const vpHomogeneousMatrix &cMo) const;

private:
  void add(const Eigen::Isometry3d &turn);
  Eigen::Isometry3d better(const Eigen::Isometry3d &first, const Eigen::Isometry3d &second,
                           const Surface &surface) const;

  Eigen::Vector3d m_centre = Eigen::Vector3d::Zero();
  double m_diameter = 1.;
  std::vector<Eigen::Isometry3d> m_turns; // In the object's frame.
};

END_VISP_NAMESPACE
#endif
