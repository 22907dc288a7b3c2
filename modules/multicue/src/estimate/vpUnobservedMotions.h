// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpUnobservedMotions_h
#define vpUnobservedMotions_h

#include "estimate/vpCueFusion.h"
#include "symmetry/vpTrackerSymmetries.h"

#include <visp3/multicue/vpMbTrackingResult.h>

BEGIN_VISP_NAMESPACE

/*!
  Finds and names the motions that an image does not show.

  The information of all rows, J^T W J without the prior, is taken in units in which each motion would move the object's
  outline about as far in the image: metres across the line of sight, a turn as the path of a point at half the
  diameter, and a shift along the line of sight by how much farther it has to be. Eigenvectors with little of the
  largest eigenvalue are not observed.
*/
class vpUnobservedMotions
{
public:
  //! \param model, symmetries Must outlive this.
  vpUnobservedMotions(const vpTrackedModel &model, const vpTrackerSymmetries &symmetries)
      : m_model(model), m_symmetries(symmetries)
  {
  }

  //! \param fusion After a minimisation; without one, no motion is observed.
  std::vector<vpMbTrackingResult::UnobservedMotion> find(const vpCueFusion &fusion) const;

private:
  using Motions = Eigen::Matrix<double, 6, Eigen::Dynamic, 0, 6, 12>;

  vpPoseMatrix6 units(const vpHomogeneousMatrix &cMb) const;
  Motions named(const Motions &hidden, const vpPoseMatrix6 &units) const;
  vpMbTrackingResult::UnobservedMotion describe(const vpPoseTangent &motion) const;
  std::string textOf(const vpPoseTangent &motion, bool turns) const;

  const vpTrackedModel &m_model;
  const vpTrackerSymmetries &m_symmetries;
};

END_VISP_NAMESPACE
#endif
